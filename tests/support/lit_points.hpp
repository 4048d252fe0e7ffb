// Where light was evaluated for a pixel, again in double: what decides whether two number types may
// show different colours there.
#pragma once

#include <vector>

#include "render/face_values.hpp"
#include "support/pictures.hpp"

namespace scanshade {

/// A point at which light was evaluated, and how far off a renderer in float may have it.
struct LitPoint {
    Vec3<double> position, normal;  // the normal as interpolated, not unit
    double position_error, normal_error;
    std::uint32_t material;
};

/// The points that the colours of one picture come from: its samples (Phong), or the corners (Gouraud)
/// and centres (flat) of its faces.
class LitPoints64 {
public:
    LitPoints64(const Scene& scene, const Settings& settings);

    /// Of all samples of a pixel.
    std::vector<LitPoint> at(int x, int y);

    /// Whether a quantity that light branches on lies within its error of the threshold: cosθ_i of
    /// 0, the cosine at the rim of a spot's cone, the length of the normal of what is taken as none.
    bool near_threshold(const LitPoint& point) const;

private:
    void add_points(FaceValues<double>& face, SnappedPoint p, std::vector<LitPoint>& out) const;

    TestFrame test_;
    std::vector<ObjectSurface> surfaces_;
    LightingPair<double> lighting_;
    EventCounts ignored_;
    std::vector<std::vector<std::uint32_t>> ids_;  // [sample]
    std::vector<SampleOffset> samples_;
};

}  // namespace scanshade

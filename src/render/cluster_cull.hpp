// Which clusters a view cannot show, by their spheres and cones of normals.
#pragma once

#include "render/engine_scene.hpp"
#include "render/transform.hpp"

namespace scanshade {

/// Every answer is on the safe side of rounding and of snapping to 1/256 pixel: what it excludes
/// would not have changed a sample.
class ClusterCull {
public:
    explicit ClusterCull(const View& view);

    /// Before near, behind far or beside the picture.
    bool outside(const ClusterBounds& cluster) const;
    /// Every triangle shows its back, and none is so small that snapping could turn it.
    bool facing_away(const ClusterBounds& cluster) const;
    /// Inside of near, far and the guard band, so that no vertex needs to be asked.
    bool unclipped(const ClusterBounds& cluster) const;

private:
    /// Centre in eye space, d along the view, and a radius that includes rounding.
    struct Sphere {
        double x, y, d, r;
    };
    Sphere sphere(const ClusterBounds& cluster) const;

    const View& view_;
    double half_width_, half_height_;  // at distance 1, or everywhere; a pixel more than is seen
    double slant_x_, slant_y_;         // length of the side planes' normals
};

}  // namespace scanshade

// Object space → picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/walk.hpp"
#include "scanshade/render/plan.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// Half the side of the square around the picture's centre outside of which polygons are clipped,
/// in pixels: edge functions within it stay below 2^50.
inline constexpr float guard_band = 32768.0f;

/// A vertex before division. On the picture, in pixels from its centre, it stands at
/// (x/w, y/w), y down.
struct ClipVertex {
    float x, y;  // pixel · w
    float d;     // distance from the eye along the view direction
    float w;     // perspective: d; orthographic: 1
};

/// Half spaces that a vertex lies outside of, as bits.
enum Outcode : std::uint8_t {
    out_near = 1,
    out_far = 2,
    out_left = 4,
    out_right = 8,
    out_top = 16,
    out_bottom = 32,
};
inline constexpr std::uint8_t out_depth = out_near | out_far;

/// The camera of one picture: everything that turns a point of normalised world space into a
/// ClipVertex.
struct View {
    glm::dvec3 eye;          // camera position
    glm::dmat3 rotation;     // world → eye
    double pixels_per_unit;  // perspective: at distance 1
    bool orthographic;
    float near, far;
    int width, height;

    /// Depth of a vertex inside near and far, in (0, 1], larger is nearer: near/w in perspective,
    /// 1 − ½(d − near)/(far − near) in orthographic projection. Affine on the picture either way.
    float depth(const ClipVertex& v) const;
    std::uint8_t outcode(const ClipVertex& v) const;
    /// Nearest 1/256 pixel; for a vertex with outcode 0.
    SnappedPoint snap(const ClipVertex& v) const;
};

View make_view(const Camera& camera, const DepthRange& depth, int width, int height);

/// One vertex on the picture.
struct VertexState {
    ClipVertex clip;
    SnappedPoint point{};  // of a vertex with outcode 0
    float depth = 0;       // of a vertex between near and far
    std::uint8_t outcode = 0;
};

/// How one object's vertices get to the picture. The matrix is multiplied in double, relative to
/// the camera, and rounded to float once; a vertex is ((m0 x + m1 y) + m2 z) + m3 in float, not
/// fused: the same bits on every machine.
struct ObjectView {
    std::array<std::array<float, 4>, 4> to_clip;  // rows x, y, d, w of ClipVertex
    bool mirrored;                                // the object's matrix turns front faces clockwise
};

ObjectView make_object_view(const Object& object, const View& view);

VertexState transform_vertex(const Mesh& mesh, std::uint32_t vertex, const ObjectView& object,
                             const View& view);

}  // namespace scanshade

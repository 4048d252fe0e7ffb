// Faces on the picture: how each is drawn, and where its corners are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/screen_plane.hpp"
#include "kernels/screen_quad.hpp"
#include "render/frame.hpp"

namespace scanshade {

/// `steepest` of planes_serve: an error of 400 u does not show in a normal or a colour, but moves a
/// texture of a thousand texels by a share of one.
inline float steepest_weight(const RenderPlan& plan) { return plan.texture ? 32.0f : 128.0f; }

/// How values travel inside a drawn face.
enum class Carrier : std::uint8_t {
    triangle,  // barycentric, from exact edge functions
    clipped,   // barycentric, from homogeneous edge functions of the unclipped triangle
    polygon,   // (C3) along edges and spans
};

/// A corner on the picture in 1/256 pixel, a whole number. In double, because corners of a whole
/// polygon may lie outside the guard band, where only coverage is clipped.
struct PictureCorner {
    double x, y;
};

/// A corner between near and far, wherever it is on the picture.
PictureCorner picture_corner(const View& view, const VertexState& vertex);

/// Homogeneous edge functions (Olano and Greer 1997): at (X, Y) in pixels from the centre,
/// λ_i ∝ a_i X + b_i Y + c_i are the perspective-correct weights of the corners, and their sum is
/// 1/w times the same factor. Corners behind the eye do no harm: nothing is divided by their w.
struct HomogeneousEdges {
    double a[3], b[3], c[3];  // signed so that λ ≥ 0 inside
    double sum_to_inv_w;      // 1/w = Σλ · this; not finite for a triangle without area
    bool positive;            // the triangle runs clockwise on the picture (y down)
};
HomogeneousEdges homogeneous_edges(const ClipVertex* const (&v)[3]);

/// Samples of a picture that a box may cover, both ends included; empty where x1 < x0 or y1 < y0.
struct SampleBox {
    int x0, y0, x1, y1;
    bool empty() const { return x1 < x0 || y1 < y0; }
    /// Planes count pixels from here: the corner of the block of 4 × 4 that the box begins in.
    int origin_x() const { return x0 & ~3; }
    int origin_y() const { return y0 & ~3; }
};

/// The samples of a width × height picture within the box around `points`.
SampleBox sample_box(std::span<const SnappedPoint> points, SampleOffset sample, int width,
                     int height);

/// One drawn polygon: a triangle of the mesh, or in `edges` a whole face. A pure function of the
/// frame's vertices, so visibility and shading both make it anew and nothing is stored.
struct DrawnFace {
    std::uint32_t id = 0;  // of the (first) triangle, in the whole scene
    std::size_t object = 0, face = 0;
    Carrier carrier = Carrier::triangle;
    std::span<const std::uint32_t> vertex;  // corners in the mesh
    std::vector<VertexState> state;         // of the corners
    std::uint8_t outside = 0;               // outcodes of the corners or-ed
    bool back = false;                      // seen from behind
    bool empty = false;                     // outside the view, or no area once snapped

    SampleBox box;  // of its samples, unless clipped

    // triangle
    SnappedPoint point[3];
    double inv_area = 0;                // 1/2A, of either sign
    std::uint8_t order[3] = {0, 1, 2};  // corners from the top, the order of sums: coincident
                                        // triangles have equal depth to the bit
    bool planar = false;                // depth is a plane, else Σ λ_i z_i
    ScreenPlane<float> depth{};         // of a planar triangle, from the box's origin

    HomogeneousEdges edges{};  // clipped

    // polygon
    std::vector<PictureCorner> corner;
    bool quad_serves = false;   // depth is that of `quad`, else (C3) with differences in double
    ScreenQuad<float> quad{};   // from the box's origin
    std::uint8_t clockwise[4];  // the corners in its order
};

/// Whether `edges` draws this face of more than three corners whole: strictly convex on the
/// picture, in front of the eye.
bool drawn_whole(const Frame& frame, std::size_t object, std::size_t face);

/// Describes triangle `triangle` of an object, or its whole face.
void describe_triangle(const Frame& frame, std::size_t object, std::uint32_t triangle,
                       DrawnFace& out);
void describe_whole(const Frame& frame, std::size_t object, std::size_t face, DrawnFace& out);

/// What was drawn under that id.
void describe_drawn(const Frame& frame, std::uint32_t id, DrawnFace& out);

}  // namespace scanshade

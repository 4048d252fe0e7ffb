// Faces on the picture: how each is drawn, and where its corners are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/frame.hpp"

namespace scanshade {

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

/// Homogeneous edge functions (Olano and Greer 1997): at (X, Y) in pixels from the centre,
/// λ_i ∝ a_i X + b_i Y + c_i are the perspective-correct weights of the corners, and their sum is
/// 1/w times the same factor. Corners behind the eye do no harm: nothing is divided by their w.
struct HomogeneousEdges {
    double a[3], b[3], c[3];  // signed so that λ ≥ 0 inside
    double sum_to_inv_w;      // 1/w = Σλ · this; not finite for a triangle without area
    bool positive;            // the triangle runs clockwise on the picture (y down)
};
HomogeneousEdges homogeneous_edges(const ClipVertex* const (&v)[3]);

/// One drawn polygon: a triangle of the mesh, or in `edges` a whole face. A pure function of the
/// frame's vertices, so visibility and shading both make it anew and nothing is stored.
struct DrawnFace {
    std::uint32_t id = 0;  // of the (first) triangle, in the whole scene
    std::size_t object = 0, face = 0;
    Carrier carrier = Carrier::triangle;
    std::span<const std::uint32_t> vertex;  // corners in the mesh
    std::uint8_t outside = 0;               // outcodes of the corners or-ed
    bool back = false;                      // seen from behind
    bool empty = false;                     // outside the view, or no area once snapped

    SnappedPoint point[3];              // triangle
    double inv_area = 0;                // triangle: 1/2A, of either sign
    std::uint8_t order[3] = {0, 1, 2};  // triangle: corners from the top, the order of sums:
                                        // coincident triangles have equal depth to the bit
    HomogeneousEdges edges{};           // clipped
    std::vector<PictureCorner> corner;  // polygon
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

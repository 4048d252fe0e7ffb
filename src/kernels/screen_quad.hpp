// Quadrilaterals drawn whole, as equation (C3) carries values through them: along the edges to the
// ends of a row, along the row to the sample. One text for the scalar renderers and the kernels.
#if defined(SCANSHADE_KERNELS_SCREEN_QUAD_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SCREEN_QUAD_HPP
#undef SCANSHADE_KERNELS_SCREEN_QUAD_HPP
#else
#define SCANSHADE_KERNELS_SCREEN_QUAD_HPP
#endif

#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

/// A strictly convex quadrilateral on the picture, its corners clockwise (y down). Pixels count from
/// an origin of its own, so that corners are exact in float.
template <class R>
struct ScreenQuad {
    R x[4], y[4];     // pixel, whole multiples of 1/256
    R per_height[4];  // 1/(y of the next corner − y), 0 for a level edge: 1/pixel
    R z[4];           // depth
};

/// 1/height of an edge.
template <Real R>
R per_height(R height) {
    const auto slanted = abs(height) > R(0);
    return select(slanted, R(1) / select(slanted, height, R(1)), R(0));
}

/// The span that a row crosses, as depth travels along it.
template <class R>
struct QuadSpan {
    R x, z;   // of its left end
    R slope;  // of z, 1/pixel
};

/// The span of the row at y, between the one edge that goes up and the one that goes down there.
/// Outside of the quadrilateral it has no meaning, but is finite. Not fused: the same bits on every
/// machine.
/// error   of span_depth ≤ 64 u of the smallest depth of the corners where quads_serve
/// checks  tests/kernels/quad_depth_test.cpp
template <Real R>
QuadSpan<R> quad_span(const ScreenQuad<R>& q, R y) {
    // A span narrower than 1/16 of the grid's step is the tip of a corner.
    constexpr float narrowest = 0x1p-12f;
    R left_x = R(0), left_z = R(0), right_x = R(1), right_z = R(0);
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        const auto from_below = q.y[k] > y, to_below = q.y[next] > y;
        const R t = (y - q.y[k]) * q.per_height[k];
        const R x = q.x[k] + (q.x[next] - q.x[k]) * t, z = q.z[k] + (q.z[next] - q.z[k]) * t;
        left_x = select(from_below, select(to_below, left_x, x), left_x);
        left_z = select(from_below, select(to_below, left_z, z), left_z);
        right_x = select(to_below, select(from_below, right_x, x), right_x);
        right_z = select(to_below, select(from_below, right_z, z), right_z);
    }
    const R width = right_x - left_x;
    const R wide = select(width > R(narrowest), width, R(narrowest));
    return {left_x, left_z, (right_z - left_z) / wide};
}

template <Real R>
R span_depth(const QuadSpan<R>& span, R x) {
    return span.z + span.slope * (x - span.x);
}

/// Whether floats serve a quadrilateral: depth changes little over it, and no corner is so flat that
/// the weights of the corners rush past a sample. Otherwise depth and values are carried in double.
/// Every renderer decides by this function.
/// in      nearest, farthest  largest and smallest depth of the corners, > 0
///         turn            twice the area of the triangle of each corner and its two neighbours
///                                                              (1/256 pixel)²
///         width, height   from the origin to the last sample   pixel
///         side_x, side_y  of the box around the corners        1/256 pixel
///         steepest        bound of how much a weight changes from the origin to a sample
template <Real R>
auto quads_serve(R nearest, R farthest, const R (&turn)[4], R width, R height, R side_x, R side_y,
                 R steepest) {
    const R weights = (side_y * width + side_x * height) * R(256);
    auto serve = R(4) * farthest > nearest;
    for (int k = 0; k < 4; ++k) serve = mask_and(serve, steepest * turn[k] > weights);
    return serve;
}

SCANSHADE_TARGET_END;

#endif

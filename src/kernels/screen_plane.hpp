// Values that are affine on the picture, as planes: one text for the scalar renderers, which ask for
// one triangle at a time in double, and for the vector set-up.
#if defined(SCANSHADE_KERNELS_SCREEN_PLANE_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SCREEN_PLANE_HPP
#undef SCANSHADE_KERNELS_SCREEN_PLANE_HPP
#else
#define SCANSHADE_KERNELS_SCREEN_PLANE_HPP
#endif

#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

/// c + (x X + y Y), X and Y in pixels from an origin of the triangle's own, so that a small triangle
/// far from the picture's corner loses nothing.
template <class R>
struct ScreenPlane {
    R c, x, y;
};

/// The plane through three values at three snapped corners. R holds doubles: the differences and
/// twice the area are exact, so a thin triangle's plane is as good as any.
/// in      px, py   corners, not on one line                    1/256 pixel
///         value    at the corners
///         ox, oy   the origin                                  1/256 pixel
/// out     the plane, its gradient a pixel. Error ≤ 4 u of double of the terms that it sums
template <Real R>
ScreenPlane<R> plane_through(const R (&px)[3], const R (&py)[3], const R (&value)[3], R ox, R oy) {
    const R dx1 = px[1] - px[0], dy1 = py[1] - py[0];
    const R dx2 = px[2] - px[0], dy2 = py[2] - py[0];
    const R d1 = value[1] - value[0], d2 = value[2] - value[0];
    const R inv_area = R(1) / (dx1 * dy2 - dx2 * dy1);
    const R gx = (d1 * dy2 - d2 * dy1) * inv_area;
    const R gy = (d2 * dx1 - d1 * dx2) * inv_area;
    const R c = value[0] + (gx * (ox - px[0]) + gy * (oy - py[0]));
    return {c, gx * R(256), gy * R(256)};
}

/// Value of a plane in float. Not fused: the same bits on every machine, and monotone in X and in Y,
/// so that the values at the corners of a box bound it.
template <Real R>
R plane_value(const ScreenPlane<R>& plane, R X, R Y) {
    return plane.c + (plane.x * X + plane.y * Y);
}

/// The same as fast as may be, for attributes.
template <Real R>
R fused_value(const ScreenPlane<R>& plane, R X, R Y) {
    return mul_add(plane.x, X, mul_add(plane.y, Y, plane.c));
}

/// Whether planes in float serve a triangle: depth changes little over it, and so does the weight of
/// each corner, so that neither the depth plane nor that of an attribute adds large terms that
/// cancel. Then a plane's value is good to about 20 u of the smallest depth, and to 3 `steepest` u of
/// the largest corner for an attribute; otherwise values are Σ λ_i a_i. Every renderer decides by
/// this function.
/// in      depth           plane of the depth                   1, 1/pixel
///         nearest_far     smallest depth of the corners, > 0
///         area2           twice the area, > 0                  (1/256 pixel)²
///         width, height   from the origin to the last sample   pixel
///         side_x, side_y  of the box around the corners        1/256 pixel
///         steepest        bound of how much a weight changes from the origin to a sample
template <Real R>
auto planes_serve(const ScreenPlane<R>& depth, R nearest_far, R area2, R width, R height, R side_x,
                  R side_y, R steepest) {
    const R change = abs(depth.x) * width + abs(depth.y) * height;
    // |∂λ/∂x| ≤ side_y/area2, and a pixel is 256 of the units.
    const R weights = (side_y * width + side_x * height) * R(256);
    return mask_and(R(4) * nearest_far > change, steepest * area2 > weights);
}

SCANSHADE_TARGET_END;

#endif

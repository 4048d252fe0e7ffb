// Chapter D of the formula sheet: ray casting.
//
// What may fail to exist comes with a number `hit`, 1 or 0, as masks differ between number types.
#if defined(SCANSHADE_EQ_RAYCAST_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_RAYCAST_HPP
#undef SCANSHADE_EQ_RAYCAST_HPP
#else
#define SCANSHADE_EQ_RAYCAST_HPP
#endif

#include "scanshade/num/vec3.hpp"

SCANSHADE_TARGET_BEGIN;

/// 1 where low ≤ x ≤ high, else 0: t ∈ [0, 1] of a segment, u and v of a parallelogram.
///
///     t ∈ [0, 1] in                                                                 (D1), (D2)
///
/// error   none: x is compared as it is
/// checks  both ends belong to the segment            tests/eq/raycast_test.cpp
/// source  the formula sheet
template <Real R>
R within(R x, R low, R high) {
    return select(x < low, R(0), select(x > high, R(0), R(1)));
}

/// Where a segment meets a plane.
///
///     t = −(n·P_0 + D)/(n·p_1),   P(t) = P_0 + t p_1,   t ∈ [0, 1]                       (D1)
///
/// error   none: plain data
/// checks  as segment_plane                           tests/eq/raycast_test.cpp
/// source  the formula sheet
template <class R>
struct PlaneHit {
    R hit;  // 1: the segment meets the plane, 0: it does not, or lies in it
    R t;
};

/// Segment and plane.
///
///     t = −(n·P_0 + D)/(n·p_1)                                                           (D1)
///
/// in      P0, p1   start and direction to the end    any        length
///         n, D     plane n·X + D = 0                 n not 0    1, length
/// out     t        0 where the segment is parallel to the plane   1
/// error   t ≤ (3 Σ|n_k P0_k| + |D|) u/|n·p_1| and 4 u (n·p_1)-relative: a slanting segment has a
///         sure t only as far as P0's distance from the plane is not rounding
/// checks  P(t) lies in the plane; parallel segments; both ends   tests/eq/raycast_test.cpp
/// source  the formula sheet
template <Real R>
PlaneHit<R> segment_plane(const Vec3<R>& P0, const Vec3<R>& p1, const Vec3<R>& n, R D) {
    const R speed = dot(n, p1);
    const auto slanted = abs(speed) > R(0);
    const R t = -(dot(n, P0) + D) / select(slanted, speed, R(1));
    return {select(slanted, within(t, R(0), R(1)), R(0)), select(slanted, t, R(0))};
}

/// Coordinates of a point in a plane along two vectors.
///
///     X = P + u u + v v                                                                  (D2)
///
/// error   none: plain data
/// checks  as plane_coordinates                       tests/eq/raycast_test.cpp
/// source  the formula sheet
template <class R>
struct PlaneCoordinates {
    R u, v;
};

/// Parallelogram or triangle: the coordinates (u, v) of a point X of its plane.
///
///     u u_x + v v_x = x − P_x,   u u_y + v v_y = y − P_y                                 (D2)
///
/// computed from those two of the three coordinates in which the parallelogram is largest, by
/// Cramer's rule: its normal u × v has the three determinants. The printed two have the
/// determinant 0 where the plane is parallel to the z axis.
/// in      X        point of the plane                any        length
///         P        corner with (u, v) = (0, 0)       any        length
///         u, v     sides                             any        length
/// out     (u, v)   (−1, −1), which is outside, where u and v are parallel   1
/// error   ≤ 12 u (|X − P| |v|, or |u|)/|u × v|·√3
/// checks  round trip in every orientation; the printed pair fails in an upright plane
///                                                    tests/eq/raycast_test.cpp
/// source  the formula sheet
template <Real R>
PlaneCoordinates<R> plane_coordinates(const Vec3<R>& X, const Vec3<R>& P, const Vec3<R>& u,
                                      const Vec3<R>& v) {
    const Vec3<R> w = X - P, n = cross(u, v), size = {abs(n.x), abs(n.y), abs(n.z)};
    const Vec3<R> w_v = cross(w, v), u_w = cross(u, w);
    const auto x_over_y = size.x > size.y;
    const R size_xy = max(size.x, size.y);
    const auto z_largest = size.z > size_xy;
    const R determinant = select(z_largest, n.z, select(x_over_y, n.x, n.y));
    const R for_u = select(z_largest, w_v.z, select(x_over_y, w_v.x, w_v.y));
    const R for_v = select(z_largest, u_w.z, select(x_over_y, u_w.x, u_w.y));
    const auto solvable = abs(determinant) > R(0);
    const R divisor = select(solvable, determinant, R(1));
    return {select(solvable, for_u / divisor, R(-1)), select(solvable, for_v / divisor, R(-1))};
}

/// Whether (u, v) lies in the parallelogram; its border does.
///
///     0 ≤ u, v ≤ 1                                                                       (D2)
///
/// in      c        coordinates                       any        1
/// out     1 or 0
/// error   none: the numbers are compared as they are
/// checks  corners and centre in, outside out         tests/eq/raycast_test.cpp
/// source  the formula sheet
template <Real R>
R in_parallelogram(const PlaneCoordinates<R>& c) {
    return within(c.u, R(0), R(1)) * within(c.v, R(0), R(1));
}

/// Whether (u, v) lies in the triangle; its border does.
///
///     0 ≤ u, v,  u + v ≤ 1                                                               (D2)
///
/// in      c        coordinates                       any        1
/// out     1 or 0
/// error   the sum ≤ 1 u
/// checks  corners and centre in, outside out         tests/eq/raycast_test.cpp
/// source  the formula sheet
template <Real R>
R in_triangle(const PlaneCoordinates<R>& c) {
    const R smallest = min(c.u, c.v);
    return select(smallest < R(0), R(0), select(c.u + c.v > R(1), R(0), R(1)));
}

/// Where a line meets a sphere.
///
///     X = P(t_0 ± t)                                                                     (D3)
///
/// error   none: plain data
/// checks  as ray_sphere                              tests/eq/raycast_test.cpp
/// source  the formula sheet
template <class R>
struct SphereHits {
    R hit;            // 1 or 0
    R t_near, t_far;  // in units of p1, so that the segment is [0, 1]; the closest point: no hit
};

/// Line and sphere.
///
///     t_0 = v·p_1,  D² = v·v − t_0²,  t² = R² − D²,  v = S − P_0        printed          (D3)
///
/// computed with p_1 made a unit vector, which the printed form supposes, and the result divided by
/// its length; D as ‖v − t_0 p_1‖ and t² as (R − D)(R + D), as v·v − t_0² cancels for spheres that
/// are small and far, and R² − D² for huge ones; the root on the side of P_0 as
/// (‖v‖ − R)(‖v‖ + R)/(t_0 ± t), as t_0 − t cancels for a P_0 near a huge sphere.
/// in      P0, p1   start and direction               p1 not 0   length
///         S, radius  centre, R                       any, ≥ 0   length
/// out     hit, t_near ≤ t_far                                   1
/// error   D ≤ 6 u ‖v‖; t ≤ 12 u (‖v‖ + R)(1 + ‖v‖/t) for t > 0
/// checks  X on the sphere; p1 of any length; R = 1 at distance 1e4 and R = 1e6 at distance 1 in
///         float, where the printed form fails        tests/eq/raycast_test.cpp
/// source  the formula sheet; Haines, Günther, Akenine-Möller 2019, Ray Tracing Gems ch. 7
template <Real R>
SphereHits<R> ray_sphere(const Vec3<R>& P0, const Vec3<R>& p1, const Vec3<R>& S, R radius) {
    const R length = sqrt(dot(p1, p1));
    const Vec3<R> direction = p1 * (R(1) / length), v = S - P0;
    const R t0 = dot(v, direction);
    const Vec3<R> closest = v - direction * t0;
    const R D = sqrt(dot(closest, closest)), distance = sqrt(dot(v, v));
    const R t2 = (radius - D) * (radius + D);
    const R half_chord = sqrt(max(t2, R(0)));
    const R outer = select(t0 < R(0), t0 - half_chord, t0 + half_chord);
    const auto apart = abs(outer) > R(0);
    const R product = (distance - radius) * (distance + radius);
    const R inner = select(apart, product / select(apart, outer, R(1)), R(0));
    const auto missed = t2 < R(0);
    return {select(missed, R(0), R(1)), select(missed, t0, min(outer, inner)) / length,
            select(missed, t0, max(outer, inner)) / length};
}

SCANSHADE_TARGET_END;

#endif

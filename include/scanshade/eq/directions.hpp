// Chapter A of the formula sheet, directions: unit vectors, spherical angles, solid angle.
#if defined(SCANSHADE_EQ_DIRECTIONS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_DIRECTIONS_HPP
#undef SCANSHADE_EQ_DIRECTIONS_HPP
#else
#define SCANSHADE_EQ_DIRECTIONS_HPP
#endif

#include "scanshade/num/vec3.hpp"

SCANSHADE_TARGET_BEGIN;

/// A direction by its angles.
///
///     ω = [θ, φ],   θ ∈ [0, π],   φ ∈ [0, 2π)                                            (A2)
///
/// in      theta    polar angle from +z               [0, π]      rad
///         phi      azimuth from +x towards +y        [0, 2π)     rad
/// error   none: plain data
/// checks  round trips stay in these ranges           tests/eq/directions_test.cpp
/// source  the formula sheet
template <class R>
struct Spherical {
    R theta, phi;
};

/// The unit vector along v.
///
///     ω = [x, y, z],   x² + y² + z² = 1                                                  (A1)
///
/// computed as v/|v|; the zero vector, which has no direction, stays zero
/// in      v        any vector whose |v|² is a normal number, or 0        1
/// out     ω        unit vector                       [−1, 1]³            1
/// error   ≤ 4 u a component: squared length 3, halved by the root and rounded 2.5, quotient 3,
///         product 4
/// checks  |ω| = 1; scaling by 2^k changes no bit     tests/eq/directions_test.cpp
/// source  the formula sheet
template <Real R>
Vec3<R> unit_direction(const Vec3<R>& v) {
    return normalise(v);
}

/// Cartesian → spherical.
///
///     θ = arccos z,   φ = arctan(y/x)                                    printed         (A3)
///
/// computed as θ = atan2(√(x² + y²), z), φ = atan2(y, x) wrapped to [0, 2π). Printed, φ is right
/// in two of the four quadrants only, and arccos loses half of the digits near the poles.
/// in      w        direction                         any length but 0    1
/// out     θ, φ                                       A2                  rad
/// error   θ ≤ 4 u of itself; φ ≤ 2 u of 2π
/// checks  round trip with A4 in every quadrant and 1e-7 rad from a pole; the printed form fails
///                                                    tests/eq/directions_test.cpp
/// source  the formula sheet, with its quadrant corrected
template <Real R>
Spherical<R> to_spherical(const Vec3<R>& w) {
    const R phi = atan2(w.y, w.x);
    const R wrapped = select(phi < R(0), phi + R(2 * pi), phi);
    // A tiny negative angle rounds to 2π itself, which is outside the half-open range.
    return {atan2(sqrt(w.x * w.x + w.y * w.y), w.z), select(wrapped < R(2 * pi), wrapped, R(0))};
}

/// Spherical → Cartesian.
///
///     x = sinθ cosφ,   y = sinθ sinφ,   z = cosθ                                         (A4)
///
/// in      s        angles                            A2                  rad
/// out     ω        unit vector                       [−1, 1]³            1
/// error   ≤ 3 u a component: two functions of 1 u each and a product
/// checks  |ω| = 1; round trip with A3                tests/eq/directions_test.cpp
/// source  the formula sheet
template <Real R>
Vec3<R> to_cartesian(const Spherical<R>& s) {
    const R sin_theta = sin(s.theta);
    return {sin_theta * cos(s.phi), sin_theta * sin(s.phi), cos(s.theta)};
}

/// Solid angle that a small area subtends.
///
///     dω = dA cosθ / r²                                                                  (A5)
///
/// in      dA       area, small against r²            ≥ 0                 m²
///         cos_theta between its normal and the line of sight  [0, 1]     1
///         r        distance                          > 0                 m
/// out     dω                                         ≥ 0                 sr
/// error   ≤ 3 u: product 1, square 1, quotient 1
/// checks  a sphere's areas sum to 4π                 tests/eq/directions_test.cpp
/// source  the formula sheet
template <Real R>
R solid_angle_of_area(R dA, R cos_theta, R r) {
    return dA * cos_theta / (r * r);
}

/// Solid angle of a small patch of angles.
///
///     dω = sinθ dθ dφ                                                                    (A6)
///
/// in      theta    polar angle                       [0, π]              rad
///         dtheta, dphi  sides of the patch           ≥ 0                 rad
/// out     dω                                         ≥ 0                 sr
/// error   ≤ 3 u: sine 1, products 2
/// checks  the patches of a sphere sum to 4π          tests/eq/directions_test.cpp
/// source  the formula sheet
template <Real R>
R solid_angle_of_angles(R theta, R dtheta, R dphi) {
    return sin(theta) * dtheta * dphi;
}

SCANSHADE_TARGET_END;

#endif

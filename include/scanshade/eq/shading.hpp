// Chapter C of the formula sheet: shading.
//
// C2 and C3 interpolate intensities (Gouraud), C4 and C5 normals (Phong). The pairs have the same
// weights, so one template over the value serves both; a value is a number or a Vec3.
#if defined(SCANSHADE_EQ_SHADING_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_SHADING_HPP
#undef SCANSHADE_EQ_SHADING_HPP
#else
#define SCANSHADE_EQ_SHADING_HPP
#endif

#include "scanshade/eq/reflection.hpp"
#include "scanshade/num/rgb.hpp"
#include "scanshade/num/vec3.hpp"

SCANSHADE_TARGET_BEGIN;

/// Vertex normal: the direction of the sum of the adjacent faces' normals.
///
///     N = Σ N_i / ‖Σ N_i‖                                                                (C1)
///
/// in      sum      Σ N_i over the faces around the vertex, unit or times a weight        1
///         lengths  Σ ‖N_i‖ of the same                                                  1
///         cancelled  share of it below which the sum is noise: a few u times the count   1
/// out     N                                          unit; 0 where they cancel           1
/// error   ≤ (n + 4) u lengths/‖sum‖ a component for n faces; where no digit of the direction is
///         sure the result is 0, and the caller takes the face normal
/// checks  cube corner; opposite normals give 0, with a rest of rounding too
///                                                    tests/eq/shading_test.cpp
/// source  Gouraud 1971
template <Real R>
Vec3<R> vertex_normal(const Vec3<R>& sum, R lengths, R cancelled) {
    const R noise = cancelled * lengths;
    const R kept = select(dot(sum, sum) > noise * noise, R(1), R(0));
    return normalise(sum * kept);
}

/// Gouraud interpolation on a quadrilateral with corners A(0,0) B(1,0) C(0,1) D(1,1).
///
///     I_X = (1 − v)[(1 − u) I_A + u I_B] + v[(1 − u) I_C + u I_D]                        (C2)
///
/// in      I_A … I_D  values at the corners                               any
///         u, v     position in the patch             [0, 1]              1
/// out     I_X      between the smallest and the largest corner, to the error
/// error   ≤ 5 u max|I|: 1 − u and 1 − v round, two products and two sums on each path
/// checks  corners exactly; by hand on given quadrilaterals   tests/eq/shading_test.cpp
/// source  the formula sheet
template <Real R, class Value>
Value bilinear(const Value& I_A, const Value& I_B, const Value& I_C, const Value& I_D, R u, R v) {
    const R u1 = R(1) - u;
    return (I_A * u1 + I_B * u) * (R(1) - v) + (I_C * u1 + I_D * u) * v;
}

/// Gouraud interpolation along an edge from A to B, at the height of a scanline.
///
///     I_AB = I_A (y − B_y)/(A_y − B_y) + I_B (A_y − y)/(A_y − B_y)                       (C3)
///
/// in      I_A, I_B values at the ends                                    any
///         A_y, B_y heights of the ends               |y| ≤ 2²²           pixel/256
///         y        height of the scanline            between them        pixel/256
/// out     I_AB; I_A for a horizontal edge, which no scanline crosses
/// error   ≤ 4 u max|I|: the heights are whole numbers, so the differences are exact
/// checks  by hand on given edges, the horizontal one included   tests/eq/shading_test.cpp
/// source  the formula sheet
template <Real R, class Value>
Value along_edge(const Value& I_A, const Value& I_B, R A_y, R B_y, R y) {
    const R height = A_y - B_y;
    const auto slanted = abs(height) > R(0);
    const R divisor = select(slanted, height, R(1));
    return I_A * select(slanted, (y - B_y) / divisor, R(1)) +
           I_B * select(slanted, (A_y - y) / divisor, R(0));
}

/// Gouraud interpolation along a span, from edge AB to edge AC.
///
///     I_X = I_AB ((AC)_x − x)/((AC)_x − (AB)_x) + I_AC (x − (AB)_x)/((AC)_x − (AB)_x)    (C3)
///
/// in      I_AB, I_AC  values at the ends                                 any
///         AB_x, AC_x  ends of the span, measured from any origin         pixel/256
///         x        position of the sample            between them        pixel/256
/// out     I_X; I_AB for an empty span
/// error   ≤ 6 u max|I| where the origin is the sample (x = 0), as in the renderers
/// checks  by hand on given spans, the empty one included   tests/eq/shading_test.cpp
/// source  the formula sheet
template <Real R, class Value>
Value along_span(const Value& I_AB, const Value& I_AC, R AB_x, R AC_x, R x) {
    const R width = AC_x - AB_x;
    const auto wide = abs(width) > R(0);
    const R divisor = select(wide, width, R(1));
    return I_AB * select(wide, (AC_x - x) / divisor, R(1)) +
           I_AC * select(wide, (x - AB_x) / divisor, R(0));
}

/// Phong interpolation on a quadrilateral: C2 of normals.
///
///     N_X = (1 − v)[(1 − u) N_A + u N_B] + v[(1 − u) N_C + u N_D]                        (C4)
///
/// computed as printed, then made a unit vector
/// in, out as C2; the result is 0 where the normals cancel
/// error   ≤ (5 max‖N‖/‖N_X‖ + 4) u a component
/// checks  unit length; opposite normals; by hand     tests/eq/shading_test.cpp
/// source  Phong 1975; the formula sheet
template <Real R>
Vec3<R> bilinear_normal(const Vec3<R>& N_A, const Vec3<R>& N_B, const Vec3<R>& N_C,
                        const Vec3<R>& N_D, R u, R v) {
    return normalise(bilinear(N_A, N_B, N_C, N_D, u, v));
}

/// Phong interpolation along two edges and a span: C3 of normals.
///
///     N_X = N_AB ((AC)_x − x)/((AC)_x − (AB)_x) + N_AC (x − (AB)_x)/((AC)_x − (AB)_x)    (C5)
///
/// computed as printed (N_AB and N_AC by along_edge), then made a unit vector
/// in, out as C3; the result is 0 where the normals cancel
/// error   ≤ (10 max‖N‖/‖N_X‖ + 4) u a component
/// checks  unit length; opposite normals; by hand     tests/eq/shading_test.cpp
/// source  Phong 1975; the formula sheet
template <Real R>
Vec3<R> span_normal(const Vec3<R>& N_AB, const Vec3<R>& N_AC, R AB_x, R AC_x, R x) {
    return normalise(along_span(N_AB, N_AC, AB_x, AC_x, x));
}

/// Attenuation of a light with the distance.
///
///     f_att = 1/(c + l d + q d²), a factor of                                            (C7)
///
/// computed as 1/(c + d (l + q d)), which cannot overflow before the result vanishes
/// in      d        distance, at least the light's radius   > 0           length
///         c, l, q  coefficients ≥ 0, not all 0             1, 1/length, 1/length²
/// out     f_att                                            ≥ 0           1
/// error   ≤ 5 u: all terms are positive
/// checks  by hand; q alone is the inverse square     tests/eq/shading_test.cpp
/// source  the formula sheet; the polynomial is OpenGL's
template <Real R>
R attenuation(R d, Scalar<R> c, Scalar<R> l, Scalar<R> q) {
    return R(1) / mul_add(d, mul_add(R(q), d, R(l)), R(c));
}

/// Ambient term of the illumination of a surface point.
///
///     I = I_a k_a + Σ …                                                                  (C7)
///
/// computed with k_a, which is k_d, as printed, unless a material says otherwise
/// in      I_a      ambient light, a channel          ≥ 0                 radiance
///         k_a      reflectance, a channel            [0, 1]              1
/// out     the sum so far                                                 radiance
/// error   ≤ 1 u
/// checks  C7 by hand, term by term                   tests/eq/shading_test.cpp
/// source  the formula sheet
template <Real R>
Rgb<R> ambient_term(const Rgb<R>& I_a, const Rgb<R>& k_a) {
    return I_a * k_a;
}

/// One light's term of the illumination of a surface point.
///
///     f_att I_i [k_d (N·L) + k_s (R·V)ⁿ], or with (N·H)ⁿ                                 (C7)
///
/// The bracket is phong_reflection (B12), 0 where N·L ≤ 0. The printed ≈ between the two forms is
/// none at equal n: near the highlight (N·H)⁴ⁿ is close to (R·V)ⁿ.
/// in      f_att    attenuation and emission          ≥ 0                 1
///         I_i      light, a channel; kernels pass the irradiance π I_i   radiance
///         bracket  reflected part; kernels pass f_r cosθ_i, which has the 1/π
///         sum      what the term is added to         ≥ 0                 radiance
/// out     sum + the term                                                 radiance
/// error   ≤ 2 u of the term, 1 u of the sum
/// checks  C7 by hand, term by term; exponents 4 n and n   tests/eq/shading_test.cpp
/// source  Phong 1975, Blinn 1977; the formula sheet
template <Real R>
Rgb<R> light_term(R f_att, const Rgb<R>& I_i, const Rgb<R>& bracket,
                  const Rgb<R>& sum = {R(0), R(0), R(0)}) {
    return mul_add(I_i * f_att, bracket, sum);
}

SCANSHADE_TARGET_END;

#endif

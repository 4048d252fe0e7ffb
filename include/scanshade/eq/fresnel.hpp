// Chapter B of the formula sheet, smooth surfaces: mirror, refraction, Fresnel reflectance.
//
// η = η_i/η_o is the ratio of the refractive indices on the side of ω_i and on the other side.
#if defined(SCANSHADE_EQ_FRESNEL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_FRESNEL_HPP
#undef SCANSHADE_EQ_FRESNEL_HPP
#else
#define SCANSHADE_EQ_FRESNEL_HPP
#endif

#include "scanshade/eq/reflection.hpp"
#include "scanshade/num/functions.hpp"

SCANSHADE_TARGET_BEGIN;

/// Snell's law by cosines: cos² of the refracted angle; negative in total internal reflection.
///
///     η_i sinθ_i = η_o sinθ_o                                                            (B9)
///
/// computed as cos²θ_o = (1 − η)(1 + η) + (η cosθ_i)². The usual 1 − η²(1 − cos²θ_i) cancels twice
/// where θ_i is grazing; this sum has positive terms for η ≤ 1 and cancels, for η > 1, only at the
/// critical angle.
/// in      cos_i    n·ω_i                             [0, 1]     1
///         eta      η_i/η_o                           > 0        1
/// out     cos²θ_o                                    ≤ 1        1
/// error   ≤ 4 u (|1 − η²| + η² cos²θ_i)
/// checks  η sinθ_i = sinθ_o; the usual form loses all digits at grazing θ_i
///                                                    tests/eq/fresnel_test.cpp
/// source  the formula sheet
template <Real R>
R snell_cos2(R cos_i, R eta) {
    const R eta_cos = eta * cos_i;
    return (R(1) - eta) * (R(1) + eta) + eta_cos * eta_cos;
}

/// Direction into which ω_i is refracted; ω_i and n on the same side.
///
///     ω_t = −η ω_i − (η cosθ_i + √(1 − η²(1 − cos²θ_i))) n              printed          (B9)
///
/// computed as ω_t = (η − 1)(η + 1)/(η cosθ_i + √(cos²θ_t)) n − η ω_i. Printed, the sign before
/// η cosθ_i does not fulfil Snell's law; the right bracket is +(η cosθ_i − √…), a difference that
/// cancels for η near 1, and equals this quotient.
/// in      wi       direction to the light            unit       1
///         n        normal, n·ω_i ≥ 0                 unit       1
///         eta      η_i/η_o                           > 0        1
/// out     ω_t      unit; 0 in total internal reflection         1
/// error   ≤ 12 max(1, η) u a component away from the critical angle
/// checks  Snell's law, one plane, unit length; the printed form fails; total reflection
///                                                    tests/eq/fresnel_test.cpp
/// source  the formula sheet, with its sign corrected
template <Real R>
Vec3<R> refracted_direction(const Vec3<R>& wi, const Vec3<R>& n, R eta) {
    const R cos_i = dot(wi, n);
    const R cos2 = snell_cos2(cos_i, eta);
    const R sum = max(eta * cos_i + sqrt(max(cos2, R(0))), R(1e-30));
    const R along_n = (eta - R(1)) * (eta + R(1)) / sum;
    return (n * along_n - wi * eta) * select(cos2 < R(0), R(0), R(1));
}

/// Critical angle: where total internal reflection begins.
///
///     θ_i = arcsin(η_o/η_i)                                                              (B10)
///
/// exists only for η_i > η_o; otherwise π/2, the largest angle there is
/// in      eta_oi   η_o/η_i                           > 0        1
/// out     θ_i                                        (0, π/2]   rad
/// error   ≤ 2 u
/// checks  total reflection on one side of it only    tests/eq/fresnel_test.cpp
/// source  the formula sheet
template <Real R>
R critical_angle(R eta_oi) {
    return asin(min(eta_oi, R(1)));
}

/// Radiance behind a smooth surface, of what is not reflected: rays are packed more densely in the
/// medium of the larger index.
///
///     L_o = L_i (η_o/η_i)²                                                               (B10)
///
/// in      L_i      arriving radiance                 ≥ 0        W/(m² sr)
///         eta_oi   η_o/η_i                           > 0        1
/// out     L_o                                        ≥ 0        W/(m² sr)
/// error   ≤ 2 u
/// checks  flux through a refracted cone is kept      tests/eq/fresnel_test.cpp
/// source  the formula sheet
template <Real R>
R refracted_radiance(R L_i, R eta_oi) {
    return L_i * eta_oi * eta_oi;
}

/// What a δ-BRDF or δ-BTDF is under the integral: L_o(ω_o) = weight · L_i(ω_i), of one ω_i.
///
///     f_r cosθ_i = weight · δ(ω_i − ω_i(ω_o)) in                                    (B8), (B10)
///
/// error   none: plain data
/// checks  as ideal_mirror and ideal_refractor        tests/eq/fresnel_test.cpp
/// source  the formula sheet
template <class R>
struct DeltaLobe {
    Vec3<R> wi;
    R weight;
};

/// Ideal mirror.
///
///     L_o(ω_o) = F(ω_i) L_i(ω_i),   f_r = F(ω_i) δ(ω_i − ω_o)/cosθ_i    printed          (B8)
///
/// computed for δ(ω_i − ω_r(ω_o)): printed, light would be reflected to where it comes from.
/// in      wo       direction to the viewer           unit       1
///         n        normal                            unit       1
///         F        reflectance at n·ω_o              [0, 1]     1
/// out     ω_i and its weight
/// error   as B7
/// checks  ω_i has the same θ and the opposite azimuth; the printed ω_i = ω_o has not
///                                                    tests/eq/fresnel_test.cpp
/// source  the formula sheet, with its δ corrected
template <Real R>
DeltaLobe<R> ideal_mirror(const Vec3<R>& wo, const Vec3<R>& n, R F) {
    return {mirror_direction(wo, n), F};
}

/// Fresnel reflectance of a dielectric for light polarised across the plane of incidence.
///
///     F_s = |(η_i cosθ_i − η_o cosθ_o)/(η_i cosθ_i + η_o cosθ_o)|²                       (B11)
///
/// computed as ((η − 1)(η + 1)/(η cosθ_i + cosθ_o)²)²: the printed difference cancels for η near
/// 1, and η² cos²θ_i − cos²θ_o = η² − 1.
/// in      cos_i    n·ω_i                             [0, 1]     1
///         eta      η_i/η_o                           > 0        1
/// out     F_s      1 in total internal reflection    [0, 1]     1
/// error   ≤ 24 u relative for η ≤ 1; for η > 1 the root near the critical angle adds its own
/// checks  r² + t² η-weighted = 1; the printed form fails at η = 1 + 1e-6   tests/eq/fresnel_test.cpp
/// source  Fresnel 1823
template <Real R>
R fresnel_s(R cos_i, R eta) {
    const R cos2 = snell_cos2(cos_i, eta);
    const R sum = max(eta * cos_i + sqrt(max(cos2, R(0))), R(1e-9));
    const R r = (eta - R(1)) * (eta + R(1)) / (sum * sum);
    return select(cos2 < R(0), R(1), r * r);
}

/// The same for light polarised in the plane of incidence.
///
///     F_p = |(η_i cosθ_o − η_o cosθ_i)/(η_i cosθ_o + η_o cosθ_i)|²                       (B11)
///
/// computed as ((η − 1)(η + 1)(1 − (1 + η²) sin²θ_i)/(η cosθ_o + cosθ_i)²)², sin² as
/// (1 − cosθ_i)(1 + cosθ_i). Its zero, Brewster's angle, is in the bracket: there F_p is small and
/// its error is absolute.
/// in      cos_i    n·ω_i                             [0, 1]     1
///         eta      η_i/η_o                           > 0        1
/// out     F_p      1 in total internal reflection    [0, 1]     1
/// error   ≤ 40 u F_p + 20 u √F_p for η ≤ 1
/// checks  0 at Brewster's angle; r² + t² η-weighted = 1   tests/eq/fresnel_test.cpp
/// source  Fresnel 1823
template <Real R>
R fresnel_p(R cos_i, R eta) {
    const R cos2 = snell_cos2(cos_i, eta);
    const R sum = max(eta * sqrt(max(cos2, R(0))) + cos_i, R(1e-9));
    const R sin2 = (R(1) - cos_i) * (R(1) + cos_i);
    const R past_brewster = R(1) - (R(1) + eta * eta) * sin2;
    const R r = (eta - R(1)) * (eta + R(1)) * past_brewster / (sum * sum);
    return select(cos2 < R(0), R(1), r * r);
}

/// Fresnel reflectance of a dielectric for light that is not polarised.
///
///     F = (F_s + F_p)/2                                                                  (B11)
///
/// in      cos_i    n·ω_i; of a facet: h·ω_i          [0, 1]     1
///         eta      η_i/η_o                           > 0        1
/// out     F        1 in total internal reflection    [0, 1]     1
/// error   ≤ 40 u relative for η ≤ 1: F_s outweighs F_p where that has no sure digits
/// checks  F(η, θ_i) = F(1/η, θ_o); F + T = 1; total reflection; normal incidence is F(0) of B19
///                                                    tests/eq/fresnel_test.cpp
/// source  Fresnel 1823
template <Real R>
R fresnel_dielectric(R cos_i, R eta) {
    return min((fresnel_s(cos_i, eta) + fresnel_p(cos_i, eta)) * R(0.5), R(1));
}

/// Ideal refractor.
///
///     f_t(ω_i → ω_o) = (η_o/η_i)² (1 − F(ω_i)) δ(ω_i − ω_o)/cosθ_i       printed         (B10)
///
/// computed for δ(ω_i − ω_t(ω_o)): printed, light would pass without being refracted, or from the
/// wrong side. F has the same value for ω_i and ω_o.
/// in      wo       direction to the viewer           unit       1
///         n        normal on the side of ω_o         unit       1
///         eta_oi   η_o/η_i                           > 0        1
/// out     ω_i, on the other side, and its weight; 0 and 0 in total internal reflection
/// error   as B9, and of the weight ≤ 45 u of (η_o/η_i)²
/// checks  refracting ω_i back gives ω_o; the printed ω_i = ω_o breaks Snell's law
///                                                    tests/eq/fresnel_test.cpp
/// source  the formula sheet, with its δ corrected
template <Real R>
DeltaLobe<R> ideal_refractor(const Vec3<R>& wo, const Vec3<R>& n, R eta_oi) {
    const R F = fresnel_dielectric(dot(wo, n), eta_oi);
    return {refracted_direction(wo, n, eta_oi), refracted_radiance(R(1) - F, eta_oi)};
}

/// Reflectance at normal incidence.
///
///     F(0) = ((η_i − η_o)/(η_i + η_o))²                                                  (B19)
///
/// in      eta      η_i/η_o                           > 0        1
/// out     F(0)                                       [0, 1)     1
/// error   ≤ 7 u: quotient 3, squared 7
/// checks  equals B11 at θ_i = 0; 0.04 for glass      tests/eq/fresnel_test.cpp
/// source  the formula sheet
template <Real R>
R normal_reflectance(R eta) {
    const R r = (eta - R(1)) / (eta + R(1));
    return r * r;
}

/// Schlick's approximation of the Fresnel reflectance.
///
///     F(θ_i) = F(0) + (1 − F(0))(1 − cosθ_i)⁵                                            (B19)
///
/// in      F0       reflectance at normal incidence, a channel   [0, 1]   1
///         cos_i    n·ω_i; of a facet: h·ω_i          [0, 1]     1
/// out     F                                          [F0, 1]    1
/// error   ≤ 10 u: 1 − cosθ_i 1, fifth power 8, product 10; the terms are positive
/// checks  ends at F(0) and 1; within 0.061 of B11 for water   tests/eq/fresnel_test.cpp
/// source  Schlick 1994
template <Real R>
Rgb<R> fresnel_schlick(const Rgb<R>& F0, R cos_i) {
    const R x = R(1) - cos_i, x2 = x * x, x5 = x2 * x2 * x;
    return {F0.r + (R(1) - F0.r) * x5, F0.g + (R(1) - F0.g) * x5, F0.b + (R(1) - F0.b) * x5};
}

SCANSHADE_TARGET_END;

#endif

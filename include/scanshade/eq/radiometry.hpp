// Chapter A of the formula sheet, radiometry: quantities of light, and light sources.
#if defined(SCANSHADE_EQ_RADIOMETRY_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_RADIOMETRY_HPP
#undef SCANSHADE_EQ_RADIOMETRY_HPP
#else
#define SCANSHADE_EQ_RADIOMETRY_HPP
#endif

#include "scanshade/num/vec3.hpp"

SCANSHADE_TARGET_BEGIN;

/// Flux: energy in a time.
///
///     Φ = dQ/dt                                                                          (A7)
///
/// in      dQ       energy                            ≥ 0        J
///         dt       time                              > 0        s
/// out     Φ                                          ≥ 0        W
/// error   ≤ 1 u
/// checks  definitions and their integrals agree      tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R flux(R dQ, R dt) {
    return dQ / dt;
}

/// Irradiance (arriving) or radiosity (leaving): flux on an area.
///
///     E = dΦ/dA                                                                          (A8)
///
/// in      dPhi     flux                              ≥ 0        W
///         dA       area                              > 0        m²
/// out     E                                          ≥ 0        W/m²
/// error   ≤ 1 u
/// checks  definitions and their integrals agree      tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R flux_density(R dPhi, R dA) {
    return dPhi / dA;
}

/// Intensity: flux in a solid angle.
///
///     I = dΦ/dω                                                                          (A9)
///
/// in      dPhi     flux                              ≥ 0        W
///         domega   solid angle                       > 0        sr
/// out     I                                          ≥ 0        W/sr
/// error   ≤ 1 u
/// checks  definitions and their integrals agree      tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R intensity(R dPhi, R domega) {
    return dPhi / domega;
}

/// Radiance: flux on an area that faces the ray, in a solid angle.
///
///     L = d²Φ/(dA dω cosθ)                                                               (A10)
///
/// in      d2Phi    flux                              ≥ 0        W
///         dA       area                              > 0        m²
///         domega   solid angle                       > 0        sr
///         cos_theta between normal and ray           (0, 1]     1
/// out     L                                          ≥ 0        W/(m² sr)
/// error   ≤ 3 u
/// checks  definitions and their integrals agree      tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R radiance(R d2Phi, R dA, R domega, R cos_theta) {
    return d2Phi / (dA * domega * cos_theta);
}

/// Irradiance from one small solid angle: the term of the integral.
///
///     E = ∫ L cosθ dω                                                                    (A11)
///
/// in      L        radiance                          ≥ 0        W/(m² sr)
///         cos_theta between normal and ray           [0, 1]     1
///         domega   solid angle                       ≥ 0        sr
/// out     dE                                         ≥ 0        W/m²
/// error   ≤ 2 u
/// checks  constant L over the hemisphere gives π L   tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R irradiance_term(R L, R cos_theta, R domega) {
    return L * cos_theta * domega;
}

/// Intensity of one small area: the term of the integral.
///
///     I = ∫ L cosθ dA                                                                    (A12)
///
/// in      L        radiance                          ≥ 0        W/(m² sr)
///         cos_theta between normal and ray           [0, 1]     1
///         dA       area                              ≥ 0        m²
/// out     dI                                         ≥ 0        W/sr
/// error   ≤ 2 u
/// checks  a constant sphere has I = π r² L           tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R intensity_term(R L, R cos_theta, R dA) {
    return L * cos_theta * dA;
}

/// Flux from one small area into one small solid angle: the term of the double integral.
///
///     Φ = ∬ L cosθ dω dA                                                                 (A13)
///
/// in      L        radiance                          ≥ 0        W/(m² sr)
///         cos_theta between normal and ray           [0, 1]     1
///         domega   solid angle                       ≥ 0        sr
///         dA       area                              ≥ 0        m²
/// out     dΦ                                         ≥ 0        W
/// error   ≤ 3 u
/// checks  constant L leaves area A with flux π A L   tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R flux_term(R L, R cos_theta, R domega, R dA) {
    return L * cos_theta * domega * dA;
}

/// Cosine (Lambertian) point light, as a factor of I₀.
///
///     I(ω) = I₀ (ω·d),   0 behind                                                        (A14)
///
/// in      w        from the light to the surface     unit       1
///         d        where the light faces             unit       1
/// out     I/I₀                                       [0, 1]     1
/// error   ≤ 3 u, absolute
/// checks  1 ahead, cos 60°, 0 behind; integral π I₀  tests/eq/radiometry_test.cpp
/// source  the formula sheet
template <Real R>
R cosine_light(const Vec3<R>& w, const Vec3<R>& d) {
    return max(dot(w, d), R(0));
}

/// Spot light, as a factor of I₀. τ is the half angle of the cone.
///
///     I(ω) = I₀ where ∠(ω, d) < τ, else 0                                                (A15)
///
/// computed as t²(3 − 2t), t = (cos∠ − cos τ)/(cos(τ − p) − cos τ) limited to [0, 1], for a
/// penumbra of width p inside the cone; the printed form for p = 0. Cosines are compared, which
/// gives the same cone without an arccos.
/// in      w        from the light to the surface     unit       1
///         d        axis of the cone                  unit       1
///         cos_cutoff    cos τ                        [−1, 1]    1
///         inv_penumbra  1/(cos(τ − p) − cos τ); 0: p = 0        1
/// out     I/I₀                                       [0, 1]     1
/// error   cosine ≤ 3 u, absolute: the rim may move by that; inside the penumbra t ≤ 4 u·(1 + inv_penumbra)
/// checks  both sides of the rim; half light in the middle; continuous   tests/eq/radiometry_test.cpp
/// source  the formula sheet; the penumbra is a cubic Hermite step
template <Real R>
R spot_light(const Vec3<R>& w, const Vec3<R>& d, Scalar<R> cos_cutoff, Scalar<R> inv_penumbra) {
    const R above = dot(w, d) - R(cos_cutoff);
    if (!(inv_penumbra > 0)) return select(above > R(0), R(1), R(0));
    const R t = clamp(above * R(inv_penumbra), R(0), R(1));
    return t * t * (R(3) - R(2) * t);
}

SCANSHADE_TARGET_END;

#endif

// Chapter B of the formula sheet, what a BRDF is: definition, reflection equation, energy.
#if defined(SCANSHADE_EQ_REFLECTANCE_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_REFLECTANCE_HPP
#undef SCANSHADE_EQ_REFLECTANCE_HPP
#else
#define SCANSHADE_EQ_REFLECTANCE_HPP
#endif

#include "scanshade/eq/directions.hpp"

SCANSHADE_TARGET_BEGIN;

/// BRDF by its definition: reflected radiance for the irradiance from one direction.
///
///     f_r(ω_i → ω_o) = dL_o(ω_o)/dE(ω_i) = dL_o/(L_i cosθ_i dω_i)                        (B1)
///
/// in      dL_o     reflected radiance                ≥ 0        W/(m² sr)
///         L_i      arriving radiance                 > 0        W/(m² sr)
///         cos_i    between normal and ω_i            (0, 1]     1
///         domega_i solid angle it arrives from       > 0        sr
/// out     f_r                                        ≥ 0        1/sr
/// error   ≤ 3 u
/// checks  undoes B3; Lambert's ρ/π from its radiance   tests/eq/reflectance_test.cpp
/// source  Nicodemus et al. 1977
template <Real R>
R brdf_by_definition(R dL_o, R L_i, R cos_i, R domega_i) {
    return dL_o / (L_i * cos_i * domega_i);
}

/// The three angles that an isotropic BRDF depends on.
///
///     θ_i, θ_o, φ_o − φ_i                                                         in      (B2)
///
/// error   none: plain data
/// checks  as isotropic_angles                        tests/eq/reflectance_test.cpp
/// source  the formula sheet
template <class R>
struct IsotropicAngles {
    R theta_i, theta_o, dphi;
};

/// Isotropy: turning both directions about the normal changes nothing.
///
///     f_r(θ_i, φ_i; θ_o, φ_o) = f_r(θ_i, φ_i + φ; θ_o, φ_o + φ) = f_r(θ_i, θ_o; φ_o − φ_i)  (B2)
///
/// computed with the difference wrapped to [0, 2π)
/// in      wi, wo   directions                        A2         rad
/// out     θ_i, θ_o, φ_o − φ_i                        [0, π/2], [0, π/2], [0, 2π)   rad
/// error   φ ≤ 2 u of 2π; θ none
/// checks  every model gives the same for turned directions   tests/eq/reflectance_test.cpp
/// source  the formula sheet
template <Real R>
IsotropicAngles<R> isotropic_angles(const Spherical<R>& wi, const Spherical<R>& wo) {
    const R difference = wo.phi - wi.phi;
    const R wrapped = select(difference < R(0), difference + R(2 * pi), difference);
    return {wi.theta, wo.theta, select(wrapped < R(2 * pi), wrapped, R(0))};
}

/// Radiance reflected from one small solid angle: the term of the reflection equation.
///
///     L_o(ω_o) = ∫ f_r(ω_i → ω_o) L_i(ω_i) cosθ_i dω_i                                   (B3)
///
/// in      f_cos    f_r cosθ_i                        ≥ 0        1/sr
///         L_i      arriving radiance                 ≥ 0        W/(m² sr)
///         domega_i solid angle it arrives from       ≥ 0        sr
/// out     dL_o                                       ≥ 0        W/(m² sr)
/// error   ≤ 2 u
/// checks  undone by B1; constant L_i gives ρ L_i     tests/eq/reflectance_test.cpp
/// source  the formula sheet
template <Real R>
R reflected_term(R f_cos, R L_i, R domega_i) {
    return f_cos * L_i * domega_i;
}

/// Share of the arriving energy that leaves again; at most 1 for a passive surface.
///
///     B/E = ∫ L_o cosθ_o dω_o / ∫ L_i cosθ_i dω_i ≤ 1                                    (B4)
///
/// in      B        radiosity: what leaves            ≥ 0        W/m²
///         E        irradiance: what arrives          > 0        W/m²
/// out     B/E                                        [0, 1]     1
/// error   ≤ 1 u
/// checks  double integral of Lambert gives ρ; every model as it promises
///                                                    tests/eq/reflectance_test.cpp
/// source  the formula sheet
template <Real R>
R energy_ratio(R B, R E) {
    return B / E;
}

/// Albedo from one small solid angle: the term of the integral.
///
///     ρ(ω_o) = ∫ f_r(ω_i → ω_o) cosθ_i dω_i                                              (B5)
///
/// in      f_cos    f_r cosθ_i                        ≥ 0        1/sr
///         domega_i solid angle                       ≥ 0        sr
/// out     dρ                                         ≥ 0        1
/// error   ≤ 1 u
/// checks  Lambert's is ρ_d; every model as it promises   tests/eq/reflectance_test.cpp
/// source  the formula sheet
template <Real R>
R albedo_term(R f_cos, R domega_i) {
    return f_cos * domega_i;
}

SCANSHADE_TARGET_END;

#endif

// Chapter B of the formula sheet: reflection.
#if defined(SCANSHADE_EQ_REFLECTION_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_REFLECTION_HPP
#undef SCANSHADE_EQ_REFLECTION_HPP
#else
#define SCANSHADE_EQ_REFLECTION_HPP
#endif

#include "scanshade/num/exponent.hpp"
#include "scanshade/num/functions.hpp"
#include "scanshade/num/rgb.hpp"
#include "scanshade/num/vec3.hpp"

SCANSHADE_TARGET_BEGIN;

/// Lambert's BRDF: the same radiance in every direction.
///
///     f_r = ρ_d/π                                                                        (B6)
///
/// in      rho_d    albedo, a channel                 [0, 1]              1
/// out     f_r                                        [0, 1/π]            1/sr
/// error   ≤ 2 u: 1/π is rounded, and the product
/// checks  albedo is ρ_d by quadrature                tests/eq/reflection_test.cpp
/// source  Lambert 1760
template <Real R>
Rgb<R> lambert_brdf(const Rgb<R>& rho_d) {
    return rho_d * inv_pi_as<R>();
}

/// Mirror direction of ω_i at a surface with normal n.
///
///     ω_r = 2 (ω_i·n) n − ω_i                                                            (B7)
///
/// in      wi       direction to the light            unit                1
///         n        normal                            unit                1
/// out     ω_r                                        unit                1
/// error   ≤ 9 u a component: cosine 3, doubled exactly, products 1, difference 1
/// checks  ω_r·n = ω_i·n; twice is the identity       tests/eq/reflection_test.cpp
/// source  the formula sheet
template <Real R>
Vec3<R> mirror_direction(const Vec3<R>& wi, const Vec3<R>& n) {
    return n * (R(2) * dot(wi, n)) - wi;
}

/// cosˢ of a cosine, for specular highlights.
///
///     xˢ in                                                                              (B12)
///
/// computed as x^⌊s⌋ by squaring, times exp(f·log x) for the fraction f of s, which most materials
/// do not have. s = 0 gives 1, at x = 0 too; otherwise x ≤ 0 gives 0, and so does a power below 2^-100.
/// in      x        cosine                            ≤ 1                 1
///         s        exponent                          [0, 4e9]            1
/// out     xˢ                                         [0, 1]              1
/// error   x taken as exact: ≤ (s − 1) u relative for a whole s ≥ 1, as each squaring doubles the
///         error and adds a rounding; a fraction adds (4 + 10 f |log x|) u for log's 4 ulp and
///         exp's 1
/// checks  against long double to the bound, every s from 0 to 1e6   tests/eq/reflection_test.cpp
/// source  binary powering, Knuth vol. 2, 4.6.3
template <Real R>
R pow_shininess(R x, const Exponent& s) {
    const auto positive = x > R(s.least);
    R base = select(positive, x, R(0));
    R result = R(1);
    for (std::uint32_t bits = s.whole; bits != 0; bits >>= 1) {
        if (bits & 1) result = result * base;
        if (bits > 1) base = base * base;
    }
    if (s.fraction > 0) {
        const R log_x = log(select(positive, x, R(1)));
        result = result * select(positive, exp(R(s.fraction) * log_x), R(0));
    }
    return result;
}

/// Phong reflection of one light: what of L_i leaves towards the viewer.
///
///     L_o = L_i (k_d cosθ_i + k_s cosⁿθ_r)                                               (B12)
///
/// computed for L_i = 1. Blinn's form is the same function with cosθ_h for cosθ_r.
/// in      k_d, k_s reflectance, a channel            [0, 1]              1
///         n        exponent                          [0, 1e6]            1
///         cos_i    n·ω_i                             (0, 1]              1
///         cos_r    ω_r·ω_o or n·h                    [0, 1]              1
/// out     L_o/L_i                                    [0, 2]              1
/// error   ≤ (n + 7) u for a whole n, of terms that are all positive: the power (n − 1),
///         its product 1, sum 1; see pow_shininess for the rest
/// checks  diffuse and specular alone; n = 0          tests/eq/reflection_test.cpp
/// source  Phong 1975
template <Real R>
Rgb<R> phong_reflection(const Rgb<R>& k_d, const Rgb<R>& k_s, const Exponent& n, R cos_i, R cos_r) {
    return mul_add(k_s, pow_shininess(cos_r, n), k_d * cos_i);
}

/// Phong reflection as a BRDF, times cosθ_i.
///
///     f_r = k_d + k_s cosⁿθ_r/cosθ_i                                    printed          (B13)
///
/// computed as f_r cosθ_i = k_d/π cosθ_i + k_s/π cosⁿθ_r: f_r is unbounded where θ_i is grazing,
/// f_r cosθ_i is not; and k/π is the same for all lights. The printed k_d and k_s are in 1/sr; here they are those of C7, larger by π.
/// in      as B12
/// out     f_r cosθ_i                                 [0, 2/π]            1/sr
/// error   that of B12 and 2 u
/// checks  finite at grazing θ_i, where the printed form is not; π f_r cosθ_i is B12
///                                                    tests/eq/reflection_test.cpp
/// source  Phong 1975
template <Real R>
Rgb<R> phong_f_cos(const Rgb<R>& k_d, const Rgb<R>& k_s, const Exponent& n, R cos_i, R cos_r) {
    const R inv_pi = inv_pi_as<R>();
    return phong_reflection(k_d * inv_pi, k_s * inv_pi, n, cos_i, cos_r);
}

/// Modified Phong reflection, normalised so that it keeps energy and is reciprocal.
///
///     f_r = ρ_d/π + ρ_s (n + 2)/(2π) cosⁿθ_r,   ρ_d + ρ_s ≤ 1                            (B14)
///
/// in      rho_d, rho_s  albedos, a channel           [0, 1]              1
///         n        exponent                          [0, 1e6]            1
///         n_plus_2 the same number plus 2            [2, 1e6 + 2]        1
///         cos_r    ω_r·ω_o                           [0, 1]              1
/// out     f_r                                        ≥ 0                 1/sr
/// error   that of pow_shininess and 5 u, of positive terms
/// checks  albedo at normal incidence is ρ_d + ρ_s for every n   tests/eq/reflection_test.cpp
/// source  Lafortune and Willems 1994
template <Real R>
Rgb<R> modified_phong_brdf(const Rgb<R>& rho_d, const Rgb<R>& rho_s, const Exponent& n, R n_plus_2,
                           R cos_r) {
    const R lobe = n_plus_2 * R(0.5) * pow_shininess(cos_r, n);
    return (rho_d + rho_s * lobe) * inv_pi_as<R>();
}

/// Half vector: the normal of the mirror that would show the light to the viewer.
///
///     h = (ω_i + ω_o)/‖ω_i + ω_o‖                                                        (B15)
///
/// computed as printed; opposite directions have none and give the zero vector
/// in      wi, wo   directions to light and viewer    unit                1
/// out     h                                          unit, or 0          1
/// error   ≤ 5 u of ‖ω_i + ω_o‖⁻¹ a component: the sum cancels as the directions become opposite
/// checks  equal angles to both; opposite directions give 0   tests/eq/reflection_test.cpp
/// source  Blinn 1977
template <Real R>
Vec3<R> half_vector(const Vec3<R>& wi, const Vec3<R>& wo) {
    return normalise(wi + wo);
}

/// The two coefficients of Oren and Nayar's model, once a material.
///
///     A = 1 − σ²/(2(σ² + 0.33)),   B = 0.45 σ²/(σ² + 0.09), for                          (B20)
///
/// error   none: plain data
/// checks  as oren_nayar_coefficients                 tests/eq/reflection_test.cpp
/// source  Oren and Nayar 1994
template <class R>
struct OrenNayarCoefficients {
    R A, B;
};

/// Coefficients of Oren and Nayar's model from the spread of slopes.
///
///     A = 1 − σ²/(2(σ² + 0.33)),   B = 0.45 σ²/(σ² + 0.09)                               (B20)
///
/// in      sigma    standard deviation of the facets' angle   [0, π/2]    rad
/// out     A, B                                       [0.56, 1], [0, 0.44]   1
/// error   ≤ 6 u
/// checks  σ = 0 is Lambert: A = 1, B = 0             tests/eq/reflection_test.cpp
/// source  Oren and Nayar 1994
template <Real R>
OrenNayarCoefficients<R> oren_nayar_coefficients(R sigma) {
    const R s2 = sigma * sigma;
    return {R(1) - R(0.5) * s2 / (s2 + R(0.33)), R(0.45) * s2 / (s2 + R(0.09))};
}

/// Oren and Nayar's reflection of a rough diffuse surface, times cosθ_i.
///
///     f_r = ρ/π (A + B max(0, cos(θ_i − θ_o)) sinα tanβ)                printed          (B20)
///
/// computed as f_r cosθ_i = ρ/π cosθ_i (A + B max(0, s)/max(cosθ_i, cosθ_o)), with
/// s = sinθ_i sinθ_o cos(φ_i − φ_o) = (n × ω_i)·(n × ω_o). The cosine is of the difference of
/// azimuths. α and β are the larger and the smaller angle, so sinα tanβ = sinθ_i sinθ_o/cosβ, and
/// s is defined where an angle is 0 and there is no azimuth. cosθ_i ≤ cosβ: the product with cosθ_i
/// is bounded where tanβ is not.
/// in      rho      albedo, a channel                 [0, 1]              1
///         k        A and B                                               1
///         n_i, n_o cosθ_i, cosθ_o, not both 0        [0, 1]              1
///         s        see above                         [−1, 1]             1
/// out     f_r cosθ_i                                 [0, 1/π·1.1]        1/sr
/// error   ≤ 9 u, of positive terms
/// checks  σ = 0 is Lambert; a turn about the normal changes nothing, with the printed cosine it
///         does not depend on azimuths at all; finite at grazing angles   tests/eq/reflection_test.cpp
/// source  Oren and Nayar 1994
template <Real R>
Rgb<R> oren_nayar_f_cos(const Rgb<R>& rho, const OrenNayarCoefficients<R>& k, R n_i, R n_o, R s) {
    const R share = n_i / max(n_i, n_o);
    return rho * ((k.A * n_i + k.B * max(s, R(0)) * share) * inv_pi_as<R>());
}

/// Cosine between the normal and the half vector, without the vector itself.
///
///     n·h = n·(ω_i + ω_o)/‖ω_i + ω_o‖                                                    (B15)
///
/// computed as (n·ω_i + n·ω_o)/‖ω_i + ω_o‖, from cosines that shading has anyway, limited to [0, 1];
/// opposite directions have no half vector and give 0
/// in      cos_i, cos_o  n·ω_i and n·ω_o              [−1, 1]             1
///         wi, wo   directions to light and viewer    unit                1
/// out     n·h                                        [0, 1]              1
/// error   ≤ 12 u ‖ω_i + ω_o‖⁻¹: as B15, no worse than the vector's own
/// checks  equals n·half_vector                       tests/eq/reflection_test.cpp
/// source  Blinn 1977
template <Real R>
R cos_half(R cos_i, R cos_o, const Vec3<R>& wi, const Vec3<R>& wo) {
    const Vec3<R> sum = wi + wo;
    return clamp((cos_i + cos_o) * inverse_length(dot(sum, sum)), R(0), R(1));
}

SCANSHADE_TARGET_END;

#endif

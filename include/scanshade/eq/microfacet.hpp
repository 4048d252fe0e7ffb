// Chapter B of the formula sheet, rough surfaces of small mirrors: Torrance and Sparrow's model,
// distributions of facets and their shadowing.
//
// θ_h is the angle between the half vector h and the normal. Near the highlight cosθ_h rounds to 1
// and its sine is lost; so the distributions take sin²θ_h = |n × h|² beside the cosine.
#if defined(SCANSHADE_EQ_MICROFACET_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_EQ_MICROFACET_HPP
#undef SCANSHADE_EQ_MICROFACET_HPP
#else
#define SCANSHADE_EQ_MICROFACET_HPP
#endif

#include "scanshade/num/functions.hpp"
#include "scanshade/num/rgb.hpp"

SCANSHADE_TARGET_BEGIN;

/// Normalisation c of the Gaussian distribution: ∫ c e^(−θ_h²/m²) cosθ_h dω = 1.
///
///     1/c = π ∫ e^(−θ²/m²) sin 2θ dθ, 0 ≤ θ ≤ π/2, for                                   (B17a)
///
/// computed as π m ∫ e^(−t²) sin(2 m t) dt, 0 ≤ t ≤ min(π/(2m), 9), by Gauss's rule of five points
/// in 40 parts; once a material.
/// in      m        roughness                         [1e-6, 1]  1
/// out     c                                          ≥ 0.58     1/sr
/// error   ≤ 1e-14 + 100 u relative; the tail beyond t = 9 is below e⁻⁸¹
/// checks  against Dawson's function for small m; ∫ D cosθ_h dω = 1   tests/eq/microfacet_test.cpp
/// source  derived; the nodes are those of Abramowitz and Stegun 25.4.30
template <Real R>
R gaussian_norm(R m) {
    constexpr double node[] = {0, 0.53846931010568309104, 0.90617984593866399280};
    constexpr double weight[] = {0.56888888888888888889, 0.47862867049936646804,
                                 0.23692688505618908751};
    constexpr int parts = 40;
    const R half_part = min(R(pi / 2) / m, R(9)) * R(0.5 / parts);
    R sum = R(0);
    for (int part = 0; part < parts; ++part)
        for (int k = -2; k <= 2; ++k) {
            const int i = k < 0 ? -k : k;
            const R t = half_part * R(2 * part + 1 + (k < 0 ? -node[i] : node[i]));
            sum = sum + exp(-(t * t)) * sin(R(2) * m * t) * R(weight[i]);
        }
    return inv_pi_as<R>() / (m * half_part * sum);
}

/// Gaussian distribution of facet normals.
///
///     D(h) = e^(−θ_h²/m²)                                               printed          (B17a)
///
/// computed as c e^(−(θ_h/m)²) with c from gaussian_norm, θ_h by atan2: printed, the integral of
/// D cosθ_h is 0.03 at m = 0.1 and 1.7 at m = 1 instead of 1.
/// in      n_h      cosθ_h                            [0, 1]     1
///         sin2_h   sin²θ_h                           [0, 1]     1
///         m        roughness                         [1e-6, 1]  1
///         c        normalisation                     > 0        1/sr
/// out     D                                          [0, c]     1/sr
/// error   ≤ (20 x + 6) u relative, x = (θ_h/m)², until it underflows at x = 87 (float)
/// checks  ∫ D cosθ_h dω = 1; the printed form's is 0.031 and 1.72   tests/eq/microfacet_test.cpp
/// source  Torrance and Sparrow 1967; normalised here
template <Real R>
R D_gaussian(R n_h, R sin2_h, R m, R c) {
    const R x = atan2(sqrt(sin2_h), n_h) / m;
    return c * exp(-(x * x));
}

/// Blinn's distribution of facet normals.
///
///     D(h) = (n·h)^(2/m² − 2)/(π m²)                                                     (B17b)
///
/// computed as e^((1 − m)(1 + m)/m² · log cos²θ_h)/(π m²), the logarithm as log(1 − sin²θ_h) by
/// log1p for small angles. Squaring to an exponent of 2e6 would lose all digits of a float.
/// in      n_h      cosθ_h, from 1e-15                [0, 1]     1
///         sin2_h   sin²θ_h                           [0, 1]     1
///         m        roughness                         [1e-6, 1]  1
/// out     D                                          [0, 1/(πm²)]   1/sr
/// error   ≤ (14 x + 8) u relative, x the exponent of e without its sign
/// checks  ∫ D cosθ_h dω = 1; m = 1 gives 1/π         tests/eq/microfacet_test.cpp
/// source  Blinn 1977, Walter et al. 2007
template <Real R>
R D_blinn(R n_h, R sin2_h, R m) {
    const R m2 = m * m;
    const R near = log1p(-min(sin2_h, R(0.5))), far = log(max(n_h * n_h, R(1e-30)));
    const R log_cos2 = select(sin2_h < R(0.5), near, far);
    return inv_pi_as<R>() / m2 * exp((R(1) - m) * (R(1) + m) / m2 * log_cos2);
}

/// Beckmann's distribution of facet normals.
///
///     D(h) = e^(((n·h)² − 1)/(m² (n·h)²))/(π m² (n·h)⁴)                                  (B17c)
///
/// computed with sin²θ_h for 1 − (n·h)², and (n·h)² no less than 1e-6: below that D is e^(−1e6) or
/// less, which is 0, and the printed form is 0/0.
/// in      n_h      cosθ_h                            [0, 1]     1
///         sin2_h   sin²θ_h                           [0, 1]     1
///         m        roughness                         [1e-6, 1]  1
/// out     D                                          [0, 1.1/(πm²)]   1/sr
/// error   ≤ (6 x + 12) u relative, x = tan²θ_h/m²
/// checks  ∫ D cosθ_h dω = 1; 0 at grazing h, where the printed form is NaN
///                                                    tests/eq/microfacet_test.cpp
/// source  Beckmann and Spizzichino 1963, Walter et al. 2007
template <Real R>
R D_beckmann(R n_h, R sin2_h, R m) {
    const R cos2 = max(n_h * n_h, R(1e-6)), m2_cos2 = m * m * cos2;
    return inv_pi_as<R>() / (m2_cos2 * cos2) * exp(-(sin2_h / m2_cos2));
}

/// GGX (Trowbridge–Reitz) distribution of facet normals.
///
///     D(h) = m²/(π ((n·h)² (m² − 1) + 1)²)                                               (B17d)
///
/// computed as q²/π, q = m/(sin²θ_h + (m n·h)²), the same function: the printed form subtracts
/// nearly equal numbers in the highlight and loses 2 log₂(1/m) bits there; this one only adds.
/// in      n_h      cosθ_h                            [0, 1]     1
///         sin2_h   sin²θ_h, not 0 with n_h           [0, 1]     1
///         m        roughness                         [1e-6, 1]  1
/// out     D                                          [0, 1/(πm²)]   1/sr
/// error   ≤ 13 u, by counting roundings: product 1, square 3, sum 4, quotient 5, square 11, /π 13
/// checks  ∫ D cosθ_h dω = 1; m = 1 gives 1/π; the printed form is off by 10 % at m = 0.001 in float
///                                                    tests/eq/microfacet_test.cpp
/// source  Walter, Marschner, Li, Torrance 2007, eq. 33
template <Real R>
R D_ggx(R n_h, R sin2_h, R m) {
    const R m_cos = m * n_h;
    const R q = m / (sin2_h + m_cos * m_cos);
    return q * q * inv_pi_as<R>();
}

/// Shadowing and masking by V-shaped cavities.
///
///     G = min{1, 2 (n·h)(n·ω_o)/(ω_o·h), 2 (n·h)(n·ω_i)/(ω_o·h)}                         (B18a)
///
/// computed with negative cosines as 0, and 0 where ω_i = −ω_o has no half vector
/// in      n_i, n_o n·ω_i, n·ω_o                      ≤ 1        1
///         n_h      n·h                               [0, 1]     1
///         i_h      ω_i·h = ω_o·h                     [0, 1]     1
/// out     G                                          [0, 1]     1
/// error   ≤ 3 u
/// checks  by hand; symmetric; [0, 1] at grazing and negative cosines   tests/eq/microfacet_test.cpp
/// source  Torrance and Sparrow 1967
template <Real R>
R G_v_cavity(R n_i, R n_o, R n_h, R i_h) {
    const R facet = R(2) * n_h / max(i_h, R(1e-18));
    return min(R(1), facet * max(min(n_i, n_o), R(0)));
}

/// Smith's masking of one direction by GGX, over its cosine, which cancels in B16.
///
///     G(ω)/(n·ω) = 2/((n·ω) + √(m² + (1 − m²)(n·ω)²)), a part of                         (B18b)
///
/// in      cos      n·ω; negative counts as 0         ≤ 1        1
///         m        roughness                         [1e-6, 1]  1
/// out     G/cosθ                                     [1, 2/m]   1
/// error   ≤ 6 u: the sums have positive terms
/// checks  as smith_over_4_cos_o                      tests/eq/microfacet_test.cpp
/// source  Walter et al. 2007, eq. 34
template <Real R>
R G1_smith_over_cos(R cos, R m) {
    const R c = max(cos, R(0));
    return R(2) / (c + sqrt(m * m + (R(1) - m) * (R(1) + m) * c * c));
}

/// Shadowing and masking after Smith, over 4 cosθ_o as B16 needs it.
///
///     G(ω_i, ω_o) = G(ω_i) G(ω_o)                                                        (B18b)
///
/// computed as cosθ_i · G(ω_i)/cosθ_i · G(ω_o)/cosθ_o / 4, so nothing is 0/0 at grazing angles
/// in      n_i, n_o n·ω_i, n·ω_o; negative counts as 0   ≤ 1     1
///         m        roughness                         [1e-6, 1]  1
/// out     G/(4 cosθ_o)                               [0, 1/(2m)]   1
/// error   ≤ 15 u
/// checks  G by hand and against the printed form; finite at cosθ_o = 0   tests/eq/microfacet_test.cpp
/// source  Smith 1967; Walter et al. 2007, eq. 34
template <Real R>
R smith_over_4_cos_o(R n_i, R n_o, R m) {
    return max(n_i, R(0)) * G1_smith_over_cos(n_i, m) * G1_smith_over_cos(n_o, m) * R(0.25);
}

/// V-cavity shadowing over 4 cosθ_o as B16 needs it.
///
///     G/(4 cosθ_o), with the G of                                                        (B18a)
///
/// in      as G_v_cavity, but n_o ≥ 1e-12
/// out     G/(4 cosθ_o)                               [0, 2.5e11]   1
/// error   ≤ 4 u
/// checks  by hand; finite at grazing angles          tests/eq/microfacet_test.cpp
/// source  Torrance and Sparrow 1967
template <Real R>
R v_cavity_over_4_cos_o(R n_i, R n_o, R n_h, R i_h) {
    return G_v_cavity(n_i, n_o, n_h, i_h) / (R(4) * n_o);
}

/// Torrance and Sparrow's reflection of a rough surface, times cosθ_i.
///
///     f_r = F(θ_i) G(ω_i, ω_o) D(h)/(4 cosθ_i cosθ_o)                   printed          (B16)
///
/// computed as f_r cosθ_i = F(ω_i·h) · G/(4 cosθ_o) · D. The facet's own angle is that of the half
/// vector: with θ_i of the surface, as printed, the model is not reciprocal.
/// in      F        Fresnel reflectance at ω_i·h, a channel   [0, 1]   1
///         G_over_4_cos_o   B18                       ≥ 0        1
///         D        B17                               ≥ 0        1/sr
/// out     f_r cosθ_i                                 ≥ 0        1/sr
/// error   ≤ 2 u and those of its factors
/// checks  reciprocal; the printed F(θ_i) is not      tests/eq/microfacet_test.cpp
/// source  Torrance and Sparrow 1967; Walter et al. 2007, eq. 20
template <Real R>
Rgb<R> torrance_sparrow_f_cos(const Rgb<R>& F, R G_over_4_cos_o, R D) {
    return F * (G_over_4_cos_o * D);
}

SCANSHADE_TARGET_END;

#endif

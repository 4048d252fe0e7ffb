// The equations of the formula sheet as they are printed, misprints included, evaluated from left to
// right in whatever type of number. The stability report and the tests measure eq/ against them;
// nothing is drawn with them. The functions have the names of their counterparts in eq/, where each
// docstring shows the same formula.
#pragma once

#include "scanshade/eq/fresnel.hpp"
#include "scanshade/eq/microfacet.hpp"
#include "scanshade/eq/raycast.hpp"
#include "scanshade/eq/reflection.hpp"
#include "scanshade/eq/shading.hpp"
#include "scanshade/num/functions.hpp"
#include "scanshade/num/vec3.hpp"
#include "scanshade/num/wide.hpp"

namespace scanshade::printed {

template <ScalarReal R>
R pow(R x, R y) {
    return std::pow(x, y);
}
template <Real R>
R pi_as() {
    return R(1) / inv_pi_as<R>();
}
template <Real R>
R square(R x) {
    return x * x;
}
/// arctan x, in (−π/2, π/2).
template <Real R>
R atan(R x) {
    return atan2(x, R(1));
}
template <Real R>
R tan(R x) {
    return sin(x) / cos(x);
}
/// v/‖v‖, whatever the length.
template <Real R>
Vec3<R> unit(const Vec3<R>& v) {
    const R length = sqrt(dot(v, v));
    return {v.x / length, v.y / length, v.z / length};
}

// ---- A  Directions and radiometry

/// (A3) θ = arccos z
template <Real R>
R polar_angle(const Vec3<R>& w) {
    return acos(w.z);
}
/// (A3) φ = arctan(y/x): two quadrants of four
template <Real R>
R azimuth(const Vec3<R>& w) {
    return atan(w.y / w.x);
}
/// (A14) I/I₀ = ω·d
template <Real R>
R cosine_light(const Vec3<R>& w, const Vec3<R>& d) {
    return dot(w, d);
}
/// (A15) I/I₀ = 1 where ∠(ω, d) < τ
template <Real R>
R spot_light(const Vec3<R>& w, const Vec3<R>& d, R tau) {
    return select(acos(dot(w, d)) < tau, R(1), R(0));
}

// ---- B  Reflection

/// (B8), (B10) the ω_i that δ(ω_i − ω_o) selects
template <Real R>
Vec3<R> delta_direction(const Vec3<R>& wo) {
    return wo;
}
/// (B9) the root of the refracted direction, squared: 1 − η²(1 − cos²θ_i)
template <Real R>
R snell_cos2(R cos_i, R eta) {
    return R(1) - square(eta) * (R(1) - square(cos_i));
}
/// (B9) ω_t = −η ω_i − (η cosθ_i + √(1 − η²(1 − cos²θ_i))) n
template <Real R>
Vec3<R> refracted_direction(const Vec3<R>& wi, const Vec3<R>& n, R eta) {
    const R cos_i = dot(wi, n);
    return wi * -eta - n * (eta * cos_i + sqrt(printed::snell_cos2(cos_i, eta)));
}
/// (B10) θ = arcsin(η_o/η_i)
template <Real R>
R critical_angle(R eta_oi) {
    return asin(eta_oi);
}
/// (B11) F_s, with cosθ_o by (B9)
template <Real R>
R fresnel_s(R cos_i, R eta) {
    const R cos_o = sqrt(printed::snell_cos2(cos_i, eta));
    return square((eta * cos_i - cos_o) / (eta * cos_i + cos_o));
}
/// (B11) F_p
template <Real R>
R fresnel_p(R cos_i, R eta) {
    const R cos_o = sqrt(printed::snell_cos2(cos_i, eta));
    return square((eta * cos_o - cos_i) / (eta * cos_o + cos_i));
}
/// (B11) F = (F_s + F_p)/2
template <Real R>
R fresnel_dielectric(R cos_i, R eta) {
    return (printed::fresnel_s(cos_i, eta) + printed::fresnel_p(cos_i, eta)) / R(2);
}
/// (B12) L_o/L_i = k_d cosθ_i + k_s cosⁿθ_r
template <Real R>
R phong_reflection(R k_d, R k_s, R n, R cos_i, R cos_r) {
    return k_d * cos_i + k_s * pow(cos_r, n);
}
/// (B13) f_r = k_d + k_s cosⁿθ_r/cosθ_i
template <Real R>
R phong_brdf(R k_d, R k_s, R n, R cos_i, R cos_r) {
    return k_d + k_s * pow(cos_r, n) / cos_i;
}
/// (B14) f_r = ρ_d/π + ρ_s (n + 2)/(2π) cosⁿθ_r
template <Real R>
R modified_phong_brdf(R rho_d, R rho_s, R n, R cos_r) {
    return rho_d / pi_as<R>() + rho_s / (R(2) * pi_as<R>()) * (n + R(2)) * pow(cos_r, n);
}
/// (B15) h = (ω_i + ω_o)/‖ω_i + ω_o‖
template <Real R>
Vec3<R> half_vector(const Vec3<R>& wi, const Vec3<R>& wo) {
    return unit(wi + wo);
}
/// (B16) f_r = F G D/(4 cosθ_i cosθ_o); the sheet takes F at θ_i
template <Real R>
R torrance_sparrow_brdf(R F, R G, R D, R cos_i, R cos_o) {
    return F * G * D / (R(4) * cos_i * cos_o);
}
/// (B17a) D = e^(−θ_h²/m²): not normalised
template <Real R>
R D_gaussian(R n_h, R m) {
    return exp(-square(acos(n_h)) / square(m));
}
/// (B17b) D = (n·h)^(2/m² − 2)/(π m²)
template <Real R>
R D_blinn(R n_h, R m) {
    return pow(n_h, R(2) / square(m) - R(2)) / (pi_as<R>() * square(m));
}
/// (B17c) D = e^(((n·h)² − 1)/(m² (n·h)²))/(π m² (n·h)⁴)
template <Real R>
R D_beckmann(R n_h, R m) {
    const R c2 = square(n_h), m2 = square(m);
    return exp((c2 - R(1)) / (m2 * c2)) / (pi_as<R>() * m2 * square(c2));
}
/// (B17d) D = m²/(π ((n·h)² (m² − 1) + 1)²)
template <Real R>
R D_ggx(R n_h, R m) {
    const R m2 = square(m);
    return m2 / (pi_as<R>() * square(square(n_h) * (m2 - R(1)) + R(1)));
}
/// (B18a) G = min{1, 2 (n·h)(n·ω_o)/(ω_o·h), 2 (n·h)(n·ω_i)/(ω_o·h)}
template <Real R>
R G_v_cavity(R n_i, R n_o, R n_h, R o_h) {
    return min(R(1), min(R(2) * n_h * n_o / o_h, R(2) * n_h * n_i / o_h));
}
/// (B18b) G(ω) = 2 (n·ω)/((n·ω) + √(m² + (1 − m²)(n·ω)²))
template <Real R>
R G1_smith(R cos, R m) {
    return R(2) * cos / (cos + sqrt(square(m) + (R(1) - square(m)) * square(cos)));
}
/// (B19) F = F(0) + (1 − F(0))(1 − cosθ_i)⁵
template <Real R>
R fresnel_schlick(R F0, R cos_i) {
    return F0 + (R(1) - F0) * pow(R(1) - cos_i, R(5));
}
/// (B20) f_r = ρ/π (A + B max(0, cosine) sinα tanβ); the sheet's cosine is cos(θ_i − θ_o)
template <Real R>
R oren_nayar_brdf(R rho, R sigma, R theta_i, R theta_o, R cosine) {
    const R s2 = square(sigma);
    const R A = R(1) - s2 / (R(2) * (s2 + R(0.33))), B = R(0.45) * s2 / (s2 + R(0.09));
    const R alpha = max(theta_i, theta_o), beta = min(theta_i, theta_o);
    return rho / pi_as<R>() * (A + B * max(R(0), cosine) * sin(alpha) * tan(beta));
}

// ---- C  Shading

/// (C1) N = Σ N_i/‖Σ N_i‖
template <Real R>
Vec3<R> vertex_normal(const Vec3<R>& sum) {
    return unit(sum);
}
/// (C3) I_AB = I_A (y − B_y)/(A_y − B_y) + I_B (A_y − y)/(A_y − B_y)
template <Real R, class Value>
Value along_edge(const Value& I_A, const Value& I_B, R A_y, R B_y, R y) {
    return I_A * ((y - B_y) / (A_y - B_y)) + I_B * ((A_y - y) / (A_y - B_y));
}
/// (C3) I_X = I_AB ((AC)_x − x)/((AC)_x − (AB)_x) + I_AC (x − (AB)_x)/((AC)_x − (AB)_x)
template <Real R, class Value>
Value along_span(const Value& I_AB, const Value& I_AC, R AB_x, R AC_x, R x) {
    return I_AB * ((AC_x - x) / (AC_x - AB_x)) + I_AC * ((x - AB_x) / (AC_x - AB_x));
}
/// (C7) f_att = 1/(c + l d + q d²)
template <Real R>
R attenuation(R d, R c, R l, R q) {
    return R(1) / (c + l * d + q * square(d));
}
/// (C7) k_d (N·L) + k_s (R·V)ⁿ, negative cosines and all
template <Real R>
R light_term(R k_d, R k_s, R n, R n_l, R r_v) {
    return k_d * n_l + k_s * pow(r_v, n);
}

// ---- D  Ray casting

/// (D2) u u_x + v v_x = x − P_x, u u_y + v v_y = y − P_y, by Cramer's rule
template <Real R>
PlaneCoordinates<R> plane_coordinates(const Vec3<R>& X, const Vec3<R>& P, const Vec3<R>& u,
                                      const Vec3<R>& v) {
    const Vec3<R> w = X - P;
    const R determinant = u.x * v.y - u.y * v.x;
    return {(w.x * v.y - w.y * v.x) / determinant, (u.x * w.y - u.y * w.x) / determinant};
}
/// (D3) v = S − P_0, t_0 = v·p_1, D² = v·v − t_0², t² = R² − D², hits at t_0 ± t
template <Real R>
SphereHits<R> ray_sphere(const Vec3<R>& P0, const Vec3<R>& p1, const Vec3<R>& S, R radius) {
    const Vec3<R> v = S - P0;
    const R t0 = dot(v, p1);
    const R t2 = square(radius) - (dot(v, v) - square(t0));
    const R hit = select(t2 < R(0), R(0), R(1)), t = sqrt(max(t2, R(0)));
    return {hit, t0 - t, t0 + t};
}

}  // namespace scanshade::printed

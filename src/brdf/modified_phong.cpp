// Modified Phong: the highlight of Phong as a BRDF that is reciprocal and keeps energy.
//
//     f_r(ω_i, ω_o) cosθ_i = (ρ_d/π + ρ_s (n + 2)/(2π) cosⁿθ_r) cosθ_i          [1/sr]     (B14)
//
// source  Lafortune and Willems 1994
#define SCANSHADE_MODEL modified_phong
#include "brdf/model_begin.hpp"

struct modified_phong {
    static constexpr std::string_view name = "modified-phong";
    static constexpr std::string_view title =
        "Phong's highlight normalised: reciprocal, and keeps energy";
    static constexpr std::string_view equation =
        "f_r cosθ_i = (ρ_d/π + ρ_s (n + 2)/(2π) (ω_r·ω_o)ⁿ) cosθ_i   (B14, ρ_d + ρ_s ≤ 1)";
    static constexpr std::string_view source =
        "Lafortune and Willems 1994, Using the modified Phong reflectance model for physically "
        "based rendering";

    enum { rho_d, rho_s, n };
    static constexpr ParamInfo params[] = {
        {"rho_d", "ρ_d", ParamKind::rgb, ParamRole::diffuse, 0, 1, 0.7, "", "diffuse albedo"},
        {"rho_s", "ρ_s", ParamKind::rgb, ParamRole::specular, 0, 1, 0.2, "",
         "albedo of the highlight at normal incidence"},
        {"n", "n", ParamKind::exponent, ParamRole::exponent, 0, 1e6, 40, "",
         "exponent of the highlight; larger is sharper"},
    };

    static double error_u(const MaterialParams<double>& p) {
        return 8 + power_error_u(p.exponent[n]);
    }
    static constexpr Promises promises{
        .reciprocal = true, .energy = Energy::conserving_to_sum_one, .error_u = error_u};

    template <Real R>
    static Rgb<R> f_cos(const Cosines<R>& c, const ParamPack<R>& p) {
        return modified_phong_brdf(p.rgb(rho_d), p.rgb(rho_s), p.exponent(n), p.number(n) + R(2),
                                   c.r_o) *
               c.n_i;
    }
    template <class T>
    static void terms(const Cosines<T>& c, const ParamPack<T>& p, BracketTerms<T>& out) {
        const T power = pow_shininess(c.r_o, p.exponent(n));
        const T lobe = (p.number(n) + T(2)) * T(0.5) * power;
        out.factor("(R·V)ⁿ", power);
        out.factor("(n + 2)/2 (R·V)ⁿ", lobe);
        out.part("ρ_d (N·L)", p.rgb(rho_d) * c.n_i);
        out.part("ρ_s (n + 2)/2 (R·V)ⁿ (N·L)", p.rgb(rho_s) * lobe * c.n_i);
    }
};

#include "brdf/model_end.hpp"

// Blinn-Phong, as printed in C7: not normalised.
//
//     f_r(ω_i, ω_o) cosθ_i = (k_d cosθ_i + k_s cosˢθ_h)/π          [1/sr]     (C7, B12 with B15)
//
// source  Blinn 1977
#define SCANSHADE_MODEL blinn_phong
#include "brdf/model_begin.hpp"

struct blinn_phong {
    static constexpr std::string_view name = "blinn-phong";
    static constexpr std::string_view title = "Blinn's form of Phong: highlight by the half vector";
    static constexpr std::string_view equation =
        "f_r cosθ_i = (k_d cosθ_i + k_s (n·h)ˢ)/π   (C7, not normalised)";
    static constexpr std::string_view source = "Blinn 1977, Models of light reflection";

    enum { kd, ks, shininess };
    static constexpr ParamInfo params[] = {
        {"kd", "k_d", ParamKind::rgb, ParamRole::diffuse, 0, 1, 0.8, "", "diffuse reflectance"},
        {"ks", "k_s", ParamKind::rgb, ParamRole::specular, 0, 1, 0.25, "", "specular weight"},
        {"shininess", "s", ParamKind::exponent, ParamRole::exponent, 0, 1e6, 40, "",
         "exponent of the highlight; larger is sharper"},
    };

    static constexpr bool reads_matt = true;
    static double most(const MaterialParams<double>& p, int c) {
        return (p.value[kd][c] + p.value[ks][c]) * inv_pi;
    }

    static double error_u(const MaterialParams<double>& p) {
        return 7 + power_error_u(p.exponent[shininess]);
    }
    static constexpr Promises promises{
        .reciprocal = false, .energy = Energy::may_exceed_one, .error_u = error_u};

    template <Real R>
    static Rgb<R> f_cos(const Cosines<R>& c, const ParamPack<R>& p) {
        if (p.matt()) return p.rgb(kd) * inv_pi_as<R>() * c.n_i;
        return phong_f_cos(p.rgb(kd), p.rgb(ks), p.exponent(shininess), c.n_i, c.n_h);
    }
    template <class T>
    static void terms(const Cosines<T>& c, const ParamPack<T>& p, BracketTerms<T>& out) {
        const T power = pow_shininess(c.n_h, p.exponent(shininess));
        out.factor("(N·H)ˢ", power);
        out.part("k_d (N·L)", p.rgb(kd) * c.n_i);
        out.part("k_s (N·H)ˢ", p.rgb(ks) * power);
    }
};

#include "brdf/model_end.hpp"

// Lambert: ideal diffuse reflection.
//
//     f_r(ω_i, ω_o) cosθ_i = ρ_d/π cosθ_i          [1/sr]     (B6)
//
// source  Lambert 1760
#define SCANSHADE_MODEL lambert
#include "brdf/model_begin.hpp"

struct lambert {
    static constexpr std::string_view name = "lambert";
    static constexpr std::string_view title = "Lambert: ideal diffuse reflection";
    static constexpr std::string_view equation = "f_r cosθ_i = ρ_d/π cosθ_i   (B6)";
    static constexpr std::string_view source = "Lambert 1760, Photometria";

    enum { kd };
    static constexpr ParamInfo params[] = {
        {"kd", "ρ_d", ParamKind::rgb, ParamRole::diffuse, 0, 1, 0.8, "", "diffuse albedo"},
    };

    static constexpr bool ignores_view = true;
    static double most(const MaterialParams<double>& p, int c) { return p.value[kd][c] * inv_pi; }

    static double error_u(const MaterialParams<double>&) { return 4; }
    static constexpr Promises promises{
        .reciprocal = true, .energy = Energy::conserving, .error_u = error_u};

    template <Real R>
    static Rgb<R> f_cos(const Cosines<R>& c, const ParamPack<R>& p) {
        return lambert_brdf(p.rgb(kd)) * c.n_i;
    }
    template <class T>
    static void terms(const Cosines<T>& c, const ParamPack<T>& p, BracketTerms<T>& out) {
        out.part("k_d (N·L)", p.rgb(kd) * c.n_i);
    }
};

#include "brdf/model_end.hpp"

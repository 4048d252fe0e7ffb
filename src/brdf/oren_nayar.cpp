// Oren-Nayar, qualitative model: rough diffuse reflection of V-shaped facets.
//
//     f_r(ω_i, ω_o) cosθ_i = ρ/π (A + B max(0, cos(φ_i − φ_o)) sinα tanβ) cosθ_i [1/sr]     (B20)
//
// source  Oren and Nayar 1994
#define SCANSHADE_MODEL oren_nayar
#include "brdf/model_begin.hpp"

struct oren_nayar {
    static constexpr std::string_view name = "oren-nayar";
    static constexpr std::string_view title = "Oren and Nayar: rough diffuse reflection";
    static constexpr std::string_view equation =
        "f_r cosθ_i = ρ/π (A + B max(0, cos(φ_i − φ_o)) sinα tanβ) cosθ_i   (B20)\n"
        "  A = 1 − σ²/(2(σ² + 0.33)), B = 0.45 σ²/(σ² + 0.09), α, β = larger, smaller of θ_i, θ_o";
    static constexpr std::string_view source =
        "Oren and Nayar 1994, Generalization of Lambert's reflectance model";

    enum { rho, sigma };
    static constexpr ParamInfo params[] = {
        {"rho", "ρ", ParamKind::rgb, ParamRole::diffuse, 0, 1, 0.8, "", "albedo of a facet"},
        {"sigma", "σ", ParamKind::number, ParamRole::none, 0, 1.5707963267948966, 0.35, "rad",
         "standard deviation of the facets' slope; 0 is Lambert"},
    };

    static double error_u(const MaterialParams<double>&) { return 10; }
    // The qualitative model leaves out terms of the full one, and gains up to 1.52 % for ρ = 1, at
    // σ = 0.2 and grazing views.
    static constexpr Promises promises{
        .reciprocal = true, .energy = Energy::may_exceed_one, .error_u = error_u};

    enum { A, B };
    static void derive(MaterialParams<double>& p) {
        const OrenNayarCoefficients<double> k = oren_nayar_coefficients(p.value[sigma][0]);
        p.derived[A] = k.A;
        p.derived[B] = k.B;
    }

    template <Real R>
    static Rgb<R> f_cos(const Cosines<R>& c, const ParamPack<R>& p) {
        const OrenNayarCoefficients<R> k{p.derived(A), p.derived(B)};
        return oren_nayar_f_cos(p.rgb(rho), k, c.n_i, c.n_o, c.s_io);
    }
    template <class T>
    static void terms(const Cosines<T>& c, const ParamPack<T>& p, BracketTerms<T>& out) {
        const T share = max(c.s_io, T(0)) * (c.n_i / max(c.n_i, c.n_o));
        out.factor("A", p.derived(A));
        out.factor("B", p.derived(B));
        out.factor("sinα tanβ cos(φ_i − φ_o) (N·L)", share);
        out.part("ρ A (N·L)", p.rgb(rho) * (p.derived(A) * c.n_i));
        out.part("ρ B sinα tanβ cos(φ_i − φ_o) (N·L)", p.rgb(rho) * (p.derived(B) * share));
    }
};

#include "brdf/model_end.hpp"

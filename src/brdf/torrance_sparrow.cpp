// Torrance-Sparrow: a rough surface of small mirrors over a diffuse base.
//
//     f_r(ω_i, ω_o) cosθ_i = ρ/π cosθ_i + F(ω_i·h) G D(h)/(4 cosθ_o)            [1/sr]     (B16)
//
// D, G and F are chosen once a material, so the branches below are uniform.
//
// source  Torrance and Sparrow 1967; Cook and Torrance 1982; Walter et al. 2007
#define SCANSHADE_MODEL torrance_sparrow
#include "brdf/model_begin.hpp"

struct torrance_sparrow {
    static constexpr std::string_view name = "torrance-sparrow";
    static constexpr std::string_view title =
        "Torrance and Sparrow: a rough surface of small mirrors over a diffuse base";
    static constexpr std::string_view equation =
        "f_r cosθ_i = ρ/π cosθ_i + F(ω_i·h) G(ω_i, ω_o) D(h)/(4 cosθ_o)   (B16)\n"
        "  D: B17, each normalised · G: B18 · F: Schlick's B19 with f0, or B11 with eta";
    static constexpr std::string_view source =
        "Torrance and Sparrow 1967, Theory for off-specular reflection from roughened surfaces; "
        "Walter et al. 2007";

    static constexpr std::string_view distributions[] = {"gaussian", "blinn", "beckmann", "ggx"};
    static constexpr std::string_view shadowings[] = {"v-cavity", "smith"};
    static constexpr std::string_view fresnels[] = {"schlick", "dielectric"};
    enum Distribution { gaussian, blinn, beckmann, ggx };
    enum Shadowing { v_cavity, smith };
    enum Fresnel { schlick, dielectric };

    enum { rho, m, f0, eta, distribution, shadowing, fresnel };
    static constexpr ParamInfo params[] = {
        {"rho", "ρ", ParamKind::rgb, ParamRole::diffuse, 0, 1, 0.5, "", "albedo of the base"},
        {"m", "m", ParamKind::number, ParamRole::roughness, 1e-4, 1, 0.25, "",
         "roughness: slope of the facets; smaller is sharper"},
        {"f0", "F(0)", ParamKind::rgb, ParamRole::specular, 0, 1, 0.05, "",
         "reflectance of a facet at normal incidence, for fresnel schlick"},
        {"eta", "η", ParamKind::number, ParamRole::none, 1, 4, 1.5, "",
         "refractive index inside over outside, for fresnel dielectric"},
        {"distribution", "D", ParamKind::choice, ParamRole::none, 0, 3, ggx, "",
         "how facet normals are distributed", distributions},
        {"shadowing", "G", ParamKind::choice, ParamRole::none, 0, 1, smith, "",
         "how facets hide each other", shadowings},
        {"fresnel", "F", ParamKind::choice, ParamRole::none, 0, 1, schlick, "",
         "how a facet reflects", fresnels},
    };

    /// The exponentials magnify the error of their argument, which is at most 88 before they
    /// underflow in float.
    static double error_u(const MaterialParams<double>& p) {
        constexpr double of_distribution[] = {20 * 88 + 6, 14 * 88 + 8, 6 * 88 + 12, 13};
        constexpr double of_shadowing[] = {4, 15}, of_fresnel[] = {10, 42};
        return of_distribution[int(p.value[distribution][0])] +
               of_shadowing[int(p.value[shadowing][0])] + of_fresnel[int(p.value[fresnel][0])] + 4;
    }
    // The base reflects its share of all light that arrives, also of what the facets take.
    static constexpr Promises promises{
        .reciprocal = true, .energy = Energy::may_exceed_one, .error_u = error_u};

    enum { norm };
    static void derive(MaterialParams<double>& p) {
        p.derived[norm] = gaussian_norm(p.value[m][0]);
    }

    template <Real R>
    static R D(const Cosines<R>& c, const ParamPack<R>& p) {
        switch (p.choice(distribution)) {
            case gaussian:
                return D_gaussian(c.n_h, c.sin2_h, p.number(m), p.derived(norm));
            case blinn:
                return D_blinn(c.n_h, c.sin2_h, p.number(m));
            case beckmann:
                return D_beckmann(c.n_h, c.sin2_h, p.number(m));
            default:
                return D_ggx(c.n_h, c.sin2_h, p.number(m));
        }
    }
    template <Real R>
    static R G_over_4_cos_o(const Cosines<R>& c, const ParamPack<R>& p) {
        if (p.choice(shadowing) == v_cavity)
            return v_cavity_over_4_cos_o(c.n_i, c.n_o, c.n_h, c.i_h);
        return smith_over_4_cos_o(c.n_i, c.n_o, p.number(m));
    }
    template <Real R>
    static Rgb<R> F(const Cosines<R>& c, const ParamPack<R>& p) {
        if (p.choice(fresnel) == schlick) return fresnel_schlick(p.rgb(f0), c.i_h);
        const R f = fresnel_dielectric(c.i_h, R(1) / p.number(eta));
        return {f, f, f};
    }

    template <Real R>
    static Rgb<R> f_cos(const Cosines<R>& c, const ParamPack<R>& p) {
        return lambert_brdf(p.rgb(rho)) * c.n_i +
               torrance_sparrow_f_cos(F(c, p), G_over_4_cos_o(c, p), D(c, p));
    }
    template <class T>
    static void terms(const Cosines<T>& c, const ParamPack<T>& p, BracketTerms<T>& out) {
        const T d = D(c, p), g = G_over_4_cos_o(c, p);
        const Rgb<T> f = F(c, p);
        out.factor("ω_i·h", c.i_h);
        out.factor("D(h)", d);
        out.factor("G/(4 cosθ_o)", g);
        out.factor_rgb("F(ω_i·h)", f);
        out.part("ρ (N·L)", p.rgb(rho) * c.n_i);
        out.part("π F G D/(4 cosθ_o)", torrance_sparrow_f_cos(f, g, d) * T(pi));
    }
};

#include "brdf/model_end.hpp"

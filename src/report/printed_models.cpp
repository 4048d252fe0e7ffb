#include "report/printed_models.hpp"

#include "report/printed_forms.hpp"
#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

/// The parameters of a material by name, grey, in the number type R.
template <class R>
class Parameters {
public:
    Parameters(const BrdfInfo& brdf, const MaterialParams<double>& values)
        : brdf_(brdf), values_(values) {}

    R operator()(std::string_view name) const { return R(values_.value[index(name)][0]); }
    std::string_view choice(std::string_view name) const {
        const std::size_t i = index(name);
        return brdf_.params[i].names[std::size_t(values_.value[i][0])];
    }

private:
    std::size_t index(std::string_view name) const {
        std::size_t i = 0;
        while (brdf_.params[i].name != name) ++i;
        return i;
    }
    const BrdfInfo& brdf_;
    const MaterialParams<double>& values_;
};

// Each is a functor, so that one row makes it in both types.
struct Lambert {
    template <class R>
    static R f_cos(const Cosines<R>& c, const Parameters<R>& p) {
        return p("kd") / printed::pi_as<R>() * c.n_i;
    }
};
// C7's coefficients are albedos, larger by π than B13's.
struct Phong {
    template <class R>
    static R f_cos(const Cosines<R>& c, const Parameters<R>& p) {
        const R k_d = p("kd") / printed::pi_as<R>(), k_s = p("ks") / printed::pi_as<R>();
        return printed::phong_brdf(k_d, k_s, p("shininess"), c.n_i, c.r_o) * c.n_i;
    }
};
struct BlinnPhong {
    template <class R>
    static R f_cos(const Cosines<R>& c, const Parameters<R>& p) {
        const R k_d = p("kd") / printed::pi_as<R>(), k_s = p("ks") / printed::pi_as<R>();
        return printed::phong_brdf(k_d, k_s, p("shininess"), c.n_i, c.n_h) * c.n_i;
    }
};
struct ModifiedPhong {
    template <class R>
    static R f_cos(const Cosines<R>& c, const Parameters<R>& p) {
        return printed::modified_phong_brdf(p("rho_d"), p("rho_s"), p("n"), c.r_o) * c.n_i;
    }
};
struct OrenNayar {
    template <class R>
    static R f_cos(const Cosines<R>& c, const Parameters<R>& p) {
        const R theta_i = acos(c.n_i), theta_o = acos(c.n_o);
        return printed::oren_nayar_brdf(p("rho"), p("sigma"), theta_i, theta_o,
                                        cos(theta_i - theta_o)) *
               c.n_i;
    }
};
struct TorranceSparrow {
    template <class R>
    static R D(std::string_view name, R n_h, R m) {
        if (name == "gaussian") return printed::D_gaussian(n_h, m);
        if (name == "blinn") return printed::D_blinn(n_h, m);
        if (name == "beckmann") return printed::D_beckmann(n_h, m);
        return printed::D_ggx(n_h, m);
    }
    template <class R>
    static R G(std::string_view name, const Cosines<R>& c, R m) {
        if (name == "v-cavity") return printed::G_v_cavity(c.n_i, c.n_o, c.n_h, c.i_h);
        return printed::G1_smith(c.n_i, m) * printed::G1_smith(c.n_o, m);
    }
    template <class R>
    static R f_cos(const Cosines<R>& c, const Parameters<R>& p) {
        const R m = p("m");
        const R F = p.choice("fresnel") == "schlick"
                        ? printed::fresnel_schlick(p("f0"), c.n_i)
                        : printed::fresnel_dielectric(c.n_i, R(1) / p("eta"));
        const R f = printed::torrance_sparrow_brdf(
            F, G(p.choice("shadowing"), c, m), D(p.choice("distribution"), c.n_h, m), c.n_i, c.n_o);
        return (p("rho") / printed::pi_as<R>() + f) * c.n_i;
    }
};

template <class Model, class R>
R f_cos(const Cosines<R>& c, const BrdfInfo& brdf, const MaterialParams<double>& params) {
    return Model::f_cos(c, Parameters<R>(brdf, params));
}

template <class Model>
constexpr PrintedModel row(std::string_view name, bool misprint, std::string_view choice) {
    return {name, misprint, choice, f_cos<Model, float>, f_cos<Model, double>};
}

constexpr PrintedModel models[] = {
    row<Lambert>("lambert", false, "as printed"),
    row<Phong>("phong", false, "times cosθ_i before it is divided by it; the power by squaring"),
    row<BlinnPhong>("blinn-phong", false,
                    "times cosθ_i before it is divided by it; the power by squaring"),
    row<ModifiedPhong>("modified-phong", false, "as printed; the power by squaring"),
    row<OrenNayar>("oren-nayar", true, "the azimuths' difference, by cross products; no tangent"),
    row<TorranceSparrow>("torrance-sparrow", true,
                         "F at the half vector; D by the sine of θ_h; G over cosθ_o"),
};

}  // namespace

const PrintedModel* find_printed_model(std::string_view name) {
    for (const PrintedModel& model : models)
        if (model.name == name) return &model;
    return nullptr;
}

}  // namespace scanshade

// Sweeps of chapter B: Torrance and Sparrow's model, its distributions and shadowing.
#include "brdf/cosines.hpp"
#include "report/equation_sweep.hpp"
#include "report/printed_forms.hpp"
#include "scanshade/eq/fresnel.hpp"
#include "scanshade/eq/microfacet.hpp"

namespace scanshade {
namespace {

/// The half vector at an angle of m from the normal: the side of the highlight.
template <class R>
struct HighlightSide {
    R n_h, sin2_h;
    explicit HighlightSide(R m) : n_h(cos(m)), sin2_h(sin(m) * sin(m)) {}
};

/// c of the Gaussian, as renderers have it: computed in double.
template <class R>
R norm_of(R m) {
    return gaussian_norm(m);
}
template <>
float norm_of(float m) {
    return float(gaussian_norm(double(m)));
}

// Torrance and Sparrow with GGX and Smith, m = 1/4, F(0) = 1/32, times cosθ_i.
template <class R>
Vec3<R> rough_mirror(const Vec3<R>& wi, const Vec3<R>& wo) {
    const R m = R(0.25);
    const Cosines<R> c = cosines(z_axis<R>(), wi, wo);
    const Rgb<R> F = fresnel_schlick(grey(R(0.03125)), c.i_h);
    const R G = smith_over_4_cos_o(c.n_i, c.n_o, m), D = D_ggx(c.n_h, c.sin2_h, m);
    return one(torrance_sparrow_f_cos(F, G, D).r);
}
/// `cos_F`: of the angle that F is taken at.
template <class R>
Vec3<R> printed_rough_mirror(const Vec3<R>& wi, const Vec3<R>& wo, R cos_F) {
    const R m = R(0.25), n_i = wi.z, n_o = wo.z;
    const R F = printed::fresnel_schlick(R(0.03125), cos_F);
    const R G = printed::G1_smith(n_i, m) * printed::G1_smith(n_o, m);
    const R D = printed::D_ggx(printed::half_vector(wi, wo).z, m);
    return one(printed::torrance_sparrow_brdf(F, G, D, n_i, n_o) * n_i);
}
template <class R>
R at_half_vector(const Vec3<R>& wi, const Vec3<R>& wo) {
    return dot(wi, printed::half_vector(wi, wo));
}

constexpr auto viewed_grazing = [](auto x) {
    return rough_mirror(from_z(decltype(x)(-0.75)), from_x(x));
};

/// Light at 0.75 rad above the surface, opposite of the viewer.
template <class R>
struct Facet {
    Vec3<R> wi, wo, h;
    explicit Facet(R elevation)
        : wi{-cos(R(0.75)), R(0), sin(R(0.75))}, wo(from_x(elevation)), h(half_vector(wi, wo)) {}
};

/// tan²θ_h/m² of Beckmann's exponent, as far as the power does not vanish.
double beckmann_exponent(double elevation, double m) {
    const double t = std::tan(elevation) * m;
    return std::min(1 / (t * t), 745.0);
}

constexpr EquationSweep sweeps[] = {
    {"B16", "rough mirror under light from the surface up", "elevation of ω_i, rad",
     Spacing::logarithmic, 1e-8, 1.57,
     [](auto x) {
         const auto wi = from_x(x), wo = from_z(decltype(x)(-0.625));
         return printed_rough_mirror(wi, wo, wi.z);
     },
     [](auto x) { return rough_mirror(from_x(x), from_z(decltype(x)(-0.625))); },
     [](Wide x) {
         const auto wi = from_x(x), wo = from_z(Wide(-0.625));
         return printed_rough_mirror(wi, wo, at_half_vector(wi, wo));
     },
     [](double, double) { return 100.0; },
     "30 u of its factors, and those of the cosines, which D squares twice",
     "F at ω_i·h: with F(θ_i), as printed, the model is not reciprocal", true},
    {"B16", "rough mirror seen from the surface up", "elevation of ω_o, rad", Spacing::from_zero,
     1e-8, 1.57,
     [](auto x) {
         const auto wi = from_z(decltype(x)(-0.75)), wo = from_x(x);
         return printed_rough_mirror(wi, wo, at_half_vector(wi, wo));
     },
     viewed_grazing, viewed_grazing, [](double, double) { return 100.0; },
     "30 u of its factors, and those of the cosines, which D squares twice",
     "Smith's factor over its cosine, in which the cosine cancels: printed, 0/0 where ω_o grazes"},
    {"B17a", "Gaussian at θ_h = m", "m", Spacing::logarithmic, 1e-6, 1,
     [](auto x) { return one(printed::D_gaussian(HighlightSide(x).n_h, x)); },
     [](auto x) {
         const HighlightSide h(x);
         return one(D_gaussian(h.n_h, h.sin2_h, x, norm_of(x)));
     },
     [](Wide x) { return one(exp(Wide(-1)) * gaussian_norm(x)); },
     [](double, double) { return 130.0; },
     "26 u of the exponential and 100 u of the quadrature of c",
     "c e^(−(θ_h/m)²): printed, it is not normalised; and θ_h by atan2, not arccos", true},
    {"B17b", "Blinn's distribution at θ_h = m", "m", Spacing::logarithmic, 1e-6, 1,
     [](auto x) { return one(printed::D_blinn(HighlightSide(x).n_h, x)); },
     [](auto x) {
         const HighlightSide h(x);
         return one(D_blinn(h.n_h, h.sin2_h, x));
     },
     [](Wide x) { return one(printed::D_blinn(cos(x), x)); }, [](double, double) { return 28.0; },
     "14 u times an exponent of 1, 8 u, and those of the sine",
     "e to the log1p(−sin²θ_h): the rounded cosine is 1, and any power of it as well"},
    {"B17c", "Beckmann's distribution at θ_h = m", "m", Spacing::logarithmic, 1e-6, 1,
     [](auto x) { return one(printed::D_beckmann(HighlightSide(x).n_h, x)); },
     [](auto x) {
         const HighlightSide h(x);
         return one(D_beckmann(h.n_h, h.sin2_h, x));
     },
     [](Wide x) { return one(printed::D_beckmann(cos(x), x)); },
     [](double, double condition) { return 24 + 4 * condition; },
     "6 u times an exponent of 1 to 2.4, 12 u, and those of sine and cosine",
     "sin²θ_h for 1 − (n·h)², which cancels in the highlight"},
    {"B17c", "Beckmann's distribution at grazing half vectors, m = 1/2", "elevation of h, rad",
     Spacing::from_zero, 1e-12, 1.57,
     [](auto x) { return one(printed::D_beckmann(from_x(x).z, decltype(x)(0.5))); },
     [](auto x) {
         const auto h = from_x(x);
         return one(D_beckmann(h.z, h.x * h.x, decltype(x)(0.5)));
     },
     [](Wide x) {
         return x > Wide(0) ? one(printed::D_beckmann(sin(x), Wide(0.5))) : one(Wide(0));
     },
     [](double x, double) { return 16 + 10 * beckmann_exponent(x, 0.5); },
     "6 u times the exponent, 12 u, and those of sine and cosine",
     "(n·h)² of at least 1e-6, where the exponential is 0 anyway: printed, 0/0"},
    {"B17d", "GGX at θ_h = m", "m", Spacing::logarithmic, 1e-6, 1,
     [](auto x) { return one(printed::D_ggx(HighlightSide(x).n_h, x)); },
     [](auto x) {
         const HighlightSide h(x);
         return one(D_ggx(h.n_h, h.sin2_h, x));
     },
     [](Wide x) { return one(printed::D_ggx(cos(x), x)); }, [](double, double) { return 20.0; },
     "13 u by counting roundings, and those of the sine",
     "q²/π, q = m/(sin²θ_h + (m n·h)²), which only adds: printed, (n·h)²(m² − 1) + 1 cancels"},
    {"B18a", "V-cavities, viewer from below to above", "elevation of ω_o, rad", Spacing::linear,
     -0.1, 1.57,
     [](auto x) {
         const Facet f(x);
         return one(printed::G_v_cavity(f.wi.z, f.wo.z, f.h.z, dot(f.wo, f.h)));
     },
     [](auto x) {
         const Facet f(x);
         return one(G_v_cavity(f.wi.z, f.wo.z, f.h.z, dot(f.wo, f.h)));
     },
     [](Wide x) {
         const Facet f(x);
         const Wide n_o = max(f.wo.z, Wide(0));
         return one(printed::G_v_cavity(f.wi.z, n_o, f.h.z, dot(f.wo, f.h)));
     },
     [](double, double) { return 16.0; }, "3 u and those of the half vector",
     "negative cosines as 0: a viewer below the surface would see negative light"},
    {"B18b", "Smith's masking, direction from below to above, m = 1/8", "elevation of ω, rad",
     Spacing::linear, -0.1, 1.57,
     [](auto x) { return one(printed::G1_smith(sin(x), decltype(x)(0.125))); },
     [](auto x) {
         using R = decltype(x);
         return one(max(sin(x), R(0)) * G1_smith_over_cos(sin(x), R(0.125)));
     },
     [](Wide x) { return one(printed::G1_smith(max(sin(x), Wide(0)), Wide(0.125))); },
     [](double, double) { return 9.0; }, "6 u and those of the sine",
     "negative cosines as 0, and over the cosine, which B16 divides by"},
};

}  // namespace

std::span<const EquationSweep> microfacet_sweeps() { return sweeps; }

}  // namespace scanshade

// Sweeps of chapter B: smooth surfaces and Phong's highlight.
#include "report/equation_sweep.hpp"
#include "report/printed_forms.hpp"
#include "scanshade/eq/fresnel.hpp"
#include "scanshade/eq/reflection.hpp"

namespace scanshade {
namespace {

/// 1 − x as float has it, in each type the same number.
template <class R>
R nearly_one(R x) {
    const double at = number_of(x), rounded = double(1.0f - float(at));
    return R(rounded) - (x - R(at));
}

/// (B9) with its sign corrected.
Vec3<Wide> refracted(const Vec3<Wide>& wi, const Vec3<Wide>& n, Wide eta) {
    const Wide cos_i = dot(wi, n);
    return wi * -eta + n * (eta * cos_i - sqrt(printed::snell_cos2(cos_i, eta)));
}

Wide fresnel(Wide cos_i, Wide eta) {
    const bool total = printed::snell_cos2(cos_i, eta) < Wide(0);
    return total ? Wide(1) : printed::fresnel_dielectric(cos_i, eta);
}

/// The polar angle at which cosⁿ is about 1/2.
template <class R>
R half_width(R n) {
    return sqrt(R(1.375) / (n + R(1)));
}

/// Two directions that are opposite but for an angle x.
template <class R>
struct NearlyOpposite {
    Vec3<R> one, other;
    explicit NearlyOpposite(R x) : one(from_z(R(0.5))), other(-from_z(R(0.5) - x)) {}
};

constexpr EquationSweep sweeps[] = {
    {"B8", "where an ideal mirror takes its light from", "θ_o, rad", Spacing::logarithmic, 1e-8,
     1.5, [](auto x) { return printed::delta_direction(from_z(x)); },
     [](auto x) { return ideal_mirror(from_z(x), z_axis<decltype(x)>(), decltype(x)(1)).wi; },
     [](Wide x) { return from_z(-x); }, [](double, double) { return 9.0; },
     "as B7: cosine 3, product and difference",
     "the mirror direction of ω_o: printed, δ(ω_i − ω_o) sends light back to where it comes from",
     true},
    {"B9", "refracted direction, from the surface up", "elevation of ω_i, rad",
     Spacing::logarithmic, 1e-8, 1.57,
     [](auto x) {
         using R = decltype(x);
         return printed::refracted_direction(from_x(x), z_axis<R>(), R(0.75));
     },
     [](auto x) {
         using R = decltype(x);
         return refracted_direction(from_x(x), z_axis<R>(), R(0.75));
     },
     [](Wide x) { return refracted(from_x(x), z_axis<Wide>(), Wide(0.75)); },
     [](double, double) { return 12.0; }, "12 u by counting roundings, for η ≤ 1",
     "(η − 1)(η + 1)/(η cosθ_i + √…) n − η ω_i: printed, the sign breaks Snell's law", true},
    {"B9", "cosine of refraction at grazing light, η = 1", "elevation of ω_i, rad",
     Spacing::logarithmic, 1e-8, 1.57,
     [](auto x) { return one(printed::snell_cos2(sin(x), decltype(x)(1))); },
     [](auto x) { return one(snell_cos2(sin(x), decltype(x)(1))); },
     [](Wide x) { return one(sin(x) * sin(x)); }, [](double, double) { return 6.0; },
     "sine squared 3, products and sum 3",
     "(1 − η)(1 + η) + (η cosθ_i)²: 1 − η²(1 − cos²θ_i) cancels twice"},
    {"B10", "critical angle into either medium", "η_o/η_i", Spacing::linear, 0.1, 3,
     [](auto x) { return one(printed::critical_angle(x)); },
     [](auto x) { return one(critical_angle(x)); },
     [](Wide x) { return one(asin(min(x, Wide(1)))); }, [](double, double) { return 2.0; },
     "one function",
     "arcsin of at most 1: towards the denser medium there is no critical angle, and π/2 says so"},
    {"B10", "where an ideal refractor takes its light from", "θ_o, rad", Spacing::logarithmic, 1e-8,
     1.5, [](auto x) { return printed::delta_direction(from_z(x)); },
     [](auto x) { return ideal_refractor(from_z(x), z_axis<decltype(x)>(), decltype(x)(0.75)).wi; },
     [](Wide x) { return refracted(from_z(x), z_axis<Wide>(), Wide(0.75)); },
     [](double, double) { return 12.0; }, "as B9",
     "the refracted direction of ω_o: printed, light passes without being refracted", true},
    {"B11", "Fresnel reflectance through the critical angle, η = 1.5", "θ_i, rad", Spacing::linear,
     0, 1.57, [](auto x) { return one(printed::fresnel_dielectric(cos(x), decltype(x)(1.5))); },
     [](auto x) { return one(fresnel_dielectric(cos(x), decltype(x)(1.5))); },
     [](Wide x) { return one(fresnel(cos(x), Wide(1.5))); },
     [](double, double condition) { return 40 + 4 * condition; },
     "40 u, and what the rounded cosine does to the root before the critical angle",
     "1 where the root is of a negative number: the printed form is no number there"},
    {"B11", "Fresnel reflectance between nearly equal media", "1 − η", Spacing::logarithmic, 1e-7,
     0.5,
     [](auto x) {
         using R = decltype(x);
         return one(printed::fresnel_dielectric(R(0.75), nearly_one(x)));
     },
     [](auto x) { return one(fresnel_dielectric(decltype(x)(0.75), nearly_one(x))); },
     [](Wide x) { return one(fresnel(Wide(0.75), nearly_one(x))); },
     [](double, double) { return 40.0; }, "40 u by counting roundings",
     "((η² − 1)/(η cosθ_i + cosθ_o)²)²: the printed difference of nearly equal products cancels"},
    {"B12", "highlight at half of its height", "exponent n", Spacing::whole, 1, 1e6,
     [](auto x) { return one(printed::pow(cos(half_width(x)), x)); },
     [](auto x) { return one(pow_shininess(cos(half_width(x)), make_exponent(number_of(x)))); },
     [](Wide x) { return one(pow(cos(half_width(x)), x)); },
     [](double x, double) { return 6 + 1.5 * x; },
     "n/2 for the rounded cosine, which no form can mend, and n − 1 for the squarings",
     "repeated squaring, which takes a vector a few products: what the rounded cosine has lost is "
     "as much, so that no exact power would be better"},
    {"B13", "Phong's BRDF under grazing light, times cosθ_i", "elevation of ω_i, rad",
     Spacing::from_zero, 1e-44, 1.57,
     [](auto x) {
         using R = decltype(x);
         const R cos_i = sin(x);
         return one(printed::phong_brdf(R(0.5), R(0.25), R(10), cos_i, R(0.875)) * cos_i);
     },
     [](auto x) {
         using R = decltype(x);
         const Rgb<R> k_d = grey(R(0.5)), k_s = grey(R(0.25));
         return one(phong_reflection(k_d, k_s, make_exponent(10), sin(x), R(0.875)).r);
     },
     [](Wide x) {
         return one(
             printed::phong_reflection(Wide(0.5), Wide(0.25), Wide(10), sin(x), Wide(0.875)));
     },
     [](double, double) { return 17.0; }, "n + 7 of B12",
     "f_r cosθ_i as B12, without the quotient: printed, f_r is unbounded, and 0/0 at last"},
    {"B15", "half vector of nearly opposite directions", "angle from opposite, rad",
     Spacing::from_zero, 1e-8, 3,
     [](auto x) {
         const NearlyOpposite w(x);
         return printed::half_vector(w.one, w.other);
     },
     [](auto x) {
         const NearlyOpposite w(x);
         return half_vector(w.one, w.other);
     },
     [](Wide x) {
         const NearlyOpposite w(x);
         return printed::half_vector(w.one, w.other);
     },
     [](double x, double) { return 5 + 4 / x; },
     "each direction is rounded, and their sum is as short as the angle is small",
     "as printed, but 0 where the sum is 0: opposite directions have no half vector", false, true},
};

}  // namespace

std::span<const EquationSweep> reflection_sweeps() { return sweeps; }

}  // namespace scanshade

// Sweeps of chapter B: Oren and Nayar's model.
#include "brdf/cosines.hpp"
#include "report/equation_sweep.hpp"
#include "report/printed_forms.hpp"
#include "scanshade/eq/directions.hpp"
#include "scanshade/eq/reflection.hpp"

namespace scanshade {
namespace {

// Oren and Nayar, ρ = 3/4, σ = 1/2.
template <class R>
Vec3<R> oren_nayar(const Vec3<R>& wi, const Vec3<R>& wo) {
    const Cosines<R> c = cosines(z_axis<R>(), wi, wo);
    const auto k = oren_nayar_coefficients(R(0.5));
    return one(oren_nayar_f_cos(grey(R(0.75)), k, c.n_i, c.n_o, c.s_io).r);
}
template <class R>
Vec3<R> printed_oren_nayar(R theta_i, R theta_o, R cosine, R cos_i) {
    return one(printed::oren_nayar_brdf(R(0.75), R(0.5), theta_i, theta_o, cosine) * cos_i);
}

constexpr auto viewed_around = [](auto x) {
    using R = decltype(x);
    return oren_nayar(from_z(R(0.875)), to_cartesian(Spherical<R>{R(0.625), x}));
};

constexpr EquationSweep sweeps[] = {
    {"B20", "Oren and Nayar's model around the normal", "φ_i − φ_o, rad", Spacing::linear, 0, 3.14,
     [](auto x) {
         using R = decltype(x);
         const R theta_i = R(0.875), theta_o = R(0.625);
         return printed_oren_nayar(theta_i, theta_o, cos(theta_i - theta_o), cos(theta_i));
     },
     viewed_around,
     [](Wide x) { return printed_oren_nayar(Wide(0.875), Wide(0.625), cos(x), cos(Wide(0.875))); },
     [](double, double) { return 20.0; }, "9 u and those of the cosines",
     "the cosine of the azimuths' difference: printed, that of the polar angles' does not notice "
     "where the viewer goes",
     true},
    {"B20", "Oren and Nayar's model, light and viewer grazing", "elevation of both, rad",
     Spacing::from_zero, 1e-8, 1.57,
     [](auto x) {
         using R = decltype(x);
         const R theta = acos(sin(x));
         return printed_oren_nayar(theta, theta, R(1), sin(x));
     },
     [](auto x) { return oren_nayar(from_x(x), from_x(x)); },
     [](Wide x) {
         const Wide theta = wide_pi() * Wide(0.5) - x;
         return x > Wide(0) ? printed_oren_nayar(theta, theta, Wide(1), sin(x))
                            : oren_nayar(from_x(x), from_x(x));
     },
     [](double, double) { return 20.0; }, "9 u and those of the cosines",
     "max(0, s) cosθ_i/max(cosθ_i, cosθ_o), which is bounded: tanβ is not, and next to 90° a "
     "rounded angle has a tangent of either sign"},
    {"B20", "Oren and Nayar's model, light near the pole", "θ_i, rad", Spacing::from_zero, 1e-8,
     1.5,
     [](auto x) {
         using R = decltype(x);
         const Vec3<R> wi = to_cartesian(Spherical<R>{x, R(0.5)});
         const Vec3<R> wo = to_cartesian(Spherical<R>{R(0.625), R(1)});
         const R cosine = cos(printed::azimuth(wi) - printed::azimuth(wo));
         return printed_oren_nayar(x, R(0.625), cosine, wi.z);
     },
     [](auto x) {
         using R = decltype(x);
         return oren_nayar(to_cartesian(Spherical<R>{x, R(0.5)}),
                           to_cartesian(Spherical<R>{R(0.625), R(1)}));
     },
     [](Wide x) { return printed_oren_nayar(x, Wide(0.625), cos(Wide(0.5)), cos(x)); },
     [](double, double) { return 20.0; }, "9 u and those of the cosines",
     "s = (n × ω_i)·(n × ω_o), which is 0 at the pole, where there is no azimuth"},
};

}  // namespace

std::span<const EquationSweep> oren_nayar_sweeps() { return sweeps; }

}  // namespace scanshade

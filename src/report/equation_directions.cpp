// Sweeps of chapter A: angles and lights.
#include <cmath>

#include "report/equation_sweep.hpp"
#include "report/printed_forms.hpp"
#include "scanshade/eq/directions.hpp"
#include "scanshade/eq/radiometry.hpp"

namespace scanshade {
namespace {

constexpr EquationSweep sweeps[] = {
    {"A3", "polar angle near the pole", "θ, rad", Spacing::logarithmic, 1e-8, 1.57,
     [](auto x) { return one(printed::polar_angle(from_z(x))); },
     [](auto x) { return one(to_spherical(from_z(x)).theta); }, [](Wide x) { return one(x); },
     [](double, double) { return 6.0; }, "sine 1, cosine 1, length 2, atan2 2",
     "atan2(√(x² + y²), z): near the pole z rounds to 1, and arccos has nothing left of the angle"},
    {"A3", "azimuth all around", "φ, rad", Spacing::linear, 0.01, 6.28,
     [](auto x) {
         return one(printed::azimuth(Vec3<decltype(x)>{cos(x), sin(x), decltype(x)(0)}));
     },
     [](auto x) {
         return one(to_spherical(Vec3<decltype(x)>{cos(x), sin(x), decltype(x)(0)}).phi);
     },
     [](Wide x) { return one(x); }, [](double, double) { return 4.0; },
     "sine and cosine 1, atan2 1, the turn by 2π 2",
     "atan2(y, x), wrapped to [0, 2π): the quotient y/x is the same in opposite quadrants", true},
    {"A14", "cosine light, ahead and behind", "∠(ω, d), rad", Spacing::linear, 0, 3.14,
     [](auto x) { return one(printed::cosine_light(from_z(x), z_axis<decltype(x)>())); },
     [](auto x) { return one(cosine_light(from_z(x), z_axis<decltype(x)>())); },
     [](Wide x) { return one(max(cos(x), Wide(0))); }, [](double, double) { return 3.0; },
     "of a product with one axis only the cosine rounds",
     "the printed form, at least 0: behind it the light would take light away"},
    {"A15", "spot light just inside its cone", "τ, rad", Spacing::logarithmic, 0.01, 1.57,
     [](auto x) {
         using R = decltype(x);
         return one(printed::spot_light(from_z(x * R(0.984375)), z_axis<R>(), x));
     },
     [](auto x) {
         using R = decltype(x);
         const Scalar<R> cutoff = Scalar<R>(std::cos(number_of(x)));
         return one(spot_light(from_z(x * R(0.984375)), z_axis<R>(), cutoff, Scalar<R>(0)));
     },
     [](Wide) { return one(Wide(1)); }, [](double, double) { return 0.0; },
     "1 or 0; cones below 0.3° lose their rim in float, as all cosines there are 1, in both forms",
     "cosines are compared, so no arccos is needed: the same cone"},
};

}  // namespace

std::span<const EquationSweep> direction_sweeps() { return sweeps; }

}  // namespace scanshade

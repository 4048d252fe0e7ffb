#include "report/sweep_errors.hpp"

#include <algorithm>
#include <cmath>

namespace scanshade {
namespace {

/// The distance of neighbours at a size.
double ulp_of(double size, const Precision& precision) {
    const double normal = std::max(size, precision.min_normal);
    return std::ldexp(precision.epsilon, std::ilogb(normal));
}

struct Lengths {
    double value = 0, error = 0, exact = 0;
    explicit Lengths(std::span<const Component> result) {
        for (const Component& c : result) {
            value = std::hypot(value, c.value);
            error = std::hypot(error, c.error);
            exact = std::hypot(exact, c.exact);
        }
    }
};

}  // namespace

void add_error(std::span<const Component> result, const Precision& precision, double x,
               double bound, bool may_be_zero, SweepErrors& into) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto is_nan = [](const Component& c) { return std::isnan(c.value); };
    const auto is_inf = [](const Component& c) { return std::isinf(c.value); };
    const bool nan = std::any_of(result.begin(), result.end(), is_nan);
    const bool inf = !nan && std::any_of(result.begin(), result.end(), is_inf);
    const Lengths lengths(result);
    if (nan || inf) {
        ++(nan ? into.nan : into.inf);
        ++into.over;
        return into.ulp.push_back(none);
    }
    if (!std::isfinite(lengths.exact)) return into.ulp.push_back(0);
    if (may_be_zero && lengths.value == 0 && lengths.exact > 0) {
        ++into.zero;
        return into.ulp.push_back(none);
    }
    const double ulp = lengths.error / ulp_of(lengths.exact, precision);
    into.ulp.push_back(ulp);
    if (ulp > into.worst_ulp) {
        into.worst_ulp = ulp;
        into.worst_at = x;
    }
    if (ulp > bound) ++into.over;
}

}  // namespace scanshade

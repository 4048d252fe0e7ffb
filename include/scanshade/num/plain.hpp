// Interval and Dual as plain data, which crosses between targets and into the registry of models.
#pragma once

#include <cmath>

namespace scanshade {

/// All reals from low to high; what num/interval.hpp computes with.
struct PlainInterval {
    float low, high;
};

/// A value and its derivative with respect to one variable; what num/dual.hpp computes with.
struct PlainDual {
    double value, derivative;
};

/// Relative condition number |x f′(x)/f(x)|: by how much f magnifies a relative error of x, where
/// `fx` was evaluated with derivative 1 at x. 0 where f is 0 and flat.
inline double condition_number(double x, const PlainDual& fx) {
    const double slope = std::abs(x * fx.derivative);
    return slope > 0 ? slope / std::abs(fx.value) : 0;
}

}  // namespace scanshade

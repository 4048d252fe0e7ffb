// Laws that measured points follow.
#pragma once

#include <optional>
#include <vector>

namespace scanshade {

/// A fitted number and its interval of 95 % confidence.
struct Estimate {
    double value, low, high;
};

struct Fit {
    Estimate slope, constant;
    std::size_t points;
};

/// y = c x^s by least squares on the logarithms: `slope` is s and `constant` is c. Points that are
/// not positive are left out; nothing where fewer than three points, or two different x, remain.
std::optional<Fit> fit_power(const std::vector<double>& x, const std::vector<double>& y);

/// y = c + s x, least squares of relative errors: every point counts alike, however small its y.
/// Points of y ≤ 0 are left out; nothing where fewer than three points, or two different x, remain.
std::optional<Fit> fit_line(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace scanshade

#include "scanshade/report/fit.hpp"

#include <algorithm>
#include <cmath>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

struct Point {
    double x, y, weight;
};

/// Student's t that 2.5 % of its values exceed.
double t_quantile(std::size_t degrees) {
    constexpr double few[] = {12.706, 4.303, 3.182, 2.776};
    if (degrees <= std::size(few)) return few[degrees - 1];
    // The first terms of Cornish and Fisher's expansion about the normal quantile; off by < 1e-3.
    const double z = 1.959964, z3 = z * z * z, z5 = z3 * z * z, n = double(degrees);
    return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n);
}

Estimate around(double value, double half) { return {value, value - half, value + half}; }

/// Weighted least squares about the weighted mean, where slope and height are uncorrelated.
std::optional<Fit> fit_weighted(const std::vector<Point>& points) {
    if (points.size() < 3) return std::nullopt;
    double w = 0, x = 0, y = 0;
    for (const Point& p : points) w += p.weight, x += p.weight * p.x, y += p.weight * p.y;
    x /= w, y /= w;
    double xx = 0, xy = 0;
    for (const Point& p : points) {
        xx += p.weight * (p.x - x) * (p.x - x);
        xy += p.weight * (p.x - x) * (p.y - y);
    }
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    if (low->x == high->x) return std::nullopt;
    const double slope = xy / xx, constant = y - slope * x;
    double rest = 0;
    for (const Point& p : points) {
        const double r = p.y - (constant + slope * p.x);
        rest += p.weight * r * r;
    }
    const std::size_t degrees = points.size() - 2;
    const double t = t_quantile(degrees) * std::sqrt(rest / double(degrees));
    return Fit{around(slope, t / std::sqrt(xx)),
               around(constant, t * std::sqrt(1 / w + x * x / xx)), points.size()};
}

}  // namespace

std::optional<Fit> fit_power(const std::vector<double>& x, const std::vector<double>& y) {
    SCANSHADE_CHECK(x.size() == y.size());
    std::vector<Point> points;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i] > 0 && y[i] > 0) points.push_back({std::log(x[i]), std::log(y[i]), 1});
    std::optional<Fit> fit = fit_weighted(points);
    if (!fit) return fit;
    Estimate& c = fit->constant;
    c = {std::exp(c.value), std::exp(c.low), std::exp(c.high)};
    return fit;
}

std::optional<Fit> fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    SCANSHADE_CHECK(x.size() == y.size());
    std::vector<Point> points;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (y[i] > 0) points.push_back({x[i], y[i], 1 / (y[i] * y[i])});
    return fit_weighted(points);
}

}  // namespace scanshade

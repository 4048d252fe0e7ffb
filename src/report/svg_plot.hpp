// Plots as SVG text, for pages that must stand alone.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scanshade {

inline constexpr int plot_width = 520;  // pixels

struct PlotPoint {
    double x, y;
};

struct Curve {
    std::string label;
    std::vector<PlotPoint> points;  // finite
    bool dashed = false;
};

struct Axes {
    std::string x_label, y_label;
    double x_low, x_high;
    bool x_log = false, y_log = false;
    // Nothing: y starts at 0, or at a round number below what is negative, or at the power of ten
    // below all curves, and ends at a round number above them.
    std::optional<double> y_low{}, y_high{};

    /// t in [0, 1] along the axis.
    double x_at(double t) const {
        return x_log ? x_low * std::pow(x_high / x_low, t) : x_low + t * (x_high - x_low);
    }
};

/// Curves over x in [x_low, x_high]. On a logarithmic axis what is not positive is left out.
std::string line_plot(const Axes& axes, const std::vector<Curve>& curves);

/// Curves over the upper half circle: x is the angle from the vertical in radians, positive to the
/// right, y ≥ 0 the distance from the centre. Rings are labelled with it.
std::string polar_plot(const std::vector<Curve>& curves);

}  // namespace scanshade

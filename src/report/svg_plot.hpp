// Plots as SVG text, for pages that must stand alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scanshade {

struct PlotPoint {
    double x, y;
};

struct Curve {
    std::string label;
    std::vector<PlotPoint> points;  // finite
};

struct Axes {
    std::string x_label, y_label;
    double x_low, x_high;
};

/// Curves over x in [x_low, x_high]; y starts at 0 and ends at a round number above all curves.
std::string line_plot(const Axes& axes, const std::vector<Curve>& curves);

/// Curves over the upper half circle: x is the angle from the vertical in radians, positive to the
/// right, y ≥ 0 the distance from the centre. Rings are labelled with it.
std::string polar_plot(const std::vector<Curve>& curves);

}  // namespace scanshade

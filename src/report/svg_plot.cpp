#include "report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scanshade/report/page.hpp"

namespace scanshade {
namespace {

constexpr double width = 560, height = 340, left = 62, right = 150, top = 16, bottom = 46;
// Colours that stay apart for colour-blind readers (Okabe and Ito 2008).
constexpr std::string_view colours[] = {"#0072b2", "#d55e00", "#009e73",
                                        "#cc79a7", "#e69f00", "#56b4e9"};

std::string_view colour(std::size_t curve) { return colours[curve % std::size(colours)]; }

/// 1, 2 or 5 times a power of ten, so that about `parts` of it make up `range`.
double round_step(double range, int parts) {
    const double rough = range / parts, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

double largest(const std::vector<Curve>& curves) {
    double y = 1e-12;
    for (const Curve& curve : curves)
        for (const PlotPoint& p : curve.points) y = std::max(y, p.y);
    return y;
}

class Svg {
public:
    Svg()
        : text_(fmt::format(
              "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
              "height=\"{}\" font-family=\"sans-serif\" font-size=\"12\">\n",
              width, height, width, height)) {}
    void line(double x1, double y1, double x2, double y2, std::string_view stroke) {
        text_ += fmt::format(
            "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\"/>\n", x1,
            y1, x2, y2, stroke);
    }
    void half_circle(double x, double y, double r) {
        text_ += fmt::format(
            "<path d=\"M {:.2f} {:.2f} A {:.2f} {:.2f} 0 0 1 {:.2f} {:.2f}\" fill=\"none\" "
            "stroke=\"#ddd\"/>\n",
            x - r, y, r, r, x + r, y);
    }
    void label(double x, double y, std::string_view anchor, std::string_view text) {
        text_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                             anchor, escaped(text));
    }
    void polyline(const std::vector<PlotPoint>& points, std::string_view stroke) {
        text_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" points=\"",
                             stroke);
        for (const PlotPoint& p : points) text_ += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
        text_ += "\"/>\n";
    }
    void legend(const std::vector<Curve>& curves) {
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const double x = width - right + 14, y = top + 14 + 20 * double(i);
            line(x, y - 4, x + 18, y - 4, colour(i));
            label(x + 24, y, "start", curves[i].label);
        }
    }
    std::string finish() { return text_ + "</svg>\n"; }

private:
    std::string text_;
};

}  // namespace

std::string line_plot(const Axes& axes, const std::vector<Curve>& curves) {
    const double y_step = round_step(largest(curves), 5);
    const double y_high = y_step * std::ceil(largest(curves) / y_step);
    const double x_step = round_step(axes.x_high - axes.x_low, 6);
    const auto at_x = [&](double x) {
        return left + (x - axes.x_low) / (axes.x_high - axes.x_low) * (width - left - right);
    };
    const auto at_y = [&](double y) {
        return height - bottom - y / y_high * (height - top - bottom);
    };
    Svg svg;
    for (double y = 0; y < y_high + y_step / 2; y += y_step) {
        svg.line(left, at_y(y), width - right, at_y(y), "#ddd");
        svg.label(left - 6, at_y(y) + 4, "end", fmt::format("{:.3g}", y));
    }
    for (double x = axes.x_low; x < axes.x_high + x_step * 1e-6; x += x_step) {
        svg.line(at_x(x), at_y(0), at_x(x), at_y(0) + 5, "#555");
        svg.label(at_x(x), at_y(0) + 18, "middle", fmt::format("{:.3g}", x));
    }
    svg.line(left, at_y(0), width - right, at_y(0), "#555");
    svg.label((left + width - right) / 2, height - 8, "middle", axes.x_label);
    svg.label(4, top - 4, "start", axes.y_label);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::vector<PlotPoint> points;
        for (const PlotPoint& p : curves[i].points) points.push_back({at_x(p.x), at_y(p.y)});
        svg.polyline(points, colour(i));
    }
    svg.legend(curves);
    return svg.finish();
}

std::string polar_plot(const std::vector<Curve>& curves) {
    const double centre_x = left + (width - left - right) / 2, centre_y = height - bottom;
    const double radius = std::min((width - left - right) / 2, height - top - bottom);
    const double step = round_step(largest(curves), 4);
    const double outermost = step * std::ceil(largest(curves) / step);
    Svg svg;
    for (double r = step; r < outermost + step / 2; r += step) {
        svg.half_circle(centre_x, centre_y, r / outermost * radius);
        svg.label(centre_x + r / outermost * radius, centre_y + 16, "middle",
                  fmt::format("{:.3g}", r));
    }
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        const double a = degrees * 3.14159265358979323846 / 180;
        svg.line(centre_x, centre_y, centre_x + radius * std::sin(a),
                 centre_y - radius * std::cos(a), degrees == 0 ? "#555" : "#ddd");
    }
    svg.line(centre_x - radius, centre_y, centre_x + radius, centre_y, "#555");
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::vector<PlotPoint> points;
        for (const PlotPoint& p : curves[i].points) {
            const double r = p.y / outermost * radius;
            points.push_back({centre_x + r * std::sin(p.x), centre_y - r * std::cos(p.x)});
        }
        svg.polyline(points, colour(i));
    }
    svg.legend(curves);
    return svg.finish();
}

}  // namespace scanshade

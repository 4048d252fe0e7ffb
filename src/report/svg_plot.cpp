#include "report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scanshade/report/page.hpp"

namespace scanshade {
namespace {

constexpr double width = plot_width, height = 340, left = 62, right = 140, top = 28, bottom = 46;
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

double least_of(const std::vector<Curve>& curves) {
    double y = largest(curves);
    for (const Curve& curve : curves)
        for (const PlotPoint& p : curve.points) y = std::min(y, p.y);
    return y;
}

double least_positive(const std::vector<Curve>& curves) {
    double y = largest(curves);
    for (const Curve& curve : curves)
        for (const PlotPoint& p : curve.points)
            if (p.y > 0) y = std::min(y, p.y);
    return y;
}

/// One axis: from a number to its place along it, and the numbers that stand there.
struct Scale {
    double low, high, step;  // step: of a linear one
    bool logarithmic;

    static Scale between(double low, double high, bool logarithmic, int parts) {
        return {low, high, logarithmic ? 0 : round_step(high - low, parts), logarithmic};
    }
    bool can_show(double v) const { return !logarithmic || v > 0; }
    /// 0 at `low`, 1 at `high`.
    double place(double v) const {
        return logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
    }
    std::vector<double> ticks() const {
        std::vector<double> out;
        if (!logarithmic) {
            const long first = std::lround(std::ceil(low / step - 1e-6));
            for (long i = first; double(i) * step <= high + step * 1e-6; ++i)
                out.push_back(double(i) * step + 0.0);  // no −0
            return out;
        }
        const double decades = std::log10(high / low);
        const long every = std::lround(std::ceil(decades / 7));
        const long first = std::lround(std::ceil(std::log10(low) - 1e-6));
        for (long i = first; double(i) <= std::log10(high) + 1e-6; i += every)
            for (const double digit : {1.0, 2.0, 5.0})
                if ((digit == 1 || decades < 3) && digit * std::pow(10, i) <= high * 1.000001)
                    out.push_back(digit * std::pow(10, i));
        return out;
    }
};

Scale y_scale(const Axes& axes, const std::vector<Curve>& curves) {
    const double most = largest(curves);
    if (axes.y_log) {
        const double low = std::pow(10, std::floor(std::log10(least_positive(curves))));
        const double high = std::pow(10, std::ceil(std::log10(most) - 1e-9));
        return Scale::between(axes.y_low.value_or(low), axes.y_high.value_or(high), true, 5);
    }
    const double least = least_of(curves), step = round_step(most - std::min(least, 0.0), 5);
    return Scale::between(axes.y_low.value_or(least < 0 ? step * std::floor(least / step) : 0),
                          axes.y_high.value_or(step * std::ceil(most / step)), false, 5);
}

class Svg {
public:
    Svg()
        : text_(fmt::format(
              "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
              "height=\"{}\" font-family=\"sans-serif\" font-size=\"12\">\n",
              width, height, width, height)) {}
    void line(double x1, double y1, double x2, double y2, std::string_view stroke,
              bool dashed = false) {
        text_ += fmt::format(
            "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\"{}/>\n", x1,
            y1, x2, y2, stroke, dash(dashed));
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
    void polyline(const std::vector<PlotPoint>& points, std::string_view stroke, bool dashed) {
        text_ +=
            fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{} points=\"",
                        stroke, dash(dashed));
        for (const PlotPoint& p : points) text_ += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
        text_ += "\"/>\n";
    }
    void legend(const std::vector<Curve>& curves) {
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const double x = width - right + 14, y = top + 14 + 20 * double(i);
            line(x, y - 4, x + 18, y - 4, colour(i), curves[i].dashed);
            label(x + 24, y, "start", curves[i].label);
        }
    }
    /// Between the two nothing is drawn beyond the axes.
    void begin_clipped() {
        text_ += fmt::format(
            "<clipPath id=\"axes\"><rect x=\"{}\" y=\"{}\" width=\"{}\" "
            "height=\"{}\"/></clipPath>\n"
            "<g clip-path=\"url(#axes)\">\n",
            left, top - 1, width - left - right, height - top - bottom + 2);
    }
    void end_clipped() { text_ += "</g>\n"; }
    std::string finish() { return text_ + "</svg>\n"; }

private:
    static std::string_view dash(bool dashed) { return dashed ? " stroke-dasharray=\"5 4\"" : ""; }

    std::string text_;
};

}  // namespace

std::string line_plot(const Axes& axes, const std::vector<Curve>& curves) {
    const Scale x = Scale::between(axes.x_low, axes.x_high, axes.x_log, 6),
                y = y_scale(axes, curves);
    const auto at_x = [&](double v) { return left + x.place(v) * (width - left - right); };
    const auto at_y = [&](double v) {
        return height - bottom - y.place(v) * (height - top - bottom);
    };
    const double floor = height - bottom;
    Svg svg;
    for (const double v : y.ticks()) {
        svg.line(left, at_y(v), width - right, at_y(v), "#ddd");
        svg.label(left - 6, at_y(v) + 4, "end", fmt::format("{:g}", v));
    }
    for (const double v : x.ticks()) {
        svg.line(at_x(v), floor, at_x(v), floor + 5, "#555");
        svg.label(at_x(v), floor + 18, "middle", fmt::format("{:g}", v));
    }
    svg.line(left, floor, width - right, floor, "#555");
    svg.label((left + width - right) / 2, height - 8, "middle", axes.x_label);
    svg.label(4, 13, "start", axes.y_label);
    svg.begin_clipped();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::vector<PlotPoint> points;
        for (const PlotPoint& p : curves[i].points)
            if (x.can_show(p.x) && y.can_show(p.y)) points.push_back({at_x(p.x), at_y(p.y)});
        svg.polyline(points, colour(i), curves[i].dashed);
    }
    svg.end_clipped();
    svg.legend(curves);
    return svg.finish();
}

std::string polar_plot(const std::vector<Curve>& curves) {
    const double centre_x = left + (width - left - right) / 2, centre_y = height - bottom;
    const double radius = std::min((width - left - right) / 2, height - top - bottom);
    const double step = round_step(largest(curves), 4);
    const long rings = std::lround(std::ceil(largest(curves) / step));
    const double outermost = step * double(rings);
    Svg svg;
    for (long ring = 1; ring <= rings; ++ring) {
        const double r = step * double(ring);
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
        svg.polyline(points, colour(i), curves[i].dashed);
    }
    svg.legend(curves);
    return svg.finish();
}

}  // namespace scanshade

// What a lesson is made with: its scene under any options, pictures, plots and measured numbers.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/svg_plot.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/report/lesson.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/subject.hpp"

namespace scanshade {

/// Options as the command line spells them: {"shading", "flat"}.
using LessonOptions = std::vector<std::pair<std::string_view, std::string>>;

class LessonWork {
public:
    /// Files of the lesson begin with its name and go into `folder`; both outlive this.
    LessonWork(const LessonInfo& lesson, const std::filesystem::path& scenes,
               const std::string& folder, Page& page);

    /// The lesson's scene as `scanshade render` reads it with these options.
    ReportInput input(const LessonOptions& options = {}) const;

    // Each writes one file and returns it with its caption.
    Figure picture(std::string_view file, const Image& image, std::string caption) const;
    Figure picture(std::string_view file, const ReportInput& input, std::string caption) const;
    Figure picture(std::string_view file, const LessonOptions& options, std::string caption) const;
    /// SVG text.
    Figure plot(std::string_view file, const std::string& svg, std::string caption) const;

    void paragraph(std::string_view text) { page_.paragraph(text); }
    void figures(const std::vector<Figure>& figures) { page_.figures(figures); }
    void table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows) {
        page_.table(head, rows);
    }
    /// A row of the table of what was measured; returns the value.
    double measured(std::string what, double value, std::string unit = {});

    const std::vector<LessonFact>& facts() const { return facts_; }

private:
    std::string path_of(const std::string& file) const;

    const LessonInfo& lesson_;
    std::filesystem::path scene_;
    std::string folder_;
    Page& page_;
    std::vector<LessonFact> facts_;
};

// ---- drawing

/// Linear radiance, depth and triangles.
Framebuffer draw_planes(const ReportInput& input);
Image shown(const Framebuffer& frame, const Settings& settings);

/// Every shape of the scene with so many polygons.
ReportInput with_tessellation(const ReportInput& input, int tessellation);
/// The scene with one of its objects alone.
ReportInput with_object(const ReportInput& input, std::size_t object);
/// A parameter of every material.
ReportInput with_parameter(ReportInput input, std::string name, double value);

// ---- measuring

/// Mean of the three channels at a pixel.
double radiance_at(const Framebuffer& frame, int x, int y);
/// Along a row of pixels, from the centre of the first to that of the last.
Curve row_curve(const Framebuffer& frame, int y, std::string label);
double peak_radiance(const Framebuffer& frame);
/// Root mean square error in levels of 255, as they are shown.
double level_rmse(const Framebuffer& picture, const Framebuffer& reference,
                  const Settings& settings);
/// The largest error of a channel in levels of 255, as they are shown.
double level_max(const Framebuffer& picture, const Framebuffer& reference,
                 const Settings& settings);
/// Where the two differ, black to white for 0 to `top` levels.
Image level_heat(const Framebuffer& picture, const Framebuffer& reference, const Settings& settings,
                 double top);

/// Where `error`, with one minimum in [low, high], is least: golden section search, to 1/5000 of the
/// interval.
template <class Error>
double least_at(double low, double high, Error&& error) {
    constexpr double golden = 0.61803398874989484820;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double at_a = error(a), at_b = error(b);
    for (int i = 0; i < 17; ++i) {
        if (at_a < at_b) {
            high = b, b = a, at_b = at_a;
            a = high - golden * (high - low), at_a = error(a);
        } else {
            low = a, a = b, at_a = at_b;
            b = low + golden * (high - low), at_b = error(b);
        }
    }
    return (low + high) / 2;
}

/// A curve y = f(x) through points at equal steps, or equal ratios, from x_low to x_high.
template <class Function>
Curve sampled(std::string label, const Axes& axes, Function&& y, int points = 181) {
    Curve curve{std::move(label), {}};
    for (int i = 0; i < points; ++i) {
        const double x = axes.x_at(double(i) / (points - 1));
        curve.points.push_back({x, y(x)});
    }
    return curve;
}

}  // namespace scanshade

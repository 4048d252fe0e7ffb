// Kinks of the radiance, and what the eye makes of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"

namespace scanshade::lessons {
namespace {

constexpr double narrow = 3, wide = 9;  // pixels, of the two Gaussians of a receptor

/// A row, seen by receptors that are excited from their middle and inhibited from around it: the
/// difference of two Gaussians. Flat and evenly sloping rows give 0.
Curve receptors(const Curve& row) {
    const auto blurred = [&](std::size_t at, double sigma) {
        double sum = 0, weights = 0;
        const int reach = int(std::ceil(3 * sigma)), last = int(row.points.size()) - 1;
        for (int k = -reach; k <= reach; ++k) {
            const double w = std::exp(-0.5 * k * k / (sigma * sigma));
            sum += w * row.points[std::size_t(std::clamp(int(at) + k, 0, last))].y;
            weights += w;
        }
        return sum / weights;
    };
    Curve out{row.label, {}};
    for (std::size_t i = 0; i < row.points.size(); ++i)
        out.points.push_back({row.points[i].x, blurred(i, narrow) - blurred(i, wide)});
    return out;
}

/// Radiance a pixel.
Curve slope(const Curve& row) {
    Curve out{row.label, {}};
    for (std::size_t i = 1; i + 1 < row.points.size(); ++i)
        out.points.push_back({row.points[i].x, (row.points[i + 1].y - row.points[i - 1].y) / 2});
    return out;
}

/// The part of a curve between two columns.
Curve between(const Curve& curve, double from, double to) {
    Curve out{curve.label, {}};
    for (const PlotPoint& p : curve.points)
        if (p.x >= from && p.x <= to) out.points.push_back(p);
    return out;
}

double largest_step(const Curve& curve) {
    double step = 0;
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        step = std::max(step, std::abs(curve.points[i].y - curve.points[i - 1].y));
    return step;
}

void fill_mach_bands(LessonWork& work) {
    work.paragraph(
        "Flat shading makes steps of the radiance, gouraud shading kinks: it is continuous, but "
        "its slope jumps at every edge. The eye answers to differences from the surroundings, so "
        "it sees a bright band at a kink that bends down and a dark one at a kink that bends up, "
        "where no photometer finds them. Ernst Mach described this in 1865.");
    std::vector<Figure> figures;
    std::vector<Curve> rows, slopes, seen;
    const double from = 62, to = 258;  // away from the silhouette
    for (const std::string shading : {"flat", "gouraud", "phong"}) {
        figures.push_back(
            work.picture(shading, {{"shading", shading}}, fmt::format("{} shading", shading)));
        const ReportInput input = work.input({{"shading", shading}, {"samples", "1"}});
        const Curve row = row_curve(draw_planes(input), input.settings.height / 2, shading);
        rows.push_back(between(row, from, to));
        slopes.push_back(between(slope(row), from, to));
        seen.push_back(between(receptors(row), from, to));
    }
    work.figures(figures);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        work.measured(fmt::format("{}: largest step between neighbours", rows[i].label),
                      largest_step(rows[i]), "radiance");
        if (i > 0)
            work.measured(fmt::format("{}: largest jump of the slope", rows[i].label),
                          largest_step(slopes[i]), "radiance a pixel");
    }
    slopes.erase(slopes.begin());  // of flat shading: steps that dwarf the others
    seen.erase(seen.begin());
    work.figures(
        {work.plot("row", line_plot({"column", "radiance", from, to}, rows),
                   "A row of pixels: steps, kinks, and a smooth curve."),
         work.plot("slope",
                   line_plot({"column", "slope of the radiance, a pixel", from, to}, slopes),
                   "Its slope: under gouraud shading constant in a face, with jumps."),
         work.plot("receptors", line_plot({"column", "answer of the receptors", from, to}, seen),
                   fmt::format("What receptors answer that are excited from {} and inhibited "
                               "from {} pixels around (difference of two Gaussians): peaks at the "
                               "kinks.",
                               narrow, wide))});
}

constexpr LessonEquation equations[] = {
    {"C3", "I_AB = I_A (y − B_y)/(A_y − B_y) + I_B (A_y − y)/(A_y − B_y)", "along_edge"},
    {"C5", "N_X = N_AB ((AC)_x − x)/((AC)_x − (AB)_x) + N_AC (x − (AB)_x)/((AC)_x − (AB)_x)",
     "span_normal"},
};
constexpr LessonCommand commands[] = {
    {"render", "--shading gouraud -o gouraud.png"},
    {"render", "--shading phong -o phong.png"},
    {"render", "--shading gouraud --transfer linear -o linear.png"},
};
constexpr LessonQuestion questions[] = {
    {"How can you show that a Mach band is not in the picture?",
     "Cover its surroundings with two sheets of paper, or read the pixels (scanshade inspect): the "
     "values rise and fall without a peak at the edge."},
    {"Does phong shading have no bands at all?",
     "Its radiance has no kink where the normal has none. The normal itself is interpolated "
     "linearly and then made unit, so its derivative jumps at edges: the kinks are of higher order "
     "and much weaker, as the plot of the slope shows."},
    {"Why do more polygons help less than one would hope?",
     "Kinks get smaller, but more numerous; and the eye is most sensitive to regular patterns."},
};

}  // namespace

constinit const LessonInfo mach_bands{
    "mach-bands",
    "Mach bands",
    "Gouraud shading is continuous, but its slope is not; the eye sees bands that are not there.",
    equations,
    commands,
    questions,
    fill_mach_bands};

}  // namespace scanshade::lessons

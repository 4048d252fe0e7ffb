// The pictures' part of the stability report, for people.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/picture_files.hpp"

namespace scanshade {
namespace {

/// "guard-clipped 2, near-clipped 1"
std::string events_text(const PictureCaseResult& result) {
    EventCounts events = result.loading;
    if (!result.renderers.empty()) events += result.renderers.front().events;
    std::string text;
    for (const EventInfo& info : all_events())
        if (const std::uint64_t n = events[info.event]; n > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", info.name, n);
    return text;
}

template <class Value>
Cell bounded_cell(const std::string& text, Value value, Value most) {
    return number_cell(text, value <= most ? "" : "bad");
}

template <class Value>
Cell count_cell(Value value, Value most) {
    return bounded_cell(fmt::format("{}", value), value, most);
}

/// The largest of a number over a case's renderers.
template <class Value>
Value largest(const PictureCaseResult& result, Value RendererResult::*number) {
    Value most{};
    for (const RendererResult& r : result.renderers) most = std::max(most, r.*number);
    return most;
}

void add_colours(const PictureStability& pictures, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const PictureCaseResult& c : pictures.cases) {
        const auto none = std::uint64_t{0};
        rows.push_back({{c.name, "whole"},
                        count_cell(largest(c, &RendererResult::not_finite), none),
                        count_cell(largest(c, &RendererResult::other_id), none),
                        count_cell(largest(c, &RendererResult::levels), c.bounds.levels),
                        number_cell(fmt::format("{}", c.bounds.levels), "faint"),
                        count_cell(largest(c, &RendererResult::beyond), c.bounds.beyond),
                        number_cell(fmt::format("{}", c.bounds.beyond), "faint"),
                        {events_text(c), "faint"}});
    }
    page.table({"case", "NaN or Inf", "other triangle", "levels", "bound", "pixels beyond one",
                "bound", "rare events"},
               rows);
}

void add_geometry(const PictureStability& pictures, Page& page) {
    const auto distance = [](double d) { return fmt::format("{:.3f}", d); };
    const auto bound_text = [&](double d) { return std::isfinite(d) ? fmt::format("{}", d) : ""; };
    std::vector<std::vector<Cell>> rows;
    for (const PictureCaseResult& c : pictures.cases) {
        const GeometryResult& g = c.geometry;
        rows.push_back(
            {{c.name, "whole"},
             bounded_cell(distance(g.displacement), g.displacement, c.bounds.displacement),
             bounded_cell(distance(g.edge_distance), g.edge_distance, c.bounds.displacement),
             number_cell(bound_text(c.bounds.displacement), "faint"),
             bounded_cell(fmt::format("{:.0f} %", 100 * g.bound_share), g.bound_share, 1.0),
             number_cell(fmt::format("{} of {}", g.moved, g.samples)),
             number_cell(fmt::format("{}", g.opened)),
             count_cell(g.mistaken, c.bounds.mistaken)});
    }
    page.table({"case", "vertex moved by", "edge moved by", "bound", "of what rounding can come to",
                "samples moved", "opened", "mistaken"},
               rows);
}

/// What each case is about, and why its bounds are wider than the others'.
void add_cases(const PictureStability& pictures, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const PictureCaseResult& c : pictures.cases) {
        const bool usual = c.bounds.reason == PictureBounds{}.reason;
        rows.push_back(
            {{c.name, "whole"}, {c.difficulty}, {usual ? "" : std::string(c.bounds.reason)}});
    }
    page.table({"case", "what is hard about it", "why its bounds are wider"}, rows);
}

}  // namespace

void add_picture_section(const PictureStability& pictures, bool plots_drawn, Page& page) {
    page.section("Pictures");
    if (pictures.cases.empty()) return page.paragraph("Nothing was drawn.");
    page.paragraph(
        "Scenes that are hard for numbers, each drawn by scalar-f64, scalar-f32 and the vector "
        "renderer on every instruction set of this machine. All must show the same triangle at the "
        "same depth at every sample, and no NaN or Inf; colours may differ from those of "
        "scalar-f64 "
        "by one level of 255, and by more only in the cases that the table names with the "
        "reason.");
    std::vector<Figure> figures;
    for (const PictureCaseResult& c : pictures.cases)
        figures.push_back({picture_file(pictures, c), c.name});
    page.figures(figures);
    add_cases(pictures, page);
    page.paragraph(fmt::format("The other bounds: {}.", PictureBounds{}.reason));
    if (plots_drawn)
        page.figures({{levels_plot, "Differences of colour, the largest of each case."},
                      {geometry_plot, "Differences of geometry, the largest of each case."}});
    page.paragraph(
        "Colour: the largest number of any renderer. Rare events are those of loading and of "
        "scalar-f64.");
    add_colours(pictures, page);
    page.paragraph(
        "Geometry: all renderers share one, rounded to float and snapped to 1/256 pixel. Beside it "
        "stands another one in double, not snapped, that starts from the same meshes. Moved are "
        "samples that some triangle covers in one of the two only; each of them must lie as near "
        "to the exact edge as vertices may be displaced. Opened are those of them that show "
        "nothing "
        "in one of the two. Mistaken are other samples, at which another triangle is nearest in "
        "double. Distances are in 1/256 pixel.");
    add_geometry(pictures, page);
}

}  // namespace scanshade

// The error report as people read it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/error_parts.hpp"

namespace scanshade {
namespace {

/// Short enough for a table, and nothing where there is nothing.
Cell error_cell(double value, std::string_view style = {}) {
    if (std::isnan(value)) return number_cell("–", "faint");
    return number_cell(std::isinf(value) ? "∞" : short_number(value), style);
}

std::string with_interval(const Estimate& e) {
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", e.value, e.low, e.high);
}

std::string memory_text(std::uint64_t bytes) {
    return bytes == 0 ? "–" : fmt::format("{:.1f}", double(bytes) / 0x1p20);
}

std::vector<std::string> table_head() {
    std::vector<std::string> head{"method", "ms", "least"};
    for (const Metric& metric : all_metrics())
        head.push_back(metric.unit == "1" ? std::string(metric.symbol)
                                          : fmt::format("{}, {}", metric.symbol, metric.unit));
    for (const char* name :
         {"RMSE inside", "RMSE at silhouettes", "efficiency", "MiB", "triangles"})
        head.emplace_back(name);
    return head;
}

/// Errors no larger than twice the reference's own say nothing of the method.
std::string_view style_of(const ErrorAxisResult& result, const ErrorRow& row) {
    if (row.on_front) return "good";
    return row.error("rmse") <= 2 * result.own_rmse ? "faint" : "";
}

std::vector<Cell> row_cells(const ErrorAxisResult& result, const ErrorRow& row) {
    const std::string_view style = style_of(result, row);
    std::vector<Cell> cells{
        {row.method.name + (row.method.as_given ? " (as given)" : "") + (row.on_front ? " ●" : ""),
         "whole", row.picture}};
    cells.push_back(row.time ? number_cell(short_number(row.time->median), style)
                             : number_cell("–", "faint"));
    cells.push_back(row.time ? number_cell(short_number(row.time->min), "faint")
                             : number_cell("–", "faint"));
    for (const Metric& metric : all_metrics())
        cells.push_back(
            error_cell(row.error(metric.name), metric.name == "rmse" ? style : std::string_view()));
    cells.push_back(error_cell(row.error("rmse", ErrorRegion::interior)));
    cells.push_back(error_cell(row.error("rmse", ErrorRegion::silhouette)));
    cells.push_back(error_cell(row.efficiency()));
    cells.push_back(number_cell(memory_text(row.memory), "faint"));
    cells.push_back(number_cell(fmt::format("{}", row.triangles), "faint"));
    return cells;
}

void add_orders(const ErrorAxisResult& result, Page& page) {
    if (result.orders.empty()) return;
    const bool known = !result.axis->expected.empty();
    std::vector<std::vector<Cell>> rows;
    for (const ErrorOrder& order : result.orders) {
        const Metric& metric = find_metric(order.metric);
        rows.push_back({{order.series, "whole"},
                        {fmt::format("{}, {} pixels", metric.symbol,
                                     error_region_names()[std::size_t(order.region)])},
                        {order.against, "whole"},
                        number_cell(with_interval(order.order))});
        if (!known) continue;
        const ExpectedOrder* expected = order.expected;
        rows.back().push_back(number_cell(expected ? fmt::format("{}", expected->order) : ""));
        rows.back().push_back({std::string(expected ? expected->why : "")});
    }
    std::vector<std::string> head{"method", "error", "against", "order"};
    if (known) head.insert(head.end(), {"expected", "because (h: the side of a polygon)"});
    page.paragraph(
        "How fast errors fall: error ~ amount^(−order), of the last four rows of each "
        "method, with the 95 % confidence interval of the fit.");
    page.table(head, rows);
}

/// The reference, the scene as it is given, and what is on the front besides.
void add_pictures(const ErrorSceneResult& scene, const ErrorAxisResult& result, Page& page) {
    constexpr std::size_t most = 5;
    const int width = std::min(scene.width, 200);
    std::vector<Figure> figures{{result.reference_picture, "reference", false, width}};
    for (const bool given : {true, false})
        for (const ErrorRow& row : result.rows)
            if (figures.size() < most && row.method.as_given == given && (given || row.on_front))
                figures.push_back({row.picture, row.method.name, false, width});
    page.figures(figures);
}

void add_axis(const ErrorSceneResult& scene, const ErrorAxisResult& result, std::size_t number,
              bool with_plots, Page& page) {
    page.subsection(fmt::format("{}: {}", result.axis->name, result.axis->question));
    page.paragraph(fmt::format("Reference: {}. Its own error: about {} (RMSE); {}.",
                               result.reference, short_number(result.own_rmse), result.own_from));
    if (result.rows.empty()) return page.paragraph("Nothing was measured.");
    const bool has_points =
        std::any_of(result.rows.begin(), result.rows.end(),
                    [](const ErrorRow& row) { return row.time && row.error("rmse") > 0; });
    if (with_plots && has_points)
        page.figures({{error_plot_file(result, number),
                       fmt::format("{}: error against time. Down and to the left is better; the "
                                   "circles are the Pareto front, beside which no method is both "
                                   "faster and nearer.",
                                   result.axis->name),
                       true}});
    add_pictures(scene, result, page);
    std::vector<std::vector<Cell>> rows;
    for (const ErrorRow& row : result.rows) rows.push_back(row_cells(result, row));
    page.table(table_head(), rows);
    add_orders(result, page);
}

void add_metrics(Page& page) {
    page.section("What the columns mean");
    page.paragraph(
        "ms is the median time of a frame, from an idle renderer to encoded bytes; all methods of "
        "an axis took turns in rounds. Efficiency is 1/(MSE · seconds): twice as high is half the "
        "squared error in the same time, or the same in half. MiB is what a renderer holds beside "
        "the scene and the picture. Inside are pixels with no edge near by; at silhouettes are the "
        "others that show a surface. ● marks the Pareto front. Grey errors are no more than twice "
        "the reference's own and say nothing of the method. Linear values are radiance before "
        "exposure; a level is 1/255 of what is shown.");
    std::vector<std::vector<Cell>> rows;
    for (const Metric& metric : all_metrics())
        rows.push_back({{std::string(metric.symbol), "whole"},
                        {std::string(metric.title)},
                        {std::string(metric.picture)},
                        {metric.better == Better::lower ? "lower" : "higher"},
                        {std::string(metric.source)}});
    page.table({"column", "meaning", "of values", "better", "source"}, rows);
}

constexpr std::string_view highlight_note =
    "A highlight changes what Gouraud shading costs. It lights vertices only, so a highlight "
    "smaller than a polygon is missed or smeared over it, and finer polygons help little: its "
    "error "
    "falls with order 2 only once several polygons fit into the highlight. Phong shading "
    "interpolates normals, finds the highlight at any tessellation, and keeps its order.";

void add_scene(const ErrorReport& report, std::size_t i, bool with_plots, Page& page) {
    const ErrorSceneResult& scene = report.scenes[i];
    page.section(fmt::format("{}, {} × {} pixels", scene.name, scene.width, scene.height));
    for (std::size_t v = 1; v < scene.verdict.size(); ++v) page.verdict(scene.verdict[v]);
    for (const ErrorAxisResult& result : scene.axes)
        add_axis(scene, result, i + 1, with_plots, page);
    if (!scene.axes.empty() && scene.axes.front().axis->name == "convergence")
        page.paragraph(highlight_note);
}

}  // namespace

std::string error_page(const ErrorReport& report, bool with_plots) {
    Page page("Error against run time",
              "What each approximation costs in error and saves in time. Four kinds of error are "
              "kept apart, each with a reference of its own: that of numbers, of too few samples, "
              "of interpolation inside polygons, and of the reflection model.");
    if (report.partial)
        page.notice(
            "This report is partial: the measurement was interrupted, and scenes, rows or times "
            "are missing.");
    page.section("Verdict");
    for (const ErrorSceneResult& scene : report.scenes)
        if (!scene.verdict.empty()) page.verdict(scene.name + ". " + scene.verdict.front());
    page.paragraph(
        "As good: RMSE and FLIP of the whole picture are no more than 5 % larger, or no pixel is "
        "off "
        "by more than a level.");
    for (std::size_t i = 0; i < report.scenes.size(); ++i) add_scene(report, i, with_plots, page);
    add_metrics(page);
    page.sources(report.provenance, {"report.json", "error.csv"});
    return page.text();
}

}  // namespace scanshade

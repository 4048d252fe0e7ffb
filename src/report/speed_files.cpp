// The speed report as files.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scanshade/base/files.hpp"
#include "scanshade/report/document.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/plot.hpp"
#include "scanshade/report/speed_report.hpp"

namespace scanshade {
namespace {

constexpr double ns_per_ms = 1e6;

Estimate in_ns(const Estimate& ms) {
    return {ms.value * ns_per_ms, ms.low * ns_per_ms, ms.high * ns_per_ms};
}

// ---- for programs

std::uint64_t count(double amount) { return static_cast<std::uint64_t>(amount); }

Json point_json(const SpeedSceneResult& scene, const SpeedAxis& axis, const SpeedPoint& point) {
    const SpeedAmounts& a = point.amounts;
    Json stages = Json::object();
    for (std::size_t s = 1; s < point.stages.size(); ++s)
        stages[point.stages[s].name] = to_json(point.stages[s].times);
    return {{"axis", axis.name},
            {"method", scene.renderer},
            {"parameters",
             {{"pixels", count(a.pixels)},
              {"triangles", count(a.triangles)},
              {"lights", count(a.lights)},
              {"samples", count(a.samples)},
              {"threads", count(a.threads)},
              {"covered_samples", count(a.covered)}}},
            {"time_ms", to_json(point.stages.front().times)},
            {"stages_ms", stages}};
}

Json fit_json(const SpeedAxis& axis, const SpeedFit& fit) {
    Json json = {{"axis", axis.name}, {"stage", fit.stage}};
    if (fit.power) json["exponent"] = to_json(fit.power->slope);
    if (fit.cost) {
        json["cost_ns"] = to_json(in_ns(fit.cost->slope));
        json["cost_unit"] = axis.unit;
        json["constant_ms"] = to_json(fit.cost->constant);
    }
    return json;
}

Json scenes_json(const SpeedReport& report) {
    Json scenes = Json::array();
    for (const SpeedSceneResult& scene : report.scenes) {
        Json rows = Json::array(), fits = Json::array();
        for (const SpeedAxisResult& result : scene.axes) {
            for (const SpeedPoint& point : result.points)
                rows.push_back(point_json(scene, *result.axis, point));
            for (const SpeedFit& fit : result.fits)
                if (fit.power) fits.push_back(fit_json(*result.axis, fit));
        }
        scenes.push_back({{"name", scene.name}, {"rows", rows}, {"fits", fits}});
    }
    return scenes;
}

// ---- plots

constexpr const char* lines_script = R"(
set logscale xy
set ylabel 'ms, median'
set key outside top center horizontal samplen 2
set autoscale xfix
set offsets graph 0.03, graph 0.03
set format y '%g'
set linetype 1 linecolor rgb '#22262c' linewidth 2.5 pointtype 7
set linetype 2 linecolor rgb '#0072b2' linewidth 1.5 pointtype 5
set linetype 3 linecolor rgb '#d55e00' linewidth 1.5 pointtype 9
set linetype 4 linecolor rgb '#009e73' linewidth 1.5 pointtype 11
set linetype 5 linecolor rgb '#cc79a7' linewidth 1.5 pointtype 13
set linetype 6 linecolor rgb '#e69f00' linewidth 1.5 pointtype 4
set linetype 7 linecolor rgb '#56b4e9' linewidth 1.5 pointtype 8
set linetype 8 linecolor rgb '#737a84' linewidth 1.5 pointtype 6
plot for [i = 0:stages - 1] 'data' index i using 1:2 with linespoints title columnheader(1)
)";

/// A stage below a microsecond has no place on a logarithmic scale.
constexpr double least_ms = 1e-3;

std::string plot_file(const SpeedAxisResult& result, std::size_t scene) {
    return fmt::format("{}-{}.svg", result.axis->name, scene);
}

Plot lines_plot(const SpeedAxisResult& result, std::size_t scene) {
    Plot plot{plot_file(result, scene), 520, 340, {}, {}, {}};
    plot.script = {result.axis->plot_label, lines_script};
    double stages = 0;
    for (const StageTimes& stage : result.points.back().stages) {
        if (stage.times.median < least_ms) continue;
        plot.data.text(stage.name).end_line();
        for (const SpeedPoint& point : result.points)
            if (const Times* times = point.find(stage.name))
                plot.data.number(result.axis->amount(point.amounts))
                    .number(times->median)
                    .end_line();
        plot.data.end_block();
        ++stages;
    }
    plot.numbers = {{"stages", stages}};
    return plot;
}

std::vector<Plot> plots_of(const SpeedReport& report) {
    std::vector<Plot> plots;
    for (std::size_t i = 0; i < report.scenes.size(); ++i)
        for (const SpeedAxisResult& result : report.scenes[i].axes)
            plots.push_back(lines_plot(result, i + 1));
    return plots;
}

// ---- for people

std::string with_interval(const Estimate& e) {
    return fmt::format("{:.3g} ({:.2g} to {:.2g})", e.value, e.low, e.high);
}

std::vector<Cell> fit_cells(const SpeedAxis& axis, const SpeedFit& fit) {
    std::vector<Cell> cells{{std::string(axis.name)}, {fit.stage}};
    cells.push_back(fit.power ? number_cell(with_interval(fit.power->slope)) : Cell{""});
    cells.push_back(fit.cost ? number_cell(with_interval(in_ns(fit.cost->slope))) : Cell{""});
    cells.push_back({std::string(fit.cost ? axis.unit : ""), "whole"});
    cells.push_back(fit.cost ? number_cell(with_interval(fit.cost->constant)) : Cell{""});
    return cells;
}

void add_fits(const SpeedSceneResult& scene, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const SpeedAxisResult& result : scene.axes)
        for (const SpeedFit& fit : result.fits)
            if (fit.power) rows.push_back(fit_cells(*result.axis, fit));
    if (!rows.empty())
        page.table({"against", "stage", "exponent", "cost, ns", "of a", "constant, ms"}, rows);
}

void add_points(const SpeedSceneResult& scene, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const SpeedAxisResult& result : scene.axes) {
        const double first = result.points.front().stages.front().times.median;
        for (const SpeedPoint& point : result.points) {
            const Times& frame = point.stages.front().times;
            rows.push_back({{std::string(result.axis->name)},
                            number_cell(fmt::format("{:.0f}", result.axis->amount(point.amounts))),
                            number_cell(fmt::format("{:.3f}", frame.median)),
                            number_cell(fmt::format("{:.3f}", frame.min)),
                            number_cell(fmt::format("{}", frame.runs)),
                            number_cell(fmt::format("{:.2f}", frame.median / first), "faint")});
        }
    }
    page.table({"against", "amount", "ms, median", "ms, least", "runs", "times the first"}, rows);
}

void add_scene(const SpeedReport& report, std::size_t number, bool drawn, Page& page) {
    const SpeedSceneResult& scene = report.scenes[number];
    page.section(scene.name);
    if (scene.axes.empty()) return page.paragraph("Nothing was measured.");
    std::vector<Figure> figures;
    for (const SpeedAxisResult& result : scene.axes)
        figures.push_back(
            {plot_file(result, number + 1),
             fmt::format("The time of a frame and of its stages against {}.", result.axis->name)});
    if (drawn) page.figures(figures);
    add_fits(scene, page);
    add_points(scene, page);
}

std::string page_text(const SpeedReport& report, bool drawn) {
    Page page("What a frame costs",
              "The time of a frame, stage by stage, while one thing is varied: pixels, lights, "
              "samples a pixel and threads for each scene, triangles for a sphere.");
    if (report.partial)
        page.notice(
            "This report is partial: the measurement was interrupted, and scenes are "
            "missing or have fewer runs.");
    page.paragraph(
        "Exponent: the time grows as this power of the amount, by least squares on the "
        "logarithms; 1 is in proportion, 0 is not at all. Cost: what one more costs, by "
        "least squares of relative errors of time = constant + cost · amount. In brackets "
        "the 95 % confidence interval of the fit. Where a fit is missing there were "
        "fewer than three points.");
    for (std::size_t i = 0; i < report.scenes.size(); ++i) add_scene(report, i, drawn, page);
    page.sources(report.provenance, {"report.json", "speed.csv"});
    return page.text();
}

}  // namespace

std::vector<std::string> write_speed_report(const SpeedReport& report, const std::string& folder) {
    const std::filesystem::path path(folder);
    const Json scenes = scenes_json(report);
    write_file(report_json("speed", report.provenance, report.partial, scenes),
               path / "report.json");
    write_file(report_csv(scenes), path / "speed.csv");
    std::vector<std::string> warnings;
    if (std::string reason = draw_plots(plots_of(report), folder); !reason.empty())
        warnings.push_back(std::move(reason));
    write_file(page_text(report, warnings.empty()), path / "index.html");
    return warnings;
}

}  // namespace scanshade

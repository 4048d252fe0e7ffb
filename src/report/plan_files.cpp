// The plan's report as files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scanshade/base/files.hpp"
#include "scanshade/report/document.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/plan_report.hpp"
#include "scanshade/report/plot.hpp"

namespace scanshade {
namespace {

constexpr std::string_view whole_plan = "whole-plan";
constexpr const char *heat_file = "plan.svg", *times_file = "frames.svg";

// ---- for programs

void add_gain(const std::optional<PlanGain>& gain, const std::string& change, Json& row) {
    if (!gain) return;
    const Difference& saved = gain->saved;
    row["time_ms"] = to_json(gain->with);
    row["time_without_ms"] = to_json(gain->without);
    row["gain_ms"] = {{"median", saved.median}, {"low", saved.low}, {"high", saved.high}};
    row["share"] = gain->share;
    row["identical"] = change.empty();
    if (!change.empty()) row["change"] = change;
}

Json row_json(const PlanSceneResult& scene, std::string_view method) {
    return {{"axis", "plan"},
            {"method", method},
            {"parameters",
             {{"width", scene.width},
              {"height", scene.height},
              {"samples", scene.samples},
              {"triangles", scene.triangles},
              {"lights", scene.lights}}}};
}

Json scene_json(const PlanSceneResult& scene) {
    Json rows = Json::array();
    for (const PlanRowResult& result : scene.rows) {
        Json row = row_json(scene, result.row.info->name);
        row["left_out"] = result.row.left_out;
        row["reason"] = result.row.reason;
        if (result.row.left_out)
            row["saved"] = {{"count", result.row.saving.saved},
                            {"of", result.row.saving.of},
                            {"unit", result.row.info->unit}};
        add_gain(result.gain, result.change, row);
        rows.push_back(std::move(row));
    }
    if (scene.whole_plan) {
        rows.push_back(row_json(scene, whole_plan));
        add_gain(scene.whole_plan, scene.whole_change, rows.back());
    }
    return {{"name", scene.name}, {"rows", rows}};
}

Json scenes_json(const PlanReport& report) {
    Json scenes = Json::array();
    for (const PlanSceneResult& scene : report.scenes) scenes.push_back(scene_json(scene));
    return scenes;
}

// ---- plots

/// A long name would take the plot's room.
std::string short_name(const std::string& name) {
    constexpr std::size_t most = 24;
    return name.size() <= most ? name : clean_text(name.substr(0, most - 1)) + "…";
}

constexpr const char* heat_script = R"(
unset key
unset grid
set border 0
set tics scale 0
set lmargin 24
set rmargin 10
set xrange [-0.5:scenes - 0.5]
set yrange [rows - 0.5:-0.5]
set cbrange [-40:40]
set cblabel '% of the frame saved'
set palette defined (-40 '#c8703f', 0 '#f7f7f7', 40 '#3f7fc0')
set xtics rotate by -30
plot 'data' index 0 using 1:2:3 with image pixels, \
     'data' index 0 using 1:2:4 with labels textcolor rgb '#22262c', \
     'data' index 1 using 1:(0):xtic(2) with points pointsize 0 linecolor rgb '#f7f7f7', \
     'data' index 2 using (0):1:ytic(2) with points pointsize 0 linecolor rgb '#f7f7f7'
)";

constexpr const char* times_script = R"(
set style data histograms
set style histogram clustered gap 1
set style fill solid border rgb '#ffffff'
set ylabel 'ms a frame, median'
set yrange [0:*]
set xtics rotate by -30
set key outside top left horizontal reverse Left
plot 'data' using 2:xtic(1) title 'with the plan' linecolor rgb '#3f7fc0', \
     'data' using 3 title 'leaving nothing out' linecolor rgb '#c8703f'
)";

/// One cell: how much of the frame in %, and the same as a label; blank where nothing was timed.
void add_heat(PlotData& data, std::size_t x, std::size_t y, const std::optional<PlanGain>& gain) {
    const bool sure = gain && !gain->saved.is_noise();
    data.number(double(x)).number(double(y)).number(sure ? 100 * gain->share : 0);
    data.text(!gain ? "" : sure ? fmt::format("{:.1f}", 100 * gain->share) : "~").end_line();
}

Plot heat_plot(const PlanReport& report) {
    const std::size_t rows = plan_row_count + 1, scenes = report.scenes.size();
    Plot plot{heat_file, int(280 + 80 * scenes), 620, {}, {heat_script}, {}};
    plot.numbers = {{"scenes", double(scenes)}, {"rows", double(rows)}};
    for (std::size_t x = 0; x < scenes; ++x) {
        const PlanSceneResult& scene = report.scenes[x];
        for (std::size_t y = 0; y < plan_row_count; ++y)
            add_heat(plot.data, x, y,
                     y < scene.rows.size() ? scene.rows[y].gain : std::optional<PlanGain>());
        add_heat(plot.data, x, plan_row_count, scene.whole_plan);
    }
    plot.data.end_block();
    for (std::size_t x = 0; x < scenes; ++x)
        plot.data.number(double(x)).text(short_name(report.scenes[x].name)).end_line();
    plot.data.end_block();
    for (std::size_t y = 0; y < rows; ++y)
        plot.data.number(double(y))
            .text(y < plan_row_count ? all_plan_rows()[y].name : whole_plan)
            .end_line();
    return plot;
}

Plot times_plot(const PlanReport& report) {
    Plot plot{times_file, int(240 + 80 * report.scenes.size()), 420, {}, {times_script}, {}};
    for (const PlanSceneResult& scene : report.scenes)
        if (const auto& gain = scene.whole_plan)
            plot.data.text(short_name(scene.name))
                .number(gain->with.median)
                .number(gain->without.median)
                .end_line();
    return plot;
}

std::vector<Plot> plots_of(const PlanReport& report) {
    const auto has_times = [](const PlanSceneResult& scene) {
        return scene.whole_plan.has_value();
    };
    std::vector<Plot> plots;
    if (!report.scenes.empty()) plots.push_back(heat_plot(report));
    if (std::any_of(report.scenes.begin(), report.scenes.end(), has_times))
        plots.push_back(times_plot(report));
    return plots;
}

// ---- for people

std::string ms(double value) { return fmt::format("{:.3f}", value); }

/// Time with and without, what it saves, in ms and of the frame.
void add_gain(const std::optional<PlanGain>& gain, std::vector<Cell>& cells) {
    if (!gain) return cells.insert(cells.end(), 5, Cell{""}), void();
    const Difference& saved = gain->saved;
    const std::string_view style = saved.is_noise() ? "faint" : saved.median > 0 ? "good" : "bad";
    cells.push_back(number_cell(ms(gain->with.median)));
    cells.push_back(number_cell(ms(gain->without.median)));
    cells.push_back(number_cell(ms(saved.median), style));
    cells.push_back(number_cell(fmt::format("{} to {}", ms(saved.low), ms(saved.high)), "faint"));
    cells.push_back(number_cell(fmt::format("{:.1f} %", 100 * gain->share), style));
}

Cell same_cell(const std::optional<PlanGain>& gain, const std::string& change) {
    if (!change.empty()) return {change, "bad"};
    return {gain ? "yes" : "", "faint"};
}

void add_scene(const PlanSceneResult& scene, Page& page) {
    page.section(scene.name);
    page.paragraph(fmt::format("{} × {} pixels, {} samples a pixel, {} triangles, {} lights",
                               scene.width, scene.height, scene.samples, scene.triangles,
                               scene.lights));
    std::vector<std::vector<Cell>> rows;
    for (const PlanRowResult& result : scene.rows) {
        const PlannedRow& row = result.row;
        rows.push_back({{std::string(row.info->name), "whole"}});
        if (row.left_out)
            rows.back().push_back({row.amount()});
        else
            rows.back().push_back({fmt::format("not left out: {}", row.reason), "faint"});
        add_gain(result.gain, rows.back());
        rows.back().push_back(same_cell(result.gain, result.change));
    }
    if (scene.whole_plan) {
        rows.push_back({{std::string(whole_plan)}, {"all of the above together"}});
        add_gain(scene.whole_plan, rows.back());
        rows.back().push_back(same_cell(scene.whole_plan, scene.whole_change));
    }
    page.table({"row", "left out", "ms with the row", "ms without", "ms saved", "95 % interval",
                "of the frame", "same picture"},
               rows);
}

void add_meanings(Page& page) {
    page.section("What the rows leave out");
    std::vector<std::vector<Cell>> rows;
    for (const PlanRowInfo& info : all_plan_rows())
        rows.push_back({{std::string(info.name), "whole"}, {std::string(info.left_out)}});
    page.table({"row", "left out"}, rows);
}

std::string page_text(const PlanReport& report, const std::vector<Plot>& drawn) {
    Page page("What the plan saves",
              "Before a scene is drawn, a plan decides which work its picture does not need. Each "
              "row of the plan was measured alone: frames with the row, and frames in which the "
              "work it leaves out is done all the same, taking turns.");
    if (report.partial)
        page.notice(
            "This report is partial: the measurement was interrupted, and rows and scenes "
            "are missing or have fewer runs.");
    for (const std::string& fault : report.faults()) page.notice("Fault: " + fault);
    std::vector<Figure> figures;
    for (const Plot& plot : drawn)
        figures.push_back(
            {plot.file,
             plot.file == heat_file
                 ? "How much of the frame each row saves, in %. A ~ stands where the runs do not "
                   "show a difference for sure; blank: the row does not apply."
                 : "The time of a frame with the whole plan, and with nothing left out.",
             true});
    page.figures(figures);
    page.paragraph(
        "Times are medians. The interval holds the true median of the differences with "
        "95 % confidence: one in twenty does not. Where it contains 0 the row may save "
        "nothing, and the number is grey. Same picture: colour, depth and triangle of every pixel "
        "have the same "
        "bits with the row and without. Counts are those of all samples of a frame.");
    for (const PlanSceneResult& scene : report.scenes) add_scene(scene, page);
    add_meanings(page);
    page.sources(report.provenance, {"report.json", "plan.csv"});
    return page.text();
}

}  // namespace

std::vector<std::string> write_plan_report(const PlanReport& report, const std::string& folder) {
    const std::filesystem::path path(folder);
    const Json scenes = scenes_json(report);
    write_file(report_json("plan", report.provenance, report.partial, scenes),
               path / "report.json");
    write_file(report_csv(scenes), path / "plan.csv");
    std::vector<Plot> plots = plots_of(report);
    std::vector<std::string> warnings;
    if (std::string reason = draw_plots(plots, folder); !reason.empty()) {
        warnings.push_back(std::move(reason));
        plots.clear();
    }
    write_file(page_text(report, plots), path / "index.html");
    return warnings;
}

}  // namespace scanshade

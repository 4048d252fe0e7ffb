// The error report as files for programs, and its plots.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "report/error_parts.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/report/document.hpp"

namespace scanshade {
namespace {

// ---- for programs

/// What is not finite is null.
Json errors_json(const RegionErrors& errors) {
    constexpr const char* channels[] = {"r", "g", "b"};
    Json json = {{"pixels", errors.pixels}};
    for (std::size_t m = 0; m < errors.values.size(); ++m) {
        const Metric& metric = all_metrics()[m];
        json[std::string(metric.name)] = errors.values[m];
        for (std::size_t c = 0; !errors.channels.empty() && metric.per_channel && c < 3; ++c)
            json[fmt::format("{}-{}", metric.name, channels[c])] = errors.channels[m][c];
    }
    return json;
}

Json row_json(const ErrorAxisResult& result, const ErrorRow& row) {
    Json parameters = Json::object(), errors = Json::object();
    for (const auto& [name, value] : row.method.parameters) parameters[name] = value;
    parameters["triangles"] = row.triangles;
    for (std::size_t r = 0; r < error_region_count; ++r)
        errors[std::string(error_region_names()[r])] = errors_json(row.regions[r]);
    Json json = {{"axis", result.axis->name},
                 {"method", row.method.name},
                 {"as_given", row.method.as_given},
                 {"parameters", parameters}};
    if (row.time) {
        json["time_ms"] = to_json(*row.time);
        json["efficiency"] = row.efficiency();
        json["pareto_front"] = row.on_front;
    }
    if (row.memory > 0) json["memory_bytes"] = row.memory;
    json["errors"] = errors;
    json["picture"] = row.picture;
    return json;
}

Json order_json(const ErrorAxisResult& result, const ErrorOrder& order) {
    Json json = {{"axis", result.axis->name},
                 {"series", order.series},
                 {"against", order.against},
                 {"metric", order.metric},
                 {"region", error_region_names()[std::size_t(order.region)]},
                 {"order", to_json(order.order)}};
    if (order.expected != nullptr)
        json["expected"] = order.expected->order, json["because"] = order.expected->why;
    return json;
}

Json scenes_json(const ErrorReport& report) {
    Json scenes = Json::array();
    for (const ErrorSceneResult& scene : report.scenes) {
        Json rows = Json::array(), orders = Json::array(), references = Json::array();
        for (const ErrorAxisResult& result : scene.axes) {
            references.push_back({{"axis", result.axis->name},
                                  {"what", result.reference},
                                  {"own_rmse", result.own_rmse},
                                  {"own_rmse_from", result.own_from},
                                  {"picture", result.reference_picture}});
            for (const ErrorRow& row : result.rows) rows.push_back(row_json(result, row));
            for (const ErrorOrder& order : result.orders)
                orders.push_back(order_json(result, order));
        }
        scenes.push_back({{"name", scene.name},
                          {"width", scene.width},
                          {"height", scene.height},
                          {"verdict", scene.verdict},
                          {"references", references},
                          {"rows", rows},
                          {"orders", orders}});
    }
    return scenes;
}

// ---- plots

constexpr const char* plot_script = R"(
set logscale xy
set xlabel 'time of a frame, ms'
set ylabel 'error, RMSE of linear radiance'
set key outside right top samplen 2
set format y '1e%T'
set format x '%g'
set autoscale xfix
set offsets graph 0.06, graph 0.1, 0, 0
set yrange [y_low:y_high]
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000)
set linetype 1 linecolor rgb '#0072b2' linewidth 1.5 pointtype 7
set linetype 2 linecolor rgb '#d55e00' linewidth 1.5 pointtype 5
set linetype 3 linecolor rgb '#009e73' linewidth 1.5 pointtype 9
set linetype 4 linecolor rgb '#cc79a7' linewidth 1.5 pointtype 11
set linetype 5 linecolor rgb '#e69f00' linewidth 1.5 pointtype 13
set linetype 6 linecolor rgb '#56b4e9' linewidth 1.5 pointtype 4
set linetype 7 linecolor rgb '#737a84' linewidth 1.5 pointtype 8
set linetype 8 linecolor rgb '#b3541e' linewidth 1.5 pointtype 6
)";
constexpr const char* plot_curves = R"(
plot 'data' index 0 using 1:2 with steps linecolor rgb '#22262c' linewidth 3 dashtype 3 \
         title columnheader(1), \
     'data' index 0 using 1:2 with points pointtype 6 pointsize 2 linewidth 1.5 \
         linecolor rgb '#22262c' notitle, \
     for [i = 1:series] 'data' index i using 1:2 with linespoints linetype 1 + (i - 1) % 8 \
         pointtype 3 + i title columnheader(1), \
     'data' index series + 1 using 1:2 with points pointtype 7 pointsize 0.7 \
         linecolor rgb '#22262c' title columnheader(1), \
     'data' index 0 using 1:2:3 with labels left offset character 0.8, 0.9 \
         textcolor rgb '#22262c' font ',11' notitle
)";

bool has_point(const ErrorRow& row) {
    const double rmse = row.error("rmse");
    return row.time && std::isfinite(rmse) && rmse > 0;
}

/// Rows that have a place on logarithmic axes; the one that is the reference has none.
std::vector<const ErrorRow*> points_of(const ErrorAxisResult& result) {
    std::vector<const ErrorRow*> points;
    for (const ErrorRow& row : result.rows)
        if (has_point(row)) points.push_back(&row);
    std::stable_sort(points.begin(), points.end(), [](const ErrorRow* a, const ErrorRow* b) {
        return a->time->median < b->time->median;
    });
    return points;
}

/// What tells a row from the others of its series.
std::string short_name(const ErrorMethod& method) {
    const std::string &name = method.name, &series = method.series;
    if (!name.starts_with(series) || name.size() < series.size() + 2) return name;
    std::string rest = name.substr(series.size() + 2);
    constexpr std::string_view tessellation = "tessellation ";
    return rest.starts_with(tessellation) ? rest.substr(tessellation.size()) : rest;
}

void add_point(const ErrorRow& row, PlotData& data) {
    data.number(row.time->median).number(row.error("rmse"));
    data.text(short_name(row.method)).end_line();
}

/// With room around, and never so narrow that noise looks like a difference.
std::pair<double, double> rmse_range(const std::vector<const ErrorRow*>& points) {
    const auto [least, most] = std::minmax_element(
        points.begin(), points.end(),
        [](const ErrorRow* a, const ErrorRow* b) { return a->error("rmse") < b->error("rmse"); });
    const double low = (*least)->error("rmse") / 1.6, high = (*most)->error("rmse") * 1.8;
    const double widen = std::sqrt(std::max(1.0, 100 * low / high));
    return {low / widen, high * widen};
}

Plot plot_of(const ErrorAxisResult& result, std::size_t number) {
    Plot plot{error_plot_file(result, number), 760, 430, {}, {plot_script, plot_curves}, {}};
    const std::vector<const ErrorRow*> points = points_of(result);
    plot.data.text("Pareto front").end_line();
    for (const ErrorRow* row : points)
        if (row->on_front) add_point(*row, plot.data);
    plot.data.end_block();
    std::vector<std::string> series;
    for (const ErrorRow& row : result.rows)
        if (has_point(row) &&
            std::find(series.begin(), series.end(), row.method.series) == series.end())
            series.push_back(row.method.series);
    for (const std::string& name : series) {
        plot.data.text(name).end_line();
        for (const ErrorRow& row : result.rows)
            if (has_point(row) && row.method.series == name) add_point(row, plot.data);
        plot.data.end_block();
    }
    plot.data.text("as the scene asks for").end_line();
    for (const ErrorRow* row : points)
        if (row->method.as_given) add_point(*row, plot.data);
    plot.data.end_block();
    const auto [low, high] = rmse_range(points);
    plot.numbers = {{"series", double(series.size())}, {"y_low", low}, {"y_high", high}};
    return plot;
}

std::vector<Plot> plots_of(const ErrorReport& report) {
    std::vector<Plot> plots;
    for (std::size_t i = 0; i < report.scenes.size(); ++i)
        for (const ErrorAxisResult& result : report.scenes[i].axes)
            if (!points_of(result).empty()) plots.push_back(plot_of(result, i + 1));
    return plots;
}

}  // namespace

std::string error_plot_file(const ErrorAxisResult& result, std::size_t number) {
    return fmt::format("{}-{}.svg", result.axis->name, number);
}

std::string short_number(double value) { return fmt::format("{:.3g}", value); }

std::vector<std::string> write_error_report(const ErrorReport& report, const std::string& folder) {
    const std::filesystem::path path(folder);
    const Json scenes = scenes_json(report);
    write_file(report_json("error", report.provenance, report.partial, scenes),
               path / "report.json");
    write_file(report_csv(scenes), path / "error.csv");
    std::vector<std::string> warnings;
    if (std::string reason = draw_plots(plots_of(report), folder); !reason.empty())
        warnings.push_back(std::move(reason));
    write_file(error_page(report, warnings.empty()), path / "index.html");
    return warnings;
}

}  // namespace scanshade

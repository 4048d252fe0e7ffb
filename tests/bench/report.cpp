#include "bench/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/console.hpp"

namespace scanshade::bench {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

/// The faster way of a rival, or nullptr.
const Result* fastest(const CellResult& cell, const std::string& rival) {
    const Result* best = nullptr;
    for (const Result& result : cell.results)
        if (result.rival == rival && !result.ms.empty())
            if (best == nullptr || result.median_ms < best->median_ms) best = &result;
    return best;
}

const Result* find_way(const CellResult& cell, const std::string& way) {
    for (const Result& result : cell.results)
        if (result.rival == our_name && result.way == way) return &result;
    return nullptr;
}

/// Our time in the same cell with `perspective`, for a cell with another interpolation.
const Result* perspective_twin(const Report& report, const CellResult& of, const Result& ours) {
    Cell wanted = of.cell;
    if (wanted.interpolation == Interpolation::perspective) return nullptr;
    wanted.interpolation = Interpolation::perspective;
    for (const CellResult& cell : report.cells)
        if (name_of(cell.cell) == name_of(wanted)) return find_way(cell, ours.way);
    return nullptr;
}

std::string number(double value) { return fmt::format("{:.{}f}", value, value < 10 ? 2 : 1); }
std::string times(double ratio) { return fmt::format("{:.{}f}x", ratio, ratio < 10 ? 2 : 1); }
std::string megabytes(const Result& r) { return fmt::format("{}", r.memory.peak_bytes >> 20); }

/// Median, the way it was reached where a rival has several, ratio to ours.
void add_peer(const Result* peer, const Result& ours, Row& row) {
    if (peer == nullptr || ours.ms.empty()) {
        row.insert(row.end(), {"-", "-", "-", "-"});
        return;
    }
    row.insert(row.end(),
               {number(peer->median_ms), number(peer->min_ms),
                times(peer->median_ms / ours.median_ms), times(peer->min_ms / ours.min_ms)});
}

const Row header = {"cell", "ours by", "ms",     "min",       "llvmpipe",
                    "min",  "ratio",   "of min", "by",        "Embree",
                    "min",  "ratio",   "of min", "to persp.", "MB ours/llvmpipe/Embree"};

Row table_row(const Report& report, const CellResult& cell, const Result& ours) {
    const Result* llvmpipe = fastest(cell, "llvmpipe");
    const Result* embree = fastest(cell, "embree");
    Row row = {name_of(cell.cell), ours.way};
    if (ours.ms.empty()) {
        row.push_back("pictures differ");
        return row;
    }
    row.insert(row.end(), {number(ours.median_ms), number(ours.min_ms)});
    add_peer(llvmpipe, ours, row);
    row.push_back(llvmpipe != nullptr ? llvmpipe->way : "-");
    add_peer(embree, ours, row);
    const Result* twin = perspective_twin(report, cell, ours);
    row.push_back(twin != nullptr ? times(ours.median_ms / twin->median_ms) : "-");
    std::string memory = megabytes(ours);
    for (const Result* peer : {llvmpipe, embree})
        memory += "/" + (peer != nullptr ? megabytes(*peer) : "-");
    row.push_back(memory);
    return row;
}

std::vector<Row> table_rows(const Report& report) {
    std::vector<Row> rows = {header};
    for (const CellResult& cell : report.cells)
        for (const Result& result : cell.results)
            if (result.rival == our_name) rows.push_back(table_row(report, cell, result));
    return rows;
}

std::string markdown(const Report& report) {
    std::string text =
        "# Benchmark\n\nTimes are medians and minima in ms a frame, ratios are a peer's time over "
        "ours. Memory is what the\nprocess needs beyond the loaded scene.\n\n";
    for (const auto& [key, value] : report.provenance)
        text += fmt::format("- {}: {}\n", key, value);
    std::vector<Row> rows = table_rows(report);
    rows.insert(rows.begin() + 1, Row(header.size(), "---"));
    text += "\n";
    for (Row& row : rows) {
        row.resize(header.size());
        text += fmt::format("| {} |\n", fmt::join(row, " | "));
    }
    return text;
}

std::string csv(const Report& report) {
    std::string text =
        "scene,width,height,shading,brdf,lights,interpolation,threads,rival,way,median_ms,min_ms,"
        "frames,copy_out_ms,scene_bytes,peak_bytes,covered,same_id,compared,within_1,worst\n";
    for (const CellResult& cell : report.cells)
        for (const Result& r : cell.results) {
            std::string name = fmt::format("{}", cell.cell.scene);
            std::replace(name.begin(), name.end(), ',', '_');
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{:.4f},{:.4f},{},{:.4f},{},{},{},{},"
                "{},{},{}\n",
                name, cell.cell.width, cell.cell.height,
                shading_names()[std::size_t(cell.cell.shading)], cell.cell.brdf, cell.cell.lights,
                interpolation_names()[std::size_t(cell.cell.interpolation)],
                cell.cell.all_threads ? "all" : "1", r.rival, r.way, r.median_ms, r.min_ms,
                r.ms.size(), r.copy_out_ms, r.memory.scene_bytes, r.memory.peak_bytes,
                r.agreement.covered, r.agreement.same_id, r.agreement.compared, r.agreement.within,
                r.agreement.worst);
        }
    return text;
}

Json row_json(const Report& report, const CellResult& cell, const Result& r) {
    Json row = {
        {"axis", "speed"},
        {"method", fmt::format("{} {}", r.rival, r.way)},
        {"parameters",
         {{"width", cell.cell.width},
          {"height", cell.cell.height},
          {"shading", shading_names()[std::size_t(cell.cell.shading)]},
          {"brdf", cell.cell.brdf},
          {"lights", cell.cell.lights},
          {"interpolation", interpolation_names()[std::size_t(cell.cell.interpolation)]},
          {"threads", cell.cell.all_threads ? "all" : "1"},
          {"cull", report.cull == Cull::back ? "back" : "none"}}},
        {"memory_bytes", {{"scene", r.memory.scene_bytes}, {"peak", r.memory.peak_bytes}}},
        {"agreement",
         {{"good", r.agreement.good()},
          {"covered", r.agreement.covered},
          {"same_id", r.agreement.same_id},
          {"compared", r.agreement.compared},
          {"within_1", r.agreement.within},
          {"worst", r.agreement.worst}}},
    };
    if (!r.ms.empty())
        row["time_ms"] = {{"median", r.median_ms}, {"min", r.min_ms}, {"runs", r.ms.size()}};
    if (r.copy_out_ms > 0) row["copy_out_ms"] = r.copy_out_ms;
    return row;
}

std::string json(const Report& report) {
    Json provenance, scenes = Json::array();
    for (const auto& [key, value] : report.provenance) provenance[key] = value;
    for (const CellResult& cell : report.cells) {
        if (scenes.empty() || scenes.back()["name"] != cell.cell.scene)
            scenes.push_back({{"name", cell.cell.scene}, {"rows", Json::array()}});
        for (const Result& r : cell.results)
            scenes.back()["rows"].push_back(row_json(report, cell, r));
    }
    const Json all = {{"provenance", provenance}, {"scenes", scenes}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string text_table(const Report& report) { return table(table_rows(report)); }

void write_files(const Report& report, const std::filesystem::path& folder) {
    write_text(json(report), folder / "report.json");
    write_text(csv(report), folder / "report.csv");
    write_text(markdown(report), folder / "report.md");
}

std::vector<std::string> disagreements(const Report& report) {
    std::vector<std::string> sentences;
    for (const CellResult& cell : report.cells)
        for (const Result& r : cell.results)
            if (!r.agreement.good())
                sentences.push_back(fmt::format("{}: {} {} differs from ours: {}",
                                                name_of(cell.cell), r.rival, r.way,
                                                r.agreement.sentence()));
    return sentences;
}

}  // namespace scanshade::bench

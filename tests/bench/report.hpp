// What a run of the benchmark found out.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bench/contest.hpp"

namespace scanshade::bench {

struct Report {
    std::vector<std::pair<std::string, std::string>> provenance;
    Cull cull;
    std::vector<CellResult> cells;
};

/// For people: a row for each cell and each of our ways, with the peers' times and the ratios.
std::string text_table(const Report& report);

/// report.json, report.csv and report.md. Throws Error(file).
void write_files(const Report& report, const std::filesystem::path& folder);

/// One sentence for each picture that differs from ours.
std::vector<std::string> disagreements(const Report& report);

}  // namespace scanshade::bench

// Rivals against one another: first whether they draw the same, then how long they take.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/agreement.hpp"
#include "bench/process.hpp"

namespace scanshade::bench {

/// One rival's way of drawing a cell.
struct Result {
    std::string rival, way;
    std::vector<double> ms;  // of each frame; empty where the pictures disagree
    double median_ms = 0, min_ms = 0;
    double copy_out_ms = 0;
    Memory memory{};      // of the rival in this cell, whatever the way
    Agreement agreement;  // with the first result's picture
};

struct CellResult {
    Cell cell;
    std::vector<Result> results;  // ours first
};

/// The name of our rival, whose pictures the others' must equal.
inline constexpr const char* our_name = "scanshade";

class Contest {
public:
    /// Starts a process for each rival. Pictures that disagree are written to `folder`, or all.
    Contest(Group group, std::filesystem::path folder, bool keep_pictures);

    /// "name: version", one each.
    std::vector<std::string> about();

    CellResult run(std::size_t cell);

private:
    Group group_;
    std::filesystem::path folder_;
    bool keep_pictures_;
    std::vector<std::unique_ptr<RivalProcess>> rivals_;
};

}  // namespace scanshade::bench

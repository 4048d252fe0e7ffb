// Plots, drawn by gnuplot.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scanshade {

/// A table of data as gnuplot reads it: fields between tabs; two empty lines begin the next block.
class PlotData {
public:
    PlotData& number(double value);
    /// A name: whatever gnuplot could take for more than letters is replaced.
    PlotData& text(std::string_view name);
    void end_line();
    void end_block();
    const std::string& bytes() const { return bytes_; }

private:
    PlotData& field(std::string_view bytes);
    std::string bytes_;
    bool line_begun_ = false;
};

/// One picture. Nothing that a user can name is part of a script: scripts are constants of this
/// program, what varies reaches them as numbers and as the file 'data'.
struct Plot {
    std::string file;  // "plan.svg"
    int width, height;
    std::vector<std::pair<const char*, double>> numbers;  // variables of the script
    std::vector<const char*> script;                      // parts; the last plots 'data'
    PlotData data;
};

/// Draws them into the folder. Returns an empty string, or one sentence where gnuplot is not there
/// or fails; the files that it should have made are then not there either.
std::string draw_plots(std::span<const Plot> plots, const std::string& folder);

}  // namespace scanshade

// What is measured: the cells of the matrix.
#pragma once

#include <string>
#include <vector>

#include "scanshade/scene/settings.hpp"

namespace scanshade::bench {

/// One picture that all rivals draw.
struct Cell {
    std::string scene;  // a row of scenes.cpp
    int width, height;
    Shading shading;
    std::string brdf;  // "unlit" has no lights
    int lights;
    Interpolation interpolation;
    bool all_threads;  // else one
};

/// "mesh-70k/1920x1080/phong/blinn-phong/1/perspective/1T": what CELLS= matches.
std::string name_of(const Cell& cell);

/// The cells of `scenes` that `which` names, in the order in which they are measured: "quick",
/// "all", or shell patterns separated by commas. Throws Error(usage) where none does.
std::vector<Cell> select_cells(const std::vector<std::string>& scenes, const std::string& which);

/// What the cell means to the renderer. Bytes are linear: the rivals have no sRGB curve.
Settings settings_of(const Cell& cell, Cull cull);

}  // namespace scanshade::bench

#include "bench/cells.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "scanshade/base/error.hpp"

namespace scanshade::bench {
namespace {

constexpr struct { int width, height; } sizes[] = {{1920, 1080}, {640, 480}};
constexpr Shading shadings[] = {Shading::phong, Shading::gouraud, Shading::flat};
constexpr const char* brdfs[] = {"blinn-phong", "phong"};
constexpr int light_counts[] = {1, 4, 16};

/// The cells of one scene, size and number of threads.
void add_cells(const Cell& base, std::vector<Cell>& cells) {
    const auto add = [&](Shading shading, const char* brdf, int lights, Interpolation how) {
        Cell cell = base;
        cell.shading = shading, cell.brdf = brdf, cell.lights = lights, cell.interpolation = how;
        cells.push_back(cell);
    };
    add(Shading::phong, "unlit", 0, Interpolation::perspective);
    for (const Shading shading : shadings) {
        for (const char* brdf : brdfs)
            for (const int lights : light_counts)
                add(shading, brdf, lights, Interpolation::perspective);
        add(shading, brdfs[0], light_counts[0], Interpolation::edges);
    }
}

std::vector<Cell> all_cells(const std::vector<std::string>& scenes) {
    std::vector<Cell> cells;
    for (const std::string& scene : scenes)
        for (const bool all_threads : {false, true})
            for (const auto& size : sizes)
                add_cells({scene, size.width, size.height, {}, {}, 0, {}, all_threads}, cells);
    return cells;
}

/// What a change of the engine is judged by: one light on every scene, and on the first of them
/// everything that makes a picture cheaper or dearer, once.
constexpr const char* quick =
    "*/1920x1080/phong/blinn-phong/1/perspective/1T,"
    "mesh-*/1920x1080/phong/blinn-phong/1/perspective/*,"
    "mesh-70k/1920x1080/*/blinn-phong/1/*/1T,"
    "mesh-70k/1920x1080/phong/blinn-phong/16/perspective/1T,"
    "mesh-70k/1920x1080/phong/unlit/*/1T";

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        parts.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

}  // namespace

std::string name_of(const Cell& cell) {
    return fmt::format("{}/{}x{}/{}/{}/{}/{}/{}", cell.scene, cell.width, cell.height,
                       shading_names()[std::size_t(cell.shading)], cell.brdf, cell.lights,
                       interpolation_names()[std::size_t(cell.interpolation)],
                       cell.all_threads ? "allT" : "1T");
}

std::vector<Cell> select_cells(const std::vector<std::string>& scenes, const std::string& which) {
    std::vector<Cell> cells = all_cells(scenes);
    if (which == "all") return cells;
    const std::vector<std::string> patterns = split(which == "quick" ? quick : which);
    std::erase_if(cells, [&](const Cell& cell) {
        return std::none_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
            return ::fnmatch(pattern.c_str(), name_of(cell).c_str(), 0) == 0;
        });
    });
    if (cells.empty())
        throw Error(Errc::usage,
                    fmt::format("no cell is called '{}'; give quick, all, or patterns as in '{}'",
                                which, "mesh-70k/1920x1080/phong/*/1T"));
    return cells;
}

Settings settings_of(const Cell& cell, Cull cull) {
    Settings settings;
    settings.width = cell.width;
    settings.height = cell.height;
    settings.shading = cell.shading;
    settings.interpolation = cell.interpolation;
    settings.transfer = Transfer::linear;
    settings.cull = cull;
    return settings;
}

}  // namespace scanshade::bench

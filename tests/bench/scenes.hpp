// What is drawn: scenes that this project makes, and any OBJ file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/cells.hpp"
#include "bench/peer_light.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade::bench {

/// The one material of all scenes.
inline constexpr double surface_kd[3] = {0.65, 0.45, 0.3};
inline constexpr double surface_ks = 0.3;
inline constexpr int surface_shininess = 1 << specular_squarings;

/// Names of the scenes; with a file, that is the only one.
std::vector<std::string> scene_names(const std::filesystem::path& mesh_file);

/// One object, its camera, ambient light; no lights yet. Throws Error for a file.
Scene make_scene(const std::string& name, const std::filesystem::path& mesh_file);

/// The scene with the cell's lights and its model of reflection.
Scene lit_scene(const Scene& scene, const Cell& cell);

}  // namespace scanshade::bench

// What files and options may say of a scene: limits that keep later arithmetic finite, and that no
// file of a few megabytes makes a picture of hours. docs/robustness.md lists all there are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace scanshade {

inline constexpr double max_coordinate = 1e100;  // squares and cubes of it are finite
inline constexpr double max_radiance = 1e30;     // finite in float
inline constexpr double min_view_angle_deg = 1e-3, max_view_angle_deg = 179.9;

inline constexpr std::size_t max_scene_bytes = std::size_t{1} << 26;
inline constexpr std::size_t max_obj_bytes = std::size_t{1} << 32;  // so at most 2^31 corners
inline constexpr std::size_t max_mtl_bytes = std::size_t{1} << 26;
inline constexpr std::size_t max_face_corners = 1 << 16;
inline constexpr std::size_t max_scene_triangles = std::size_t{1} << 28;
inline constexpr std::int64_t max_scene_texels = std::int64_t{1} << 27;  // two of the largest
inline constexpr std::size_t max_objects = 1 << 16;
inline constexpr std::size_t max_materials = 1 << 15;
inline constexpr std::size_t max_lights = 1 << 12;
inline constexpr std::size_t max_key_parts = 32;        // of a TOML text: a.b.c has three
inline constexpr std::size_t max_parameters = 64;       // of a material; models have a dozen
inline constexpr std::size_t max_path_bytes = 1 << 12;  // the system takes no longer ones

/// The largest component's size; NaN where one is.
inline double max_abs(const glm::dvec3& v) {
    const double sum = v.x + v.y + v.z;
    return std::isnan(sum) ? sum : std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace scanshade

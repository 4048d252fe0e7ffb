// What files and options may say of a scene: limits that keep later arithmetic finite.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>

namespace scanshade {

inline constexpr double max_coordinate = 1e100;  // squares and cubes of it are finite
inline constexpr double max_radiance = 1e30;     // finite in float
inline constexpr std::size_t max_scene_triangles = std::size_t{1} << 28;
inline constexpr double min_view_angle_deg = 1e-3, max_view_angle_deg = 179.9;

/// The largest component's size; NaN where one is.
inline double max_abs(const glm::dvec3& v) {
    const double sum = v.x + v.y + v.z;
    return std::isnan(sum) ? sum : std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace scanshade

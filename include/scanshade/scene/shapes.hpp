// Procedural shapes.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scanshade/scene/material.hpp"
#include "scanshade/scene/mesh.hpp"

namespace scanshade {

/// A shape of the table: every shape is about one unit in radius, centred at the origin, y up, with
/// normals and texture coordinates in [0, 1]; closed shapes are watertight (shared positions, no
/// T-junctions) and counter-clockwise from outside.
struct ShapeInfo {
    std::string_view name;
    std::string_view meaning;  // size, parametrisation, what tessellation n means
    int default_tessellation;  // n
    int max_tessellation;
    PolygonSoup (*make)(int tessellation);  // 1 ≤ n ≤ max_tessellation
    std::vector<Material> (*materials)();   // that the soup's numbers count into
};

/// sphere, torus, teapot, cube, cylinder, plane, ...
std::span<const ShapeInfo> all_shapes();

/// The shape of that name, or nullptr.
const ShapeInfo* find_shape(std::string_view name);

}  // namespace scanshade

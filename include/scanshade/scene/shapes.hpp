// Procedural shapes.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "scanshade/scene/material.hpp"
#include "scanshade/scene/mesh.hpp"

namespace scanshade {

/// A point of a smooth surface S(u, v), in object space.
struct SmoothPoint {
    glm::dvec3 position, du, dv;  // S, ∂S/∂u, ∂S/∂v
    glm::dvec3 normal;            // unit length, outward
};

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

    // The surface that the polygons stand for: faces come patch after patch, as many of each, and a
    // vertex's texture coordinates are its parameters. A point outside of [0, 1] continues the patch.
    int patches = 1;
    SmoothPoint (*smooth)(int patch, double u, double v) = nullptr;  // null: the polygons are it
};

/// sphere, torus, teapot, cube, cylinder, plane, ...
std::span<const ShapeInfo> all_shapes();

/// A mesh that knows what it was made from; without `normals`, with those of the surface itself.
std::shared_ptr<Mesh> make_shape_mesh(const ShapeInfo& shape, int tessellation,
                                      const NormalOptions& normals = {});

/// The shape of that name, or nullptr.
const ShapeInfo* find_shape(std::string_view name);

}  // namespace scanshade

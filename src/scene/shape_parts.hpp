// What the files that make shapes share.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scanshade/scene/shapes.hpp"

namespace scanshade {

/// One point of a parametric surface.
struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec2 texcoord;
    glm::dvec3 normal;  // unit length, outward
};

/// Puts grids of quads together into one soup. Points on the borders of grids that are equal to
/// the bit become one position, so what fits together is watertight.
class ShapeBuilder {
public:
    explicit ShapeBuilder(std::string_view name) { soup_.name = name; }

    /// rows × columns quads over at(row, column), row in [0, rows], column in [0, columns].
    /// Counter-clockwise from where columns go right and rows go up. Where a row has shrunk to a
    /// point (a pole), the quads are triangles.
    template <class At>
    void add_grid(int rows, int columns, const At& at) {
        std::vector<PolygonSoup::Corner> below, row(std::size_t(columns) + 1);
        for (int r = 0; r <= rows; ++r) {
            for (int c = 0; c <= columns; ++c) {
                const bool border = r == 0 || r == rows || c == 0 || c == columns;
                row[std::size_t(c)] = add_point(at(r, c), border);
            }
            for (std::size_t c = 0; r > 0 && c < std::size_t(columns); ++c)
                add_face({below[c], below[c + 1], row[c + 1], row[c]});
            below = row;
        }
    }

    /// The material of the grids from here on; 0 at first.
    void use_material(std::uint32_t material) { material_ = material; }

    PolygonSoup take() { return std::move(soup_); }

private:
    using Bits = std::array<std::uint64_t, 3>;
    struct Hash {
        std::size_t operator()(const Bits& b) const {
            constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;
            std::uint64_t h = 0;
            for (const std::uint64_t x : b) h = (h ^ (x ^ (x >> 32))) * odd;
            return std::size_t(h ^ (h >> 29));
        }
    };

    PolygonSoup::Corner add_point(const SurfacePoint& point, bool border);
    void add_face(const std::array<PolygonSoup::Corner, 4>& quad);

    PolygonSoup soup_;
    std::uint32_t material_ = 0;
    std::unordered_map<Bits, std::uint32_t, Hash> border_;
};

/// Newell's teapot (shape_teapot.cpp).
PolygonSoup make_teapot(int n);
SmoothPoint smooth_teapot(int patch, double u, double v);

/// Hills (shape_terrain.cpp).
PolygonSoup make_terrain(int n);
SmoothPoint smooth_terrain(int patch, double u, double v);

/// The Cornell box (shape_cornell_box.cpp).
PolygonSoup make_cornell_box(int n);
std::vector<Material> cornell_box_materials();

}  // namespace scanshade

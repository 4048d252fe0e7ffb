// What the files that build a mesh share.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scanshade/scene/mesh.hpp"

namespace scanshade {

/// v / |v| without overflow or underflow, or nothing for a vector of no length or not finite.
std::optional<glm::dvec3> safe_normalize(const glm::dvec3& v);

/// The unit Newell normal, or nothing where it is 0: collinear corners, fewer than three distinct
/// ones, loops of more than four corners that cancel.
std::optional<glm::dvec3> unit_newell_normal(std::span<const glm::dvec3> polygon);

/// The faces of a soup that have an area.
struct DrawnFaces {
    std::vector<std::uint32_t> number;        // [face] in the soup
    std::vector<glm::dvec3> normal;           // [face] unit Newell normal
    std::vector<std::uint32_t> begin{0};      // CSR into corner and face
    std::vector<PolygonSoup::Corner> corner;  // [corner]
    std::vector<std::uint32_t> face;          // [corner] index into number and normal

    std::size_t size() const { return number.size(); }
};

/// The corners that stand at each position, in their order.
struct CornersByPosition {
    std::vector<std::uint32_t> begin;   // [position + 1]
    std::vector<std::uint32_t> corner;  // index into DrawnFaces::corner

    CornersByPosition(const DrawnFaces& faces, std::size_t position_count);
    std::span<std::uint32_t> at(std::size_t position) {
        return std::span(corner).subspan(begin[position], begin[position + 1] - begin[position]);
    }
};

/// Normals of all corners.
struct CornerNormals {
    enum class Origin : std::uint8_t {
        summed,  // (C1), or the face normal where no other face takes part
        file,
        cancelled,  // the sum had no length: face normal
        repaired,   // the file's had no length: face normal
    };
    std::vector<std::array<float, 3>> normal;
    std::vector<Origin> origin;
};

/// `unit` is the mesh's: areas are taken relative to it. Changes the order in `around`.
CornerNormals corner_normals(const PolygonSoup& soup, const DrawnFaces& faces,
                             CornersByPosition& around, const NormalOptions& options, double unit);

}  // namespace scanshade

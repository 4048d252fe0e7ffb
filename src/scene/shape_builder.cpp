#include "scene/shape_parts.hpp"

namespace scanshade {

PolygonSoup::Corner ShapeBuilder::add_point(const SurfacePoint& point, bool border) {
    const glm::dvec3 p = point.position + 0.0;  // no -0: equal means the same bits
    const auto next = std::uint32_t(soup_.positions.size());
    std::uint32_t position = next;
    if (border) {
        const Bits bits{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                        std::bit_cast<std::uint64_t>(p.z)};
        position = border_.try_emplace(bits, next).first->second;
    }
    if (position == next) soup_.positions.push_back(p);
    soup_.texcoords.push_back(point.texcoord);
    soup_.normals.push_back(point.normal + 0.0);
    const auto attribute = std::uint32_t(soup_.normals.size() - 1);
    return {position, attribute, attribute};
}

void ShapeBuilder::add_face(const std::array<PolygonSoup::Corner, 4>& quad) {
    std::size_t distinct = 0;
    for (std::size_t c = 0; c < quad.size(); ++c)
        distinct += quad[c].position != quad[(c + 1) % quad.size()].position;
    if (distinct < 3) return;
    for (std::size_t c = 0; c < quad.size(); ++c)
        if (quad[c].position != quad[(c + 1) % quad.size()].position)
            soup_.corners.push_back(quad[c]);
    soup_.face_begin.push_back(std::uint32_t(soup_.corners.size()));
    soup_.face_material.push_back(material_);
}

}  // namespace scanshade

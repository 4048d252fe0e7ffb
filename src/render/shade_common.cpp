#include "render/shade_common.hpp"

namespace scanshade {

template <>
LightingPair<double> lighting_of<double>(const Frame& frame) {
    return {frame.lighting, frame.unlit};
}

template <>
LightingPair<float> lighting_of<float>(const Frame& frame) {
    return {to_float(frame.lighting), to_float(frame.unlit)};
}

bool falls_back(const Frame& frame, const DrawnFace& face, bool has_patch) {
    const std::size_t corners = frame.scene.objects[face.object].mesh->corner_count(face.face);
    switch (frame.plan.interpolation) {
        case Interpolation::perspective:
            return false;
        case Interpolation::edges:
            return corners > 3 && face.carrier != Carrier::polygon;
        case Interpolation::patch:
            return corners == 4 && !has_patch;
    }
    return false;
}

bool patch_corners(const Frame& frame, const DrawnFace& face, std::uint32_t (&vertex)[4],
                   PictureCorner (&corner)[4]) {
    const Mesh& mesh = *frame.scene.objects[face.object].mesh;
    if (frame.plan.interpolation != Interpolation::patch || mesh.corner_count(face.face) != 4)
        return false;
    constexpr std::uint32_t order[4] = {0, 1, 3, 2};
    for (int i = 0; i < 4; ++i) {
        vertex[i] = mesh.corner[mesh.face_begin[face.face] + order[i]];
        const VertexState state = frame.vertex(face.object, vertex[i]);
        if (state.outcode != 0) return false;
        corner[i] = {double(state.point.x), double(state.point.y)};
    }
    return drawn_whole(frame, face.object, face.face);
}

}  // namespace scanshade

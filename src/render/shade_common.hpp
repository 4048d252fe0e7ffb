// What lighting points and shading samples share.
#pragma once

#include <cstdint>

#include "render/carry.hpp"
#include "render/frame.hpp"
#include "render/lighting.hpp"
#include "render/surface.hpp"
#include "scanshade/num/rgb.hpp"

namespace scanshade {

/// The lighting of the plan's number type.
template <class T>
struct LightingPair {
    Lighting<T> lit, unlit;
    const Lighting<T>& of(const ResolvedMaterial& material) const {
        return material.unlit ? unlit : lit;
    }
};

template <class T>
LightingPair<T> lighting_of(const Frame& frame);

template <class T>
std::vector<LitPoints<T>>& lit_points(Frame& frame) {
    if constexpr (std::is_same_v<T, float>)
        return frame.lit_f32;
    else
        return frame.lit_f64;
}

/// Key of a lit point: vertices (Gouraud) or faces (flat) of one object.
inline std::uint64_t lit_key(std::uint32_t material, bool back, std::uint64_t number) {
    return (std::uint64_t(material) << 33) | (std::uint64_t(back) << 32) | number;
}

/// Adds the surface point of a key: the middle of a face (flat) or a vertex (Gouraud).
template <class T>
void push_lit_point(Batch<T>& batch, const ObjectSurface& surface, Shading shading,
                    std::uint64_t key, std::size_t to) {
    const auto number = static_cast<std::uint32_t>(key);
    const bool flat = shading == Shading::flat, back = ((key >> 32) & 1) != 0;
    const glm::dvec3 normal = flat ? surface.face_normal(number) : surface.vertex_normal(number);
    batch.push(to_vec3<T>(flat ? surface.face_centre(number) : surface.vertex_position(number)),
               to_vec3<T>(back ? -normal : normal), to);
}

/// The material of a face, as an index into the plan's and the scene's.
inline std::uint32_t material_of(const Frame& frame, std::size_t object, std::size_t face) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    return frame.plan.objects[object].materials[mesh.face_material[face]];
}

/// Whether `edges` or `patch` draw this face as triangles in place of what they would.
bool falls_back(const Frame& frame, const DrawnFace& face, bool has_patch);

/// The four corners A B C D of a quadrilateral in `patch`. False: barycentric, also for one that is
/// not strictly convex on the picture or reaches beyond near, far or the guard band.
/// From the file's cyclic v0 v1 v2 v3: A = v0, B = v1, C = v3, D = v2.
bool patch_corners(const Frame& frame, const DrawnFace& face, std::uint32_t (&vertex)[4],
                   PictureCorner (&corner)[4]);

}  // namespace scanshade

// Light at faces (flat) and vertices (Gouraud), before samples are shaded.
#include <algorithm>

#include "render/shade.hpp"
#include "render/shade_common.hpp"

namespace scanshade {
namespace {

/// Triangles that are seen anywhere, ascending.
std::vector<std::uint32_t> visible_triangles(const Frame& frame) {
    std::vector<bool> seen(frame.plan.triangles);
    for (const std::uint32_t id : frame.id)
        if (id != Framebuffer::no_triangle) seen[id] = true;
    std::vector<std::uint32_t> visible;
    for (std::uint32_t id = 0; id < seen.size(); ++id)
        if (seen[id]) visible.push_back(id);
    return visible;
}

/// Keys of all points of objects with that shading that visible faces need, ascending, once each.
std::vector<std::vector<std::uint64_t>> needed_keys(const Frame& frame, Shading shading) {
    std::vector<std::vector<std::uint64_t>> keys(frame.scene.objects.size());
    DrawnFace face;
    for (const std::uint32_t id : visible_triangles(frame)) {
        const std::size_t object = object_of(frame.plan, id);
        if (frame.plan.objects[object].shading != shading) continue;
        describe_drawn(frame, id, face);
        const std::uint32_t material = material_of(frame, object, face.face);
        if (shading == Shading::flat) {
            keys[object].push_back(lit_key(material, face.back, face.face));
            continue;
        }
        std::uint32_t quad[4];
        PictureCorner corner[4];
        const bool patch = patch_corners(frame, face, quad, corner);
        for (const std::uint32_t v : patch ? std::span<const std::uint32_t>(quad) : face.vertex)
            keys[object].push_back(lit_key(material, face.back, v));
    }
    for (auto& list : keys) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return keys;
}

/// Lights keys [begin, end), all of one material, with a uniform albedo.
template <class T>
void light_range(const Frame& frame, const ObjectSurface& surface, Shading shading,
                 const LightingPair<T>& lighting, const LitPoints<T>& points, std::size_t begin,
                 std::size_t end, float albedo, std::vector<T> (&radiance)[3],
                 EventCounts& events) {
    const ResolvedMaterial& material = frame.plan.materials[points.key[begin] >> 33];
    Batch<T> batch;
    batch.textured = true;
    for (std::size_t i = begin; i < end; ++i) {
        push_lit_point(batch, surface, shading, points.key[i], i);
        batch.push_albedo({albedo, albedo, albedo});
    }
    batch.illuminate(material, lighting.of(material), events);
    for (std::size_t i = begin; i < end; ++i)
        for (int c = 0; c < 3; ++c) radiance[c][i] = batch.radiance[c][i - begin];
}

}  // namespace

template <class T>
void light_points(Frame& frame, Shading shading) {
    const LightingPair<T> lighting = lighting_of<T>(frame);
    const auto keys = needed_keys(frame, shading);
    lit_points<T>(frame).resize(frame.scene.objects.size());
    for (std::size_t object = 0; object < keys.size(); ++object) {
        if (frame.plan.objects[object].shading != shading) continue;
        const ObjectSurface surface(frame.scene.objects[object]);
        LitPoints<T>& points = lit_points<T>(frame)[object];
        points.key = keys[object];
        for (int c = 0; c < 3; ++c) {
            points.radiance[c].resize(points.key.size());
            points.unreflecting[c].resize(frame.plan.texture ? points.key.size() : 0);
        }
        for (std::size_t begin = 0, end; begin < points.key.size(); begin = end) {
            const std::uint64_t material = points.key[begin] >> 33;
            for (end = begin; end < points.key.size() && points.key[end] >> 33 == material;) ++end;
            light_range<T>(frame, surface, shading, lighting, points, begin, end, 1,
                           points.radiance, frame.events);
            if (frame.plan.texture)
                light_range<T>(frame, surface, shading, lighting, points, begin, end, 0,
                               points.unreflecting, frame.events);
        }
        frame.items += points.key.size();
    }
}

template void light_points<float>(Frame&, Shading);
template void light_points<double>(Frame&, Shading);

}  // namespace scanshade

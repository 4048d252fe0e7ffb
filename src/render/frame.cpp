#include "render/frame.hpp"

#include <algorithm>

#include "render/lighting.hpp"

namespace scanshade {

Frame::Frame(const Scene& normalised_scene, const RenderPlan& render_plan, Framebuffer& into)
    : scene(normalised_scene),
      plan(render_plan),
      view(make_view(render_plan.camera, render_plan.depth, render_plan.width, render_plan.height)),
      lighting(make_lighting(normalised_scene, view)),
      unlit(make_unlit_lighting(view)),
      target(into) {
    for (const Object& object : scene.objects)
        object_views.push_back(make_object_view(object, view));
}

void transform_vertices(Frame& frame) {
    frame.vertices.resize(frame.scene.objects.size());
    for (std::size_t i = 0; i < frame.vertices.size(); ++i) {
        const Mesh& mesh = *frame.scene.objects[i].mesh;
        frame.vertices[i].resize(mesh.vertex_count());
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            frame.vertices[i][v] = transform_vertex(mesh, v, frame.object_views[i], frame.view);
    }
}

std::size_t object_of(const RenderPlan& plan, std::uint32_t triangle) {
    const auto after = std::upper_bound(
        plan.objects.begin(), plan.objects.end(), triangle,
        [](std::uint32_t t, const ObjectPlan& object) { return t < object.first_triangle; });
    return static_cast<std::size_t>(after - plan.objects.begin()) - 1;
}

}  // namespace scanshade

#include "scanshade/render/plan.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/stages.hpp"
#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

Shading shading_of(const Object& object, const Settings& settings) {
    return settings.is_given("shading") ? settings.shading
                                        : object.shading.value_or(settings.shading);
}

/// One object after another: triangles are numbered through the whole scene.
void plan_objects(const Scene& scene, const Settings& settings, RenderPlan& plan) {
    for (const Object& object : scene.objects) {
        const Shading shading = shading_of(object, settings);
        plan.objects.push_back(
            {shading, static_cast<std::uint32_t>(plan.triangles), object.materials});
        plan.triangles += object.mesh->triangle_count();
        plan.vertices += object.mesh->vertex_count();
        plan.face_light |= shading == Shading::flat;
        plan.vertex_light |= shading == Shading::gouraud;
    }
    if (plan.triangles >= no_index)
        throw Error(Errc::scene, fmt::format("the scene has {} triangles; at most {} can be drawn",
                                             plan.triangles, no_index - 1));
}

void plan_materials(const Scene& scene, const Settings& settings, RenderPlan& plan) {
    std::vector<bool> used(scene.materials.size());
    for (const Object& object : scene.objects)
        for (const std::uint32_t material : object.materials) used[material] = true;
    bool any_lit = false;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        plan.materials.push_back(resolve_material(material, settings.brdf, settings.set));
        if (!used[i]) continue;
        plan.texture |= material.map_kd != nullptr;
        any_lit |= !plan.materials.back().unlit;
    }
    plan.light_count = any_lit ? scene.lights.size() : 0;
}

}  // namespace

RenderPlan make_plan(const Scene& scene, const Settings& settings) {
    RenderPlan plan{};
    plan.width = settings.width;
    plan.height = settings.height;
    plan.samples_side = static_cast<int>(std::lround(std::sqrt(settings.samples)));
    plan.interpolation = settings.interpolation;
    plan.renderer = settings.renderer;
    plan.isa = settings.isa;
    plan.threads = settings.threads;
    plan.transfer = settings.transfer;
    plan.exposure_ev = settings.exposure_ev;
    plan.cull = settings.cull;
    for (int c = 0; c < 3; ++c) plan.background[c] = static_cast<float>(settings.background[c]);
    const Bounds bounds = scene.bounds();
    const double aspect = double(settings.width) / double(settings.height);
    plan.camera = scene.camera ? *scene.camera : framed_camera(bounds, aspect);
    plan.depth = depth_range(plan.camera, bounds);
    plan_objects(scene, settings, plan);
    plan_materials(scene, settings, plan);
    return plan;
}

std::vector<PlanLine> explain(const RenderPlan& plan) {
    std::vector<PlanLine> lines;
    for (const Stage& stage : all_stages())
        lines.push_back({stage.name, stage.needed(plan), stage.reason(plan)});
    return lines;
}

}  // namespace scanshade

#include "scanshade/render/plan.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/stages.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/scene/clusters.hpp"

namespace scanshade {

bool is_matt(const ResolvedMaterial& material) {
    if (material.unlit || !material.brdf->reads_matt) return false;
    const auto params = material.brdf->params;
    for (std::size_t i = 0; i < params.size(); ++i)
        if (params[i].role == ParamRole::specular) {
            const auto& value = material.params.value[i];
            return value[0] == 0 && value[1] == 0 && value[2] == 0;
        }
    return false;
}

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
        if (plan.renderer == RendererKind::simd)
            plan.clusters +=
                clusters_of(*object.mesh, draws_whole(plan.interpolation)).clusters.size();
        const bool drawn = object.mesh->triangle_count() > 0;
        if (shading != Shading::phong)
            plan.points +=
                shading == Shading::flat ? object.mesh->face_count() : object.mesh->vertex_count();
        plan.face_light |= drawn && shading == Shading::flat;
        plan.vertex_light |= drawn && shading == Shading::gouraud;
        plan.sample_light |= drawn && shading == Shading::phong;
    }
    if (plan.triangles >= no_index)
        throw Error(Errc::scene, fmt::format("the scene has {} triangles; at most {} can be drawn",
                                             plan.triangles, no_index - 1));
}

void plan_materials(const Scene& scene, const Settings& settings, RenderPlan& plan) {
    std::vector<bool> used(scene.materials.size());
    for (const Object& object : scene.objects)
        for (const std::uint32_t material : object.materials) used[material] = true;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        plan.materials.push_back(resolve_material(scene.materials[i], settings.brdf, settings.set));
        if (settings.power == PowerForm::exp_log)
            for (Exponent& s : plan.materials.back().params.exponent) s = by_exp_log(s);
        if (!used[i]) continue;
        const ResolvedMaterial& material = plan.materials.back();
        ++plan.used_materials;
        plan.unlit_materials += material.unlit;
        plan.textured_materials += scene.materials[i].map_kd != nullptr;
        plan.matt_materials += is_matt(material);
        plan.position_read |= plan.sample_light && !material.unlit && !material.brdf->ignores_view;
    }
    plan.texture = plan.textured_materials > 0;
}

void plan_lights(const Scene& scene, RenderPlan& plan) {
    if (plan.unlit_materials == plan.used_materials) return;
    plan.light_count = scene.lights.size();
    for (const Light& light : scene.lights) {
        const bool placed = light.kind != LightKind::directional;
        plan.dark_lights += light.intensity == glm::dvec3(0);
        plan.narrow_lights += light.kind == LightKind::spot || light.kind == LightKind::cosine;
        plan.constant_lights += !placed || (light.attenuation.y == 0 && light.attenuation.z == 0);
        plan.position_read |= plan.sample_light && placed;
    }
}

void plan_rows(const Settings& settings, RenderPlan& plan) {
    if (settings.no_plan || plan.renderer != RendererKind::simd) return;
    for (const PlanRowInfo& info : all_plan_rows())
        plan.rows[static_cast<std::size_t>(info.row)] =
            info.applies(plan) && settings.kept_rows.find(info.name) == settings.kept_rows.end();
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
    plan.tile = settings.tile;
    plan.transfer = settings.transfer;
    plan.exposure_ev = settings.exposure_ev;
    plan.tolerance = settings.tolerance;
    plan.cull = settings.cull;
    for (int c = 0; c < 3; ++c)
        plan.background[std::size_t(c)] = static_cast<float>(settings.background[c]);
    const Bounds bounds = scene.bounds();
    const double aspect = double(settings.width) / double(settings.height);
    plan.camera = scene.camera ? *scene.camera : framed_camera(bounds, aspect);
    plan.depth = depth_range(plan.camera, bounds);
    plan_objects(scene, settings, plan);
    plan_materials(scene, settings, plan);
    plan_lights(scene, plan);
    plan_rows(settings, plan);
    return plan;
}

std::vector<PlannedStage> explain_stages(const RenderPlan& plan) {
    std::vector<PlannedStage> stages;
    for (const Stage& stage : stages_of(plan.renderer))
        stages.push_back({stage.name, stage.needed(plan), stage.reason(plan)});
    return stages;
}

std::string PlannedRow::amount() const {
    return fmt::format("{} of {} {}", saving.saved, saving.of, info->unit);
}

std::vector<PlannedRow> explain_rows(const RenderPlan& plan, const PlanSavings& saved) {
    std::vector<PlannedRow> rows;
    if (plan.renderer != RendererKind::simd) return rows;
    for (const PlanRowInfo& info : all_plan_rows()) {
        const bool left_out = plan.leaves_out(info.row);
        const bool asked = info.applies(plan) && !left_out;
        rows.push_back({&info, left_out, asked ? "asked for" : info.reason(plan), saved[info.row]});
    }
    return rows;
}

}  // namespace scanshade

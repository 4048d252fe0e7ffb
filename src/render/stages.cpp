#include "render/stages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/lighting.hpp"
#include "render/shade.hpp"
#include "render/visibility.hpp"

namespace scanshade {
namespace {

bool always(const RenderPlan&) { return true; }
bool has_faces(const RenderPlan& plan) { return plan.triangles > 0; }

std::size_t objects_with(const RenderPlan& plan, Shading shading) {
    return static_cast<std::size_t>(
        std::count_if(plan.objects.begin(), plan.objects.end(),
                      [=](const ObjectPlan& object) { return object.shading == shading; }));
}

std::string count_reason(const RenderPlan& plan, Shading shading, std::string_view what) {
    const std::size_t objects = objects_with(plan, shading);
    if (objects == 0)
        return fmt::format("no object is {}", shading_names()[static_cast<std::size_t>(shading)]);
    return fmt::format("{} of {} objects: {}", objects, plan.objects.size(), what);
}

/// Runs the function for the number type of the plan.
template <class F32, class F64>
void by_number(Frame& frame, F32 f32, F64 f64) {
    frame.plan.renderer == RendererKind::scalar_f32 ? f32(frame) : f64(frame);
}

void transform(Frame& frame) {
    transform_vertices(frame);
    for (const auto& vertices : frame.vertices) frame.items += vertices.size();
}

template <Shading shading>
void light(Frame& frame) {
    by_number(
        frame, [](Frame& f) { light_points<float>(f, shading); },
        [](Frame& f) { light_points<double>(f, shading); });
}

void shade(Frame& frame) { by_number(frame, shade_samples<float>, shade_samples<double>); }

/// Background where nothing was drawn; the colour of a sample starts at 0 otherwise.
void background(Frame& frame) {
    const auto color = frame.plan.background;
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
        if (frame.id[i] != Framebuffer::no_triangle) continue;
        frame.target.r[i] += color[0];
        frame.target.g[i] += color[1];
        frame.target.b[i] += color[2];
        ++frame.items;
    }
}

void average(Frame& frame) {
    const float samples = static_cast<float>(frame.plan.samples_side * frame.plan.samples_side);
    for (std::vector<float>* channel : {&frame.target.r, &frame.target.g, &frame.target.b})
        for (float& value : *channel) value /= samples;
    frame.items += frame.target.r.size();
}

constexpr Stage stages[] = {
    {"transform", "vertices", false, has_faces,
     [](const RenderPlan& plan) { return fmt::format("{} vertices", plan.vertices); }, transform},
    {"visibility", "polygons", true, always,
     [](const RenderPlan& plan) { return fmt::format("{} triangles", plan.triangles); },
     find_visible},
    {"light-faces", "faces", true, [](const RenderPlan& plan) { return plan.face_light; },
     [](const RenderPlan& plan) {
         return count_reason(plan, Shading::flat, "visible faces are lit once");
     },
     light<Shading::flat>},
    {"light-vertices", "vertices", true, [](const RenderPlan& plan) { return plan.vertex_light; },
     [](const RenderPlan& plan) {
         return count_reason(plan, Shading::gouraud, "vertices of visible faces are lit once");
     },
     light<Shading::gouraud>},
    {"shade", "samples", true, has_faces,
     [](const RenderPlan& plan) {
         return fmt::format("visible samples only; {} lights", plan.light_count);
     },
     shade},
    {"background", "samples", true, always,
     [](const RenderPlan&) { return std::string("samples without a surface"); }, background},
    {"average", "pixels", false, [](const RenderPlan& plan) { return plan.samples_side > 1; },
     [](const RenderPlan& plan) {
         return plan.samples_side > 1 ? fmt::format("{0} x {0} samples a pixel", plan.samples_side)
                                      : std::string("one sample a pixel is its own mean");
     },
     average},
};

}  // namespace

std::span<const Stage> all_stages() { return stages; }

}  // namespace scanshade

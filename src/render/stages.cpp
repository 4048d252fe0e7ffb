#include "render/stages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/engine.hpp"
#include "render/lighting.hpp"
#include "render/shade.hpp"
#include "render/visibility.hpp"
#include "scanshade/base/timer.hpp"

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

void visibility(Frame& frame) {
    find_visible(frame);
    if (!frame.first_sample) return;
    frame.target.depth = frame.depth;
    frame.target.id = frame.id;
}

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

std::string triangles_reason(const RenderPlan& plan) {
    return fmt::format("{} triangles", plan.triangles);
}
std::string samples_reason(const RenderPlan& plan) {
    return fmt::format("visible samples only; {} lights", plan.light_count);
}
std::string average_reason(const RenderPlan& plan) {
    return plan.samples_side > 1 ? fmt::format("{0} x {0} samples a pixel", plan.samples_side)
                                 : std::string("one sample a pixel is its own mean");
}
bool several_samples(const RenderPlan& plan) { return plan.samples_side > 1; }
bool lights_points(const RenderPlan& plan) { return plan.vertex_light || plan.face_light; }
std::string background_reason(const RenderPlan&) { return "samples without a surface"; }

constexpr Stage scalar_stages[] = {
    {"transform", "vertices", false, has_faces,
     [](const RenderPlan& plan) { return fmt::format("{} vertices", plan.vertices); }, transform},
    {"visibility", "polygons", true, always, triangles_reason, visibility},
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
    {"shade", "samples", true, has_faces, samples_reason, shade},
    {"background", "samples", true, always, background_reason, background},
    {"average", "pixels", false, several_samples, average_reason, average},
};

constexpr Stage simd_stages[] = {
    {"set-up", "triangles", true, has_faces,
     [](const RenderPlan& plan) {
         return fmt::format("{} triangles in {} clusters", plan.triangles, plan.clusters);
     },
     [](Frame& frame) { frame.engine->set_up(frame); }},
    {"records", "polygons", true, has_faces,
     [](const RenderPlan&) {
         return std::string("large, clipped and needle-shaped triangles, polygons drawn whole");
     },
     [](Frame& frame) { frame.engine->make_records(frame); }},
    {"raster", "tiles", true,
     [](const RenderPlan& plan) { return plan.leaves_out(PlanRow::unseen_points); },
     [](const RenderPlan& plan) {
         return std::string(plan.leaves_out(PlanRow::unseen_points)
                                ? "all tiles, so that light knows what is seen"
                                : "done tile by tile with the shading");
     },
     [](Frame& frame) { frame.engine->raster(frame); }},
    {"light-points", "points", true, lights_points,
     [](const RenderPlan& plan) {
         return std::string(lights_points(plan) ? "vertices and faces are lit once"
                                                : "light is evaluated at samples");
     },
     [](Frame& frame) { frame.engine->light_points(frame); }},
    {"shade", "samples", true, has_faces, samples_reason,
     [](Frame& frame) { frame.engine->shade(frame); }},
    {"background", "tiles", true, always,
     [](const RenderPlan&) { return std::string("tiles without a surface"); },
     [](Frame& frame) { frame.engine->draw_background(frame); }},
    {"average", "pixels", false, several_samples, average_reason, average},
};

}  // namespace

std::span<const Stage> stages_of(RendererKind renderer) {
    if (renderer == RendererKind::simd) return simd_stages;
    return scalar_stages;
}

namespace {

/// Sample (i, j) of a regular grid of side × side in a pixel, to the nearest 1/256.
SampleOffset grid_sample(int i, int j, int side) {
    const auto at = [side](int k) { return (2 * k + 1) * subpixels / (2 * side); };
    return {at(i), at(j)};
}

void run_stage(std::size_t number, Frame& frame, FrameStats& stats) {
    const Stage& stage = stages_of(frame.plan.renderer)[number];
    if (!stage.needed(frame.plan)) return;
    StageStats& row = stats.stages[number];
    frame.items = 0;
    const Timer timer;
    stage.run(frame);
    row.ms += timer.ms();
    row.ran = true;
    row.items += frame.items;
}

}  // namespace

void run_stages(Frame& frame, FrameStats& stats, const std::function<void()>& after_sample) {
    const auto stages = stages_of(frame.plan.renderer);
    for (const Stage& stage : stages)
        stats.stages.push_back({stage.name, false, 0, 0, stage.item_name});
    const auto is_each = [](const Stage& stage) { return stage.each_sample; };
    const auto first = std::find_if(stages.begin(), stages.end(), is_each);
    const auto last = std::find_if_not(first, stages.end(), is_each);
    const auto run = [&](auto from, auto to) {
        for (auto stage = from; stage != to; ++stage)
            run_stage(static_cast<std::size_t>(stage - stages.begin()), frame, stats);
    };
    run(stages.begin(), first);
    const int side = frame.plan.samples_side;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            frame.sample = grid_sample(i, j, side);
            frame.first_sample = i == 0 && j == 0;
            run(first, last);
            if (after_sample) after_sample();
        }
    run(last, stages.end());
    for (const StageStats& row : stats.stages)
        if (row.name == "shade") stats.covered_samples = row.items;
    stats.events = frame.events;
    stats.saved = frame.saved;
    stats.tolerated_lights = frame.tolerated_lights;
}

}  // namespace scanshade

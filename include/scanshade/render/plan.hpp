// The plan: what a picture needs, decided once, before anything is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/brdf/brdf.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// One object's part of the plan.
struct ObjectPlan {
    Shading shading;
    std::uint32_t first_triangle;          // number of its triangle 0 in the whole scene
    std::vector<std::uint32_t> materials;  // mesh material number → index into the plan's
};

/// Everything that drawing decides on, made by one pure function. Comparable through its text.
struct RenderPlan {
    // what is drawn, by which method
    int width, height, samples_side;  // samples_side² samples a pixel
    Interpolation interpolation;
    RendererKind renderer;
    std::string isa;
    int threads;
    Transfer transfer;
    double exposure_ev;
    Cull cull;
    std::array<float, 3> background;
    Camera camera;  // in normalised space
    DepthRange depth;
    std::vector<ObjectPlan> objects;
    std::vector<ResolvedMaterial> materials;

    // what is needed; each with the count that decides it
    std::uint64_t triangles = 0, vertices = 0;
    bool vertex_light = false;    // some object is gouraud
    bool face_light = false;      // some object is flat
    bool texture = false;         // some material in use has a texture
    std::size_t light_count = 0;  // 0 where no material in use is lit
};

/// `scene` must be normalised. Throws Error for materials that no model can draw.
RenderPlan make_plan(const Scene& scene, const Settings& settings);

/// One line of `scanshade explain`.
struct PlanLine {
    std::string_view stage;
    bool runs;
    std::string reason;  // with the counts
};
std::vector<PlanLine> explain(const RenderPlan& plan);

}  // namespace scanshade

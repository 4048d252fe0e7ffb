// The plan: what a picture needs, decided once, before anything is drawn.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/brdf/brdf.hpp"
#include "scanshade/render/plan_rows.hpp"
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
    int tile;  // side of a tile in samples
    Transfer transfer;
    double exposure_ev;
    double tolerance;  // levels of 255
    Cull cull;
    std::array<float, 3> background;
    Camera camera;  // in normalised space
    DepthRange depth;
    std::vector<ObjectPlan> objects;
    std::vector<ResolvedMaterial> materials;

    // what is needed; each with the count that decides it
    std::uint64_t triangles = 0, vertices = 0, clusters = 0;
    std::uint64_t points = 0;     // vertices of gouraud objects, faces of flat ones
    bool vertex_light = false;    // some object is gouraud
    bool face_light = false;      // some object is flat
    bool sample_light = false;    // some object is phong
    bool texture = false;         // some material in use has a texture
    std::size_t light_count = 0;  // 0 where no material in use is lit
    std::size_t used_materials = 0, unlit_materials = 0, textured_materials = 0;
    std::size_t matt_materials = 0;   // lit, with a specular parameter that is black
    std::size_t dark_lights = 0;      // of no intensity
    std::size_t narrow_lights = 0;    // spot and cosine lights
    std::size_t constant_lights = 0;  // attenuation does not depend on the distance
    bool position_read = false;       // light at samples depends on where they are

    /// What is left out, by PlanRow: it applies, and was not asked for.
    std::bitset<plan_row_count> rows;
    bool leaves_out(PlanRow row) const { return rows[static_cast<std::size_t>(row)]; }
};

/// `scene` must be normalised. Throws Error for materials that no model can draw.
RenderPlan make_plan(const Scene& scene, const Settings& settings);

/// Lit, and what it adds for highlights is black.
bool is_matt(const ResolvedMaterial& material);

/// A stage of the plan's renderer, as `scanshade explain` shows it.
struct PlannedStage {
    std::string_view name;
    bool runs;           // else it is left out
    std::string reason;  // with the counts
};
/// In the order in which they run.
std::vector<PlannedStage> explain_stages(const RenderPlan& plan);

/// A row of the plan and what it saved in a frame.
struct PlannedRow {
    const PlanRowInfo* info;
    bool left_out;       // else the work is done
    std::string reason;  // with the counts
    PlanSaving saving;

    /// "12 of 34 triangles".
    std::string amount() const;
};
/// All rows in the order of PlanRow; none for the scalar renderers, which do all work. `saved` is
/// that of a frame of this plan.
std::vector<PlannedRow> explain_rows(const RenderPlan& plan, const PlanSavings& saved);

}  // namespace scanshade

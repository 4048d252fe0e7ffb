#include "scanshade/render/plan_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scanshade/render/plan.hpp"

namespace scanshade {
namespace {

bool has_triangles(const RenderPlan& plan) { return plan.triangles > 0; }

std::string clusters_reason(const RenderPlan& plan) {
    return fmt::format("those of {} clusters whose sphere is outside the view", plan.clusters);
}

std::string facing_reason(const RenderPlan& plan) {
    return plan.cull == Cull::back
               ? fmt::format("those of {} clusters that show only back faces", plan.clusters)
               : std::string("both sides are drawn");
}

bool some_normals_unread(const RenderPlan& plan) {
    return plan.unlit_materials > 0 || plan.face_light;
}
std::string normals_reason(const RenderPlan& plan) {
    if (!some_normals_unread(plan)) return "light reads the normals of every surface";
    return fmt::format("{} of {} materials are unlit{}", plan.unlit_materials, plan.used_materials,
                       plan.face_light ? ", and flat faces have their own" : "");
}

bool positions_unread(const RenderPlan& plan) { return !plan.position_read; }
std::string positions_reason(const RenderPlan& plan) {
    if (!plan.sample_light) return "light is evaluated at vertices and faces";
    return plan.position_read ? "a light or a highlight depends on them"
                              : "no light has a place and no material a highlight";
}

bool texcoords_unread(const RenderPlan& plan) {
    return plan.textured_materials < plan.used_materials;
}
std::string texcoords_reason(const RenderPlan& plan) {
    return fmt::format("{} of {} materials have a texture", plan.textured_materials,
                       plan.used_materials);
}

bool lights_points(const RenderPlan& plan) { return plan.vertex_light || plan.face_light; }

/// To know what is seen, all tiles are kept before any is lit: about what a light at every pixel
/// costs, or at half as many points.
bool seeing_pays(const RenderPlan& plan) {
    const std::uint64_t pixels = std::uint64_t(plan.width) * std::uint64_t(plan.height);
    return lights_points(plan) && 2 * plan.light_count * plan.points > pixels;
}
std::string points_reason(const RenderPlan& plan) {
    if (!lights_points(plan)) return "light is evaluated at samples";
    return seeing_pays(plan) ? "only vertices and faces that some sample shows are lit"
                             : fmt::format(
                                   "to light all {} vertices and faces costs less than to "
                                   "find those that are seen",
                                   plan.points);
}

bool some_dark(const RenderPlan& plan) { return plan.dark_lights > 0 || plan.narrow_lights > 0; }
std::string dark_reason(const RenderPlan& plan) {
    if (!some_dark(plan)) return "every light shines in every direction";
    return fmt::format("{} lights are black; {} shine one way, and not into every tile",
                       plan.dark_lights, plan.narrow_lights);
}

bool some_constant(const RenderPlan& plan) { return plan.constant_lights > 0; }
std::string attenuation_reason(const RenderPlan& plan) {
    return fmt::format("{} of {} lights do not weaken with distance", plan.constant_lights,
                       plan.light_count);
}

bool some_matt(const RenderPlan& plan) { return plan.matt_materials > 0; }
std::string specular_reason(const RenderPlan& plan) {
    return fmt::format("{} of {} materials have no highlight", plan.matt_materials,
                       plan.used_materials);
}

bool one_material(const RenderPlan& plan) {
    return plan.used_materials == 1 && !lights_points(plan);
}
std::string lookup_reason(const RenderPlan& plan) {
    return plan.used_materials == 1 ? std::string("there is one material")
                                    : fmt::format("there are {} materials", plan.used_materials);
}

bool always(const RenderPlan&) { return true; }
std::string tiles_reason(const RenderPlan&) { return "tiles that no triangle touches"; }

bool writes_bytes(const RenderPlan& plan) { return plan.samples_side == 1; }
std::string unchanged_reason(const RenderPlan& plan) {
    return writes_bytes(plan)
               ? std::string("16 × 16 pixels that the frame before left so; a first frame has none")
               : "samples of a pixel are added before they are bytes";
}

constexpr PlanRowInfo rows[] = {
    {PlanRow::clusters_outside, "clusters-outside", "clusters outside the view", "triangles",
     has_triangles, clusters_reason},
    {PlanRow::clusters_facing_away, "clusters-facing-away", "clusters seen from behind",
     "triangles", [](const RenderPlan& plan) { return plan.cull == Cull::back; }, facing_reason},
    {PlanRow::clipping, "clipping", "the test against near, far and guard band", "vertices",
     has_triangles,
     [](const RenderPlan&) { return std::string("where a cluster's sphere is inside of all"); }},
    {PlanRow::normals, "normals", "planes of normals", "triangles", some_normals_unread,
     normals_reason},
    {PlanRow::positions, "positions", "positions of samples", "samples", positions_unread,
     positions_reason},
    {PlanRow::texcoords, "texture-coordinates", "planes of texture coordinates", "triangles",
     texcoords_unread, texcoords_reason},
    {PlanRow::unseen_points, "unseen-points", "light at vertices and faces that nobody sees",
     "points", seeing_pays, points_reason},
    {PlanRow::dark_lights, "dark-lights", "lights that add exactly nothing to a tile",
     "lights in tiles", some_dark, dark_reason},
    {PlanRow::attenuation, "attenuation", "attenuation that is constant", "lights", some_constant,
     attenuation_reason},
    {PlanRow::specular, "specular", "the power of highlights that are black", "materials",
     some_matt, specular_reason},
    {PlanRow::material_lookup, "material-look-up", "sorting samples by material", "subtiles",
     one_material, lookup_reason},
    {PlanRow::empty_tiles, "empty-tiles", "everything but the background", "tiles", always,
     tiles_reason},
    {PlanRow::unchanged_background, "unchanged-background",
     "background where the frame before left it", "blocks", writes_bytes, unchanged_reason},
};
static_assert(std::size(rows) == plan_row_count);

}  // namespace

std::span<const PlanRowInfo> all_plan_rows() { return rows; }

}  // namespace scanshade

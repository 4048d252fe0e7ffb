#include "scanshade/base/events.hpp"

namespace scanshade {
namespace {

constexpr EventInfo events[] = {
    {Event::degenerate_face, "degenerate-face",
     "a face with fewer than three distinct corners or no area was left out", 0, "faces"},
    {Event::concave_face, "concave-face", "a concave face was triangulated by ear clipping", 1,
     "faces"},
    {Event::self_crossing_face, "self-crossing-face",
     "a face crosses itself, so its triangles overlap", 0, "faces"},
    {Event::cancelled_normal, "cancelled-normal",
     "averaged normals cancelled at a vertex, so the face normal was taken", 0.01, "vertices"},
    {Event::repaired_normal, "repaired-normal",
     "a normal in the file had no direction, so the face normal was taken", 0, "vertices"},
    {Event::missing_material, "missing-material",
     "a face names a material that no material library defines", 0, "faces"},
    {Event::transparency_ignored, "transparency-ignored",
     "a transparent material (d < 1) is drawn opaque", 0, "materials"},
    {Event::near_clipped, "near-clipped", "a triangle was cut by the near or far plane", 1,
     "triangles"},
    {Event::guard_clipped, "guard-clipped", "a triangle was cut by the guard band", 1, "triangles"},
    {Event::zero_area, "zero-area", "a triangle has no area once snapped to 1/256 pixel", 1,
     "triangles"},
    {Event::clamped_weight, "clamped-weight",
     "a weight of a clipped triangle was below zero by rounding and was clamped", 1, "samples"},
    {Event::edges_fallback, "edges-fallback",
     "a polygon was not strictly convex on screen, so its triangles were drawn", 0.05, "faces"},
    {Event::patch_fallback, "patch-fallback",
     "a quadrilateral had no inverse bilinear map, so barycentric weights were used", 0.05,
     "faces"},
    {Event::zero_normal, "zero-normal",
     "an interpolated normal had no length, so the face normal was taken", 0.0005, "samples"},
    {Event::light_at_surface, "light-at-surface",
     "a light was closer to the surface than its radius", 0.01, "samples"},
    {Event::not_finite, "not-finite", "a colour was not a finite number and was drawn black", 0,
     "samples"},
};

static_assert(std::size(events) == static_cast<std::size_t>(Event::count_));

}  // namespace

std::span<const EventInfo> all_events() { return events; }

}  // namespace scanshade

#include "report/picture_cases.hpp"

#include <string>

#include "report/picture_scenes.hpp"

namespace scanshade {
namespace {

constexpr auto flat = Shading::flat, gouraud = Shading::gouraud, phong = Shading::phong;
constexpr auto edges = Interpolation::edges, patch = Interpolation::patch;

// ---- bounds that are wider than the usual ones, with their reasons

constexpr PictureBounds usual{};

constexpr PictureBounds colour_within(int levels, std::uint64_t beyond, std::string_view reason) {
    PictureBounds bounds;
    bounds.levels = levels;
    bounds.beyond = beyond;
    bounds.reason = reason;
    return bounds;
}

constexpr PictureBounds moved_within(double displacement, std::string_view reason) {
    PictureBounds bounds;
    bounds.displacement = displacement;
    bounds.reason = reason;
    return bounds;
}

constexpr PictureBounds mistaken_within(std::uint64_t samples, std::string_view reason) {
    PictureBounds bounds;
    bounds.mistaken = samples;
    bounds.reason = reason;
    return bounds;
}

constexpr PictureBounds near_corners_lost = moved_within(
    256,
    "a mesh is stored in units of its size, 1e3, and its matrix is rounded to float: w of a corner "
    "at 1e-3 is off by up to 3 %");

constexpr PictureBounds wide_angle = moved_within(
    3, "corners almost beside the eye stand 1e4 pixels away, where w is rounded to float");

constexpr PictureBounds closer_than_floats = mistaken_within(
    2000, "the surfaces are 1e-7 of their distance apart, two steps of a float's depth");
constexpr PictureBounds equally_near =
    mistaken_within(2000, "the faces are equally near, so in double, too, rounding decides");
constexpr PictureBounds crossing_in_a_plane =
    mistaken_within(100, "the triangles of a face that crosses itself overlap in one plane");
constexpr PictureBounds nearly_equally_near =
    mistaken_within(100, "faces that cross 1e-9 apart are equally near in float");

// One rounding of the cosine, 2^-24, is magnified by the exponent: 4e-5 · 1e6 levels.
constexpr PictureBounds rounded_cosine = colour_within(
    40, 4000, "the exponent magnifies one rounding of the cosine to 6 % of the highlight");

constexpr PictureBounds light_or_none = colour_within(
    64, 24, "cosθ_i is 0 but for rounding, which decides whether a sample is lit at all");

constexpr HardCase cases[] = {
    // ---- where things are
    {"scale-1e-18", "squares of lengths are 1e-36, attenuation is 5e34 a unit²", scaled_scene,
     1e-18},
    {"scale-1e-9", "a scene of a nanometre", scaled_scene, 1e-9},
    {"scale-1e9", "a scene of a million kilometres", scaled_scene, 1e9},
    {"scale-1e18", "squares of lengths are 1e36, attenuation is 5e-38 a unit²", scaled_scene, 1e18},
    {"offset-1e7-file", "the file has the model at 1e7, where a float's step is 1", far_in_file,
     1e7},
    {"offset-1e7-placed", "a matrix moves the model to 1e7", far_placed, 1e7},
    {"far-pair-1e7", "the scene is ten million times as large as what the camera is close to",
     far_pair, 1e7},
    {"near-through-mesh", "the near plane cuts the sphere open", cut_by_near, 0.4},
    {"near-through-mesh-gouraud", "corners that the near plane makes need values", cut_by_near, 0.4,
     usual, gouraud, edges},
    {"near-and-far-cut", "orthographic: near and far leave a slice", cut_by_both, 0.3},
    {"inside-mesh", "corners all around the eye, 150° high", inside_mesh, 150, wide_angle},
    {"guard-band", "triangles a million pixels large", beyond_guard_band, 1e4},
    {"behind-the-eye", "w below zero mirrors a corner and turns the winding", behind_eye, 1},
    {"behind-the-eye-gouraud", "the same, with light from corners behind the eye", behind_eye, 1,
     usual, gouraud},
    {"at-the-eye", "corners at w = 1e-6, just behind the eye", behind_eye, 1e-6},
    {"w-ratio-1e6", "distances of 1e-3 and 1e3 in one triangle", w_ratio, 1e6, near_corners_lost},
    {"w-ratio-1e6-gouraud-edges", "the same, linear along edges on the picture", w_ratio, 1e6,
     near_corners_lost, gouraud, edges},
    {"w-ratio-1e6-patch", "the same, by the inverse bilinear map", w_ratio, 1e6, near_corners_lost,
     phong, patch},
    {"w-ratio-1e6-texture", "the same, with texture coordinates", w_ratio_texture, 1e6,
     near_corners_lost},
    {"depth-1e-3-to-1e9", "depth spans twelve orders of magnitude", depth_range_scene, 1e-3},
    {"near-coplanar-1e-7", "surfaces closer than a float's step of depth", z_fighting, 1e-7,
     closer_than_floats},
    {"near-coplanar-1e-4", "surfaces as close as depth must tell apart", z_fighting, 1e-4},

    // ---- meshes
    {"slivers", "2764 triangles a tenth of a pixel wide meet in a point", slivers, 0.1},
    {"needles-1-256", "6144 triangles no wider than the grid they are snapped to", needles,
     1 / 256.0},
    {"t-junctions", "corners on the middle of a neighbour's edge", t_junctions, 7},
    {"coplanar", "faces that overlap in one plane", coplanar, 60, equally_near},
    {"duplicated-vertices", "every face has its own corners, and is there three times",
     duplicated_vertices, 3},
    {"zero-area-faces", "points, lines and needles among the faces", zero_area_faces, 1e-9},
    {"tiny-triangles", "forty triangles in a pixel", tiny_triangles, 40},
    {"denormal-coordinates", "coordinates of 1e-310 beside 1", tiny_coordinates, 1e-310,
     crossing_in_a_plane},
    {"tiny-coordinates", "coordinates of 1e-9 beside 1", tiny_coordinates, 1e-9,
     nearly_equally_near},
    {"odd-quads", "concave, crossed, folded and flattened quadrilaterals", odd_quads, 0.3},
    {"odd-quads-edges", "the same, drawn whole where that is possible", odd_quads, 0.3, usual,
     gouraud, edges},
    {"odd-quads-patch", "the same: not each has an inverse bilinear map", odd_quads, 0.3, usual,
     phong, patch},
    {"normals-zero", "the file's normals are of length 0, 1, 1e-30, 1e-300 and 1e300",
     normal_lengths, 1e300},
    {"normals-opposite", "normals of a face that cancel where they are interpolated",
     opposite_normals, 180},
    {"normals-opposite-edges", "the same, along spans", opposite_normals, 180, usual, phong, edges},
    {"normals-opposite-flat", "the same, and flat shading that must not care", opposite_normals,
     180, usual, flat},
    {"normals-cancelling", "averaged normals of front and back", cancelling_normals, 1e-2,
     equally_near},

    // ---- light and reflection
    {"exponent-0", "x⁰ is 1, also of 0", exponent, 0},
    {"exponent-1", "the widest highlight", exponent, 1},
    {"exponent-1e4", "a rounding of the cosine is magnified ten thousand times", exponent, 1e4},
    {"exponent-1e6", "one step of a float's cosine is 6 % of the highlight", exponent, 1e6,
     rounded_cosine},
    {"exponent-1e6-gouraud", "the same at corners", exponent, 1e6, rounded_cosine, gouraud},
    {"roughness-1e-2", "the highlight of a nearly smooth surface", roughness, 1e-2},
    {"roughness-1e-4", "facets that lean by 1e-4: sin² of the half vector is 1e-8", roughness,
     1e-4},
    {"light-on-surface", "cosines are rounding noise, and distances go to 0", light_off_origin, 0,
     light_or_none},
    {"light-on-surface-gouraud", "the same at corners: one of them has distance 0",
     light_off_origin, 0, usual, gouraud},
    {"light-near-surface", "a light as high as rounding errors, over a plane through the origin",
     light_at_height, 1e-7},
    {"light-near-surface-1e-3", "a light that a thousandth lifts", light_off_origin, 1e-3},
    {"light-inside", "a light in a closed mesh that near cuts open", light_inside, 1},
    {"light-at-1e15", "squares of distances are 1e30", light_far, 1e15},
    {"light-at-1e30", "squares of distances are beyond float", light_far, 1e30},
    {"grazing-1e-2", "light and view are almost in the surface", grazing, 1e-2},
    {"grazing-1e-8", "cosθ is 1e-8", grazing, 1e-8},
    {"spot-rim", "a sample is lit or not by the last bit of an angle", spot_rim, 20},
    {"bright-1e30", "radiance far beyond what a byte holds", bright, 1e30},
};

}  // namespace

ReportInput HardCase::input() const {
    ReportInput input = make(parameter);
    input.scene.name = std::string(name);
    input.settings.shading = shading;
    input.settings.interpolation = interpolation;
    return input;
}

std::span<const HardCase> hard_cases() { return cases; }

}  // namespace scanshade

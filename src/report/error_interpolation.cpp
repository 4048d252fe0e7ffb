// The axis of interpolation: flat, Gouraud and Phong shading of polygons against the smooth surface
// that they stand for; and spheres for which theory says how fast their errors fall.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/error_parts.hpp"
#include "scanshade/render/smooth.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {
namespace {

bool any_mesh(const ReportInput& input, bool (*is)(const Mesh&)) {
    return std::any_of(input.scene.objects.begin(), input.scene.objects.end(),
                       [is](const Object& object) { return is(*object.mesh); });
}

/// Flat shading carries nothing; interpolations differ only where faces have more corners.
void add_shadings(const ReportInput& input, const std::string& suffix, double amount, bool as_given,
                  std::vector<ErrorMethod>& methods) {
    const bool polygons = any_mesh(input, [](const Mesh& mesh) { return mesh.has_polygons; });
    const bool quads = any_mesh(input, [](const Mesh& mesh) { return mesh.has_quads; });
    for (std::size_t shading = 0; shading < shading_names().size(); ++shading)
        for (std::size_t way = 0; way < interpolation_names().size(); ++way) {
            const bool carries = Shading(shading) != Shading::flat;
            if (way > 0 && !carries) continue;
            if (Interpolation(way) == Interpolation::edges && !polygons) continue;
            if (Interpolation(way) == Interpolation::patch && !quads) continue;
            const std::string name(shading_names()[shading]), how(interpolation_names()[way]);
            ErrorMethod method{carries ? name + ", " + how : name,
                               {},
                               {{"shading", name}},
                               amount,
                               false,
                               with_one_sample(input)};
            if (carries) method.parameters.emplace_back("interpolation", how);
            method.series = method.name;
            method.name += suffix;
            Settings& s = method.input.settings;
            method.as_given = as_given && s.shading == Shading(shading) &&
                              (!carries || s.interpolation == Interpolation(way));
            s.shading = Shading(shading);
            s.interpolation = Interpolation(way);
            s.given.insert("shading");
            methods.push_back(std::move(method));
        }
}

bool has_shapes(const ReportInput& input) {
    return any_mesh(input, [](const Mesh& mesh) { return mesh.shape != nullptr; });
}

/// As many quads along an edge as the whole scene has in a square.
double edge_count(const Scene& scene) { return std::sqrt(double(scene.triangle_count()) / 2); }

/// The largest power of two that keeps smooth shapes below some size.
double reference_factor(const Scene& scene) {
    constexpr double most_triangles = 1.2e6;
    double factor = 16;
    while (factor > 2 && predicted_triangles(scene, factor) > most_triangles) factor /= 2;
    return factor;
}

ErrorReference smooth_reference(const ReportInput& input, double factor) {
    Framebuffer half;
    draw_smooth(retessellated(input.scene, factor / 2, Retessellate::smooth), input.settings, half);
    ErrorReference reference{{}, {}, 0, {}};
    const SmoothCounts counts =
        draw_smooth(retessellated(input.scene, factor, Retessellate::smooth), input.settings,
                    reference.picture);
    reference.what = fmt::format(
        "the smooth surface, shaded in double at its exact position and with its exact normal "
        "where the ray through each pixel's centre meets it ({} pixels{}{})",
        counts.exact,
        counts.unrefined > 0 ? fmt::format("; {} at silhouettes on a fine mesh", counts.unrefined)
                             : "",
        counts.meshes > 0 ? fmt::format("; {} on meshes from files, whose smooth surface nobody "
                                        "knows: by Phong shading on that mesh",
                                        counts.meshes)
                          : "");
    // What a silhouette of chords leaves out of a smooth one has a quarter of the area with chords
    // half as long, so of the two strips' squares three quarters are the difference.
    const Comparison pair(half, reference.picture, Transfer::linear, 0);
    reference.own_rmse = measure(find_metric("rmse"), pair) / std::sqrt(3.0);
    reference.own_from = fmt::format(
        "nearly all of it is at silhouettes, which are those of a mesh {} times as fine as the "
        "scene's; from the difference to a reference with a mesh half as fine",
        factor);
    return reference;
}

// ---- spheres of known orders

constexpr int convergence_reference = 128;

std::vector<ErrorMethod> convergence_methods(const ReportInput& input) {
    std::vector<ErrorMethod> methods;
    for (int n = 2; n <= 64; n *= 2) {
        ReportInput finer = input;
        const int given = input.scene.objects.front().mesh->tessellation;
        finer.scene = retessellated(input.scene, double(n) / given);
        std::vector<ErrorMethod> all;
        add_shadings(finer, fmt::format(", n = {}", n), n, n == given, all);
        for (ErrorMethod& method : all) {
            if (method.input.settings.interpolation != Interpolation::perspective) continue;
            method.parameters.emplace_back("tessellation", fmt::format("{}", n));
            methods.push_back(std::move(method));
        }
    }
    return methods;
}

ErrorReference convergence_reference_of(const ReportInput& input, const MakeDrawing&) {
    return smooth_reference(
        input, double(convergence_reference) / input.scene.objects.front().mesh->tessellation);
}

// h is the side of a polygon.
constexpr ExpectedOrder diffuse_orders[] = {
    {"flat", "mae", ErrorRegion::covered, 1,
     "one value a face is off by the slope times the way from its middle: h"},
    {"flat", "rmse", ErrorRegion::covered, 1, "the same everywhere, so squares change nothing"},
    {"flat", "max", ErrorRegion::covered, 1, "the same at the far corner of a face"},
    {"flat", "rmse", ErrorRegion::all, 1, "h on the faces, and the silhouette's share below"},
    {"gouraud", "mae", ErrorRegion::covered, 2,
     "a smooth radiance is off by h² between vertices; at the terminator it has a kink and is off "
     "by "
     "h, in a strip that is only h wide"},
    {"gouraud", "rmse", ErrorRegion::covered, 1.5,
     "squares weigh the strip at the terminator more: √(h² · h). Without it in view the order is "
     "2"},
    {"gouraud", "max", ErrorRegion::covered, 1, "the kink at the terminator"},
    {"gouraud", "rmse", ErrorRegion::all, 1,
     "at the silhouette a strip h² wide shows the background instead: √h²"},
    {"phong", "mae", ErrorRegion::covered, 2, "an interpolated normal is off by h²"},
    {"phong", "rmse", ErrorRegion::covered, 2,
     "the same, but for a factor √log(1/h) from near the silhouette"},
    {"phong", "max", ErrorRegion::covered, 1,
     "the surface is h² from the polygon, but √h² along a view that grazes it"},
    {"phong", "rmse", ErrorRegion::all, 1,
     "at the silhouette a strip h² wide shows the background instead: √h²"},
};

constexpr ErrorAxis convergence = {
    "convergence", "How fast does the error of interpolation fall with finer polygons?",
    "quads a quarter turn", convergence_methods, convergence_reference_of};

constexpr ErrorAxis known_convergence = [] {
    ErrorAxis axis = convergence;
    axis.expected = diffuse_orders;
    return axis;
}();

ReportInput lit_sphere(const Settings& settings, const std::string& name, double ks) {
    constexpr int tessellation = 16, side = 512;
    Material material;
    material.brdf = ks > 0 ? "blinn-phong" : "lambert";
    if (ks > 0) material.set("ks", {ks}), material.set("shininess", {100});
    ReportInput input{
        single_object_scene(make_shape_mesh(*find_shape("sphere"), tessellation), material),
        settings};
    Light oblique;
    oblique.kind = LightKind::directional;
    oblique.direction = {-0.7, -0.5, -0.5};
    Camera camera;
    camera.view_angle_deg = 25;
    input.scene.name = name;
    input.scene.ambient = glm::dvec3(0);
    input.scene.lights = {oblique};
    input.scene.camera = camera;
    Settings& s = input.settings;
    if (!s.is_given("resolution")) s.width = s.height = side;
    s.brdf.clear(), s.set.clear();
    s.background = glm::dvec3(0);
    return input;
}

}  // namespace

std::vector<ErrorMethod> interpolation_methods(const ReportInput& input) {
    std::vector<ErrorMethod> methods;
    if (!has_shapes(input)) {
        add_shadings(input, "", 0, true, methods);
        return methods;
    }
    constexpr double most_triangles = 4e5;
    const bool may_double = 4 * double(input.scene.triangle_count()) <= most_triangles;
    for (const double factor : {0.125, 0.25, 0.5, 1.0, 2.0}) {
        if (factor == (may_double ? 0.125 : 2.0)) continue;
        ReportInput finer = input;
        finer.scene = retessellated(input.scene, factor);
        const std::size_t before = methods.size();
        add_shadings(finer, fmt::format(", tessellation ×{}", factor), edge_count(finer.scene),
                     factor == 1, methods);
        for (std::size_t i = before; i < methods.size(); ++i)
            methods[i].parameters.emplace_back("tessellation_factor", fmt::format("{}", factor));
    }
    return methods;
}

ErrorReference interpolation_reference(const ReportInput& input, const MakeDrawing&) {
    if (has_shapes(input)) return smooth_reference(input, reference_factor(input.scene));
    ErrorReference reference{{},
                             "Phong shading in double on the same mesh, in perspective",
                             0,
                             "its pictures are stored as floats, to 2⁻²⁴ of each value"};
    draw_smooth(input.scene, input.settings, reference.picture);
    reference.own_rmse = 0x1p-24 * root_mean_square(reference.picture);
    return reference;
}

std::vector<ErrorStudy> convergence_studies(const Settings& settings) {
    return {{lit_sphere(settings, "diffuse sphere", 0), &known_convergence},
            {lit_sphere(settings, "sphere with a highlight", 0.5), &convergence}};
}

}  // namespace scanshade

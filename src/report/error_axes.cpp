// The axes of the error report: what is varied, and what it is compared with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/error_parts.hpp"
#include "scanshade/kernels/isa.hpp"
#include "scanshade/render/smooth.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {
namespace {

std::string name_of(RendererKind renderer) {
    return std::string(renderer_names()[std::size_t(renderer)]);
}

/// The mean square of what a picture shows, to its root.
double root_mean_square(const Framebuffer& frame) {
    double sum = 0;
    for (const auto* plane : {&frame.r, &frame.g, &frame.b})
        for (const float value : *plane) sum += double(value) * double(value);
    return std::sqrt(sum / (3.0 * double(frame.r.size())));
}

Framebuffer planes_of(const ReportInput& input, const MakeDrawing& make) {
    Framebuffer picture;
    make(input.scene, input.settings).planes(picture);
    return picture;
}

ReportInput with_one_sample(ReportInput input) {
    input.settings.samples = 1;
    return input;
}

// ---- numerical

bool has_exponent(const ReportInput& input) {
    const RenderPlan plan = make_plan(normalised(input.scene), input.settings);
    return std::any_of(plan.materials.begin(), plan.materials.end(), [](const auto& material) {
        const auto& s = material.params.exponent;
        return std::any_of(std::begin(s), std::end(s),
                           [](const Exponent& e) { return e.whole > 0 || e.fraction > 0; });
    });
}

ErrorMethod numerical_method(const ReportInput& input, RendererKind renderer,
                             const std::string& isa, PowerForm power, bool with_power) {
    const std::string form(power_form_names()[std::size_t(power)]);
    const bool vectors = renderer == RendererKind::simd;
    ErrorMethod method{name_of(renderer),     {}, {{"renderer", name_of(renderer)}}, 0, false,
                       with_one_sample(input)};
    if (vectors) method.name += ", " + isa, method.parameters.emplace_back("isa", isa);
    method.series = method.name;
    if (with_power) method.name += ", " + form, method.parameters.emplace_back("power", form);
    Settings& s = method.input.settings;
    const std::string best = instruction_sets().front();
    method.as_given = s.renderer == renderer && s.power == power &&
                      (!vectors || isa == (s.isa.empty() ? best : s.isa));
    s.renderer = renderer;
    s.power = power;
    s.isa = isa;
    return method;
}

std::vector<ErrorMethod> numerical_methods(const ReportInput& input) {
    std::vector<ErrorMethod> methods;
    const bool with_power = has_exponent(input);
    for (const PowerForm power : {PowerForm::squaring, PowerForm::exp_log}) {
        if (power != PowerForm::squaring && !with_power) break;
        for (const std::string& isa : instruction_sets())
            methods.push_back(numerical_method(input, RendererKind::simd, isa, power, with_power));
        for (const RendererKind renderer : {RendererKind::scalar_f32, RendererKind::scalar_f64})
            methods.push_back(
                numerical_method(input, renderer, instruction_sets().front(), power, with_power));
    }
    return methods;
}

ErrorReference numerical_reference(const ReportInput& input, const MakeDrawing& make) {
    ReportInput exact = with_one_sample(input);
    exact.settings.renderer = RendererKind::scalar_f64;
    exact.settings.power = PowerForm::squaring;
    ErrorReference reference{
        planes_of(exact, make),
        "the same shading, model and interpolation by scalar-f64, whose powers "
        "are raised by squaring",
        0, "its pictures are stored as floats, to 2⁻²⁴ of each value"};
    reference.own_rmse = 0x1p-24 * root_mean_square(reference.picture);
    return reference;
}

// ---- aliasing

std::vector<ErrorMethod> aliasing_methods(const ReportInput& input) {
    std::vector<int> counts{1, 4, 16, 64};
    if (const int given = input.settings.samples;
        given < reference_samples && std::find(counts.begin(), counts.end(), given) == counts.end())
        counts.push_back(given);
    std::sort(counts.begin(), counts.end());
    std::vector<ErrorMethod> methods;
    for (const int samples : counts) {
        methods.push_back({fmt::format("{} sample{}", samples, samples > 1 ? "s" : ""),
                           "samples",
                           {{"samples", fmt::format("{}", samples)}},
                           double(samples),
                           samples == input.settings.samples,
                           input});
        methods.back().input.settings.samples = samples;
    }
    return methods;
}

/// Its own error is not known before that of the rows: finish_orders sets it.
ErrorReference aliasing_reference(const ReportInput& input, const MakeDrawing& make) {
    ReportInput fine = input;
    fine.settings.samples = reference_samples;
    return {planes_of(fine, make),
            fmt::format("{} samples a pixel, everything else the same", reference_samples), 0, ""};
}

// ---- interpolation

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

// ---- model

std::vector<ErrorMethod> model_methods(const ReportInput& input) {
    std::vector<ErrorMethod> methods{{"as given", "as given", {}, 0, true, with_one_sample(input)}};
    for (const BrdfInfo* brdf : all_brdfs()) {
        const std::string name(brdf->name);
        methods.push_back({name, name, {{"brdf", name}}, 0, false, with_one_sample(input)});
        methods.back().input.settings.brdf = name;
    }
    return methods;
}

ErrorReference model_reference(const ReportInput& input, const MakeDrawing& make) {
    return {planes_of(with_one_sample(input), make),
            "the scene with its own models. This compares models with each other, and says nothing "
            "of how any of them differs from light transport",
            0, "it is what the scene asks for, by definition"};
}

constexpr ErrorAxis axes[] = {
    {"numerical", "What do fewer digits, other instructions and other forms of the power cost?", "",
     numerical_methods, numerical_reference},
    {"aliasing", "What do few samples a pixel cost?", "samples a pixel", aliasing_methods,
     aliasing_reference},
    {"interpolation",
     "What does it cost to light faces, vertices or interpolated normals of polygons in place of "
     "the surface that they stand for?",
     "quads along an edge", interpolation_methods, interpolation_reference},
    {"model", "How far are reflection models from each other?", "", model_methods, model_reference},
};

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

std::span<const ErrorAxis> error_axes() { return axes; }

std::vector<ErrorStudy> convergence_studies(const Settings& settings) {
    return {{lit_sphere(settings, "diffuse sphere", 0), &known_convergence},
            {lit_sphere(settings, "sphere with a highlight", 0.5), &convergence}};
}

}  // namespace scanshade

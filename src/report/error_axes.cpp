// The axes of the error report: what is varied, and what it is compared with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/error_parts.hpp"
#include "scanshade/kernels/isa.hpp"

namespace scanshade {
namespace {

std::string name_of(RendererKind renderer) {
    return std::string(renderer_names()[std::size_t(renderer)]);
}

Framebuffer planes_of(const ReportInput& input, const MakeDrawing& make) {
    Framebuffer picture;
    make(input.scene, input.settings).planes(picture);
    return picture;
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

}  // namespace

double root_mean_square(const Framebuffer& frame) {
    double sum = 0;
    for (const auto* plane : {&frame.r, &frame.g, &frame.b})
        for (const float value : *plane) sum += double(value) * double(value);
    return std::sqrt(sum / (3.0 * double(frame.r.size())));
}

ReportInput with_one_sample(ReportInput input) {
    input.settings.samples = 1;
    return input;
}

std::span<const ErrorAxis> error_axes() { return axes; }

}  // namespace scanshade

#include "report/model_sweeps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brdf/cosines.hpp"
#include "report/printed_models.hpp"
#include "report/sweep_errors.hpp"
#include "scanshade/brdf/brdf.hpp"

namespace scanshade {
namespace {

constexpr std::size_t points = 161;

/// Light and viewer in a plane with the normal, by their elevation; the viewer across the normal.
Cosines<long double> across(double light_angle, double viewer_angle) {
    const auto light = static_cast<long double>(light_angle);
    const auto viewer = static_cast<long double>(viewer_angle);
    const Vec3<long double> up = {0, 0, 1};
    const Vec3<long double> wi = {std::cos(light), 0, std::sin(light)};
    const Vec3<long double> wo = {-std::cos(viewer), 0, std::sin(viewer)};
    return cosines(up, wi, wo);
}

constexpr double elsewhere = 0.875;  // elevation of what is not swept

/// What is swept: `width` is the angle of the half vector at which the highlight has fallen off.
struct Axis {
    std::string_view title, variable;
    bool of_parameter;  // else of directions, from 1e-8 rad to the normal
    Cosines<long double> (*at)(double x, double width);
};
constexpr Axis axes[] = {
    {"side of the highlight", "", true,
     [](double, double width) { return across(elsewhere, elsewhere + width); }},
    {"light from the surface up", "elevation of ω_i, rad", false,
     [](double x, double) { return across(x, elsewhere); }},
    {"seen from the surface up", "elevation of ω_o, rad", false,
     [](double x, double) { return across(elsewhere, x); }},
    {"mirrored, from the surface up", "elevation of both, rad", false,
     [](double x, double) { return across(x, x); }},
};

/// A model with one choice other than the standard one, or none.
struct Variant {
    const BrdfInfo* brdf;
    const ParamInfo* choice = nullptr;
    std::string_view word{};

    std::string title() const {
        return choice ? fmt::format("{} {}", choice->name, word) : std::string();
    }
    const ParamInfo* roughness() const {
        for (const ParamInfo& param : brdf->params)
            if (param.role == ParamRole::exponent || param.role == ParamRole::roughness)
                return &param;
        return nullptr;
    }
    /// All parameters as float has them.
    MaterialParams<double> params(const ParamInfo* swept, double value) const {
        Material material;
        material.brdf = brdf->name;
        if (choice) material.set_word(choice->name, std::string(word));
        if (swept) material.set(swept->name, {std::clamp(value, swept->min, swept->max)});
        return params_as<double>(to_float(resolve_material(material, "", {}).params));
    }
};

std::vector<Variant> variants() {
    std::vector<Variant> all;
    for (const BrdfInfo* brdf : all_brdfs()) {
        all.push_back({brdf});
        for (const ParamInfo& param : brdf->params)
            for (std::size_t i = 0; i < param.names.size(); ++i)
                if (double(i) != param.standard) all.push_back({brdf, &param, param.names[i]});
    }
    return all;
}

template <class Make>
void for_each_sweep(Make make) {
    for (const Variant& variant : variants())
        for (const Axis& axis : axes)
            if (!axis.of_parameter || variant.roughness()) make(variant, axis);
}

/// Floats from low to high; a range that begins at 0 has it as its first point.
std::vector<double> points_between(double low, double high) {
    std::vector<double> x;
    if (low == 0) x.push_back(0);
    const double first = low > 0 ? low : 1;
    for (std::size_t i = 0; i < points; ++i)
        x.push_back(double(float(first * std::pow(high / first, double(i) / double(points - 1)))));
    return x;
}

/// The angle of the half vector at which a highlight of this exponent or roughness has fallen off.
double width_of(const ParamInfo& param, double value) {
    const double m = param.role == ParamRole::exponent ? std::sqrt(2 / (value + 2)) : value;
    return std::min(m, 0.5);
}

/// How much of an error of 1 u in each cosine is in the result, in u.
double condition_of(const BrdfInfo& brdf, const Cosines<double>& c,
                    const MaterialParams<double>& params) {
    constexpr double Cosines<double>::*values[] = {&Cosines<double>::n_i, &Cosines<double>::n_o,
                                                   &Cosines<double>::n_h, &Cosines<double>::r_o,
                                                   &Cosines<double>::i_h, &Cosines<double>::sin2_h,
                                                   &Cosines<double>::s_io};
    constexpr PlainDual Cosines<PlainDual>::*duals[] = {
        &Cosines<PlainDual>::n_i, &Cosines<PlainDual>::n_o, &Cosines<PlainDual>::n_h,
        &Cosines<PlainDual>::r_o, &Cosines<PlainDual>::i_h, &Cosines<PlainDual>::sin2_h,
        &Cosines<PlainDual>::s_io};
    double sum = 0;
    for (std::size_t seeded = 0; seeded < std::size(values); ++seeded) {
        Cosines<PlainDual> x;
        for (std::size_t k = 0; k < std::size(values); ++k)
            x.*duals[k] = {c.*values[k], k == seeded ? 1.0 : 0.0};
        sum += condition_number(c.*values[seeded], brdf.f_cos_dual(x, params)[0]);
    }
    return sum;
}

template <class R>
void add_point(R value, long double exact, double x, double bound, SweepErrors& errors) {
    const Component component{double(value), double((long double)(value)-exact), double(exact)};
    add_error({&component, 1}, precision_of<R>(), x, bound, false, errors);
}

/// Measures one point of a sweep.
void measure_point(const Variant& variant, const PrintedModel* printed,
                   const MaterialParams<double>& params, const Cosines<long double>& c, double x,
                   SweepResult& result) {
    const BrdfInfo& brdf = *variant.brdf;
    const Cosines<float> c32 = cosines_as<float>(c);
    const Cosines<double> c64 = cosines_as<double>(c);
    const long double exact = brdf.f_cos_f80(c, params_as<long double>(params))[0];
    const double condition = condition_of(brdf, c64, params);
    const double bound = brdf.promises.error_u(params) + condition + 1;
    result.condition = std::max(result.condition, condition);
    result.bound.push_back(bound);
    add_point(brdf.f_cos_f32(c32, to_float(params))[0], exact, x, bound, result.ours_f32);
    add_point(brdf.f_cos_f64(c64, params)[0], exact, x, bound, result.ours_f64);
    if (!printed) return;
    add_point(printed->f32(c32, brdf, params), exact, x, bound, *result.printed_f32);
    add_point(printed->f64(c64, brdf, params), exact, x, bound, *result.printed_f64);
}

SweepResult measure(const Variant& variant, const Axis& axis) {
    const ParamInfo* roughness = variant.roughness();
    const ParamInfo* swept = axis.of_parameter ? roughness : nullptr;
    const PrintedModel* printed = find_printed_model(variant.brdf->name);
    SweepResult result{};
    result.number = variant.brdf->name;
    result.title = variant.title().empty() ? std::string(axis.title)
                                           : fmt::format("{}, {}", variant.title(), axis.title);
    result.variable = swept ? swept->symbol : axis.variable;
    result.choice = printed ? printed->choice : "no printed form";
    result.because = "the error that the model states, and that of each rounded cosine";
    result.misprint = printed && printed->misprint;
    result.logarithmic = true;
    result.plotted = variant.choice == nullptr;
    if (printed) result.printed_f32 = result.printed_f64 = SweepErrors{};
    result.x = swept ? points_between(swept->min, swept->max) : points_between(1e-8, 1.57);
    for (const double x : result.x) {
        const double width = swept ? width_of(*swept, x) : 0;
        measure_point(variant, printed, variant.params(swept, x), axis.at(x, width), x, result);
    }
    return result;
}

}  // namespace

std::size_t model_sweep_count() {
    std::size_t count = 0;
    for_each_sweep([&](const Variant&, const Axis&) { ++count; });
    return count;
}

std::vector<SweepResult> measure_models(Steps& steps) {
    std::vector<SweepResult> results;
    for_each_sweep([&](const Variant& variant, const Axis& axis) {
        if (steps.watch.stopped()) return;
        steps.tell(fmt::format("{} {}", variant.brdf->name, axis.title));
        results.push_back(measure(variant, axis));
        ++steps.done;
    });
    return results;
}

}  // namespace scanshade

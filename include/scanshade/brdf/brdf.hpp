// Reflection models: one row of the registry for each file src/brdf/<model>.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/brdf/light_report.hpp"
#include "scanshade/kernels/span.hpp"
#include "scanshade/num/plain.hpp"
#include "scanshade/scene/material.hpp"

namespace scanshade {

/// A choice is one of a few names; its value is the name's place in the list.
enum class ParamKind : std::uint8_t { rgb, number, exponent, choice };

/// What a parameter means across models, so that a material of one can be drawn with another.
/// Exponent s and roughness m are two measures of one thing: m = √(2/(s + 2)).
enum class ParamRole : std::uint8_t { none, diffuse, specular, exponent, roughness };

/// One parameter: from this row come its option, its checks, its slider and its documentation.
struct ParamInfo {
    std::string_view name;    // "kd", as files and --set spell it
    std::string_view symbol;  // "k_d", as equations spell it
    ParamKind kind;
    ParamRole role;
    double min, max;        // inclusive; an input outside is an error
    double standard;        // default
    std::string_view unit;  // "" for pure numbers
    std::string_view meaning;
    std::span<const std::string_view> names{};  // of a choice, for the values 0, 1, ...
};

/// A value as people read it: a number, or the name of a choice.
std::string value_text(const ParamInfo& info, double value);

/// Whether the albedo stays at or below 1: always; where the diffuse and the specular parameter
/// sum to at most 1 in each channel; or not for all parameters in range.
enum class Energy : std::uint8_t { conserving, conserving_to_sum_one, may_exceed_one };

/// What a model says of itself; property tests hold it to every word.
struct Promises {
    bool reciprocal;  // f_r(ω_i, ω_o) = f_r(ω_o, ω_i)
    Energy energy;
    double (*error_u)(const MaterialParams<double>&);  // relative error of f_cos in u of its number
                                                       // type, cosines taken as exact
};

/// The same cosines in another type of number.
template <class To, class From>
Cosines<To> cosines_as(const Cosines<From>& c) {
    return {To(c.n_i), To(c.n_o), To(c.n_h), To(c.r_o), To(c.i_h), To(c.sin2_h), To(c.s_io)};
}

/// f_r cosθ_i in 1/sr a channel: cosines and result in T, parameters in the type that T's
/// arithmetic gives uniform quantities in.
template <class T, class Param = T>
using FCosFn = std::array<T, 3> (*)(const Cosines<T>&, const MaterialParams<Param>&);

/// Lights a span; `simd` runs on the best instruction set of this machine.
template <class T>
using IlluminateFn = SpanEvents (*)(const SurfaceSpan<T>&, const Lighting<T>&,
                                    const MaterialParams<T>&);
/// The same for a span of one point, and what it computed on the way.
template <class T>
using ReportFn = void (*)(const SurfaceSpan<T>&, const Lighting<T>&, const MaterialParams<T>&,
                          PointReport<T>&);

struct BrdfInfo {
    std::string_view name;      // "blinn-phong"
    std::string_view title;     // one line
    std::string_view equation;  // f_r cosθ_i in UTF-8, with its number in the formula sheet
    std::string_view source;    // author and year
    std::span<const ParamInfo> params;
    Promises promises;
    /// Upper bound of f_cos in 1/sr for a channel, whatever the directions; null: none is known.
    double (*most)(const MaterialParams<double>&, int channel);
    bool reads_matt;    // f_cos leaves its highlight out where MaterialParams::matt says so
    bool ignores_view;  // f_cos reads cosθ_i alone

    /// Computes `derived` from the other parameters, in double.
    void (*derive)(MaterialParams<double>&);

    /// One text in every type of number: the interval encloses what float and its exact value are,
    /// the dual carries a derivative.
    FCosFn<double> f_cos_f64;
    FCosFn<float> f_cos_f32;
    FCosFn<long double> f_cos_f80;
    FCosFn<PlainInterval, float> f_cos_interval;
    FCosFn<PlainDual, double> f_cos_dual;

    IlluminateFn<float> illuminate_f32;  // one sample at a time: the plain twin
    IlluminateFn<double> illuminate_f64;
    IlluminateFn<float> illuminate_simd;  // whole vectors, dispatched at run time

    ReportFn<float> report_f32;  // the text of illuminate_f32 with a witness
    ReportFn<double> report_f64;
};

/// Every model that has a file, by name.
std::span<const BrdfInfo* const> all_brdfs();

/// The model of that name, or nullptr. "unlit" is none: see resolve_material.
const BrdfInfo* find_brdf(std::string_view name);

/// A material bound to a model, every parameter in range.
struct ResolvedMaterial {
    const BrdfInfo* brdf;
    bool unlit;  // the diffuse colour, whatever the light
    MaterialParams<double> params;
    std::vector<std::string> mapped;  // sentences: parameters of another model and what became
                                      // of them, energy that a model cannot keep
};

/// Binds a material to `brdf_override` (where not empty) or its own model, maps parameters of
/// another model by their role, applies `set`, checks names and ranges.
/// Throws Error(scene), or Error(usage) for what came from an option.
ResolvedMaterial resolve_material(const Material& material, std::string_view brdf_override,
                                  const std::vector<ParamSetting>& set);

/// The parameters in another type of number.
template <class To, class From>
MaterialParams<To> params_as(const MaterialParams<From>& from) {
    MaterialParams<To> to{};
    const auto copy = [](const From(&a)[3], To(&b)[3]) {
        for (int c = 0; c < 3; ++c) b[c] = static_cast<To>(a[c]);
    };
    for (std::size_t i = 0; i < max_params; ++i) {
        copy(from.value[i], to.value[i]);
        to.exponent[i] = from.exponent[i];
    }
    for (std::size_t i = 0; i < max_derived; ++i) to.derived[i] = static_cast<To>(from.derived[i]);
    copy(from.ka, to.ka);
    copy(from.emission, to.emission);
    to.matt = from.matt;
    return to;
}

/// double → float, once, before shading.
MaterialParams<float> to_float(const MaterialParams<double>& params);

}  // namespace scanshade

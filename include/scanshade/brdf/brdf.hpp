// Reflection models: one row of the registry for each file src/brdf/<model>.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/kernels/span.hpp"
#include "scanshade/scene/material.hpp"

namespace scanshade {

enum class ParamKind : std::uint8_t { rgb, number, exponent };

/// What a parameter means across models, so that a material of one can be drawn with another.
enum class ParamRole : std::uint8_t { none, diffuse, specular, exponent };

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
};

enum class Energy : std::uint8_t { conserving, may_exceed_one };

/// What a model says of itself; property tests hold it to every word.
struct Promises {
    bool reciprocal;                                   // f_r(ω_i, ω_o) = f_r(ω_o, ω_i)
    Energy energy;                                     // albedo ≤ 1 for all parameters in range
    double (*error_u)(const MaterialParams<double>&);  // relative error of f_cos in u of its number
                                                       // type, cosines taken as exact
};

/// Directions at a surface point, unit length, by their cosines.
template <class R>
struct Cosines {
    R n_i;  // cosθ_i = n·ω_i, > 0
    R n_o;  // cosθ_o = n·ω_o, ≥ 1e-12
    R n_h;  // cosθ_h = n·h, [0, 1]
    R r_o;  // cosθ_r = ω_r·ω_o, [0, 1]: 0 where the mirror direction points away from the viewer
};

/// Lights a span; `simd` runs on the best instruction set of this machine.
template <class T>
using IlluminateFn = SpanEvents (*)(const SurfaceSpan<T>&, const Lighting<T>&,
                                    const MaterialParams<T>&);

struct BrdfInfo {
    std::string_view name;      // "blinn-phong"
    std::string_view title;     // one line
    std::string_view equation;  // f_r cosθ_i in UTF-8, with its number in the formula sheet
    std::string_view source;    // author and year
    std::span<const ParamInfo> params;
    Promises promises;
    bool ignores_view;  // f_cos reads cosθ_i alone

    /// f_r cosθ_i in 1/sr a channel, in the number type that the name says.
    std::array<double, 3> (*f_cos_f64)(const Cosines<double>&, const MaterialParams<double>&);
    std::array<float, 3> (*f_cos_f32)(const Cosines<float>&, const MaterialParams<float>&);

    IlluminateFn<float> illuminate_f32;  // one sample at a time: the plain twin
    IlluminateFn<double> illuminate_f64;
    IlluminateFn<float> illuminate_simd;  // whole vectors, dispatched at run time
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
                                      // of them
};

/// Binds a material to `brdf_override` (where not empty) or its own model, maps parameters of
/// another model by their role, applies `set`, checks names and ranges.
/// Throws Error(scene), or Error(usage) for what came from an option.
ResolvedMaterial resolve_material(const Material& material, std::string_view brdf_override,
                                  const std::vector<ParamSetting>& set);

/// double → float, once, before shading.
MaterialParams<float> to_float(const MaterialParams<double>& params);

}  // namespace scanshade

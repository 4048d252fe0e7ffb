// Random materials of any reflection model.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "scanshade/brdf/brdf.hpp"
#include "support/random.hpp"

namespace scanshade {

/// A value of a parameter: every fourth time an end of its range. Exponents are kept where a power
/// does not yet amount to a cliff; extremes have a test of their own.
inline double random_value(const ParamInfo& param, Rng& rng) {
    const double high = param.kind == ParamKind::exponent ? 300 : param.max;
    const std::int64_t pick = rng.integer(0, 7);
    if (param.kind == ParamKind::choice) return double(rng.integer(0, std::int64_t(param.max)));
    const double v = pick == 0 ? param.min : pick == 1 ? high : rng.real(param.min, high);
    return param.kind == ParamKind::exponent && pick % 2 == 0 ? std::floor(v) : v;
}

/// Parameters of a model, each channel by `value(param)`.
template <class Value>
MaterialParams<double> params_by(const BrdfInfo& brdf, Value value) {
    Material material;
    material.brdf = brdf.name;
    for (const ParamInfo& param : brdf.params) {
        if (param.kind == ParamKind::choice)
            material.set_word(param.name, std::string(param.names[std::size_t(value(param))]));
        else if (param.kind == ParamKind::rgb)
            material.set(param.name, {value(param), value(param), value(param)});
        else
            material.set(param.name, {value(param)});
    }
    return resolve_material(material, "", {}).params;
}

inline MaterialParams<double> random_params(const BrdfInfo& brdf, Rng& rng) {
    return params_by(brdf, [&](const ParamInfo& param) { return random_value(param, rng); });
}

}  // namespace scanshade

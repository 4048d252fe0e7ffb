// Materials bound to models.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/brdf/brdf.hpp"

namespace scanshade {
namespace {

// What every material may carry beside its model's parameters.
constexpr double max_emission = 1e6;
constexpr ParamInfo ka_info = {"ka",
                               "k_a",
                               ParamKind::rgb,
                               ParamRole::none,
                               0,
                               1,
                               0,
                               "",
                               "factor of the ambient light; default: the diffuse colour"};
constexpr ParamInfo emission_info = {"emission",
                                     "L_e",
                                     ParamKind::rgb,
                                     ParamRole::none,
                                     0,
                                     max_emission,
                                     0,
                                     "",
                                     "radiance that the surface adds of its own"};

std::vector<std::string_view> known_names(const BrdfInfo& brdf) {
    std::vector<std::string_view> names;
    for (const ParamInfo& param : brdf.params) names.push_back(param.name);
    names.insert(names.end(), {ka_info.name, emission_info.name});
    return names;
}

const ParamInfo* find_param(const BrdfInfo& brdf, std::string_view name) {
    if (name == ka_info.name) return &ka_info;
    if (name == emission_info.name) return &emission_info;
    for (const ParamInfo& param : brdf.params)
        if (param.name == name) return &param;
    return nullptr;
}

/// The parameter of any model by that name: it tells the role of a foreign parameter.
const ParamInfo* find_anywhere(std::string_view name) {
    for (const BrdfInfo* brdf : all_brdfs())
        if (const ParamInfo* param = find_param(*brdf, name)) return param;
    return nullptr;
}

/// The place of a word in the names of a choice.
double checked_choice(const ParamInfo& info, const ParamSetting& setting, Errc errc) {
    const auto found = std::find(info.names.begin(), info.names.end(), setting.word);
    if (found != info.names.end()) return static_cast<double>(found - info.names.begin());
    throw Error(errc, setting.word.empty()
                          ? fmt::format("{} takes one of {}, not a number", info.name,
                                        fmt::join(info.names, ", "))
                          : fmt::format("{} knows no '{}'{}", info.name, setting.word,
                                        suggestion(setting.word, info.names)))
        .at(setting.place);
}

/// One channel value each, checked against the row.
std::array<double, 3> checked(const ParamInfo& info, const ParamSetting& setting, Errc errc) {
    if (info.kind == ParamKind::choice) {
        const double value = checked_choice(info, setting, errc);
        return {value, value, value};
    }
    const bool one = setting.values.size() == 1;
    if (!one && !(setting.values.size() == 3 && info.kind == ParamKind::rgb))
        throw Error(
            errc,
            fmt::format("{} takes {}, not {}", info.name,
                        info.kind == ParamKind::rgb ? "one number or three (R,G,B)" : "one number",
                        setting.word.empty() ? fmt::format("{} numbers", setting.values.size())
                                             : fmt::format("'{}'", setting.word)))
            .at(setting.place);
    for (const double value : setting.values)
        if (!(value >= info.min && value <= info.max))
            throw Error(errc, fmt::format("{} = {} is out of range; it lies between {} and {}",
                                          info.name, value, info.min, info.max))
                .at(setting.place);
    const auto at = [&](std::size_t i) { return setting.values[one ? 0 : i]; };
    return {at(0), at(1), at(2)};
}

void store(MaterialParams<double>& params, const BrdfInfo& brdf, const ParamInfo& info,
           const std::array<double, 3>& value) {
    double(*target)[3] = nullptr;
    if (info.name == ka_info.name) target = &params.ka;
    if (info.name == emission_info.name) target = &params.emission;
    if (target == nullptr) {
        const std::size_t index = static_cast<std::size_t>(&info - brdf.params.data());
        target = &params.value[index];
        if (info.kind == ParamKind::exponent) params.exponent[index] = make_exponent(value[0]);
    }
    std::copy(value.begin(), value.end(), *target);
}

const ParamInfo* param_of_role(const BrdfInfo& brdf, ParamRole role) {
    if (role == ParamRole::none) return nullptr;
    for (const ParamInfo& param : brdf.params)
        if (param.role == role) return &param;
    return nullptr;
}

/// Between roles that measure one thing: values of `from` in terms of `to`.
struct RoleConversion {
    ParamRole from, to;
    double (*convert)(double);
    std::string_view rule;
};
constexpr RoleConversion conversions[] = {
    {ParamRole::exponent, ParamRole::roughness, [](double s) { return std::sqrt(2 / (s + 2)); },
     "√(2/(s + 2))"},
    {ParamRole::roughness, ParamRole::exponent, [](double m) { return 2 / (m * m) - 2; },
     "2/m² − 2"},
};

/// A parameter of a role that `brdf` lacks while it has one of a related role. Says what became of
/// it; false where there is no such role.
bool map_converted(ResolvedMaterial& out, const ParamSetting& setting, const ParamInfo& foreign) {
    for (const RoleConversion& c : conversions) {
        const ParamInfo* own = param_of_role(*out.brdf, c.to);
        if (foreign.role != c.from || own == nullptr) continue;
        const double wanted = c.convert(checked(foreign, setting, Errc::scene)[0]);
        const double value = std::clamp(wanted, own->min, own->max);
        store(out.params, *out.brdf, *own, {value, value, value});
        out.mapped.push_back(fmt::format("{} {:g} became {} {:g} = {}{}", setting.name,
                                         setting.values[0], own->name, value, c.rule,
                                         value == wanted ? "" : ", limited to its range"));
        return true;
    }
    return false;
}

/// A parameter that `brdf` does not have but another model does: mapped by its role, or dropped.
void map_foreign(ResolvedMaterial& out, const ParamSetting& setting, const ParamInfo& foreign) {
    if (map_converted(out, setting, foreign)) return;
    const ParamInfo* own = param_of_role(*out.brdf, foreign.role);
    if (own == nullptr) {
        out.mapped.push_back(
            fmt::format("{} has no part in {} and was left out", setting.name, out.brdf->name));
        return;
    }
    store(out.params, *out.brdf, *own, checked(*own, setting, Errc::scene));
    out.mapped.push_back(fmt::format("{} became {}", setting.name, own->name));
}

/// Says so where a model keeps energy only for parameters other than these.
void note_energy(ResolvedMaterial& out) {
    if (out.brdf->promises.energy != Energy::conserving_to_sum_one || out.unlit) return;
    const ParamInfo* diffuse = param_of_role(*out.brdf, ParamRole::diffuse);
    const ParamInfo* specular = param_of_role(*out.brdf, ParamRole::specular);
    const auto value = [&](const ParamInfo* info, int channel) {
        return out.params.value[info - out.brdf->params.data()][channel];
    };
    for (int channel = 0; channel < 3; ++channel) {
        const double sum = value(diffuse, channel) + value(specular, channel);
        if (sum <= 1) continue;
        out.mapped.push_back(fmt::format("{} + {} is {:g}: above 1, more is reflected than arrives",
                                         diffuse->name, specular->name, sum));
        return;
    }
}

/// Settings of the material itself; `foreign_allowed` where another model was asked for.
void apply(ResolvedMaterial& out, const std::vector<ParamSetting>& settings, bool foreign_allowed,
           Errc errc) {
    for (const ParamSetting& setting : settings) {
        if (const ParamInfo* info = find_param(*out.brdf, setting.name)) {
            store(out.params, *out.brdf, *info, checked(*info, setting, errc));
            continue;
        }
        const ParamInfo* foreign = foreign_allowed ? find_anywhere(setting.name) : nullptr;
        if (foreign == nullptr)
            throw Error(errc,
                        fmt::format("{} has no parameter '{}'{}", out.brdf->name, setting.name,
                                    suggestion(setting.name, known_names(*out.brdf))))
                .at(setting.place);
        map_foreign(out, setting, *foreign);
    }
}

const BrdfInfo& brdf_named(std::string_view name, Errc errc, std::string_view place) {
    if (const BrdfInfo* brdf = find_brdf(name)) return *brdf;
    std::vector<std::string_view> names;
    for (const BrdfInfo* brdf : all_brdfs()) names.push_back(brdf->name);
    names.push_back("unlit");
    Error error(errc,
                fmt::format("no reflection model is called '{}'{}", name, suggestion(name, names)));
    if (!place.empty()) error.at(place);
    throw error;
}

bool sets(const std::vector<ParamSetting>& settings, std::string_view name) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const ParamSetting& s) { return s.name == name; });
}

}  // namespace

std::string value_text(const ParamInfo& info, double value) {
    if (info.kind == ParamKind::choice) return std::string(info.names[std::size_t(value)]);
    return fmt::format("{:g}", value);
}

ResolvedMaterial resolve_material(const Material& material, std::string_view brdf_override,
                                  const std::vector<ParamSetting>& set) {
    const bool overridden = !brdf_override.empty() && brdf_override != material.brdf;
    const std::string_view name = brdf_override.empty() ? material.brdf : brdf_override;
    ResolvedMaterial out{};
    out.unlit = name == "unlit";
    // What is unlit shows its diffuse colour, a parameter of the plainest model.
    out.brdf =
        &brdf_named(out.unlit ? "lambert" : name, brdf_override.empty() ? Errc::scene : Errc::usage,
                    brdf_override.empty() ? std::string_view(material.place) : "--brdf");
    for (const ParamInfo& info : out.brdf->params)
        store(out.params, *out.brdf, info, {info.standard, info.standard, info.standard});

    apply(out, material.parameters, overridden || out.unlit, Errc::scene);
    apply(out, set, true, Errc::usage);

    const bool own_ka = sets(material.parameters, ka_info.name) || sets(set, ka_info.name);
    const ParamInfo* diffuse = param_of_role(*out.brdf, ParamRole::diffuse);
    if (diffuse != nullptr && (!own_ka || out.unlit)) {
        const auto& from = out.params.value[diffuse - out.brdf->params.data()];
        std::copy(std::begin(from), std::end(from), out.params.ka);
    }
    out.brdf->derive(out.params);
    note_energy(out);
    return out;
}

MaterialParams<float> to_float(const MaterialParams<double>& params) {
    return params_as<float>(params);
}

}  // namespace scanshade

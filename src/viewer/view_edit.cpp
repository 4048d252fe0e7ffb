// What the panel changes.
#include <fmt/format.h>

#include <algorithm>

#include "scanshade/base/error.hpp"
#include "scanshade/render/plan.hpp"
#include "viewer/view_state.hpp"

namespace scanshade::viewer {
namespace {

/// Options that are a side's own; the others are both sides'.
constexpr std::string_view side_options[] = {"shading", "brdf", "interpolation", "renderer"};

bool is_of_side(std::string_view option) {
    return std::find(std::begin(side_options), std::end(side_options), option) !=
           std::end(side_options);
}

}  // namespace

Settings ViewState::settings_for_loading(const Settings& command_line) const {
    Settings out = command_line;
    for (const OptionInfo& option : shared_options()) {
        if (option.show == nullptr || !settings().is_given(option.name)) continue;
        option.apply(out, option.show(settings()));
        out.given.emplace(option.name);
    }
    out.width = settings().width, out.height = settings().height;
    out.given.insert("resolution");
    return out;
}

void ViewState::replace(Scene scene, const Settings& loaded, bool keep_camera) {
    const Camera now = camera();
    for (Side& side : sides_) {
        Settings settings = loaded;
        for (const std::string_view name : side_options) {
            const OptionInfo& option = *find_option(name);
            settings.given.erase(std::string(name));
            if (!side.settings.is_given(name)) continue;
            option.apply(settings, option.show(side.settings));
            settings.given.emplace(name);
        }
        side.settings = std::move(settings);
    }
    scene_ = std::move(scene);
    home_ = scene_.camera;
    take_scene();
    if (keep_camera) scene_.camera = now;
}

void ViewState::set_option(const OptionInfo& option, std::string_view text) {
    std::array<Side, 2> changed = sides_;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        if (is_of_side(option.name) && i != active_) continue;
        option.apply(changed[i].settings, text);
        changed[i].settings.given.emplace(option.name);
    }
    sides_ = std::move(changed);
    changed_ = true;
}

void ViewState::set_model(std::size_t number, std::string_view brdf) {
    Material changed = scene_.materials.at(number);
    changed.brdf = brdf;
    // Parameters that the new model lacks are mapped once, and become its own.
    const ResolvedMaterial resolved = resolve_material(scene_.materials[number], brdf, {});
    changed.parameters.clear();
    if (!resolved.unlit)
        for (const ParamInfo& param : resolved.brdf->params) {
            const auto& v = resolved.params.value[&param - resolved.brdf->params.data()];
            if (param.kind == ParamKind::choice)
                changed.set_word(param.name, value_text(param, v[0]));
            else if (param.kind == ParamKind::rgb)
                changed.set(param.name, {v[0], v[1], v[2]});
            else
                changed.set(param.name, {v[0]});
        }
    for (const char* kept : {"ka", "emission"})
        if (const ParamSetting* p = scene_.materials[number].find(kept))
            changed.set(p->name, p->values);
    resolve_material(changed, "", {});
    scene_.materials[number] = std::move(changed);
    changed_ = true;
}

void ViewState::set_parameter(std::size_t number, std::string_view name, std::vector<double> values,
                              std::string word) {
    const Scene before = scene_;
    try {
        const std::string& drawn = settings().brdf;
        if (!drawn.empty() && drawn != scene_.materials.at(number).brdf && drawn != "unlit")
            set_model(number, drawn);
        Material& material = scene_.materials.at(number);
        if (word.empty())
            material.set(name, std::move(values));
        else
            material.set_word(name, std::move(word));
        resolve_material(material, "", {});
    } catch (const Error&) {
        scene_ = before;
        throw;
    }
    // What was set for every material would go before it.
    for (Side& side : sides_)
        std::erase_if(side.settings.set, [&](const ParamSetting& p) { return p.name == name; });
    changed_ = true;
}

void ViewState::set_ambient(const glm::dvec3& ambient) {
    scene_.ambient = ambient;
    changed_ = true;
}

void ViewState::set_light(std::size_t number, const Light& light) {
    if (light.direction == glm::dvec3(0))
        throw Error(Errc::scene, "the direction of a light must not be 0, 0, 0");
    if (light.attenuation == glm::dvec3(0))
        throw Error(Errc::scene, "the attenuation c, l, q must not be all 0; 1, 0, 0 is none");
    Light& target = scene_.lights.at(number);
    target = light;
    target.penumbra_deg = std::min(target.penumbra_deg, target.cutoff_deg);
    changed_ = true;
}

void ViewState::add_light() {
    Light light;
    const Camera from = camera();
    light.position = from.position;
    light.direction = from.focal_point - from.position;
    light.intensity = glm::dvec3(0.5);
    scene_.lights.push_back(light);
    light_ = scene_.lights.size() - 1;
    changed_ = true;
}

void ViewState::remove_light(std::size_t number) {
    scene_.lights.erase(scene_.lights.begin() + static_cast<std::ptrdiff_t>(number));
    light_ = std::min(light_, scene_.lights.empty() ? 0 : scene_.lights.size() - 1);
    changed_ = true;
}

void ViewState::select_light(std::size_t number) { light_ = number; }

void ViewState::set_debug_view(DebugView view) {
    sides_[active_].view = view;
    changed_ = true;
}

void ViewState::set_divider(double share) {
    divider_ = std::clamp(share, 0.0, 1.0);
    changed_ = true;
}

void ViewState::set_active(std::size_t side) { active_ = side; }

}  // namespace scanshade::viewer

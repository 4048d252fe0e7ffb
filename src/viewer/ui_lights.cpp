// The lights.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

constexpr double max_intensity = 1e6;

bool drag(const char* name, glm::dvec3& v, double speed) {
    double edited[3] = {v.x, v.y, v.z};
    if (!vector3(name, edited, speed)) return false;
    v = {edited[0], edited[1], edited[2]};
    return true;
}

/// c, l, q are no less than 0.
bool build_attenuation(Light& light) {
    if (!drag("c, l, q", light.attenuation, 0.005)) return false;
    light.attenuation = glm::max(light.attenuation, glm::dvec3(0));
    return true;
}

bool build_cone(Light& light) {
    bool changed =
        slider("cutoff [°]", light.cutoff_deg, 1, 180, 30, false, "half angle of the cone");
    changed |= slider("penumbra [°]", light.penumbra_deg, 0, light.cutoff_deg, 0, false,
                      "width of the soft rim inside the cone");
    return changed;
}

bool build_kind(Light& light) {
    std::vector<std::string> names;
    for (const std::string_view name : light_kind_names()) names.emplace_back(name);
    const auto picked =
        choice("type", names, names[static_cast<std::size_t>(light.kind)], "how it shines");
    if (!picked) return false;
    light.kind =
        static_cast<LightKind>(std::find(names.begin(), names.end(), *picked) - names.begin());
    return true;
}

bool build_light(Light& light, double radius) {
    bool changed = build_kind(light);
    double rgb[3] = {light.intensity.x, light.intensity.y, light.intensity.z};
    if (colour("I", rgb, max_intensity, 1, "intensity; Ctrl + click: 1")) {
        light.intensity = {rgb[0], rgb[1], rgb[2]};
        changed = true;
    }
    if (light.kind != LightKind::directional)
        changed |= drag("position", light.position, 0.01 * radius);
    if (light.kind != LightKind::point) changed |= drag("direction", light.direction, 0.01);
    if (light.kind != LightKind::directional) changed |= build_attenuation(light);
    if (light.kind == LightKind::spot) changed |= build_cone(light);
    return changed;
}

}  // namespace

void build_lights(ViewState& state, Ui& ui) {
    double ambient[3] = {state.scene().ambient.x, state.scene().ambient.y, state.scene().ambient.z};
    if (colour("I_a", ambient, max_intensity, 0, "ambient light; Ctrl + click: none"))
        state.set_ambient({ambient[0], ambient[1], ambient[2]});
    for (std::size_t i = 0; i < state.scene().lights.size(); ++i) {
        ImGui::PushID(int(i));
        Light light = state.scene().lights[i];
        const bool selected = state.selected_light() == i;
        const std::string name = fmt::format(
            "{} {}{}###light", i + 1, light_kind_names()[static_cast<std::size_t>(light.kind)],
            selected ? "  (selected)" : "");
        const bool open = ImGui::TreeNode(name.c_str());
        if (ImGui::IsItemClicked()) state.select_light(i);
        bool removed = false;
        if (open) {
            if (build_light(light, state.bounds().radius))
                attempt(ui, [&] { state.set_light(i, light); });
            removed = ImGui::Button("remove");
            ImGui::TreePop();
        }
        ImGui::PopID();
        if (removed) {
            state.remove_light(i);
            break;
        }
    }
    if (ImGui::Button("add a light")) state.add_light();
}

}  // namespace scanshade::viewer

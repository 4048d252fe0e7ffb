// The materials: a slider for each row of a model's table of parameters.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

std::string label(const ParamInfo& param) {
    return param.unit.empty() ? fmt::format("{}##{}", param.symbol, param.name)
                              : fmt::format("{} [{}]##{}", param.symbol, param.unit, param.name);
}

std::string hint(const ParamInfo& param) {
    return fmt::format("{}: {}, from {:g} to {:g}; Ctrl + click: {}", param.name, param.meaning,
                       param.min, param.max, value_text(param, param.standard));
}

/// Exponents and roughness span decades.
bool is_logarithmic(const ParamInfo& param) {
    return param.role == ParamRole::exponent || param.role == ParamRole::roughness;
}

void build_parameter(ViewState& state, Ui& ui, std::size_t material, const ParamInfo& param,
                     const double (&now)[3]) {
    double value[3] = {now[0], now[1], now[2]};
    if (param.kind == ParamKind::choice) {
        std::vector<std::string> names;
        for (const std::string_view name : param.names) names.emplace_back(name);
        if (const auto picked =
                choice(label(param).c_str(), names, value_text(param, now[0]), hint(param)))
            attempt(ui, [&] { state.set_parameter(material, param.name, {}, *picked); });
        return;
    }
    const bool rgb = param.kind == ParamKind::rgb;
    const bool changed =
        rgb ? colour(label(param).c_str(), value, param.max, param.standard, hint(param))
            : slider(label(param).c_str(), value[0], param.min, param.max, param.standard,
                     is_logarithmic(param), hint(param));
    if (!changed) return;
    std::vector<double> values{value[0]};
    if (rgb) values = {value[0], value[1], value[2]};
    attempt(ui, [&] { state.set_parameter(material, param.name, std::move(values)); });
}

void build_model(ViewState& state, Ui& ui, std::size_t number) {
    std::vector<std::string> names;
    for (const BrdfInfo* brdf : all_brdfs()) names.emplace_back(brdf->name);
    names.emplace_back("unlit");
    const std::string now = state.scene().materials[number].brdf;
    if (const auto picked = choice("model", names, now, "the material's own reflection model"))
        attempt(ui, [&] { state.set_model(number, *picked); });
}

void build_material(ViewState& state, Ui& ui, std::size_t number) {
    build_model(state, ui, number);
    attempt(ui, [&] {
        const ResolvedMaterial drawn = resolve_material(
            state.scene().materials[number], state.settings().brdf, state.settings().set);
        if (drawn.unlit) {
            ImGui::TextUnformatted("unlit: the diffuse colour, whatever the light");
            return;
        }
        if (!state.settings().brdf.empty())
            ImGui::Text("drawn with %s", std::string(drawn.brdf->name).c_str());
        for (const ParamInfo& param : drawn.brdf->params)
            build_parameter(state, ui, number, param,
                            drawn.params.value[&param - drawn.brdf->params.data()]);
        for (const std::string& sentence : drawn.mapped) ImGui::TextWrapped("%s", sentence.c_str());
    });
}

/// Those that some object has: a shape's own give way to what a scene says.
std::vector<bool> used_materials(const Scene& scene) {
    std::vector<bool> used(scene.materials.size());
    for (const Object& object : scene.objects)
        for (const std::uint32_t m : object.materials) used[m] = true;
    return used;
}

}  // namespace

void build_materials(ViewState& state, Ui& ui) {
    const std::vector<bool> used = used_materials(state.scene());
    const auto first = std::find(used.begin(), used.end(), true) - used.begin();
    for (std::size_t i = 0; i < state.scene().materials.size(); ++i) {
        if (!used[i]) continue;
        ImGui::PushID(int(i));
        const std::string name = fmt::format("{}###material", state.scene().materials[i].name);
        ImGui::SetNextItemOpen(std::ptrdiff_t(i) == first, ImGuiCond_FirstUseEver);
        if (ImGui::TreeNode(name.c_str())) {
            build_material(state, ui, i);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
}

}  // namespace scanshade::viewer

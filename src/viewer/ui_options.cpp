// The table of options as widgets.
#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "scanshade/base/text.hpp"
#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

std::vector<std::string> words(std::string_view choices) {
    std::vector<std::string> out;
    for (const std::string_view word : split(choices, '|')) out.emplace_back(word);
    return out;
}

std::string hint(const OptionInfo& option) {
    std::string text = fmt::format("--{}: {}", option.name, option.meaning);
    if (option.control.while_loading) text += "; reads the file again";
    return text;
}

/// The new value as the option takes it, where a person changed it.
std::optional<std::string> edited(const OptionInfo& option, const Settings& settings) {
    const std::string now = option.show(settings), name(option.name);
    const std::string standard = option.show(Settings{});
    const OptionControl& control = option.control;
    switch (control.kind) {
        case OptionControl::choice:
            return choice(name.c_str(), words(control.choices), now, hint(option));
        case OptionControl::flag: {
            bool on = now == "true";
            if (!ImGui::Checkbox(name.c_str(), &on)) return std::nullopt;
            return on ? "true" : "false";
        }
        case OptionControl::number:
        case OptionControl::whole: {
            double value = parse_real(now).value_or(0);
            const std::string label =
                control.unit.empty() ? name : fmt::format("{} [{}]", name, control.unit);
            if (!slider(label.c_str(), value, control.low, control.high,
                        parse_real(standard).value_or(0), false, hint(option)))
                return std::nullopt;
            return control.kind == OptionControl::whole ? fmt::format("{:.0f}", value)
                                                        : fmt::format("{:.6g}", value);
        }
        case OptionControl::colour: {
            double rgb[3] = {0, 0, 0};
            const auto parts = split(now, ',');
            for (std::size_t c = 0; c < 3 && c < parts.size(); ++c)
                rgb[c] = parse_real(parts[c]).value_or(0);
            if (!colour(name.c_str(), rgb, control.high, 0, hint(option))) return std::nullopt;
            return fmt::format("{},{},{}", rgb[0], rgb[1], rgb[2]);
        }
        case OptionControl::none:
            break;
    }
    return std::nullopt;
}

void build_model_choice(ViewState& state, Ui& ui) {
    const std::string own = "each material's own";
    std::vector<std::string> names{own};
    for (const BrdfInfo* brdf : all_brdfs()) names.emplace_back(brdf->name);
    names.emplace_back("unlit");
    const std::string& now = state.settings().brdf;
    const OptionInfo& option = *find_option("brdf");
    if (const auto picked = choice("brdf", names, now.empty() ? own : now, option.meaning))
        attempt(ui, [&] { state.set_option(option, *picked == own ? "" : *picked); });
}

void build_views(ViewState& state) {
    std::vector<std::string> names;
    for (const DebugViewInfo& view : all_debug_views()) names.emplace_back(view.name);
    const auto now = static_cast<std::size_t>(state.active().view);
    if (const auto picked = choice("view", names, names[now], all_debug_views()[now].meaning))
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == *picked) state.set_debug_view(static_cast<DebugView>(i));
    bool wireframe = state.active().wireframe, split = state.split();
    if (ImGui::Checkbox("edges", &wireframe)) state.apply({Action::toggle_wireframe});
    ImGui::SameLine();
    if (ImGui::Checkbox("split A | B", &split)) state.apply({Action::toggle_split});
    if (!state.split()) return;
    ImGui::SameLine();
    if (ImGui::RadioButton("A", state.active_number() == 0)) state.set_active(0);
    ImGui::SameLine();
    if (ImGui::RadioButton("B", state.active_number() == 1)) state.set_active(1);
}

}  // namespace

void build_options(ViewState& state, Ui& ui) {
    build_views(state);
    build_model_choice(state, ui);
    for (const OptionInfo& option : shared_options()) {
        if (option.control.kind == OptionControl::none) continue;
        const std::optional<std::string> value = edited(option, state.settings());
        if (!value) continue;
        attempt(ui, [&] {
            state.set_option(option, *value);
            if (!option.control.while_loading) return;
            Request reload{Action::reload};
            reload.keep_camera = true;
            ui.requests.push_back(reload);
        });
    }
}

}  // namespace scanshade::viewer

// Widgets that several sections share.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

void hint_of_last(std::string_view hint) {
    if (hint.empty() || !ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(hint.data(), hint.data() + hint.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool default_asked() { return ImGui::IsItemClicked() && ImGui::GetIO().KeyCtrl; }

/// Of the last item; a default while Ctrl is held is no change of its own.
bool changed(bool moved, bool asked) { return asked || (moved && !ImGui::GetIO().KeyCtrl); }

}  // namespace

bool slider(const char* name, double& value, double low, double high, double standard,
            bool logarithmic, std::string_view hint) {
    double moved_to = value;
    ImGuiSliderFlags flags = ImGuiSliderFlags_NoInput;
    if (logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    const bool moved = ImGui::SliderScalar(name, ImGuiDataType_Double, &moved_to, &low, &high,
                                           logarithmic ? "%.5g" : "%.4g", flags);
    const bool asked = default_asked();
    hint_of_last(hint);
    if (!changed(moved, asked)) return false;
    value = asked ? standard : std::clamp(moved_to, low, high);
    return true;
}

bool colour(const char* name, double (&rgb)[3], double high, double standard,
            std::string_view hint) {
    float edited[3];
    for (int c = 0; c < 3; ++c) edited[c] = float(rgb[c]);
    ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoOptions;
    if (high > 1) flags |= ImGuiColorEditFlags_HDR;
    const bool moved = ImGui::ColorEdit3(name, edited, flags);
    const bool asked = default_asked();
    hint_of_last(hint);
    if (!changed(moved, asked)) return false;
    for (int c = 0; c < 3; ++c)
        rgb[c] = asked ? standard : std::clamp(double(edited[c]), 0.0, high);
    return true;
}

bool vector3(const char* name, double (&v)[3], double speed) {
    return ImGui::DragScalarN(name, ImGuiDataType_Double, v, 3, float(speed), nullptr, nullptr,
                              "%.4g");
}

std::optional<std::string> choice(const char* name, const std::vector<std::string>& names,
                                  std::string_view now, std::string_view hint) {
    std::optional<std::string> picked;
    const bool open = ImGui::BeginCombo(name, std::string(now).c_str());
    if (!open) hint_of_last(hint);
    if (!open) return picked;
    for (const std::string& candidate : names)
        if (ImGui::Selectable(candidate.c_str(), candidate == now)) picked = candidate;
    ImGui::EndCombo();
    return picked;
}

}  // namespace scanshade::viewer

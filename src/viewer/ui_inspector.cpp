// The pixel inspector.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

constexpr float window_width = 460;

/// Components of a vector below each other.
std::string stacked(std::string text) {
    std::replace(text.begin(), text.end(), ' ', '\n');
    return text;
}

void build_row(const InspectionRow& row) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.symbol.c_str());
    if (!row.meaning.empty() && ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", row.meaning.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(stacked(f32_text(row)).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(stacked(f64_text(row)).c_str());
}

void build_section(const InspectionSection& section) {
    ImGui::TextWrapped("%s", section.title.c_str());
    if (!ImGui::BeginTable("rows", 3, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.2f);
    ImGui::TableSetupColumn("in float", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("in double", ImGuiTableColumnFlags_WidthStretch, 1.3f);
    for (const InspectionRow& row : section.rows) build_row(row);
    ImGui::EndTable();
}

}  // namespace

void build_inspector(Ui& ui, double left) {
    if (!ui.inspection) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(window_width, display.x - 20);
    // On the half of the picture where the pixel is not.
    const bool at_right = 2 * ui.inspection->x < ui.inspection->width;
    ImGui::SetNextWindowPos({at_right ? display.x - width - 10 : float(left) + 10, 34},
                            ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({width, display.y - 44}, ImGuiCond_Appearing);
    bool open = true;
    const std::string title =
        fmt::format("Pixel {}, {}###inspector", ui.inspection->x, ui.inspection->y);
    if (ImGui::Begin(title.c_str(), &open)) {
        int number = 0;
        for (const InspectionSection& section : inspection_sections(*ui.inspection)) {
            ImGui::PushID(number++);
            build_section(section);
            ImGui::PopID();
        }
    }
    ImGui::End();
    if (!open) ui.inspection.reset();
}

}  // namespace scanshade::viewer

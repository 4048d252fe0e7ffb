// The pixel inspector.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

void build_row(const InspectionRow& row) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.symbol.c_str());
    if (!row.meaning.empty() && ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", row.meaning.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(f32_text(row).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(f64_text(row).c_str());
}

void build_section(const InspectionSection& section) {
    ImGui::TextWrapped("%s", section.title.c_str());
    if (!ImGui::BeginTable("rows", 3, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.8f);
    ImGui::TableSetupColumn("in float", ImGuiTableColumnFlags_WidthStretch, 1.3f);
    ImGui::TableSetupColumn("in double", ImGuiTableColumnFlags_WidthStretch, 1.7f);
    for (const InspectionRow& row : section.rows) build_row(row);
    ImGui::EndTable();
}

}  // namespace

void build_inspector(Ui& ui) {
    if (!ui.inspection) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(640.0f, display.x - 20);
    ImGui::SetNextWindowPos({display.x - width - 10, 10}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({width, display.y - 20}, ImGuiCond_Appearing);
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

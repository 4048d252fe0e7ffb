// The panel at the left, the help and errors.
#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

void menu_item(Ui& ui, const char* name, const char* keys, Action action) {
    if (ImGui::MenuItem(name, keys)) ui.requests.push_back({action});
}

void build_menu(Ui& ui) {
    if (!ImGui::BeginMenuBar()) return;
    if (ImGui::BeginMenu("File")) {
        menu_item(ui, "Previous file", "Left", Action::previous_file);
        menu_item(ui, "Next file", "Right", Action::next_file);
        menu_item(ui, "Read again", "R", Action::reload);
        ImGui::Separator();
        build_lesson_menu(ui);
        ImGui::Separator();
        menu_item(ui, "Save the scene", "Ctrl+S", Action::save_scene);
        menu_item(ui, "Save the picture", "F12", Action::save_picture);
        ImGui::Separator();
        menu_item(ui, "Quit", "Q", Action::quit);
        ImGui::EndMenu();
    }
    if (ImGui::MenuItem("Keys")) ui.requests.push_back({Action::toggle_help});
    if (ImGui::MenuItem("Hide")) ui.requests.push_back({Action::toggle_panel});
    ImGui::EndMenuBar();
}

/// A section that is open at first or not.
bool section(const char* name, bool open) {
    return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

}  // namespace

void build_panel(ViewState& state, const Picture& picture, Ui& ui) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({float(panel_width), ImGui::GetIO().DisplaySize.y});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoBringToFrontOnFocus);
    build_menu(ui);
    ImGui::PushItemWidth(-ImGui::GetFontSize() * 8);
    ImGui::Text("%s   %s", state.scene().name.c_str(), ui.status.c_str());
    if (section("Drawing", true)) build_options(state, ui);
    if (section("Materials", true)) build_materials(state, ui);
    if (section("Lights", false)) build_lights(state, ui);
    if (section("Times and plan", false)) build_report(picture.report(state.active_number()));
    ImGui::PopItemWidth();
    ImGui::End();
}

void build_report(const FrameReport& report) {
    ImGui::Text("frame %.2f ms", report.stats.frame_ms);
    const ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchProp;
    if (ImGui::BeginTable("stages", 3, flags)) {
        for (const StageStats& stage : report.stats.stages) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(std::string(stage.name).c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(stage.ran ? fmt::format("{:.2f} ms", stage.ms).c_str()
                                             : "left out");
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(
                stage.ran ? fmt::format("{} {}", stage.items, stage.item_name).c_str() : "");
        }
        ImGui::EndTable();
    }
    for (const PlannedRow& row : report.rows) {
        const std::string name(row.info->name);
        if (row.left_out)
            ImGui::TextWrapped("%s: left out, %s", name.c_str(), row.amount().c_str());
        else
            ImGui::TextDisabled("%s: done", name.c_str());
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.reason.c_str());
    }
}

void build_help(const ViewState& state, Ui& ui) {
    if (!ui.help) return;
    ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x / 2, 20}, ImGuiCond_Always, {0.5f, 0});
    ImGui::Begin("Keys and mouse", &ui.help,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::BeginTable("keys", 3)) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 310);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 280);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 170);
        for (const HelpRow& row : help_rows()) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(row.inputs.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(row.effect.c_str());
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", state.current(row.action, row.number).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void build_notice(Ui& ui, double left) {
    if (ui.notice.empty()) return;
    ImGui::SetNextWindowPos({float(left) + 12, ImGui::GetIO().DisplaySize.y - 12}, ImGuiCond_Always,
                            {0, 1});
    ImGui::Begin("notice", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 34);
    ImGui::TextUnformatted(ui.notice.c_str());
    ImGui::PopTextWrapPos();
    if (ImGui::Button("close")) ui.notice.clear();
    ImGui::End();
}

}  // namespace scanshade::viewer

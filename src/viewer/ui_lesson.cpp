// Lessons: their menu, and a window about the one whose scene is shown.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

constexpr float window_width = 330;

void wrapped(std::string_view text) { ImGui::TextWrapped("%s", std::string(text).c_str()); }

}  // namespace

void build_lesson_menu(Ui& ui) {
    if (!ImGui::BeginMenu("Lessons")) return;
    int number = 0;
    for (const LessonInfo* lesson : all_lessons()) {
        const std::string label = fmt::format("{}  {}", number + 1, lesson->title);
        if (ImGui::MenuItem(label.c_str(), nullptr, lesson == ui.lesson))
            ui.requests.push_back({.action = Action::open_lesson, .number = number});
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(lesson->summary).c_str());
        ++number;
    }
    ImGui::EndMenu();
}

void build_lesson(Ui& ui) {
    if (ui.lesson == nullptr) return;
    const LessonInfo& lesson = *ui.lesson;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x - 10, 10}, ImGuiCond_FirstUseEver, {1, 0});
    ImGui::SetNextWindowSize({std::min(window_width, display.x - 20), 0}, ImGuiCond_Always);
    bool open = true;
    const std::string title = fmt::format("{}###lesson", lesson.title);
    if (ImGui::Begin(title.c_str(), &open, ImGuiWindowFlags_NoSavedSettings)) {
        wrapped(lesson.summary);
        ImGui::Separator();
        for (const LessonQuestion& q : lesson.questions) {
            ImGui::PushID(&q);
            wrapped(q.question);
            if (ImGui::TreeNode("answer")) {
                wrapped(q.answer);
                ImGui::TreePop();
            }
            ImGui::PopID();
        }
        ImGui::Separator();
        ImGui::TextDisabled("%s", fmt::format("scanshade lesson {} -o DIR", lesson.name).c_str());
    }
    ImGui::End();
    if (!open) ui.lesson = nullptr;
}

}  // namespace scanshade::viewer

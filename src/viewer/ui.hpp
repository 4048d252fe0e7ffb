// The interface: windows over the picture. Each function describes one part anew for every frame;
// what a person changes goes into the state at once, what is not the state's business becomes a
// request.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/base/error.hpp"
#include "scanshade/report/inspection.hpp"
#include "scanshade/report/lesson.hpp"
#include "viewer/picture.hpp"
#include "viewer/view_state.hpp"

namespace scanshade::viewer {

/// What the interface shows besides state and picture.
struct Ui {
    bool panel = true;
    bool help = false;
    std::string status;  // "6.4 ms"
    std::string notice;  // an error, until the next thing that works
    std::optional<Inspection> inspection;
    const LessonInfo* lesson = nullptr;  // whose scene is shown, until its window is closed
    std::vector<Request> requests;
    bool moving = false;  // something is dragged
    bool light_is_moving = false;
};

inline constexpr int panel_width = 350;  // points

/// Does what may throw an Error, which is then shown.
template <class Do>
void attempt(Ui& ui, Do&& act) {
    try {
        act();
    } catch (const Error& error) {
        ui.notice = error.what();
    }
}

/// The panel at the left.
void build_panel(ViewState& state, const Picture& picture, Ui& ui);

// Its sections.
void build_options(ViewState& state, Ui& ui);
void build_materials(ViewState& state, Ui& ui);
void build_lights(ViewState& state, Ui& ui);
void build_report(const FrameReport& report);

/// Keys with what they stand at.
void build_help(const ViewState& state, Ui& ui);

/// The equation at the pixel that was clicked; the picture begins at column `left`.
void build_inspector(Ui& ui, double left);

/// The menu of all lessons, and the window of the one whose scene is shown.
void build_lesson_menu(Ui& ui);
void build_lesson(Ui& ui);

/// On the picture itself, which begins at column `left`: the inspected polygon, the light that
/// moves, the divider, scales.
void build_overlays(const ViewState& state, const Picture& picture, const Ui& ui, double left);

/// An error, over the picture.
void build_notice(Ui& ui, double left);

// Widgets. A label carries `name` and a hint; Ctrl + click sets the default. True when changed.
bool slider(const char* name, double& value, double low, double high, double standard,
            bool logarithmic, std::string_view hint);
bool colour(const char* name, double (&rgb)[3], double high, double standard,
            std::string_view hint);
bool vector3(const char* name, double (&v)[3], double speed);
/// One of names; `now` and the result are names.
std::optional<std::string> choice(const char* name, const std::vector<std::string>& names,
                                  std::string_view now, std::string_view hint);

}  // namespace scanshade::viewer

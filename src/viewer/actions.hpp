// What a person can ask of the viewer, and the one table of keys and gestures that ask for it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scanshade::viewer {

enum class Action : std::uint8_t {
    orbit,  // the first four are gestures with an amount
    pan,
    zoom,
    move_light,
    click,
    next_shading,
    next_brdf,
    next_interpolation,
    next_light,
    toggle_wireframe,
    toggle_split,
    other_side,
    debug_view,  // `number` of a DebugView
    reset_camera,
    view_front,
    view_right,
    view_top,
    view_opposite,
    toggle_projection,
    previous_file,  // the rest is not the state's business
    next_file,
    reload,
    open_lesson,  // `number` in all_lessons()
    save_picture,
    save_scene,
    toggle_help,
    toggle_panel,
    quit,
};

/// An action with its amount: pixels of the picture, y down (orbit, pan, light), or wheel steps in y.
struct Request {
    Action action;
    double x = 0, y = 0;
    int number = 0;             // of a debug view or a lesson
    bool keep_camera = false;   // for another file
    double at_x = 0, at_y = 0;  // where the mouse is, in pixels of the picture
};

enum class Gesture : std::uint8_t { key, drag, wheel, click };

/// Held while the key or button goes down. Keys do not mind Shift.
enum Modifier : std::uint8_t { no_modifier = 0, with_shift = 1, with_ctrl = 2 };

struct Binding {
    Gesture gesture;
    std::string_view code;  // key as SDL names it, or number of the mouse button
    std::uint8_t modifiers;
    Action action;
    int number;
    std::string_view input;   // for people; bindings of one action stand together
    std::string_view effect;  // empty: as the line before
};

std::span<const Binding> all_bindings();

/// The binding of an input, or nullptr.
const Binding* find_binding(Gesture gesture, std::string_view code, std::uint8_t modifiers);

/// "S" and "next shading", a row for each effect.
struct HelpRow {
    std::string inputs, effect;
    Action action;
    int number;
};
std::vector<HelpRow> help_rows();

/// The rows as lines "S: next shading".
std::string help_text();

}  // namespace scanshade::viewer

#include "viewer/actions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "scanshade/render/debug_view.hpp"

namespace scanshade::viewer {
namespace {

constexpr Binding debug_key(std::string_view key, DebugView view, std::string_view effect) {
    return {Gesture::key,           key, no_modifier, Action::debug_view,
            static_cast<int>(view), key, effect};
}

constexpr Binding key(std::string_view code, Action action, std::string_view effect) {
    return {Gesture::key, code, no_modifier, action, 0, code, effect};
}

constexpr Binding ctrl_key(std::string_view code, Action action, std::string_view input,
                           std::string_view effect) {
    return {Gesture::key, code, with_ctrl, action, 0, input, effect};
}

constexpr Binding drag(std::string_view button, int modifiers, Action action,
                       std::string_view input, std::string_view effect) {
    return {Gesture::drag, button, static_cast<std::uint8_t>(modifiers), action, 0, input, effect};
}

constexpr Binding bindings[] = {
    drag("1", no_modifier, Action::orbit, "left drag", "rotate"),
    drag("1", with_shift, Action::pan, "Shift + left drag", "pan"),
    drag("2", no_modifier, Action::pan, "middle drag", ""),
    drag("3", no_modifier, Action::pan, "right drag", ""),
    {Gesture::wheel, "", no_modifier, Action::zoom, 0, "wheel", "zoom to the cursor"},
    drag("1", with_shift | with_ctrl, Action::move_light, "Ctrl + Shift + left drag",
         "move the selected light"),
    {Gesture::click, "1", no_modifier, Action::click, 0, "left click", "inspect a pixel"},
    key("S", Action::next_shading, "next shading"),
    key("B", Action::next_brdf, "next brdf"),
    key("I", Action::next_interpolation, "next interpolation"),
    key("Tab", Action::next_light, "select the next light"),
    key("W", Action::toggle_wireframe, "edges of the polygons"),
    debug_key("F1", DebugView::depth, "depth"),
    debug_key("F2", DebugView::normals, "normals"),
    debug_key("F3", DebugView::barycentrics, "barycentric coordinates"),
    debug_key("F4", DebugView::triangles, "triangles"),
    debug_key("F5", DebugView::overdraw, "overdraw"),
    debug_key("F6", DebugView::plan, "plan: work of each pixel"),
    debug_key("F7", DebugView::error_f64, "error against double"),
    debug_key("F8", DebugView::error_phong, "error against phong shading"),
    key("V", Action::toggle_split, "split screen, A beside B"),
    key("X", Action::other_side, "keys and panel act on the other side"),
    key("Return", Action::reset_camera, "reset the camera"),
    key("Keypad Enter", Action::reset_camera, ""),
    key("1", Action::view_front, "view from the front"),
    key("Keypad 1", Action::view_front, ""),
    key("3", Action::view_right, "view from the right"),
    key("Keypad 3", Action::view_right, ""),
    key("7", Action::view_top, "view from the top"),
    key("Keypad 7", Action::view_top, ""),
    key("9", Action::view_opposite, "view from the opposite side"),
    key("Keypad 9", Action::view_opposite, ""),
    key("5", Action::toggle_projection, "perspective or orthographic"),
    key("Keypad 5", Action::toggle_projection, ""),
    key("Left", Action::previous_file, "previous file; with Ctrl the camera stays"),
    ctrl_key("Left", Action::previous_file, "", ""),
    key("Right", Action::next_file, "next file; with Ctrl the camera stays"),
    ctrl_key("Right", Action::next_file, "", ""),
    key("R", Action::reload, "read the file again"),
    ctrl_key("S", Action::save_scene, "Ctrl + S", "save the scene as TOML"),
    key("F12", Action::save_picture, "save the picture"),
    key("H", Action::toggle_help, "show or hide this help"),
    key("P", Action::toggle_panel, "show or hide the panel"),
    key("Q", Action::quit, "quit"),
    key("Escape", Action::quit, ""),
};

}  // namespace

std::span<const Binding> all_bindings() { return bindings; }

const Binding* find_binding(Gesture gesture, std::string_view code, std::uint8_t modifiers) {
    const auto fits = [&](const Binding& b) {
        return b.gesture == gesture && b.code == code && b.modifiers == modifiers;
    };
    const auto found = std::find_if(std::begin(bindings), std::end(bindings), fits);
    return found == std::end(bindings) ? nullptr : found;
}

std::vector<HelpRow> help_rows() {
    std::vector<HelpRow> rows;
    for (const Binding& b : bindings) {
        if (!b.effect.empty())
            rows.push_back({std::string(b.input), std::string(b.effect), b.action, b.number});
        else if (!b.input.empty())
            rows.back().inputs += fmt::format(", {}", b.input);
    }
    return rows;
}

std::string help_text() {
    std::string text;
    for (const HelpRow& row : help_rows()) text += fmt::format("{}: {}\n", row.inputs, row.effect);
    return text;
}

}  // namespace scanshade::viewer

#include "viewer/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace scanshade::viewer {
namespace {

enum class Gesture { key, drag, wheel };

struct Binding {
    Gesture gesture;
    SDL_Keycode code;  // key, or mouse button of a drag
    bool shift;        // drags: held when the button goes down; keys do not mind
    Action action;
    std::string_view input;   // for people; bindings of one action stand together
    std::string_view effect;  // empty: as the line before
};

constexpr Binding bindings[] = {
    {Gesture::drag, SDL_BUTTON_LEFT, false, Action::orbit, "left drag", "orbit"},
    {Gesture::drag, SDL_BUTTON_LEFT, true, Action::pan, "Shift + left drag", "pan"},
    {Gesture::drag, SDL_BUTTON_MIDDLE, false, Action::pan, "middle drag", ""},
    {Gesture::drag, SDL_BUTTON_RIGHT, false, Action::pan, "right drag", ""},
    {Gesture::wheel, 0, false, Action::zoom, "wheel", "zoom"},
    {Gesture::key, SDLK_s, false, Action::next_shading, "S", "next shading"},
    {Gesture::key, SDLK_b, false, Action::next_brdf, "B", "next brdf"},
    {Gesture::key, SDLK_i, false, Action::next_interpolation, "I", "next interpolation"},
    {Gesture::key, SDLK_RETURN, false, Action::reset_camera, "Enter", "reset the camera"},
    {Gesture::key, SDLK_KP_ENTER, false, Action::reset_camera, "keypad Enter", ""},
    {Gesture::key, SDLK_F12, false, Action::save_picture, "F12", "save the picture"},
    {Gesture::key, SDLK_h, false, Action::toggle_help, "H", "show or hide this help"},
    {Gesture::key, SDLK_q, false, Action::quit, "Q", "quit"},
    {Gesture::key, SDLK_ESCAPE, false, Action::quit, "Escape", ""},
};

const Binding* find_binding(Gesture gesture, SDL_Keycode code, bool shift) {
    const auto fits = [&](const Binding& b) {
        return b.gesture == gesture && b.code == code && b.shift == shift;
    };
    const auto found = std::find_if(std::begin(bindings), std::end(bindings), fits);
    return found == std::end(bindings) ? nullptr : found;
}

// Keys held with these are the desktop's, not ours.
constexpr int other_modifiers = KMOD_CTRL | KMOD_ALT | KMOD_GUI;

bool shift_is_down() { return (SDL_GetModState() & KMOD_SHIFT) != 0; }

/// The drag that a button starts; a button without a meaning of its own for Shift ignores it.
const Binding* find_drag(Uint8 button) {
    const Binding* shifted = shift_is_down() ? find_binding(Gesture::drag, button, true) : nullptr;
    return shifted != nullptr ? shifted : find_binding(Gesture::drag, button, false);
}

}  // namespace

std::string help_text() {
    std::string text;
    std::string inputs;
    std::string_view effect;
    const auto end_line = [&] {
        if (!inputs.empty()) text += fmt::format("{}: {}\n", inputs, effect);
    };
    for (const Binding& b : bindings) {
        if (b.effect.empty()) {
            inputs += fmt::format(", {}", b.input);
            continue;
        }
        end_line();
        inputs = b.input;
        effect = b.effect;
    }
    end_line();
    return text;
}

std::optional<Request> Input::translate(const SDL_Event& event, double pixels_per_point) {
    switch (event.type) {
        case SDL_QUIT:
            return Request{Action::quit};
        case SDL_KEYDOWN:
            if (event.key.repeat != 0 || (event.key.keysym.mod & other_modifiers) != 0) return {};
            if (const Binding* b = find_binding(Gesture::key, event.key.keysym.sym, false))
                return Request{b->action};
            return {};
        case SDL_MOUSEBUTTONDOWN:
            if (const Binding* b = drag_ ? nullptr : find_drag(event.button.button))
                drag_ = Drag{event.button.button, b->action};
            return {};
        case SDL_MOUSEBUTTONUP:
            if (drag_ && drag_->button == event.button.button) drag_.reset();
            return {};
        case SDL_MOUSEMOTION:
            if (!drag_) return {};
            return Request{drag_->action, event.motion.xrel * pixels_per_point,
                           event.motion.yrel * pixels_per_point};
        case SDL_MOUSEWHEEL:
            if (const Binding* b = find_binding(Gesture::wheel, 0, false))
                return Request{b->action, 0, double(event.wheel.preciseY)};
            return {};
        default:
            return {};
    }
}

}  // namespace scanshade::viewer

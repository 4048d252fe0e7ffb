#include "viewer/input.hpp"

#include <cmath>

namespace scanshade::viewer {
namespace {

constexpr double click_distance = 3;  // points that a hand may shake

std::uint8_t modifiers_of(int state) {
    return static_cast<std::uint8_t>(((state & KMOD_SHIFT) != 0 ? with_shift : no_modifier) |
                                     ((state & KMOD_CTRL) != 0 ? with_ctrl : no_modifier));
}

/// The drag that a button starts; a button without a meaning of its own for modifiers ignores them.
const Binding* find_drag(std::string_view button) {
    const Binding* held = find_binding(Gesture::drag, button, modifiers_of(SDL_GetModState()));
    return held != nullptr ? held : find_binding(Gesture::drag, button, no_modifier);
}

std::string number(std::uint8_t button) { return std::string(1, char('0' + button)); }

}  // namespace

std::optional<Action> Input::dragging() const {
    if (!drag_ || drag_->may_be_click) return std::nullopt;
    return drag_->action;
}

std::optional<Request> Input::key(const SDL_KeyboardEvent& event) const {
    // Keys held with these are the desktop's, not ours.
    if (event.repeat != 0 || (event.keysym.mod & (KMOD_ALT | KMOD_GUI)) != 0) return {};
    const auto modifiers =
        static_cast<std::uint8_t>(modifiers_of(event.keysym.mod) & ~std::uint8_t{with_shift});
    const Binding* b = find_binding(Gesture::key, SDL_GetKeyName(event.keysym.sym), modifiers);
    if (b == nullptr) return {};
    Request request{b->action};
    request.number = b->number;
    request.keep_camera = (modifiers & with_ctrl) != 0;
    return request;
}

void Input::begin(const SDL_MouseButtonEvent& event) {
    const Binding* b = drag_ ? nullptr : find_drag(number(event.button));
    if (b == nullptr) return;
    const bool may_click =
        b->modifiers == no_modifier &&
        find_binding(Gesture::click, number(event.button), no_modifier) != nullptr;
    drag_ = Drag{event.button, b->action, may_click};
}

std::optional<Request> Input::end(const SDL_MouseButtonEvent& event, const Placement& placement) {
    if (!drag_ || drag_->button != event.button) return {};
    const bool click = drag_->may_be_click;
    drag_.reset();
    if (!click) return {};
    Request request{Action::click};
    request.at_x = (event.x - placement.left) * placement.pixels_per_point;
    request.at_y = (event.y - placement.top) * placement.pixels_per_point;
    return request;
}

std::optional<Request> Input::move(const SDL_MouseMotionEvent& event, const Placement& placement) {
    mouse_x_ = event.x, mouse_y_ = event.y;
    if (!drag_) return {};
    drag_->x += event.xrel, drag_->y += event.yrel;
    if (drag_->may_be_click && std::hypot(drag_->x, drag_->y) <= click_distance) return {};
    drag_->may_be_click = false;
    Request request{drag_->action, drag_->x * placement.pixels_per_point,
                    drag_->y * placement.pixels_per_point};
    drag_->x = drag_->y = 0;
    return request;
}

std::optional<Request> Input::translate(const SDL_Event& event, const Placement& placement) {
    switch (event.type) {
        case SDL_QUIT:
            return Request{Action::quit};
        case SDL_KEYDOWN:
            return key(event.key);
        case SDL_MOUSEBUTTONDOWN:
            begin(event.button);
            return {};
        case SDL_MOUSEBUTTONUP:
            return end(event.button, placement);
        case SDL_MOUSEMOTION:
            return move(event.motion, placement);
        case SDL_MOUSEWHEEL: {
            Request request{Action::zoom, 0, double(event.wheel.preciseY)};
            request.at_x = (mouse_x_ - placement.left) * placement.pixels_per_point;
            request.at_y = (mouse_y_ - placement.top) * placement.pixels_per_point;
            return request;
        }
        default:
            return {};
    }
}

}  // namespace scanshade::viewer

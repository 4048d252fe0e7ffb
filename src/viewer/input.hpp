// From SDL events to requests, by the table of keys and gestures.
#pragma once

#include <SDL.h>

#include <optional>
#include <string>

#include "viewer/actions.hpp"

namespace scanshade::viewer {

/// Where the picture is in the window. The mouse counts in points, which high-density displays have
/// several pixels of.
struct Placement {
    double left = 0, top = 0;  // points
    double pixels_per_point = 1;
};

/// Translates events one by one; remembers which drag is under way.
class Input {
public:
    /// What the event asks for, if anything.
    std::optional<Request> translate(const SDL_Event& event, const Placement& placement);

    /// The drag under way has moved.
    std::optional<Action> dragging() const;

private:
    struct Drag {
        std::uint8_t button;
        Action action;
        bool may_be_click;    // has not moved far
        double x = 0, y = 0;  // movement that was held back, in points
    };
    std::optional<Request> key(const SDL_KeyboardEvent& event) const;
    void begin(const SDL_MouseButtonEvent& event);
    std::optional<Request> end(const SDL_MouseButtonEvent& event, const Placement& placement);
    std::optional<Request> move(const SDL_MouseMotionEvent& event, const Placement& placement);

    std::optional<Drag> drag_;
    int mouse_x_ = 0, mouse_y_ = 0;
};

}  // namespace scanshade::viewer

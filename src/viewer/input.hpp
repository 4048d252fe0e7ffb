// From SDL events to requests, by one table of keys and gestures.
#pragma once

#include <SDL.h>

#include <optional>
#include <string>

#include "viewer/view_state.hpp"

namespace scanshade::viewer {

/// Keys and gestures with what they do, a line each.
std::string help_text();

/// Translates events one by one; remembers which drag is under way.
class Input {
public:
    /// What the event asks for, if anything. `pixels_per_point` is the picture's size over the
    /// window's: they differ on high-density displays, where the mouse counts in points.
    std::optional<Request> translate(const SDL_Event& event, double pixels_per_point);

private:
    struct Drag {
        Uint8 button;
        Action action;
    };
    std::optional<Drag> drag_;
};

}  // namespace scanshade::viewer

// Lines of text over the picture.
#pragma once

#include <SDL.h>

#include <string_view>

namespace scanshade::viewer {

/// Draws the text (ASCII; other characters show as '?') on a dark box in the upper left corner,
/// lines broken so that they fit into `width` pixels.
void draw_overlay(SDL_Renderer* renderer, std::string_view text, int width);

}  // namespace scanshade::viewer

// Text over the picture.
#pragma once

#include <string>
#include <vector>

#include "scanshade/image/image.hpp"

namespace scanshade::viewer {

/// The lines of `text`, broken at spaces so that none is wider than `width` pixels (a word that is
/// wider stands alone).
std::vector<std::string> wrapped(const std::string& text, int width);

/// Draws the text in white on a black box in the upper left corner.
void draw_overlay(Image& picture, const std::string& text);

}  // namespace scanshade::viewer

// Text in pictures.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "scanshade/image/image.hpp"

namespace scanshade {

using Rgb8 = std::array<std::uint8_t, 3>;

/// The font is drawn twice as large as it is made: one of its units is this many pixels.
inline constexpr int letter_scale = 2;
inline constexpr int letter_height = 10 * letter_scale;  // with descenders

/// Pixels that a line takes. Characters other than printable ASCII are drawn as '?'.
int lettering_width(const std::string& line);

/// Fills the axis-aligned rectangle, as far as it lies inside the picture.
void fill_rectangle(Image& image, int x, int y, int width, int height, Rgb8 colour);

/// Draws a line with its upper left corner at (x, y).
void draw_lettering(Image& image, int x, int y, const std::string& line, Rgb8 colour);

}  // namespace scanshade

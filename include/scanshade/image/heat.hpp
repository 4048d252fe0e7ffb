// Numbers as colours.
#pragma once

#include <span>

#include "scanshade/image/image.hpp"

namespace scanshade {

/// From black by blue, green and red to white, each lighter than the one before, also to those who
/// do not see all colours: t in [0, 1], more and less are the ends. NaN is magenta.
void put_heat(double t, std::uint8_t* rgb);

/// One value for each pixel; 0 is black and `top` white. Where top is 0 all is black.
Image heat_picture(std::span<const float> values, int width, int height, double top);

}  // namespace scanshade

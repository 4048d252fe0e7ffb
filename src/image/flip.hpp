// FLIP, a model of how different two pictures look when they take turns on a screen.
#pragma once

#include <array>
#include <vector>

namespace scanshade {

/// Of a screen of 3840 pixels in 0.7 m, seen from 0.7 m, as in the paper: 67.02.
inline constexpr double flip_pixels_per_degree = 3840 * 3.14159265358979323846 / 180;

/// FLIP of each pixel, 0 (equal) to 1, of two pictures of sRGB values in [0, 1], [channel][pixel].
std::vector<float> flip_map(const std::array<std::vector<float>, 3>& a,
                            const std::array<std::vector<float>, 3>& b, int width, int height,
                            double pixels_per_degree = flip_pixels_per_degree);

}  // namespace scanshade

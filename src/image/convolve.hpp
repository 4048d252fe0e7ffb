// Filters that are a product of one along rows and one along columns.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scanshade {

using DoublePlane = std::vector<double>;  // [y·width + x]

/// What a filter finds beyond the picture: the pixel at the border again; or nothing, and the
/// weights within are divided by their sum.
enum class Border { repeat, cut };

/// Σ across[i] down[j] plane(x + i − r, y + j − r). Both filters have an odd number of weights, the
/// middle one for the pixel itself.
DoublePlane convolve(const DoublePlane& plane, int width, int height,
                     std::span<const double> across, std::span<const double> down, Border border);

/// exp(−k²/2σ²) for k = −radius to radius, divided by their sum.
std::vector<double> gaussian(int radius, double sigma);

}  // namespace scanshade

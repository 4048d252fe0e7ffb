// Structural similarity.
#pragma once

#include <vector>

namespace scanshade {

/// The index of the window around each pixel, for one channel of two encoded pictures in [0, 1].
std::vector<float> ssim_map(const std::vector<float>& a, const std::vector<float>& b, int width,
                            int height);

}  // namespace scanshade

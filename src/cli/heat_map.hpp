// A heat map with its scale.
#pragma once

#include "scanshade/image/image.hpp"
#include "scanshade/image/metrics.hpp"

namespace scanshade {

/// The error of each pixel in false colours, and below it which error, and which colour is how much:
/// from 0 to the largest there is.
Image heat_map(const Metric& metric, const Comparison& pair);

}  // namespace scanshade

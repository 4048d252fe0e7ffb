// Predicts what a frame will cost, from smaller ones.
#pragma once

#include <span>
#include <vector>

#include "scanshade/report/choose.hpp"

namespace scanshade {

/// Milliseconds a frame of each method: draws the same view at a sixteenth of the pixels, the methods
/// in turns. Stages that work on triangles and vertices cost the same at any size, and the others
/// sixteen times as much.
std::vector<double> predict_ms(const Scene& scene, const Settings& settings,
                               std::span<const Method* const> methods);

}  // namespace scanshade

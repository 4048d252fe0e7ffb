// Every reflection model of the registry at the extremes of its roughness and of the directions.
#pragma once

#include "scanshade/report/equation_stability.hpp"

namespace scanshade {

std::size_t model_sweep_count();

/// Stops between two sweeps when asked to.
std::vector<SweepResult> measure_models(Steps& steps);

}  // namespace scanshade

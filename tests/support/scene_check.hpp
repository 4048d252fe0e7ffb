// All that is checked of a random scene.
#pragma once

#include <string>

#include "scanshade/render/plan_rows.hpp"
#include "support/level_check.hpp"
#include "support/random_scene.hpp"

namespace scanshade {

struct SceneTotals {
    PlanSavings saved{};
    LevelCounts levels;
};

/// Draws the scene with and without a plan, by the vector renderer and its scalar twins. Returns the
/// first thing that is wrong, or "": a bit that the plan changes, a depth, id or colour that is not
/// the twin's, a byte that is not its colour's, a value that is not finite.
std::string scene_fault(const RandomScene& random, SceneTotals& totals);

}  // namespace scanshade

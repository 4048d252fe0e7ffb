// Visibility: which triangle is seen at each sample. One computation for every renderer.
#pragma once

#include "render/frame.hpp"

namespace scanshade {

/// Fills frame.depth and frame.id for frame.sample. Nearer depth wins, equal depth the lower id,
/// so the order of drawing has no part in it. Counts what was clipped, empty or not whole.
void find_visible(Frame& frame);

}  // namespace scanshade

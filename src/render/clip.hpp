// Clipping polygons before the division.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/transform.hpp"

namespace scanshade {

/// The part of a convex or concave polygon inside near, far and the guard band; fewer than three
/// corners: nothing is left. `outside`: the corners' outcodes or-ed together, only those planes are
/// clipped against. New corners are always interpolated from the inside corner to the outside one,
/// so two polygons that share an edge get the same corner, bit for bit.
void clip_polygon(std::vector<ClipVertex>& polygon, std::uint8_t outside, const View& view);

}  // namespace scanshade

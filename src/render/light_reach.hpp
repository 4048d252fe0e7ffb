// Whether a light that shines one way reaches what a tile shows.
#pragma once

#include "kernels/engine_data.hpp"
#include "scanshade/kernels/span.hpp"

namespace scanshade {

/// A sphere around all surface points of a tile, normalised world space.
struct TileSphere {
    double centre[3];
    double radius;
};

TileSphere tile_sphere(const ResolveView& view, int x, int y, const TileBuffer& tile);

/// False where the light's emission is exactly 0 at every point of the sphere.
bool reaches(const LightTerm<float>& light, const TileSphere& sphere);

}  // namespace scanshade

// Whether a light that shines one way reaches what a tile shows.
#pragma once

#include "kernels/engine_data.hpp"
#include "scanshade/kernels/span.hpp"
#include "scanshade/render/plan.hpp"

namespace scanshade {

/// A sphere around all surface points of a tile, normalised world space.
struct TileSphere {
    double centre[3];
    double radius;
};

TileSphere tile_sphere(const ResolveView& view, int x, int y, const TileBuffer& tile);

/// How much light may be left out of a tile, all together.
struct LightTolerance {
    double radiance = 0;  // that no byte of the picture shows as more than the tolerance in levels
    double most[3] =
        {};  // upper bound of f_r cosθ_i, 1/sr, of every material; infinite: none known
};
LightTolerance light_tolerance(const RenderPlan& plan);

/// Upper bound of what a light adds to any point of the sphere, in its largest channel.
double most_radiance(const LightTerm<float>& light, const TileSphere& sphere,
                     const LightTolerance& tolerance);

/// False where the light's emission is exactly 0 at every point of the sphere.
bool reaches(const LightTerm<float>& light, const TileSphere& sphere);

}  // namespace scanshade

// The surface that a mesh stands for, at each pixel: what interpolation is measured against.
#pragma once

#include <cstdint>

#include "scanshade/image/framebuffer.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// How the pixels of a smooth picture came about.
struct SmoothCounts {
    std::uint64_t exact = 0;   // on the smooth surface itself, or on polygons that are it
    std::uint64_t meshes = 0;  // on the mesh of a file: Phong shading of its normals
    std::uint64_t unrefined =
        0;  // the pixel's ray misses the surface beside the silhouette: as meshes
};

/// Shades each covered pixel at its centre, in double: the ray through it meets the smooth surface
/// of the shape that the mesh was made from, found by Newton's method from where it meets the mesh,
/// and position, normal and texture coordinates are those of that point. Which face is seen is
/// decided by the mesh, so the silhouette is the mesh's, and it should be fine. Depth and id are
/// those of the mesh. Samples, shading, interpolation and renderer of the settings do not matter.
SmoothCounts draw_smooth(const Scene& scene, const Settings& settings, Framebuffer& into);

}  // namespace scanshade

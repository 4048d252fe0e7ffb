// Shading: light at visible faces, at the vertices that they use, or at each visible sample.
#pragma once

#include "render/frame.hpp"

namespace scanshade {

/// Lights the visible faces of flat objects or the vertices of visible faces of Gouraud objects,
/// each once for every side and material that is seen. T is the number type of the plan.
template <class T>
void light_points(Frame& frame, Shading shading);

/// Adds every sample's radiance to the target: interpolated from lit points, or lit here with the
/// interpolated normal (Phong).
template <class T>
void shade_samples(Frame& frame);

}  // namespace scanshade

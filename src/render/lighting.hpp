// Lights as kernels read them.
#pragma once

#include "render/transform.hpp"
#include "scanshade/kernels/span.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// The lights of a normalised scene, seen from `view`.
Lighting<double> make_lighting(const Scene& scene, const View& view);

/// Light that shows k_a as it is: what an unlit material sees.
Lighting<double> make_unlit_lighting(const View& view);

Lighting<float> to_float(const Lighting<double>& lighting);

}  // namespace scanshade

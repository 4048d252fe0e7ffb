// Numbers about a reflection model with given parameters.
#pragma once

#include "scanshade/brdf/brdf.hpp"

namespace scanshade {

/// Directions by their angles, radians: the light in the half plane of azimuth 0, the viewer at
/// azimuth `dphi` from it. The mirror direction has dphi = π and equal polar angles.
struct ViewedFrom {
    double theta_i, theta_o, dphi;
};

/// f_r cosθ_i of the first channel, 1/sr.
double f_cos_at(const BrdfInfo& brdf, const MaterialParams<double>& params, const ViewedFrom& at);

/// Albedo ρ(ω_o) (B5) of the first channel: what a viewer at polar angle theta_o sees of white
/// surroundings. By quadrature in rings about the mirror direction; good to 1e-3.
double albedo(const BrdfInfo& brdf, const MaterialParams<double>& params, double theta_o);

}  // namespace scanshade

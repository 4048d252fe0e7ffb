// Directions for tests, and integrals over the hemisphere.
#pragma once

#include <cmath>

#include "scanshade/num/vec3.hpp"
#include "support/random.hpp"

namespace scanshade {

/// Unit vector by its z and its azimuth.
inline Vec3<double> direction_at(double z, double phi) {
    const double r = std::sqrt((1 - z) * (1 + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A direction with a z of at least `lowest`.
inline Vec3<double> random_direction(Rng& rng, double lowest) {
    const double z = rng.real(lowest, 1);
    return direction_at(z, rng.real(0, 2 * pi));
}

/// ∫ f(ω) dω over the hemisphere about z, in polar coordinates about `centre`: rings are as dense
/// as θ⁴ there, so a lobe of any width about it is seen. Good to some 1e-4 for a smooth f.
template <class F>
double hemisphere_integral(const Vec3<double>& centre, F f) {
    constexpr int rings = 160, sectors = 96;
    const Vec3<double> other =
        std::abs(centre.z) < 0.9 ? Vec3<double>{0, 0, 1} : Vec3<double>{1, 0, 0};
    const Vec3<double> x = normalise(cross(other, centre)), y = cross(centre, x);
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        const double t = (i + 0.5) / rings, theta = pi * t * t * t * t;
        const double ring = std::sin(theta) * 4 * pi * t * t * t / rings * (2 * pi / sectors);
        for (int j = 0; j < sectors; ++j) {
            const double phi = (j + 0.5) * 2 * pi / sectors;
            const Vec3<double> w = centre * std::cos(theta) +
                                   (x * std::cos(phi) + y * std::sin(phi)) * std::sin(theta);
            if (w.z > 0) sum += f(w) * ring;
        }
    }
    return sum;
}

}  // namespace scanshade

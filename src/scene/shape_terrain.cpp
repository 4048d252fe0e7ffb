// A terrain of hills: a sum of octaves of value noise, with its exact normals.
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "scene/shape_parts.hpp"

namespace scanshade {
namespace {

/// A height and its slopes along x and z.
struct Height {
    double y, dx, dz;
};

/// In [−1, 1), the same for each point of the lattice on every machine.
double lattice_value(std::int64_t i, std::int64_t j) {
    std::uint64_t h =
        std::uint64_t(i) * 0x9e3779b97f4a7c15u ^ std::uint64_t(j) * 0xc2b2ae3d27d4eb4fu;
    h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 32)) * 0x94d049bb133111ebu;
    return double(h >> 11) * 0x1p-52 - 1;
}

/// Value noise: lattice values blended by a quintic whose first two derivatives vanish at the ends.
Height noise(double x, double z) {
    const double i = std::floor(x), j = std::floor(z), s = x - i, t = z - j;
    const auto blend = [](double u) { return u * u * u * (10 + u * (6 * u - 15)); };
    const auto slope = [](double u) { return 30 * u * u * (u - 1) * (u - 1); };
    const auto at = [&](int k, int l) {
        return lattice_value(std::int64_t(i) + k, std::int64_t(j) + l);
    };
    const double a = at(0, 0), b = at(1, 0) - a, c = at(0, 1) - a;
    const double d = a - at(1, 0) - at(0, 1) + at(1, 1);
    const double u = blend(s), v = blend(t);
    return {a + b * u + c * v + d * u * v, slope(s) * (b + d * v), slope(t) * (c + d * u)};
}

/// Octaves of half the size and less than half the height each.
Height terrain_height(double x, double z) {
    constexpr double amplitude = 0.22, gain = 0.45, frequency = 1.7;
    constexpr int octaves = 5;
    Height sum{0, 0, 0};
    double height = amplitude, f = frequency;
    for (int k = 0; k < octaves; ++k, height *= gain, f *= 2) {
        const Height n = noise(x * f + 100 * k, z * f - 100 * k);
        sum = {sum.y + height * n.y, sum.dx + height * f * n.dx, sum.dz + height * f * n.dz};
    }
    return sum;
}

}  // namespace

PolygonSoup make_terrain(int n) {
    ShapeBuilder builder("terrain");
    builder.add_grid(n, n, [&](int row, int column) {
        const double x = double(2 * column - n) / n, z = double(n - 2 * row) / n;
        const Height h = terrain_height(x, z);
        return SurfacePoint{{x, h.y, z},
                            {double(column) / n, double(row) / n},
                            glm::normalize(glm::dvec3(-h.dx, 1, -h.dz))};
    });
    return builder.take();
}

SmoothPoint smooth_terrain(int, double u, double v) {
    const double x = 2 * u - 1, z = 1 - 2 * v;
    const Height h = terrain_height(x, z);
    return {{x, h.y, z},
            {2, 2 * h.dx, 0},
            {0, -2 * h.dz, -2},
            glm::normalize(glm::dvec3(-h.dx, 1, -h.dz))};
}

}  // namespace scanshade

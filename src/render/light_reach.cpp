#include "render/light_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanshade {
namespace {

/// Nearest and farthest distance along the view of what a tile shows.
struct Range {
    double nearest, farthest;
};
Range distance_range(const ResolveView& view, const TileBuffer& tile) {
    float low = 1, high = 0;
    for (int s = 0; s < TileBuffer::subtiles; ++s) {
        if (!tile.written[s]) continue;
        for (int block = 0; block < subtile_samples / block_samples; ++block) {
            const int at = tile_index((s % 4) * subtile_side + (block % 4) * block_side,
                                      (s / 4) * subtile_side + (block / 4) * block_side);
            for (int i = at; i < at + block_samples; ++i) {
                if (tile.ref[i] == no_ref) continue;
                low = std::min(low, tile.depth[i]);
                high = std::max(high, tile.depth[i]);
            }
        }
    }
    const double near = double(view.raster.near), far = double(view.raster.far);
    if (view.raster.orthographic) {
        const auto distance = [&](float z) { return near + (1 - double(z)) * 2 * (far - near); };
        return {distance(high), distance(low)};
    }
    return {near / double(high), near / double(low)};
}

}  // namespace

TileSphere tile_sphere(const ResolveView& view, int x, int y, const TileBuffer& tile) {
    const Range range = distance_range(view, tile);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};
    for (const double d : {range.nearest, range.farthest})
        for (const int px : {x - 1, x + view.raster.tile})
            for (const int py : {y - 1, y + view.raster.tile})
                for (int c = 0; c < 3; ++c) {
                    const double ray = double(view.ray[c]) + px * double(view.ray_x[c]) +
                                       py * double(view.ray_y[c]);
                    const double eye = double(view.eye[c]);
                    const double p = view.raster.orthographic ? ray + d * eye : eye + d * ray;
                    low[c] = std::min(low[c], p);
                    high[c] = std::max(high[c], p);
                }
    TileSphere sphere{};
    double size2 = 0;
    for (int c = 0; c < 3; ++c) {
        sphere.centre[c] = (low[c] + high[c]) / 2;
        size2 += (high[c] - low[c]) * (high[c] - low[c]);
    }
    // Positions are float, and what planes give may be off by 400 u of 4.5, the farthest that
    // anything is from the origin.
    sphere.radius = std::sqrt(size2) / 2 * (1 + 1e-3) + 2e-4;
    return sphere;
}

bool reaches(const LightTerm<float>& light, const TileSphere& sphere) {
    if (light.emission == LightEmission::uniform) return true;
    const double s = double(light.point_scale);
    double along = 0, distance2 = 0;
    for (int c = 0; c < 3; ++c) {
        const double v = s * sphere.centre[c] - double(light.position[c]);
        along += v * double(light.axis[c]);
        distance2 += v * v;
    }
    const double radius = s * sphere.radius;
    if (light.emission == LightEmission::cosine) return along + radius > 0;
    const double distance = std::sqrt(distance2);
    if (distance <= radius) return true;
    // The cone's rim, widened by what the sphere subtends and by the error of a cosine.
    const double angle = std::acos(std::clamp(along / distance, -1.0, 1.0));
    const double rim = std::acos(std::clamp(double(light.cos_cutoff), -1.0, 1.0));
    return angle - std::asin(radius / distance) <= rim + 1e-3;
}

LightTolerance light_tolerance(const RenderPlan& plan) {
    LightTolerance tolerance;
    // The sRGB curve is steepest in the dark.
    const double steepest = plan.transfer == Transfer::srgb ? 12.92 : 1;
    tolerance.radiance = plan.tolerance / 255 / steepest / std::exp2(plan.exposure_ev);
    for (const ResolvedMaterial& material : plan.materials)
        for (int c = 0; c < 3 && !material.unlit; ++c)
            tolerance.most[c] =
                std::max(tolerance.most[c], material.brdf->most == nullptr
                                                ? std::numeric_limits<double>::infinity()
                                                : material.brdf->most(material.params, c));
    return tolerance;
}

double most_radiance(const LightTerm<float>& light, const TileSphere& sphere,
                     const LightTolerance& tolerance) {
    const double s = double(light.point_scale);
    double distance2 = 0;
    for (int c = 0; c < 3; ++c) {
        const double v = s * sphere.centre[c] - double(light.position[c]);
        distance2 += v * v;
    }
    // Attenuation falls with the distance; a directional light has none, and s = 0.
    const double d = std::max(std::sqrt(distance2) - s * sphere.radius, double(light.radius));
    const auto& a = light.attenuation;
    const double factor =
        s == 0 ? 1 / double(a[0]) : 1 / (double(a[0]) + d * (double(a[1]) + double(a[2]) * d));
    double most = 0;
    for (int c = 0; c < 3; ++c)
        most = std::max(most, double(light.irradiance[c]) * factor * tolerance.most[c]);
    // What float makes of it is not more than this.
    return most * (1 + 1e-4);
}

}  // namespace scanshade

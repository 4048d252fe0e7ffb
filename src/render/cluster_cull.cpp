#include "render/cluster_cull.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace scanshade {
namespace {

// Snapping moves a corner by 1/512 pixel along each axis, and float rounding by less than that
// within 2^13 pixels of the centre. A triangle that is this many pixels high keeps its side.
constexpr double safe_height = 1.0 / 16;

}  // namespace

ClusterCull::ClusterCull(const View& view)
    : view_(view),
      half_width_((view.width / 2.0 + 1) / view.pixels_per_unit),
      half_height_((view.height / 2.0 + 1) / view.pixels_per_unit),
      slant_x_(view.orthographic ? 1 : std::hypot(1, half_width_)),
      slant_y_(view.orthographic ? 1 : std::hypot(1, half_height_)) {}

ClusterCull::Sphere ClusterCull::sphere(const ClusterBounds& cluster) const {
    const glm::dvec3 from_eye = glm::dvec3(cluster.centre) - view_.eye;
    const glm::dvec3 p = view_.rotation * from_eye;
    const double rounding = 1e-6 * (glm::length(from_eye) + 1);
    return {p.x, p.y, -p.z, double(cluster.radius) + rounding};
}

bool ClusterCull::outside(const ClusterBounds& cluster) const {
    const Sphere s = sphere(cluster);
    if (s.d + s.r < double(view_.near) || s.d - s.r > double(view_.far)) return true;
    const double reach = view_.orthographic ? 1 : s.d;
    return std::abs(s.x) - half_width_ * reach > s.r * slant_x_ ||
           std::abs(s.y) - half_height_ * reach > s.r * slant_y_;
}

bool ClusterCull::facing_away(const ClusterBounds& cluster) const {
    if (cluster.sin_cone >= 1) return false;
    const Sphere s = sphere(cluster);
    // γ: by how much directions from the eye differ within the sphere.
    const double distance = std::sqrt(s.x * s.x + s.y * s.y + s.d * s.d);
    const double sin_g = view_.orthographic ? 0 : s.r / distance;
    if (!(sin_g < 1)) return false;
    const glm::dvec3 along = view_.orthographic
                                 ? glm::dvec3(0, 0, -1) * view_.rotation
                                 : (glm::dvec3(cluster.centre) - view_.eye) / distance;
    // β: between the axis and the view. All normals face away where α + β + γ < 90°, and the cosine
    // of that sum is the least foreshortening.
    const double sin_a = double(cluster.sin_cone), cos_a = std::sqrt(1 - sin_a * sin_a);
    const double cos_g = std::sqrt(1 - sin_g * sin_g);
    const double sin_ag = sin_a * cos_g + cos_a * sin_g, cos_ag = cos_a * cos_g - sin_a * sin_g;
    const double cos_b = glm::dot(cluster.axis, along);
    if (cos_ag <= 0 || cos_b <= sin_ag) return false;
    const double sin_b = std::sqrt(std::max(0.0, 1 - cos_b * cos_b));
    const double least = cos_b * cos_ag - sin_b * sin_ag;
    const double farthest = view_.orthographic ? 1 : s.d + s.r;
    const double height = double(cluster.least_height) * least * view_.pixels_per_unit / farthest;
    return farthest > 0 && height > safe_height;
}

bool ClusterCull::unclipped(const ClusterBounds& cluster) const {
    const Sphere s = sphere(cluster);
    if (s.d - s.r < double(view_.near) || s.d + s.r > double(view_.far)) return false;
    const double w = view_.orthographic ? 1 : s.d - s.r;
    const double side = std::max(std::abs(s.x), std::abs(s.y)) + s.r;
    return side * view_.pixels_per_unit < double(guard_band - 1) * w;
}

}  // namespace scanshade

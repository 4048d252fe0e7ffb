#include "report/picture_reference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace scanshade {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Corners of the part with side(corner) ≥ 0.
template <class Side>
std::vector<glm::dvec3> kept_part(const std::vector<glm::dvec3>& polygon, Side side) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = side(a), at_b = side(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    return kept;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double segment_distance(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
    return glm::distance(p, a + along * t);
}

}  // namespace

glm::dvec3 ReferenceCamera::to_eye(const glm::dvec3& world) const {
    const glm::dvec3 from = world - position;
    return {glm::dot(from, right), glm::dot(from, down), glm::dot(from, forward)};
}

glm::dvec2 ReferenceCamera::to_picture(const glm::dvec3& eye) const {
    const double w = orthographic ? 1 : eye.z;
    return {scale * eye.x / w + width / 2.0, scale * eye.y / w + height / 2.0};
}

ReferenceCamera reference_camera(const Scene& scene, const Settings& settings) {
    const Bounds bounds = scene.bounds();
    const Camera camera =
        scene.camera ? *scene.camera
                     : framed_camera(bounds, double(settings.width) / double(settings.height));
    const DepthRange depth = depth_range(camera, bounds);
    ReferenceCamera out{};
    out.position = camera.position;
    out.forward = glm::normalize(camera.focal_point - camera.position);
    out.right = glm::normalize(glm::cross(out.forward, glm::normalize(camera.view_up)));
    out.down = glm::cross(out.forward, out.right);
    const double half_angle = camera.view_angle_deg * (std::numbers::pi / 360);
    out.orthographic = camera.projection == Projection::orthographic;
    const double seen_from =
        out.orthographic ? glm::distance(camera.focal_point, camera.position) : 1;
    out.scale = settings.height / (2 * std::tan(half_angle) * seen_from);
    out.near = depth.near;
    out.far = depth.far;
    out.width = settings.width;
    out.height = settings.height;
    return out;
}

std::vector<glm::dvec3> reference_vertices(const ReferenceCamera& camera, const Object& object) {
    const Mesh& mesh = *object.mesh;
    std::vector<glm::dvec3> eye;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const glm::dvec3 local(mesh.x[v], mesh.y[v], mesh.z[v]);
        const glm::dvec4 world = object.to_world * glm::dvec4(mesh.origin + mesh.unit * local, 1);
        eye.push_back(camera.to_eye(glm::dvec3(world)));
    }
    return eye;
}

ReferencePolygon::ReferencePolygon(std::vector<glm::dvec2> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] != corners[(i + 1) % corners.size()]) corner_.push_back(corners[i]);
    double area = 0;
    for (std::size_t i = 2; i < corner_.size(); ++i)
        area += cross(corner_[i - 1] - corner_[0], corner_[i] - corner_[0]);
    if (area == 0) corner_.clear();
    for (std::size_t i = 0; i < corner_.size(); ++i) {
        const glm::dvec2 along = corner_[(i + 1) % corner_.size()] - corner_[i];
        const glm::dvec2 left(-along.y, along.x);
        inward_.push_back(left / std::copysign(glm::length(left), area));
    }
}

double ReferencePolygon::line_distance(const glm::dvec2& p) const {
    double least = corner_.empty() ? -infinite : infinite;
    for (std::size_t i = 0; i < corner_.size(); ++i)
        least = std::min(least, glm::dot(p - corner_[i], inward_[i]));
    return least;
}

double ReferencePolygon::outline_distance(const glm::dvec2& p) const {
    double least = infinite;
    for (std::size_t i = 0; i < corner_.size(); ++i)
        least = std::min(least, segment_distance(corner_[i], corner_[(i + 1) % corner_.size()], p));
    return least;
}

ReferencePolygon reference_polygon(const ReferenceCamera& camera,
                                   const std::array<glm::dvec3, 3>& triangle) {
    std::vector<glm::dvec3> corners(triangle.begin(), triangle.end());
    corners = kept_part(corners, [&](const glm::dvec3& eye) { return eye.z - camera.near; });
    corners = kept_part(corners, [&](const glm::dvec3& eye) { return camera.far - eye.z; });
    std::vector<glm::dvec2> on_picture;
    for (const glm::dvec3& eye : corners) on_picture.push_back(camera.to_picture(eye));
    return ReferencePolygon(std::move(on_picture));
}

}  // namespace scanshade

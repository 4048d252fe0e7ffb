#include "scanshade/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/base/error.hpp"
#include "scene/mesh_parts.hpp"

namespace scanshade {
namespace {

constexpr double parallel_sine = 1e-9;  // between view up and the view direction

/// Unit vector against the view direction.
glm::dvec3 backward(const Camera& camera) {
    const auto direction = safe_normalize(camera.position - camera.focal_point);
    if (!direction)
        throw Error(Errc::scene,
                    "the camera's focal point is its position; give two different points");
    return *direction;
}

}  // namespace

Camera framed_camera(const Bounds& bounds, double aspect) {
    constexpr double azimuth = glm::radians(30.0), elevation = glm::radians(20.0);
    constexpr double margin = 1.05;
    Camera camera;
    const double vertical = glm::radians(camera.view_angle_deg) / 2;
    const double horizontal = std::atan(std::tan(vertical) * aspect);
    // The sphere touches the narrower of the two pairs of sides.
    const double distance = margin * bounds.radius / std::sin(std::min(vertical, horizontal));
    const glm::dvec3 towards_eye = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                    std::cos(elevation) * std::cos(azimuth)};
    camera.focal_point = bounds.centre;
    camera.position = bounds.centre + towards_eye * distance;
    return camera;
}

glm::dmat3 eye_rotation(const Camera& camera) {
    const glm::dvec3 back = backward(camera);
    const glm::dvec3 view_up = safe_normalize(camera.view_up).value_or(back);
    const glm::dvec3 right = glm::cross(view_up, back);
    const double sine = glm::length(right);
    if (!(sine > parallel_sine))
        throw Error(Errc::scene,
                    "the camera's view up is along its view direction; give a direction that "
                    "points up in the picture");
    const glm::dvec3 x = right / sine;
    return glm::transpose(glm::dmat3(x, glm::cross(back, x), back));
}

DepthRange depth_range(const Camera& camera, const Bounds& bounds) {
    const double along = glm::dot(camera.position - bounds.centre, backward(camera));
    // A little room on both sides, so that rounding does not cut what touches the sphere; vertices
    // are rounded to float relative to their distance.
    const double room = 1.001 * bounds.radius + 1e-6 * std::abs(along);
    const double least = 1e-3 * bounds.radius;
    // A fitted plane gives way where the camera's own one lies on its wrong side.
    double near = camera.near.value_or(std::max(along - room, least));
    if (camera.far && !camera.near && near >= *camera.far) near = 1e-3 * *camera.far;
    const double far = camera.far.value_or(std::max(along + room, 2 * near));
    if (!(near > 0) || !(far > near))
        throw Error(Errc::scene, "the camera's near and far planes must satisfy 0 < near < far");
    return {near, far};
}

}  // namespace scanshade

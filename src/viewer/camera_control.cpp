#include "viewer/camera_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace scanshade::viewer {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double pole_margin = 0.01;    // radians between the camera and the turntable's axis
constexpr double zoom_per_step = 0.9;   // of the distance
constexpr double max_zoom_ratio = 1e3;  // between the distance and the radius, either way

// glm::length squares its input: far cameras would overflow.
double length(const glm::dvec3& v) { return std::hypot(v.x, v.y, v.z); }

/// The nearest value in [low, high], widened to hold where the camera stands already: a camera
/// that a scene put outside the limits must not jump at the first gesture.
double limit(double value, double low, double high, double now) {
    return std::clamp(value, std::min(low, now), std::max(high, now));
}

}  // namespace

Camera orbited(const Camera& camera, double dx, double dy, int window_height) {
    const glm::dvec3 offset = camera.position - camera.focal_point;
    const double distance = length(offset);
    const glm::dvec3 axis = camera.view_up / length(camera.view_up);
    const glm::dvec3 backward = offset / distance;
    const glm::dvec3 side = glm::cross(axis, backward);  // to the camera's right

    // The polar angle from the axis by atan2, which is precise near the poles where acos is not.
    const double sine = length(side);
    const double polar = std::atan2(sine, glm::dot(axis, backward));
    const double angle_per_pixel = 2 * pi / window_height;
    const double new_polar =
        limit(polar - dy * angle_per_pixel, pole_margin, pi - pole_margin, polar);

    const glm::dvec3 right = side / sine;
    const glm::dvec3 outward = glm::cross(right, axis);
    const double azimuth = -dx * angle_per_pixel;
    const glm::dvec3 new_outward = std::cos(azimuth) * outward + std::sin(azimuth) * right;

    Camera moved = camera;
    moved.position = camera.focal_point +
                     distance * (std::cos(new_polar) * axis + std::sin(new_polar) * new_outward);
    return moved;
}

namespace {

/// Size of a pixel at the focal point.
double pixel_size(const Camera& camera, int window_height) {
    const double distance = length(camera.position - camera.focal_point);
    return 2 * distance * std::tan(camera.view_angle_deg * pi / 360) / window_height;
}

}  // namespace

Camera panned(const Camera& camera, double dx, double dy, int window_height) {
    const glm::dmat3 eye = glm::transpose(eye_rotation(camera));  // columns: right, up, backward
    const glm::dvec3 shift = pixel_size(camera, window_height) * (dy * eye[1] - dx * eye[0]);

    Camera moved = camera;
    moved.position += shift;
    moved.focal_point += shift;
    return moved;
}

Camera zoomed(const Camera& camera, double steps, double radius, double x, double y,
              int window_height) {
    const glm::dvec3 offset = camera.position - camera.focal_point;
    const double distance = length(offset);
    const double new_distance = limit(distance * std::pow(zoom_per_step, steps),
                                      radius / max_zoom_ratio, radius * max_zoom_ratio, distance);

    const glm::dmat3 eye = glm::transpose(eye_rotation(camera));  // columns: right, up, backward
    const double scale = new_distance / distance;
    const double shift = pixel_size(camera, window_height) * (1 - scale);

    Camera moved = camera;
    moved.focal_point += shift * (x * eye[0] - y * eye[1]);
    moved.position = moved.focal_point + offset * scale;
    return moved;
}

Camera seen_from(const Camera& camera, const glm::dvec3& direction) {
    glm::dvec3 outward = direction / length(direction);
    if (std::hypot(outward.x, outward.z) < pole_margin) outward.z += pole_margin;
    Camera moved = camera;
    moved.view_up = {0, 1, 0};
    moved.position = camera.focal_point +
                     outward / length(outward) * length(camera.position - camera.focal_point);
    return moved;
}

Camera opposite(const Camera& camera) {
    Camera moved = camera;
    moved.position = camera.focal_point - (camera.position - camera.focal_point);
    return moved;
}

std::optional<glm::dvec2> project(const Camera& camera, int width, int height,
                                  const glm::dvec3& point) {
    const glm::dvec3 at = eye_rotation(camera) * (point - camera.position);
    const bool orthographic = camera.projection == Projection::orthographic;
    if (!orthographic && !(-at.z > 0)) return std::nullopt;
    const double distance = orthographic ? length(camera.position - camera.focal_point) : -at.z;
    const double pixels = height / (2 * distance * std::tan(camera.view_angle_deg * pi / 360));
    return glm::dvec2(width / 2.0 + at.x * pixels, height / 2.0 - at.y * pixels);
}

}  // namespace scanshade::viewer

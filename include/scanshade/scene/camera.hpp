// The camera.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace scanshade {

enum class Projection { perspective, orthographic };

/// A camera in world space; right-handed, looks from position to focal_point.
struct Camera {
    glm::dvec3 position{0, 0, 5};
    glm::dvec3 focal_point{0};    // not the position
    glm::dvec3 view_up{0, 1, 0};  // not along the view direction
    double view_angle_deg = 30;   // vertical, (0, 180); in orthographic projection the height
                                  // of the picture is what this angle sees at the focal point
    Projection projection = Projection::perspective;
    std::optional<double> near, far;  // distances along the view direction, 0 < near < far;
                                      // default: fitted to the bounds
};

/// Sphere around everything that is drawn.
struct Bounds {
    glm::dvec3 centre{0};
    double radius = 1;  // > 0
};

/// A camera that sees the whole sphere with a margin, from the front right and a little above.
Camera framed_camera(const Bounds& bounds, double aspect);

/// World → eye: a rotation about the camera's position, in two parts so that a far camera loses
/// nothing: eye = rotation · (p − position). Rows are right, up, backward.
/// Throws Error(scene) for a camera that looks nowhere.
glm::dmat3 eye_rotation(const Camera& camera);

/// Distances of the near and far plane: the camera's own, or fitted: near is the distance to the
/// sphere, at least 1e-3 of its radius; far lies beyond it.
struct DepthRange {
    double near, far;
};
DepthRange depth_range(const Camera& camera, const Bounds& bounds);

}  // namespace scanshade

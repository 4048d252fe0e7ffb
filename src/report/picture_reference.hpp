// The geometry of a picture, a second time: in double, straight from the scene as it was given, and
// without snapping.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// The camera as textbooks have it. Eye space: x right, y down, z along the view direction; on the
/// picture a point stands at scale · (x/z, y/z) pixels from the centre (orthographic: z = 1 there).
struct ReferenceCamera {
    glm::dvec3 position, right, down, forward;
    double scale;
    bool orthographic;
    double near, far;
    int width, height;

    glm::dvec3 to_eye(const glm::dvec3& world) const;
    /// Pixels from the upper left corner, of a point in eye space at z > 0.
    glm::dvec2 to_picture(const glm::dvec3& eye) const;
};

ReferenceCamera reference_camera(const Scene& scene, const Settings& settings);

/// A convex polygon on the picture, in pixels: what near and far leave of a triangle.
struct ReferencePolygon {
    std::vector<glm::dvec2> corner;
    double turn = 1;  // −1: corners run anticlockwise on the picture

    /// Pixels to the nearest point of the outline; above 0 inside.
    double distance(const glm::dvec2& p) const;
};

/// `triangle` in eye space. No corners where nothing of it is between near and far.
ReferencePolygon reference_polygon(const ReferenceCamera& camera,
                                   const std::array<glm::dvec3, 3>& triangle);

/// Closer than this to an edge, in pixels, the reference cannot tell on which side a sample is.
inline constexpr double undecided = 1e-8;

}  // namespace scanshade

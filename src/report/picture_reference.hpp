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

/// An object's vertices in eye space.
std::vector<glm::dvec3> reference_vertices(const ReferenceCamera& camera, const Object& object);

/// A convex polygon on the picture, in pixels: what near and far leave of a triangle.
class ReferencePolygon {
public:
    /// Nothing but an empty polygon where there is no area.
    explicit ReferencePolygon(std::vector<glm::dvec2> corners);

    const std::vector<glm::dvec2>& corners() const { return corner_; }
    /// Pixels to the nearest of the lines along the edges; above 0 inside, where it is the distance
    /// from the outline. Outside it is no more than that.
    double line_distance(const glm::dvec2& p) const;
    /// Pixels to the nearest point of the outline, never below 0.
    double outline_distance(const glm::dvec2& p) const;

private:
    std::vector<glm::dvec2> corner_;
    std::vector<glm::dvec2> inward_;  // [edge] unit normal
};

/// `triangle` in eye space.
ReferencePolygon reference_polygon(const ReferenceCamera& camera,
                                   const std::array<glm::dvec3, 3>& triangle);

/// Closer than this to an edge, in pixels, the reference cannot tell on which side a sample is.
inline constexpr double undecided = 1e-6;

}  // namespace scanshade

#include "viewer/light_control.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace scanshade::viewer {

Light turned(const Light& light, const Camera& camera, const glm::dvec3& centre, double dx,
             double dy, int window_height) {
    const glm::dmat3 eye = glm::transpose(eye_rotation(camera));  // columns: right, up, backward
    const double angle = std::numbers::pi / window_height;
    glm::dmat4 turn = glm::rotate(glm::dmat4(1), dx * angle, eye[1]);
    turn = glm::rotate(turn, dy * angle, eye[0]);
    const glm::dmat3 rotation(turn);
    Light moved = light;
    moved.direction = rotation * light.direction;
    if (light.kind != LightKind::directional)
        moved.position = centre + rotation * (light.position - centre);
    return moved;
}

glm::dvec3 shown_position(const Light& light, const glm::dvec3& centre, double radius) {
    if (light.kind != LightKind::directional) return light.position;
    return centre - glm::normalize(light.direction) * radius;
}

}  // namespace scanshade::viewer

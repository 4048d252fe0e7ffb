#include "render/surface.hpp"

#include <glm/glm.hpp>

namespace scanshade {

ObjectSurface::ObjectSurface(const Object& object)
    : mesh_(object.mesh.get()),
      linear_(glm::dmat3(object.to_world) * object.mesh->unit),
      origin_(glm::dmat3(object.to_world) * object.mesh->origin + glm::dvec3(object.to_world[3])),
      normal_(glm::transpose(glm::inverse(glm::dmat3(object.to_world)))) {}

glm::dvec3 ObjectSurface::to_world(double x, double y, double z) const {
    return linear_ * glm::dvec3(x, y, z) + origin_;
}

glm::dvec3 ObjectSurface::vertex_position(std::uint32_t vertex) const {
    return to_world(double(mesh_->x[vertex]), double(mesh_->y[vertex]), double(mesh_->z[vertex]));
}

glm::dvec3 ObjectSurface::vertex_normal(std::uint32_t vertex) const {
    return glm::normalize(normal_ * glm::dvec3(double(mesh_->nx[vertex]), double(mesh_->ny[vertex]),
                                               double(mesh_->nz[vertex])));
}

glm::dvec3 ObjectSurface::face_centre(std::size_t face) const {
    const auto& c = mesh_->face_centre[face];
    return to_world(double(c[0]), double(c[1]), double(c[2]));
}

glm::dvec3 ObjectSurface::face_normal(std::size_t face) const {
    const auto& n = mesh_->face_normal[face];
    return glm::normalize(normal_ * glm::dvec3(double(n[0]), double(n[1]), double(n[2])));
}

}  // namespace scanshade

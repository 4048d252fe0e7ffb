// The ray through a point of the picture, as two planes that meet in it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "render/transform.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {

/// A point of a mesh or of a surface that a ray meets.
struct SurfaceHit {
    glm::dvec3 position, normal;  // world; the normal of unit length, outward
    glm::dvec2 texcoord{0};
    glm::dvec2 texcoord_per_pixel[2]{};  // to the right, down
};

/// g(P) = 0 in both components where P lies on the ray; g/w is P's distance from it on the picture,
/// in pixels to the right and down.
class PixelRay {
public:
    /// (x, y) in pixels from the upper left corner of the picture.
    PixelRay(const View& view, double x, double y);

    glm::dvec2 g(const glm::dvec3& P) const;
    /// The change of g along a direction.
    glm::dvec2 along(const glm::dvec3& direction) const;
    /// 1 in orthographic projection.
    double w(const glm::dvec3& P) const;
    glm::dvec3 towards_eye(const glm::dvec3& P) const;

    /// (λ_1, λ_2) of the point A + λ_1 e_1 + λ_2 e_2 that the ray meets; nothing where it runs
    /// along the plane. Jacobian⁻¹ per pixel is what `inverse` gets.
    std::optional<glm::dvec2> meet_plane(const glm::dvec3& A, const glm::dvec3& e1,
                                         const glm::dvec3& e2, glm::dmat2& inverse) const;

private:
    const View& view_;
    glm::dvec3 plane_[2];  // normals
    glm::dvec2 offset_{0};
};

/// A smooth patch placed in the world.
class PlacedPatch {
public:
    PlacedPatch(const ShapeInfo& shape, int patch, const glm::dmat4& to_world)
        : shape_(shape),
          patch_(patch),
          to_world_(to_world),
          linear_(to_world),
          normal_(glm::transpose(glm::inverse(linear_))) {}

    /// In the world; normal of unit length.
    SmoothPoint at(const glm::dvec2& uv) const;

    /// Newton's method from the parameters `start`. Nothing where it does not converge.
    std::optional<SurfaceHit> meet(const PixelRay& ray, glm::dvec2 start) const;

private:
    const ShapeInfo& shape_;
    int patch_;
    glm::dmat4 to_world_;
    glm::dmat3 linear_, normal_;
};

}  // namespace scanshade

#include "render/pixel_ray.hpp"

#include <cmath>

namespace scanshade {
namespace {

constexpr double on_the_ray = 1e-9;  // pixels
constexpr int most_steps = 20;

std::optional<glm::dmat2> inverse_of(const glm::dvec2& column0, const glm::dvec2& column1) {
    const glm::dmat2 m(column0, column1);
    const double size = glm::length(column0) * glm::length(column1);
    const double determinant = glm::determinant(m);
    if (!(std::abs(determinant) > 1e-12 * size)) return std::nullopt;
    return glm::inverse(m);
}

}  // namespace

// With e = rotation (P − eye) a point stands at (X, Y) = scale (e_x, −e_y)/w on the picture, and
// g = (scale e_x − X w, −scale e_y − Y w), where w = −e_z, or 1.
PixelRay::PixelRay(const View& view, double x, double y) : view_(view) {
    const glm::dmat3 rows = glm::transpose(view.rotation);
    const double X = x - 0.5 * view.width, Y = y - 0.5 * view.height;
    plane_[0] = rows[0] * view.pixels_per_unit;
    plane_[1] = rows[1] * -view.pixels_per_unit;
    if (view.orthographic) {
        offset_ = {X, Y};
        return;
    }
    plane_[0] += rows[2] * X;
    plane_[1] += rows[2] * Y;
}

glm::dvec2 PixelRay::along(const glm::dvec3& direction) const {
    return {glm::dot(plane_[0], direction), glm::dot(plane_[1], direction)};
}

glm::dvec2 PixelRay::g(const glm::dvec3& P) const { return along(P - view_.eye) - offset_; }

double PixelRay::w(const glm::dvec3& P) const {
    if (view_.orthographic) return 1;
    return -glm::dot(glm::transpose(view_.rotation)[2], P - view_.eye);
}

glm::dvec3 PixelRay::towards_eye(const glm::dvec3& P) const {
    return view_.orthographic ? glm::transpose(view_.rotation)[2] : view_.eye - P;
}

std::optional<glm::dvec2> PixelRay::meet_plane(const glm::dvec3& A, const glm::dvec3& e1,
                                               const glm::dvec3& e2, glm::dmat2& inverse) const {
    const auto found = inverse_of(along(e1), along(e2));
    if (!found) return std::nullopt;
    const glm::dvec2 at = *found * -g(A);
    inverse = *found * w(A + e1 * at.x + e2 * at.y);
    return at;
}

SmoothPoint PlacedPatch::at(const glm::dvec2& uv) const {
    const SmoothPoint local = shape_.smooth(patch_, uv.x, uv.y);
    return {glm::dvec3(to_world_ * glm::dvec4(local.position, 1)), linear_ * local.du,
            linear_ * local.dv, glm::normalize(normal_ * local.normal)};
}

std::optional<SurfaceHit> PlacedPatch::meet(const PixelRay& ray, glm::dvec2 uv) const {
    for (int step = 0; step < most_steps; ++step) {
        const SmoothPoint p = at(uv);
        glm::dmat2 inverse;
        const auto move = ray.meet_plane(p.position, p.du, p.dv, inverse);
        if (!move) return std::nullopt;
        const double w = ray.w(p.position);
        if (w > 0 && glm::length(ray.g(p.position)) <= on_the_ray * w)
            return SurfaceHit{p.position, p.normal, uv, {inverse[0], inverse[1]}};
        uv += *move;
    }
    return std::nullopt;
}

}  // namespace scanshade

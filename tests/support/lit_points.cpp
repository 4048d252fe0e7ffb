#include "support/lit_points.hpp"

#include <cmath>

namespace scanshade {
namespace {

constexpr double u = 0x1p-24;

/// A value that a plane carries is good to 100 u of the largest corner, and depths in a triangle
/// differ by a factor of 5 at most.
constexpr double plane_error = 500 * u;
/// A vertex is transformed, and its normal rounded.
constexpr double vertex_error = 8 * u;

/// On the picture, and so of what is found from depth, a corner is off by half of 1/256 pixel.
double picture_error(const View& view, const glm::dvec3& position) {
    const double distance = view.orthographic ? 1 : glm::length(position - view.eye);
    return distance * (2 * 0x1p-21 + std::sqrt(0.5) / subpixels / view.pixels_per_unit);
}

Vec3<double> vec3_of(const double (&v)[3]) { return {v[0], v[1], v[2]}; }
glm::dvec3 to_glm(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

LitPoints64::LitPoints64(const Scene& scene, const Settings& settings)
    : test_(scene, settings),
      surfaces_(test_.scene.objects.begin(), test_.scene.objects.end()),
      lighting_(lighting_of<double>(test_.frame)) {
    const int side = test_.plan.samples_side;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const auto at = [side](int k) { return (2 * k + 1) * subpixels / (2 * side); };
            samples_.push_back({at(i), at(j)});
            test_.frame.sample = samples_.back();
            find_visible(test_.frame);
            ids_.push_back(test_.frame.id);
        }
}

std::vector<LitPoint> LitPoints64::at(int x, int y) {
    std::vector<LitPoint> points;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        const std::uint32_t id = ids_[s][test_.target.index(x, y)];
        if (id == Framebuffer::no_triangle) continue;
        test_.frame.sample = samples_[s];
        FaceValues<double> face(test_.frame, surfaces_, ignored_);
        face.begin(id);
        add_points(face, sample_point(x, y, samples_[s]), points);
    }
    return points;
}

void LitPoints64::add_points(FaceValues<double>& face, SnappedPoint p,
                             std::vector<LitPoint>& out) const {
    const ObjectSurface& surface = surfaces_[face.drawn.object];
    const double side = face.drawn.back ? -1 : 1;
    const auto add = [&](const glm::dvec3& position, const glm::dvec3& normal) {
        out.push_back({to_vec3<double>(position), to_vec3<double>(normal * side), vertex_error,
                       vertex_error, face.material});
    };
    if (face.shading == Shading::flat)
        return add(surface.face_centre(face.drawn.face), surface.face_normal(face.drawn.face));
    if (face.shading == Shading::gouraud) {
        for (const std::uint32_t v : face.vertex)
            add(surface.vertex_position(v), surface.vertex_normal(v));
        return;
    }
    const Place<double> at = face.place(p);
    const Vec3<double> P = face.position(at);
    out.push_back({P, face.normal(at), plane_error + picture_error(test_.frame.view, to_glm(P)),
                   plane_error, face.material});
}

bool LitPoints64::near_threshold(const LitPoint& point) const {
    const ResolvedMaterial& material = test_.plan.materials[point.material];
    if (material.unlit) return false;
    const double length = std::sqrt(dot(point.normal, point.normal));
    if (std::abs(length - shortest_normal) <= point.normal_error) return true;
    const Vec3<double> n = normalise(point.normal);
    for (const LightTerm<double>& light : lighting_.lit.lights) {
        const Vec3<double> to_light = vec3_of(light.position) - point.position * light.point_scale;
        const double distance = std::sqrt(dot(to_light, to_light));
        const double turned =
            4 * u + point.position_error * light.point_scale / std::max(distance, 1e-300);
        const Vec3<double> wi = normalise(to_light);
        if (std::abs(dot(n, wi)) <= turned + point.normal_error / length) return true;
        if (light.emission == LightEmission::spot &&
            std::abs(dot(-wi, vec3_of(light.axis)) - light.cos_cutoff) <= turned)
            return true;
    }
    return false;
}

}  // namespace scanshade

// Points of surfaces in normalised world space, and batches of them for the kernels.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <type_traits>
#include <vector>

#include "render/faces.hpp"
#include "scanshade/num/vec3.hpp"

namespace scanshade {

/// One object's vertices and faces in normalised world space, in double.
class ObjectSurface {
public:
    explicit ObjectSurface(const Object& object);

    glm::dvec3 vertex_position(std::uint32_t vertex) const;
    glm::dvec3 vertex_normal(std::uint32_t vertex) const;  // unit
    glm::dvec3 face_centre(std::size_t face) const;        // mean of the corners
    glm::dvec3 face_normal(std::size_t face) const;        // Newell's, unit

private:
    glm::dvec3 to_world(double x, double y, double z) const;
    const Mesh* mesh_;
    glm::dmat3 linear_;  // mesh units → world
    glm::dvec3 origin_;
    glm::dmat3 normal_;  // inverse transpose
};

template <class T>
Vec3<T> to_vec3(const glm::dvec3& v) {
    return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}

/// Surface points of one material on their way through a kernel.
template <class T>
struct Batch {
    std::vector<T> position[3], normal[3], albedo[3], radiance[3];
    std::vector<std::size_t> target;  // where each result goes
    bool textured = false;            // albedo is filled
    bool vectors = false;             // by the vector kernel, not its scalar twin

    std::size_t size() const { return target.size(); }

    void clear() {
        for (int c = 0; c < 3; ++c) position[c].clear(), normal[c].clear(), albedo[c].clear();
        target.clear();
    }

    void push(const Vec3<T>& P, const Vec3<T>& n, std::size_t to) {
        const T values[6] = {P.x, P.y, P.z, n.x, n.y, n.z};
        for (int c = 0; c < 3; ++c) {
            position[c].push_back(values[c]);
            normal[c].push_back(values[3 + c]);
        }
        target.push_back(to);
    }

    void push_albedo(const std::array<float, 3>& a) {
        for (std::size_t c = 0; c < 3; ++c) albedo[c].push_back(T(a[c]));
    }

    /// Takes the padding away that illuminate has added, to light the same points again.
    void unpad() {
        for (int c = 0; c < 3; ++c) {
            position[c].resize(size());
            normal[c].resize(size());
        }
    }

    /// radiance[·][i] for each point. The padding repeats the last point.
    void illuminate(const ResolvedMaterial& material, const Lighting<T>& lighting,
                    EventCounts& events) {
        if (target.empty()) return;
        const SurfaceSpan<T> points = span();
        SpanEvents seen;
        if constexpr (std::is_same_v<T, float>)
            seen = (vectors ? material.brdf->illuminate_simd : material.brdf->illuminate_f32)(
                points, lighting, to_float(material.params));
        else
            seen = material.brdf->illuminate_f64(points, lighting, material.params);
        events.add(Event::light_at_surface, seen.light_at_surface);
    }

    /// What illuminating the one point of a batch computes.
    PointReport<T> report(const ResolvedMaterial& material, const Lighting<T>& lighting) {
        PointReport<T> out{};
        if constexpr (std::is_same_v<T, float>)
            material.brdf->report_f32(span(), lighting, to_float(material.params), out);
        else
            material.brdf->report_f64(span(), lighting, material.params, out);
        return out;
    }

private:
    /// All points, padded, with room for their radiance.
    SurfaceSpan<T> span() {
        const std::size_t whole = padded(size());
        SurfaceSpan<T> span{};
        for (int c = 0; c < 3; ++c) {
            position[c].resize(whole, position[c].back());
            normal[c].resize(whole, normal[c].back());
            if (textured) albedo[c].resize(whole, albedo[c].back());
            radiance[c].resize(whole);
            span.position[c] = position[c].data();
            span.normal[c] = normal[c].data();
            span.albedo[c] = textured ? albedo[c].data() : nullptr;
            span.radiance[c] = radiance[c].data();
        }
        span.count = size();
        return span;
    }
};

}  // namespace scanshade

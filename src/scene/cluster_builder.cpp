#include "scene/cluster_builder.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <iterator>
#include <numeric>

namespace scanshade {
namespace {

glm::dvec3 position(const Mesh& mesh, std::uint32_t v) {
    return {double(mesh.x[v]), double(mesh.y[v]), double(mesh.z[v])};
}

/// Smallest height of a triangle: twice its area over its longest side.
float height(const Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::dvec3 p = position(mesh, a), q = position(mesh, b), r = position(mesh, c);
    const double longest =
        std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
    const double area2 = glm::length(glm::cross(q - p, r - p));
    return longest > 0 ? float(area2 / longest * (1 - 1e-6)) : 0.0f;
}

template <class Visit>
void each_triangle(const ClusterPiece& piece, Visit&& visit) {
    const std::vector<unsigned char>& l = piece.triangle_corner;
    for (std::size_t i = 0; i < l.size(); i += 3)
        visit(piece.vertex[l[i]], piece.vertex[l[i + 1]], piece.vertex[l[i + 2]]);
}

/// Sine of the largest angle between the axis and a normal; 1 where one is not on its side.
double sine_of_cone(const Mesh& mesh, const ClusterPiece& piece, const glm::dvec3& axis) {
    if (!(glm::length(axis) > 0.5)) return 1;
    const glm::dvec3 unit = glm::normalize(axis);
    double sine = 0;
    each_triangle(piece, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 p = position(mesh, a);
        const glm::dvec3 n = glm::cross(position(mesh, b) - p, position(mesh, c) - p);
        if (!(glm::length(n) > 0)) return;  // least_height is 0
        if (!(glm::dot(n, unit) > 0)) sine = 1;
        sine = std::max(sine, glm::length(glm::cross(n, unit)) / glm::length(n));
    });
    return std::min(sine, 1.0);
}

}  // namespace

void ClusterBuilder::add(const ClusterPiece& piece) {
    Cluster cluster{};
    cluster.first_vertex = std::uint32_t(out_.x.size());
    cluster.first_face = std::uint32_t(out_.corners.size());
    cluster.vertex_count = std::uint32_t(piece.vertex.size());
    cluster.face_count = std::uint32_t(piece.number.size());
    cluster.corners = piece.corners;
    cluster.material = piece.material;
    for (const unsigned int v : piece.vertex) add_vertex(v);
    while (out_.x.size() % cluster_padding != 0) add_vertex(piece.vertex[0]);
    for (std::uint32_t f = 0; f < cluster.face_count; ++f) {
        std::uint32_t packed = f * number_bit;
        for (std::uint32_t k = 0; k < piece.corners; ++k)
            packed |= std::uint32_t(piece.corner[f * piece.corners + k]) << (k * corner_bits);
        out_.corners.push_back(packed);
        out_.triangle.push_back(piece.number[f]);
    }
    while (out_.corners.size() % cluster_padding != 0) {
        out_.corners.push_back(0);
        out_.triangle.push_back(no_index);
    }
    bound(piece, cluster);
    out_.clusters.push_back(cluster);
}

void ClusterBuilder::add_vertex(std::uint32_t v) {
    out_.x.push_back(mesh_.x[v]);
    out_.y.push_back(mesh_.y[v]);
    out_.z.push_back(mesh_.z[v]);
    out_.u.push_back(mesh_.u[v]);
    out_.v.push_back(mesh_.v[v]);
    out_.vertex.push_back(v);
}

void ClusterBuilder::bound(const ClusterPiece& piece, Cluster& cluster) const {
    std::vector<float> at;  // x, y, z by turns
    for (const unsigned int v : piece.vertex)
        at.insert(at.end(), {mesh_.x[v], mesh_.y[v], mesh_.z[v]});
    unsigned int local[max_cluster_vertices];
    std::iota(std::begin(local), std::end(local), 0u);
    const meshopt_Bounds bounds = meshopt_computeMeshletBounds(
        local, piece.triangle_corner.data(), piece.triangle_corner.size() / 3, at.data(),
        piece.vertex.size(), 3 * sizeof(float));
    for (std::size_t c = 0; c < 3; ++c) {
        cluster.centre[c] = bounds.center[c];
        cluster.axis[c] = bounds.cone_axis[c];
    }
    // The sphere and the cone are measured again, in double and around what has been rounded:
    // what they exclude is left out of the picture, and in float the area of a needle may be 0
    // and its normal point anywhere.
    constexpr double outward = 1 + 1e-5;
    const auto vec = [](const std::array<float, 3>& v) {
        return glm::dvec3(double(v[0]), double(v[1]), double(v[2]));
    };
    double radius = 0;
    for (const unsigned int v : piece.vertex)
        radius = std::max(radius, glm::distance(position(mesh_, v), vec(cluster.centre)));
    cluster.radius = float(radius * outward);
    const double sine = sine_of_cone(mesh_, piece, vec(cluster.axis));
    cluster.sin_cone = float(std::min(1.0, sine * outward + 1e-5));
    cluster.least_height = INFINITY;
    each_triangle(piece, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        cluster.least_height = std::min(cluster.least_height, height(mesh_, a, b, c));
    });
}

ClusteredMesh joined(const std::vector<ClusteredMesh>& parts) {
    ClusteredMesh all;
    const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    for (const ClusteredMesh& part : parts) {
        for (Cluster cluster : part.clusters) {
            cluster.first_vertex += std::uint32_t(all.x.size());
            cluster.first_face += std::uint32_t(all.corners.size());
            all.clusters.push_back(cluster);
        }
        append(all.x, part.x), append(all.y, part.y), append(all.z, part.z);
        append(all.u, part.u), append(all.v, part.v), append(all.vertex, part.vertex);
        append(all.corners, part.corners), append(all.triangle, part.triangle);
        append(all.left_out, part.left_out);
    }
    return all;
}

void pad_slots(ClusteredMesh& mesh) {
    if (mesh.clusters.empty()) return;
    const std::size_t slots = mesh.clusters.back().first_vertex + max_cluster_vertices;
    const auto pad = [&](auto& of) { of.resize(std::max(of.size(), slots), of.back()); };
    pad(mesh.x), pad(mesh.y), pad(mesh.z), pad(mesh.u), pad(mesh.v), pad(mesh.vertex);
}

}  // namespace scanshade

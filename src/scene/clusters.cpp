#include "scanshade/scene/clusters.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numeric>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

// Weight of a common direction of normals against compactness, as meshoptimizer counts it.
constexpr float cone_weight = 0.25f;

/// Triangles around a vertex. For each that it adds meshoptimizer looks at all that are left around
/// the vertices it has, so the time for a fan is the square of this.
constexpr std::uint32_t max_valence = 1024;

bool has_hub(const std::vector<unsigned int>& index, std::size_t vertices) {
    std::vector<std::uint32_t> valence(vertices);
    for (const unsigned int v : index) ++valence[v];
    return std::any_of(valence.begin(), valence.end(),
                       [](std::uint32_t n) { return n > max_valence; });
}

/// Triangles ordered by material; within one, as in the mesh.
std::vector<std::uint32_t> triangles_by_material(const Mesh& mesh) {
    std::vector<std::uint32_t> order(mesh.triangle_count());
    std::iota(order.begin(), order.end(), 0u);
    const auto material = [&](std::uint32_t t) {
        return mesh.face_material[mesh.triangle_face[t]];
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return material(a) < material(b); });
    return order;
}

/// The mesh's triangle for each one that meshoptimizer gives back: it keeps the corners' order but
/// not the triangle's number. Equal triangles are told apart by taking each number once.
class TriangleNumbers {
public:
    TriangleNumbers(const Mesh& mesh, const std::uint32_t* begin, const std::uint32_t* end) {
        for (const std::uint32_t* t = begin; t != end; ++t)
            numbers_.push_back({rotated(mesh.triangle[*t]), *t});
        std::sort(numbers_.begin(), numbers_.end());
        taken_.resize(numbers_.size());
    }

    std::uint32_t take(const std::array<std::uint32_t, 3>& corners) {
        const Key key = rotated(corners);
        const auto first = std::size_t(
            std::lower_bound(numbers_.begin(), numbers_.end(), Row{key, 0}) - numbers_.begin());
        return numbers_[first + taken_[first]++].number;
    }

private:
    using Key = std::array<std::uint32_t, 3>;
    struct Row {
        Key corners;
        std::uint32_t number;
        auto operator<=>(const Row&) const = default;
    };
    static Key rotated(const Key& t) {
        const auto least = std::min_element(t.begin(), t.end()) - t.begin();
        return {t[std::size_t(least)], t[std::size_t((least + 1) % 3)],
                t[std::size_t((least + 2) % 3)]};
    }
    std::vector<Row> numbers_;
    std::vector<std::uint32_t> taken_;  // [first of equal ones] how many
};

class Builder {
public:
    explicit Builder(const Mesh& mesh) : mesh_(mesh) {
        for (std::size_t i = 0; i < mesh.vertex_count(); ++i)
            position_.insert(position_.end(), {mesh.x[i], mesh.y[i], mesh.z[i]});
    }

    /// Cuts the triangles [begin, end), all of one material.
    void cut(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t material) {
        std::vector<unsigned int> index;
        for (const std::uint32_t* t = begin; t != end; ++t)
            index.insert(index.end(), mesh_.triangle[*t].begin(), mesh_.triangle[*t].end());
        const std::size_t most =
            meshopt_buildMeshletsBound(index.size(), max_cluster_vertices, max_cluster_triangles);
        std::vector<meshopt_Meshlet> meshlets(most);
        std::vector<unsigned int> vertices(most * max_cluster_vertices);
        std::vector<unsigned char> corners(most * max_cluster_triangles * 3);
        if (has_hub(index, mesh_.vertex_count()))  // as they come
            meshlets.resize(meshopt_buildMeshletsScan(
                meshlets.data(), vertices.data(), corners.data(), index.data(), index.size(),
                mesh_.vertex_count(), max_cluster_vertices, max_cluster_triangles));
        else
            meshlets.resize(meshopt_buildMeshlets(
                meshlets.data(), vertices.data(), corners.data(), index.data(), index.size(),
                position_.data(), mesh_.vertex_count(), 3 * sizeof(float), max_cluster_vertices,
                max_cluster_triangles, cone_weight));
        TriangleNumbers numbers(mesh_, begin, end);
        for (const meshopt_Meshlet& meshlet : meshlets)
            add(meshlet, &vertices[meshlet.vertex_offset], &corners[meshlet.triangle_offset],
                material, numbers);
    }

    ClusteredMesh take() { return std::move(out_); }

private:
    void add(const meshopt_Meshlet& meshlet, const unsigned int* vertices,
             const unsigned char* corners, std::uint32_t material, TriangleNumbers& numbers) {
        Cluster cluster{};
        cluster.first_vertex = std::uint32_t(out_.x.size());
        cluster.first_triangle = std::uint32_t(out_.corners.size());
        cluster.vertex_count = meshlet.vertex_count;
        cluster.triangle_count = meshlet.triangle_count;
        cluster.material = material;
        for (std::uint32_t i = 0; i < meshlet.vertex_count; ++i) add_vertex(vertices[i]);
        while (out_.x.size() % cluster_padding != 0) add_vertex(vertices[0]);
        cluster.least_height = INFINITY;
        for (std::uint32_t t = 0; t < meshlet.triangle_count; ++t) {
            const unsigned char* l = corners + 3 * t;
            out_.corners.push_back(l[0] | unsigned(l[1]) << corner_bits |
                                   unsigned(l[2]) << (2 * corner_bits) | t * number_bit);
            out_.triangle.push_back(numbers.take({vertices[l[0]], vertices[l[1]], vertices[l[2]]}));
            cluster.least_height = std::min(cluster.least_height,
                                            height(vertices[l[0]], vertices[l[1]], vertices[l[2]]));
        }
        while (out_.corners.size() % cluster_padding != 0) {
            out_.corners.push_back(0);
            out_.triangle.push_back(no_index);
        }
        bound(meshlet, vertices, corners, cluster);
        out_.clusters.push_back(cluster);
    }

    void add_vertex(std::uint32_t v) {
        out_.x.push_back(mesh_.x[v]);
        out_.y.push_back(mesh_.y[v]);
        out_.z.push_back(mesh_.z[v]);
        out_.u.push_back(mesh_.u[v]);
        out_.v.push_back(mesh_.v[v]);
        out_.vertex.push_back(v);
    }

    glm::dvec3 position(std::uint32_t v) const {
        return {double(mesh_.x[v]), double(mesh_.y[v]), double(mesh_.z[v])};
    }

    /// Smallest height of a triangle: twice its area over its longest side.
    float height(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const glm::dvec3 p = position(a), q = position(b), r = position(c);
        const double longest =
            std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
        const double area2 = glm::length(glm::cross(q - p, r - p));
        return longest > 0 ? float(area2 / longest * (1 - 1e-6)) : 0.0f;
    }

    void bound(const meshopt_Meshlet& meshlet, const unsigned int* vertices,
               const unsigned char* corners, Cluster& cluster) const {
        const meshopt_Bounds bounds =
            meshopt_computeMeshletBounds(vertices, corners, meshlet.triangle_count,
                                         position_.data(), mesh_.vertex_count(), 3 * sizeof(float));
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
        for (std::uint32_t i = 0; i < meshlet.vertex_count; ++i)
            radius = std::max(radius, glm::distance(position(vertices[i]), vec(cluster.centre)));
        cluster.radius = float(radius * outward);
        const double sine = sine_of_cone(meshlet, vertices, corners, vec(cluster.axis));
        cluster.sin_cone = float(std::min(1.0, sine * outward + 1e-5));
    }

    /// Sine of the largest angle between the axis and a normal; 1 where one is not on its side.
    double sine_of_cone(const meshopt_Meshlet& meshlet, const unsigned int* vertices,
                        const unsigned char* corners, const glm::dvec3& axis) const {
        if (!(glm::length(axis) > 0.5)) return 1;
        const glm::dvec3 a = glm::normalize(axis);
        double sine = 0;
        for (const unsigned char* l = corners; l != corners + 3 * meshlet.triangle_count; l += 3) {
            const glm::dvec3 p = position(vertices[l[0]]);
            const glm::dvec3 n =
                glm::cross(position(vertices[l[1]]) - p, position(vertices[l[2]]) - p);
            if (!(glm::length(n) > 0)) continue;  // least_height is 0
            if (!(glm::dot(n, a) > 0)) return 1;
            sine = std::max(sine, glm::length(glm::cross(n, a)) / glm::length(n));
        }
        return sine;
    }

    const Mesh& mesh_;
    std::vector<float> position_;
    ClusteredMesh out_;
};

}  // namespace

ClusteredMesh build_clusters(const Mesh& mesh) {
    const std::vector<std::uint32_t> order = triangles_by_material(mesh);
    const auto material = [&](std::size_t i) {
        return mesh.face_material[mesh.triangle_face[order[i]]];
    };
    Builder builder(mesh);
    for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
        for (end = begin + 1; end < order.size() && material(end) == material(begin);) ++end;
        builder.cut(order.data() + begin, order.data() + end, material(begin));
    }
    return builder.take();
}

const ClusteredMesh& clusters_of(const Mesh& mesh) {
    SCANSHADE_CHECK(mesh.cluster_cache != nullptr);
    ClusterCache& cache = *mesh.cluster_cache;
    std::call_once(cache.once, [&] { cache.clusters = build_clusters(mesh); });
    return cache.clusters;
}

}  // namespace scanshade

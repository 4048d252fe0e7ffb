// Clusters of a mesh: the same triangles again, with bounds that hold.
#include "scanshade/scene/clusters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/base/timer.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random_mesh.hpp"

using namespace scanshade;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The least corner first, so that triangles are compared whatever corner they begin with.
Triangle from_least(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

/// A triangle slot's corners in the mesh.
Triangle corners_of(const ClusteredMesh& mesh, const Cluster& cluster, std::uint32_t t) {
    const std::uint32_t packed = mesh.corners[cluster.first_face + t];
    Triangle out{};
    for (int k = 0; k < 3; ++k)
        out[std::size_t(k)] = mesh.vertex[cluster.first_vertex + (packed >> (k * corner_bits) &
                                                                  (max_cluster_vertices - 1))];
    return out;
}

glm::dvec3 position(const Mesh& mesh, std::uint32_t v) {
    return {double(mesh.x[v]), double(mesh.y[v]), double(mesh.z[v])};
}

/// What is wrong with a cluster's triangles; counts how often each of the mesh's is there.
std::string check_triangles(const Mesh& mesh, const ClusteredMesh& clusters, const Cluster& cluster,
                            std::vector<int>& times) {
    for (std::uint32_t t = 0; t < cluster.face_count; ++t) {
        const std::uint32_t number = clusters.triangle[cluster.first_face + t];
        if (number >= mesh.triangle_count()) return "a number that no triangle has";
        ++times[number];
        if (from_least(corners_of(clusters, cluster, t)) != from_least(mesh.triangle[number]))
            return "a triangle's corners are not the mesh's";
        if (mesh.face_material[mesh.triangle_face[number]] != cluster.material)
            return "a triangle of another material";
        if (clusters.corners[cluster.first_face + t] >> number_shift != t)
            return "a triangle's place is not its number";
    }
    return "";
}

/// What is wrong with a cluster's numbers and padding.
std::string check_slots(const Mesh& mesh, const ClusteredMesh& clusters, const Cluster& cluster) {
    if (cluster.vertex_count == 0 || cluster.vertex_count > max_cluster_vertices ||
        cluster.face_count == 0 || cluster.face_count > max_cluster_triangles)
        return "too many or too few";
    if (cluster.first_vertex % cluster_padding != 0 || cluster.first_face % cluster_padding != 0)
        return "does not begin on whole groups";
    for (std::uint32_t i = 0;
         i < (cluster.vertex_count + cluster_padding - 1) / cluster_padding * cluster_padding;
         ++i) {
        const std::uint32_t slot = cluster.first_vertex + i;
        const std::uint32_t v = clusters.vertex[slot];
        if (i >= cluster.vertex_count && v != clusters.vertex[cluster.first_vertex])
            return "padding is not the first vertex";
        if (clusters.x[slot] != mesh.x[v] || clusters.y[slot] != mesh.y[v] ||
            clusters.z[slot] != mesh.z[v] || clusters.u[slot] != mesh.u[v] ||
            clusters.v[slot] != mesh.v[v])
            return "a slot is not its vertex";
    }
    for (std::uint32_t t = cluster.face_count; t % cluster_padding != 0; ++t)
        if (clusters.triangle[cluster.first_face + t] != no_index ||
            clusters.corners[cluster.first_face + t] != 0)
            return "triangles' padding has an area";
    return "";
}

/// What is wrong with a cluster's sphere, cone and least height.
std::string check_bounds(const Mesh& mesh, const ClusteredMesh& clusters, const Cluster& cluster) {
    const glm::dvec3 centre(cluster.centre[0], cluster.centre[1], cluster.centre[2]);
    const glm::dvec3 axis(cluster.axis[0], cluster.axis[1], cluster.axis[2]);
    for (std::uint32_t t = 0; t < cluster.face_count; ++t) {
        const Triangle corner = corners_of(clusters, cluster, t);
        const glm::dvec3 p[3] = {position(mesh, corner[0]), position(mesh, corner[1]),
                                 position(mesh, corner[2])};
        for (const glm::dvec3& q : p)
            if (glm::distance(q, centre) > double(cluster.radius))
                return "a vertex is outside of the sphere";
        const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double longest = std::max(
            {glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
        if (longest > 0 && glm::length(n) / longest < double(cluster.least_height))
            return "a triangle is lower than the least height";
        if (longest == 0 && cluster.least_height > 0) return "a point has a height";
        if (cluster.sin_cone >= 1 || glm::length(n) == 0) continue;
        const double sine = glm::length(glm::cross(n, axis)) / (glm::length(n) * glm::length(axis));
        if (!(glm::dot(n, axis) > 0) || sine > double(cluster.sin_cone))
            return "a normal is outside of the cone";
    }
    return "";
}

/// What is wrong with a cluster's whole faces, their sphere and their cone; counts each of the mesh's.
std::string check_whole_faces(const Mesh& mesh, const ClusteredMesh& clusters,
                              const Cluster& cluster, std::vector<int>& times) {
    const glm::dvec3 centre(cluster.centre[0], cluster.centre[1], cluster.centre[2]);
    const glm::dvec3 axis(cluster.axis[0], cluster.axis[1], cluster.axis[2]);
    for (std::uint32_t f = 0; f < cluster.face_count; ++f) {
        const std::uint32_t first = clusters.triangle[cluster.first_face + f];
        const std::uint32_t face = mesh.triangle_face[first];
        ++times[face];
        if (first != mesh.face_first_triangle[face]) return "not the face's first triangle";
        if (mesh.corner_count(face) != cluster.corners) return "of other faces";
        if (mesh.face_material[face] != cluster.material) return "a face of another material";
        const std::uint32_t packed = clusters.corners[cluster.first_face + f];
        for (std::uint32_t k = 0; k < cluster.corners; ++k) {
            const std::uint32_t slot =
                packed >> (k * std::uint32_t(corner_bits)) & (max_cluster_vertices - 1);
            const std::uint32_t v = mesh.corner[mesh.face_begin[face] + k];
            if (clusters.vertex[cluster.first_vertex + slot] != v)
                return "a face's corners are not the mesh's";
            if (glm::distance(position(mesh, v), centre) > double(cluster.radius))
                return "a vertex is outside of the sphere";
        }
        for (std::uint32_t t = first; t < mesh.face_first_triangle[face + 1]; ++t) {
            const auto& [a, b, c] = mesh.triangle[t];
            const glm::dvec3 p = position(mesh, a);
            const glm::dvec3 n = glm::cross(position(mesh, b) - p, position(mesh, c) - p);
            if (cluster.sin_cone >= 1 || glm::length(n) == 0) continue;
            const double sine =
                glm::length(glm::cross(n, axis)) / (glm::length(n) * glm::length(axis));
            if (!(glm::dot(n, axis) > 0) || sine > double(cluster.sin_cone))
                return "a normal is outside of the cone";
        }
    }
    return "";
}

/// What is wrong with a mesh's clusters; "" where each triangle is in one, as it should be.
std::string wrong(const Mesh& mesh, const ClusteredMesh& clusters) {
    std::vector<int> times(mesh.triangle_count());
    for (const Cluster& cluster : clusters.clusters) {
        std::string fault = check_slots(mesh, clusters, cluster);
        if (fault.empty()) fault = check_triangles(mesh, clusters, cluster, times);
        if (fault.empty()) fault = check_bounds(mesh, clusters, cluster);
        if (!fault.empty()) return fault;
    }
    const bool once = std::all_of(times.begin(), times.end(), [](int n) { return n == 1; });
    return once ? "" : "a triangle is not there once";
}

}  // namespace

TEST_CASE("clusters hold each triangle once, under bounds that contain it", "[engine][clusters]") {
    int with_cone = 0, clusters_seen = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Rng rng(seed);
        const auto mesh = make_random_mesh(rng, std::uint32_t(rng.integer(1, 4)));
        const ClusteredMesh clusters = build_clusters(*mesh);
        for (const Cluster& cluster : clusters.clusters) with_cone += cluster.sin_cone < 1;
        clusters_seen += int(clusters.clusters.size());
        CAPTURE(seed, mesh->name);
        CHECK(wrong(*mesh, clusters) == "");
    }
    CHECK(with_cone > 100);
    CHECK(clusters_seen > 1000);
}

TEST_CASE(
    "clusters of whole faces hold each triangle and quadrilateral once, and leave out the others",
    "[engine][clusters]") {
    std::size_t quads = 0, left_out = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Rng rng(seed);
        const auto mesh = make_random_mesh(rng, std::uint32_t(rng.integer(1, 4)));
        const ClusteredMesh whole = build_whole_clusters(*mesh, build_clusters(*mesh));
        CAPTURE(seed, mesh->name);
        std::vector<int> times(mesh->face_count());
        for (const std::uint32_t face : whole.left_out) {
            CHECK(mesh->corner_count(face) > 4);
            ++times[face], ++left_out;
        }
        for (const Cluster& cluster : whole.clusters) {
            CHECK(check_slots(*mesh, whole, cluster) == "");
            CHECK(check_whole_faces(*mesh, whole, cluster, times) == "");
            quads += cluster.corners == 4 ? cluster.face_count : 0;
        }
        CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    }
    CHECK(quads > 1000);
    CHECK(left_out > 100);
}

TEST_CASE("copies of a mesh share the clusters that were cut once", "[engine][clusters]") {
    Rng rng(3);
    const auto mesh = make_random_mesh(rng, 1);
    const std::vector<Mesh> copies(2, *mesh);
    for (const Mesh& copy : copies) CHECK(&clusters_of(*mesh) == &clusters_of(copy));
}

TEST_CASE("a hundred thousand triangles around one vertex, and as many on one place",
          "[engine][clusters][extremes]") {
    constexpr std::uint32_t n = 100'000;
    std::vector<glm::dvec3> ring{{0, 0, 1}};
    std::vector<std::vector<std::uint32_t>> fan, pile(n, {0, 1, n / 3});
    for (std::uint32_t i = 0; i < n; ++i) {
        ring.push_back({std::cos(i * 2 * pi / n), std::sin(i * 2 * pi / n), 0});
        fan.push_back({0, 1 + i, 1 + (i + 1) % n});
    }
    const auto time = [](const Mesh& mesh) {
        const Timer timer;
        CHECK(wrong(mesh, build_clusters(mesh)) == "");
        return timer.ms();
    };
    const double ordinary = time(build_mesh(find_shape("plane")->make(224), {}));
    // What grows with the square takes a hundred times as long.
    CHECK(time(build_mesh(make_soup(ring, fan), {})) <= 20 * ordinary);
    CHECK(time(build_mesh(make_soup(ring, pile), {})) <= 20 * ordinary);
}

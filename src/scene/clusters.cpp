#include "scanshade/scene/clusters.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <numeric>

#include "scanshade/base/error.hpp"
#include "scene/cluster_builder.hpp"

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

/// Cuts the triangles [begin, end), all of one material.
void cut(const Mesh& mesh, const std::uint32_t* begin, const std::uint32_t* end,
         ClusterBuilder& builder) {
    std::vector<unsigned int> index;
    for (const std::uint32_t* t = begin; t != end; ++t)
        index.insert(index.end(), mesh.triangle[*t].begin(), mesh.triangle[*t].end());
    const std::size_t most =
        meshopt_buildMeshletsBound(index.size(), max_cluster_vertices, max_cluster_triangles);
    std::vector<meshopt_Meshlet> meshlets(most);
    std::vector<unsigned int> vertices(most * max_cluster_vertices);
    std::vector<unsigned char> corners(most * max_cluster_triangles * 3);
    if (has_hub(index, mesh.vertex_count()))  // as they come
        meshlets.resize(meshopt_buildMeshletsScan(meshlets.data(), vertices.data(), corners.data(),
                                                  index.data(), index.size(), mesh.vertex_count(),
                                                  max_cluster_vertices, max_cluster_triangles));
    else
        meshlets.resize(meshopt_buildMeshlets(
            meshlets.data(), vertices.data(), corners.data(), index.data(), index.size(),
            builder.positions().data(), mesh.vertex_count(), 3 * sizeof(float),
            max_cluster_vertices, max_cluster_triangles, cone_weight));
    TriangleNumbers numbers(mesh, begin, end);
    for (const meshopt_Meshlet& meshlet : meshlets) {
        ClusterPiece piece{mesh.face_material[mesh.triangle_face[*begin]], 3, {}, {}, {}, {}};
        const unsigned int* v = &vertices[meshlet.vertex_offset];
        const unsigned char* l = &corners[meshlet.triangle_offset];
        piece.vertex.assign(v, v + meshlet.vertex_count);
        piece.corner.assign(l, l + 3 * meshlet.triangle_count);
        piece.triangle_corner = piece.corner;
        for (unsigned int t = 0; t < meshlet.triangle_count; ++t, l += 3)
            piece.number.push_back(numbers.take({v[l[0]], v[l[1]], v[l[2]]}));
        builder.add(piece);
    }
}

}  // namespace

ClusteredMesh build_clusters(const Mesh& mesh) {
    const std::vector<std::uint32_t> order = triangles_by_material(mesh);
    const auto material = [&](std::size_t i) {
        return mesh.face_material[mesh.triangle_face[order[i]]];
    };
    ClusterBuilder builder(mesh);
    for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
        for (end = begin + 1; end < order.size() && material(end) == material(begin);) ++end;
        cut(mesh, order.data() + begin, order.data() + end, builder);
    }
    return builder.take();
}

const ClusteredMesh& clusters_of(const Mesh& mesh, bool whole) {
    SCANSHADE_CHECK(mesh.cluster_cache != nullptr);
    ClusterCache& cache = *mesh.cluster_cache;
    std::call_once(cache.once, [&] { cache.clusters = build_clusters(mesh); });
    if (!whole || !mesh.has_polygons) return cache.clusters;
    std::call_once(cache.once_whole,
                   [&] { cache.whole = build_whole_clusters(mesh, cache.clusters); });
    return cache.whole;
}

}  // namespace scanshade

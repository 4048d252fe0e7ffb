#include "scanshade/scene/clusters.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <numeric>
#include <span>

#include "scanshade/base/error.hpp"
#include "scanshade/base/parallel.hpp"
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

/// Triangles that are cut at once. Parts of a mesh are cut side by side, and faster than the whole:
/// what is looked up stays in the caches.
constexpr std::size_t chunk_triangles = 1 << 14;

/// The mesh's triangles by material; of one material in chunks that are compact in space, unless one
/// is enough.
class Chunks {
public:
    explicit Chunks(const Mesh& mesh) : mesh_(mesh), order_(mesh.triangle_count()) {
        std::iota(order_.begin(), order_.end(), 0u);
        const auto by_material = [&](std::uint32_t a, std::uint32_t b) {
            return material(a) < material(b);
        };
        if (!std::is_sorted(order_.begin(), order_.end(), by_material))
            std::stable_sort(order_.begin(), order_.end(), by_material);
        for (std::size_t begin = 0, end; begin < order_.size(); begin = end) {
            for (end = begin + 1;
                 end < order_.size() && material(order_[end]) == material(order_[begin]);)
                ++end;
            if (end - begin > chunk_triangles) sort_in_space(begin, end);
            for (; begin < end; begin = std::min(begin + chunk_triangles, end))
                first_.push_back(begin);
        }
        first_.push_back(order_.size());
    }

    std::size_t count() const { return first_.size() - 1; }
    std::span<const std::uint32_t> chunk(std::size_t i) const {
        return std::span(order_).subspan(first_[i], first_[i + 1] - first_[i]);
    }

private:
    std::uint32_t material(std::uint32_t t) const {
        return mesh_.face_material[mesh_.triangle_face[t]];
    }

    /// Along a curve that fills space.
    void sort_in_space(std::size_t begin, std::size_t end) {
        std::vector<float> centre;
        centre.reserve(3 * (end - begin));
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [a, b, c] = mesh_.triangle[order_[i]];
            for (const std::vector<float>* axis : {&mesh_.x, &mesh_.y, &mesh_.z})
                centre.push_back((*axis)[a] + (*axis)[b] + (*axis)[c]);
        }
        std::vector<unsigned int> place(end - begin);
        meshopt_spatialSortRemap(place.data(), centre.data(), end - begin, 3 * sizeof(float));
        std::vector<std::uint32_t> sorted(end - begin);
        for (std::size_t i = 0; i < place.size(); ++i) sorted[place[i]] = order_[begin + i];
        std::copy(sorted.begin(), sorted.end(), order_.begin() + std::ptrdiff_t(begin));
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> first_;  // [chunk], and the end
};

/// The place among the chunk's triangles of each one that meshoptimizer gives back: it keeps the
/// corners' order but not the triangle's number. Equal triangles are told apart by taking each once.
class TrianglePlaces {
public:
    using Key = std::array<unsigned int, 3>;

    /// index: three vertices a triangle.
    explicit TrianglePlaces(std::span<const unsigned int> index)
        : bits_(int(std::bit_width(index.size() / 3))),
          first_((std::size_t{1} << bits_) + 1),
          rows_(index.size() / 3) {
        const auto key = [&](std::size_t t) {
            return rotated({index[3 * t], index[3 * t + 1], index[3 * t + 2]});
        };
        for (std::size_t t = 0; t < rows_.size(); ++t) ++first_[hash(key(t)) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next = first_;
        for (std::uint32_t t = 0; t < rows_.size(); ++t) rows_[next[hash(key(t))]++] = {key(t), t};
    }

    std::uint32_t take(const Key& corners) {
        const Key wanted = rotated(corners);
        std::uint32_t& first = first_[hash(wanted)];
        Row* row = &rows_[first];
        while (row->corners != wanted) ++row;
        // The first of those that are left takes its row.
        const std::uint32_t place = row->place;
        *row = rows_[first++];
        return place;
    }

private:
    struct Row {
        Key corners;
        std::uint32_t place;
    };
    /// The least first.
    static Key rotated(const Key& t) {
        const auto least = std::size_t(std::min_element(t.begin(), t.end()) - t.begin());
        return {t[least], t[(least + 1) % 3], t[(least + 2) % 3]};
    }
    /// Of all three: a fan has one corner in all of its triangles.
    std::size_t hash(const Key& t) const {
        std::uint64_t h = 0;
        for (const unsigned int corner : t) h = (h ^ corner) * 0x9e3779b97f4a7c15u;
        return std::size_t(h >> (64 - bits_));
    }
    int bits_;                          // of a hash
    std::vector<std::uint32_t> first_;  // [hash] row of the first triangle that is left
    std::vector<Row> rows_;
};

/// Cuts chunks, one after another.
class Cutter {
public:
    explicit Cutter(const Mesh& mesh) : mesh_(mesh), local_(mesh.vertex_count(), no_index) {}

    ClusteredMesh cut(std::span<const std::uint32_t> triangles) {
        collect(triangles);
        const std::size_t most =
            meshopt_buildMeshletsBound(index_.size(), max_cluster_vertices, max_cluster_triangles);
        std::vector<meshopt_Meshlet> meshlets(most);
        std::vector<unsigned int> vertices(most * max_cluster_vertices);
        std::vector<unsigned char> corners(most * max_cluster_triangles * 3);
        if (has_hub(index_, vertex_.size()))  // as they come
            meshlets.resize(meshopt_buildMeshletsScan(
                meshlets.data(), vertices.data(), corners.data(), index_.data(), index_.size(),
                vertex_.size(), max_cluster_vertices, max_cluster_triangles));
        else
            meshlets.resize(meshopt_buildMeshlets(
                meshlets.data(), vertices.data(), corners.data(), index_.data(), index_.size(),
                position_.data(), vertex_.size(), 3 * sizeof(float), max_cluster_vertices,
                max_cluster_triangles, cone_weight));
        TrianglePlaces places(index_);
        ClusterBuilder builder(mesh_);
        for (const meshopt_Meshlet& meshlet : meshlets) {
            const unsigned char* l = &corners[meshlet.triangle_offset];
            ClusterPiece piece{
                mesh_.face_material[mesh_.triangle_face[triangles[0]]], 3, {}, {}, {}, {}};
            const unsigned int* v = &vertices[meshlet.vertex_offset];
            for (unsigned int i = 0; i < meshlet.vertex_count; ++i)
                piece.vertex.push_back(vertex_[v[i]]);
            piece.corner.assign(l, l + 3 * meshlet.triangle_count);
            piece.triangle_corner = piece.corner;
            for (unsigned int t = 0; t < meshlet.triangle_count; ++t, l += 3)
                piece.number.push_back(triangles[places.take({v[l[0]], v[l[1]], v[l[2]]})]);
            builder.add(piece);
        }
        return builder.take();
    }

private:
    /// The triangles' corners, numbered among themselves.
    void collect(std::span<const std::uint32_t> triangles) {
        for (const std::uint32_t v : vertex_) local_[v] = no_index;
        index_.clear(), vertex_.clear(), position_.clear();
        for (const std::uint32_t t : triangles)
            for (const std::uint32_t v : mesh_.triangle[t]) {
                if (local_[v] == no_index) {
                    local_[v] = std::uint32_t(vertex_.size());
                    vertex_.push_back(v);
                    position_.insert(position_.end(), {mesh_.x[v], mesh_.y[v], mesh_.z[v]});
                }
                index_.push_back(local_[v]);
            }
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> local_;          // [the mesh's vertex] its number here
    std::vector<unsigned int> index_, vertex_;  // of the chunk; vertex_: the mesh's
    std::vector<float> position_;               // x, y, z by turns
};

}  // namespace

ClusteredMesh build_clusters(const Mesh& mesh) {
    const Chunks chunks(mesh);
    std::vector<ClusteredMesh> parts(chunks.count());
    std::vector<std::unique_ptr<Cutter>> cutters(static_cast<std::size_t>(available_threads()));
    parallel_for(parts.size(), 1, 0, [&](std::size_t begin, std::size_t end, int worker) {
        std::unique_ptr<Cutter>& cutter = cutters[std::size_t(worker)];
        if (!cutter) cutter = std::make_unique<Cutter>(mesh);
        for (std::size_t i = begin; i < end; ++i) parts[i] = cutter->cut(chunks.chunk(i));
    });
    ClusteredMesh all = joined(parts);
    pad_slots(all);
    return all;
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

// Clusters of faces as they stand in the file.
#include <algorithm>

#include "scene/cluster_builder.hpp"

namespace scanshade {
namespace {

/// Collects neighbouring faces of `corners` corners until a cluster is full.
class WholeFaces {
public:
    WholeFaces(const Mesh& mesh, std::uint32_t corners, ClusterBuilder& builder)
        : mesh_(mesh), builder_(builder), local_(mesh.vertex_count(), none) {
        piece_.corners = corners;
    }

    void add(std::uint32_t face) {
        const std::uint32_t* corner = mesh_.corner.data() + mesh_.face_begin[face];
        std::size_t fresh = 0;
        for (std::uint32_t k = 0; k < piece_.corners; ++k) fresh += local_[corner[k]] == none;
        const std::size_t triangles = piece_.triangle_corner.size() / 3 + piece_.corners - 2;
        if (mesh_.face_material[face] != piece_.material || triangles > max_cluster_triangles ||
            piece_.vertex.size() + fresh > max_cluster_vertices)
            finish();
        piece_.material = mesh_.face_material[face];
        for (std::uint32_t k = 0; k < piece_.corners; ++k)
            piece_.corner.push_back(local(corner[k]));
        const std::uint32_t first = mesh_.face_first_triangle[face];
        for (std::uint32_t t = first; t < mesh_.face_first_triangle[face + 1]; ++t)
            for (const std::uint32_t v : mesh_.triangle[t])
                piece_.triangle_corner.push_back(local(v));
        piece_.number.push_back(first);
    }

    void finish() {
        if (!piece_.number.empty()) builder_.add(piece_);
        for (const unsigned int v : piece_.vertex) local_[v] = none;
        piece_ = {0, piece_.corners, {}, {}, {}, {}};
    }

private:
    unsigned char local(std::uint32_t v) {
        if (local_[v] == none) {
            local_[v] = std::uint8_t(piece_.vertex.size());
            piece_.vertex.push_back(v);
        }
        return local_[v];
    }

    static constexpr std::uint8_t none = 0xff;
    const Mesh& mesh_;
    ClusterBuilder& builder_;
    ClusterPiece piece_{};
    std::vector<std::uint8_t> local_;  // [the mesh's vertex]
};

}  // namespace

ClusteredMesh build_whole_clusters(const Mesh& mesh, const ClusteredMesh& clusters) {
    ClusterBuilder builder(mesh);
    WholeFaces triangles(mesh, 3, builder), quads(mesh, 4, builder);
    for (const std::uint32_t t : clusters.triangle) {
        if (t == no_index) continue;
        const std::uint32_t face = mesh.triangle_face[t];
        if (mesh.face_first_triangle[face] != t) continue;
        const std::size_t corners = mesh.corner_count(face);
        if (corners == 3)
            triangles.add(face);
        else if (corners == 4)
            quads.add(face);
        else
            builder.leave_out(face);
    }
    triangles.finish();
    quads.finish();
    ClusteredMesh all = builder.take();
    pad_slots(all);
    return all;
}

}  // namespace scanshade

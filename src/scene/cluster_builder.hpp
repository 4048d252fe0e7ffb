// Makes clusters of pieces of a mesh: slots, packed faces, bounds.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scanshade/scene/clusters.hpp"

namespace scanshade {

/// What becomes a cluster.
struct ClusterPiece {
    std::uint32_t material, corners;             // of each face
    std::vector<unsigned int> vertex;            // the mesh's
    std::vector<unsigned char> corner;           // [face · corners] local vertices
    std::vector<unsigned char> triangle_corner;  // of the faces, cut: three each
    std::vector<std::uint32_t> number;           // [face] the mesh's triangle, the face's first
};

class ClusterBuilder {
public:
    explicit ClusterBuilder(const Mesh& mesh) : mesh_(mesh) {}

    void add(const ClusterPiece& piece);
    void leave_out(std::uint32_t face) { out_.left_out.push_back(face); }
    ClusteredMesh take() { return std::move(out_); }

private:
    void add_vertex(std::uint32_t v);
    void bound(const ClusterPiece& piece, Cluster& cluster) const;

    const Mesh& mesh_;
    ClusteredMesh out_;
};

/// All clusters of several parts of a mesh.
ClusteredMesh joined(const std::vector<ClusteredMesh>& parts);

/// Appends slots, so that max_cluster_vertices of them can be read from the first of any cluster.
void pad_slots(ClusteredMesh& mesh);

}  // namespace scanshade

// A mesh cut into small clusters: what the vector renderer reads.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <vector>

#include "scanshade/scene/mesh.hpp"

namespace scanshade {

/// A cluster's vertices and triangles are padded to whole groups of this many.
inline constexpr std::uint32_t cluster_padding = 16;
inline constexpr std::uint32_t max_cluster_vertices = 64;
inline constexpr std::uint32_t max_cluster_triangles = 112;

/// A triangle of a cluster in one number: its local vertices l0 | l1 << 6 | l2 << 12, a bit that is
/// free for others, and its place among the cluster's triangles from number_bit on.
inline constexpr int corner_bits = 6;
inline constexpr int number_shift = 3 * corner_bits + 1;
inline constexpr std::uint32_t number_bit = 1u << number_shift;
static_assert(max_cluster_vertices == 1u << corner_bits);

/// Neighbouring triangles of one material with at most 64 vertices.
struct Cluster {
    std::uint32_t first_vertex, first_triangle;  // slots, multiples of cluster_padding
    std::uint32_t vertex_count, triangle_count;  // without the padding
    std::uint32_t material;                      // the mesh's number
    std::array<float, 3> centre;                 // bounding sphere, units as the mesh's x, y, z
    float radius;
    std::array<float, 3> axis;  // every face normal is within the angle α of this unit vector
    float sin_cone;             // sin α; 1: the normals have no common side
    float least_height;         // smallest height of all triangles, 0 where one has no area
};

/// Slots repeat a mesh's vertices cluster by cluster. Padding repeats a cluster's first vertex, and
/// triangles of no area. Immutable once built.
struct ClusteredMesh {
    std::vector<Cluster> clusters;
    std::vector<float> x, y, z;           // [slot] as in the mesh
    std::vector<float> u, v;              // [slot]
    std::vector<std::uint32_t> vertex;    // [slot] the mesh's vertex
    std::vector<std::uint32_t> corners;   // [triangle slot] packed as above
    std::vector<std::uint32_t> triangle;  // [triangle slot] the mesh's triangle
};

/// Cuts along the mesh's triangulation; every triangle is in one cluster. O(triangles · log).
ClusteredMesh build_clusters(const Mesh& mesh);

/// The clusters of a mesh that build_mesh made: cut at the first call, by whichever thread, and
/// kept with the mesh.
const ClusteredMesh& clusters_of(const Mesh& mesh);

struct ClusterCache {
    std::once_flag once;
    ClusteredMesh clusters;
};

}  // namespace scanshade

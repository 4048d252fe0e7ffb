// A mesh cut into small clusters: what the vector renderer reads.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <vector>

#include "scanshade/base/memory.hpp"
#include "scanshade/scene/mesh.hpp"

namespace scanshade {

/// A cluster's vertices and faces are padded to whole groups of this many.
inline constexpr std::uint32_t cluster_padding = 16;
inline constexpr std::uint32_t max_cluster_vertices = 64;
inline constexpr std::uint32_t max_cluster_triangles = 112;

/// A face of a cluster in one number: its local vertices l0 | l1 << 6 | l2 << 12 | l3 << 18, a bit
/// that is free for others, and its place among the cluster's faces from number_bit on.
inline constexpr int corner_bits = 6;
inline constexpr int number_shift = 4 * corner_bits + 1;
inline constexpr std::uint32_t number_bit = 1u << number_shift;
inline constexpr std::uint32_t face_numbers = 1u << (32 - number_shift);
static_assert(max_cluster_vertices == 1u << corner_bits && max_cluster_triangles <= face_numbers);

/// Neighbouring faces of one material with at most 64 vertices, all triangles or all quadrilaterals.
struct Cluster {
    std::uint32_t first_vertex, first_face;  // slots, multiples of cluster_padding
    std::uint32_t vertex_count, face_count;  // without the padding
    std::uint32_t corners;                   // of each face: 3 or 4
    std::uint32_t material;                  // the mesh's number
    std::array<float, 3> centre;             // bounding sphere, units as the mesh's x, y, z
    float radius;
    std::array<float, 3> axis;  // every triangle's normal is within the angle α of this unit vector
    float sin_cone;             // sin α; 1: the normals have no common side
    float least_height;         // smallest height of all triangles, 0 where one has no area
};

/// Slots repeat a mesh's vertices cluster by cluster. Padding repeats a cluster's first vertex, and
/// faces of no area; at the end there are slots enough to read max_cluster_vertices from the first of
/// any cluster. Immutable once built.
struct ClusteredMesh {
    std::vector<Cluster> clusters;
    LargeVector<float> x, y, z;          // [slot] as in the mesh
    LargeVector<float> u, v;             // [slot]
    std::vector<std::uint32_t> vertex;   // [slot] the mesh's vertex
    LargeVector<std::uint32_t> corners;  // [face slot] packed as above
    LargeVector<std::uint32_t>
        triangle;  // [face slot] the mesh's triangle, a quadrilateral's first
    std::vector<std::uint32_t> left_out;  // the mesh's faces that are in no cluster
};

/// Cuts along the mesh's triangulation; every triangle is in one cluster. O(triangles · log).
ClusteredMesh build_clusters(const Mesh& mesh);

/// Keeps faces whole: clusters of triangles, clusters of quadrilaterals, and faces of more corners
/// left out. `clusters`: of the same mesh, for the order. O(corners).
ClusteredMesh build_whole_clusters(const Mesh& mesh, const ClusteredMesh& clusters);

/// The clusters of a mesh that build_mesh made, of triangles or of whole faces: made at the first
/// call, by whichever thread, and kept with the mesh.
const ClusteredMesh& clusters_of(const Mesh& mesh, bool whole = false);

struct ClusterCache {
    std::once_flag once, once_whole;
    ClusteredMesh clusters, whole;
};

}  // namespace scanshade

// Light at vertices and faces: the points, and where their radiance goes.
#pragma once

#include <cstdint>

#include "scanshade/scene/clusters.hpp"

namespace scanshade {

/// Points to light, one after another.
struct PointArrays {
    float *position[3], *normal[3];
};

/// A mesh's vertex slots in the world.
struct PlacedMesh {
    float to_world[3][4];
    const float* normal[3];  // [slot] unit
};

/// The faces of a cluster in the world, by their places in it; face_numbers of them can be read.
struct FaceArrays {
    const float *centre[3], *normal[3];
};

/// Radiance at the vertex slots of an object; seen from behind, `side` further on.
struct VertexLight {
    const float* radiance[3];
    std::uint32_t first;  // of the cluster's first slot
    std::uint32_t side;
};

/// The cluster_padding vertices from `slot` on.
void place_vertices(const ClusteredMesh& mesh, const PlacedMesh& placed, std::uint32_t slot,
                    bool back, const PointArrays& to);
/// The face that each of a batch is or belongs to, turned to the viewer.
void place_faces(const float* batch, const FaceArrays& faces, const PointArrays& to);

/// Planes of radiance from row `to` on, from those of the corners' weights at row `weights`.
void fill_lit(float* batch, int weights, int to, const VertexLight& light);
/// Radiance of a batch of fragments, in place of the corners' weights.
void fill_fragments_lit(float* batch, const VertexLight& light);
/// Radiance at the corners of a batch of quadrilaterals, from row `to` on.
void fill_quads_lit(float* batch, int to, const VertexLight& light);

}  // namespace scanshade

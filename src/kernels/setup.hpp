// Set-up: from clusters to batches and lists of tiles.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/batches.hpp"
#include "scanshade/base/events.hpp"
#include "scanshade/scene/settings.hpp"

namespace scanshade {

/// A face that set-up leaves to the driver.
struct SpecialFace {
    std::uint32_t object, triangle;  // the mesh's number; of a quadrilateral the first
};

/// What one worker of set-up has made.
struct SetupWorker {
    TileLists triangles;  // refs of batches
    TileLists fragments;  // ref of the first of some neighbours, and how many they are
    TileLists quads;      // refs of batches of quadrilaterals
    std::vector<SpecialFace> special;
    BatchRun batch_run, fragment_run, quad_run;  // what the worker has taken from the stores
    EventCounts events;
};

/// The picture as set-up sees it.
struct SetupView {
    float near, far, guard_band;
    float steepest;  // of planes_serve
    int width, height;
    int tile, tiles_x;       // side of a tile in samples, and how many are in a row
    int sample_x, sample_y;  // in 1/256 pixel
    bool orthographic;
    bool affine;  // values travel linearly on the picture: `edges`, and orthographic projection
    bool cull_back;
    Attributes attributes, quad_attributes;
};

/// What set-up stores for one material of a mesh.
struct SetupMaterial {
    std::uint32_t material;  // the scene's
    bool textured, store_normals, store_texcoords;
};

/// An object as set-up sees it.
struct SetupObject {
    const ClusteredMesh* mesh;
    const float* normal[3];                // [slot] unit, normalised world space
    const std::uint8_t* normals_disagree;  // [cluster] some are a right angle apart, or more
    std::uint32_t index;                   // of the object
    std::uint32_t first_triangle;
    float to_clip[4][4];  // rows x, y, d, w
    float to_world[3][4];
    bool mirrored;
    bool fragments;  // tiny triangles may become fragments: at samples nothing reads positions
    Shading shading;
    const SetupMaterial* material;  // [the mesh's material]
};

/// What set-up fills.
struct SetupStores {
    BatchStore &batches, &fragments, &quads;
};

/// Transforms, culls and sets up one cluster. `cluster`: its number in the object's mesh; clip: some
/// vertex may lie outside near, far or the guard band.
void setup_cluster(const SetupView& view, const SetupObject& object, std::uint32_t cluster,
                   bool clip, const SetupStores& to, SetupWorker& worker);

/// Asks for the numbers of a cluster that setup_cluster will read.
void prefetch_cluster(const SetupObject& object, std::uint32_t cluster);

/// Numbers in a vector of the instruction set in use; at most 16.
int vector_lanes();

}  // namespace scanshade

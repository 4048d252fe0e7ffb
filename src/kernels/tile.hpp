// Visibility inside one tile: what raster draws, and the depth and refs that it leaves.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/setup.hpp"

namespace scanshade {

inline constexpr int block_side = 4;  // a block of 4 × 4 samples is one cache line of depths
inline constexpr int block_samples = block_side * block_side;
inline constexpr int subtile_side = 16;
inline constexpr int tile_side = 64;  // the largest; see RasterView::tile
inline constexpr int tile_samples = tile_side * tile_side;
inline constexpr int tile_blocks = tile_samples / block_samples;

/// Index of a tile's sample: blocks row by row, samples of a block row by row.
constexpr int tile_index(int column, int row) {
    constexpr unsigned side = block_side, columns = tile_side / block_side, block = block_samples;
    const auto x = unsigned(column), y = unsigned(row);
    return int((y / side * columns + x / side) * block + y % side * side + x % side);
}

/// A triangle or polygon that set-up left to the driver: too large for small numbers, a needle,
/// clipped, or drawn whole. Pixels count from the picture's corner.
struct Record {
    enum class Coverage : std::uint8_t {
        edges,  // an unclipped triangle or quadrilateral: exact edge functions
        rows,   // any polygon: the scanline walker says which samples of a tile
    } coverage;
    enum class Depth : std::uint8_t {
        plane,    // c + (x X + y Y) from the origin
        spans,    // of a ScreenQuad
        weights,  // Σ λ_i z_i, λ_i from exact edge functions
        clipped,  // from homogeneous edge functions
        scalar,   // by the scalar renderers' own function
    } depth;
    bool affine;  // values travel linearly on the picture
    bool back;
    bool scalar;  // values by the scalar renderers' functions, which count what falls back
    bool normals_disagree;  // interpolated normals may vanish
    std::uint32_t id, object, material, triangle;
    int x0, y0, x1, y1;                            // samples that it may cover, both ends included
    int origin_x, origin_y;                        // of the planes
    int edge_count;                                // 3 or 4
    std::int64_t edge_x[4], edge_y[4], edge_c[4];  // ⌊(E − bias)/256⌋ at the origin, steps a pixel
    float weight_plane[3][3];  // plane: c, x, y of each corner's weight, times z in perspective
    float rows[most_rows];     // plane, spans: what a batch has of one face, without edges
    float nearest, farthest;   // bounds of the depth
    double weight_x[3], weight_y[3], weight_c[3];  // at pixel (0, 0), steps a pixel
    double inv_area;                               // weights: λ = float(weight · inv_area)
    double sum_to_inv_w;                           // clipped: 1/w = Σ weight · this
    std::uint8_t order[4];  // weights: of the sum; spans: the face's corners, clockwise
    float corner_depth[3];
    float corner_w[3];  // clipped: distance along the view
    float main[4][3], dark[4][3], texcoord[3][2], position[3][3];  // [corner]
    std::uint32_t first_point, point_count;  // rows: corners in RecordStore::points
};

/// Depth and refs of one tile. Subtiles are written when something needs them: until then `owner`
/// covers all of a subtile alone, or nothing does.
struct TileBuffer {
    static constexpr int subtiles = 16;
    alignas(64) float depth[tile_samples];
    alignas(64) std::uint32_t ref[tile_samples];
    std::uint32_t owner[subtiles];                // no_ref: nothing yet
    bool written[subtiles];                       // depth and ref hold the subtile
    float nearest[subtiles], farthest[subtiles];  // bounds of the depths of its samples

    bool shows(int subtile) const { return written[subtile] || owner[subtile] != no_ref; }
};

/// What drawing into a tile reads.
struct RasterView {
    const BatchStore *batches, *fragments, *quads;
    const Record* records;
    const SetupObject* objects;
    int sample_x, sample_y, width, height;
    int tile;  // side of a tile in samples: 16, 32 or tile_side; a buffer's rows keep their length
    float near, far;
    bool orthographic;
    /// Nothing reads depths and refs of a subtile that one record covers: resolve asks the record.
    bool leaves_owned;
    /// Whether the tiles of this size have that subtile.
    bool has_subtile(int subtile) const {
        return (subtile % 4) * subtile_side < tile && (subtile / 4) * subtile_side < tile;
    }
};

/// The triangle's number in the scene.
inline std::uint32_t ref_id(const RasterView& view, std::uint32_t ref) {
    if ((ref & record_bit) != 0) return view.records[ref & ~record_bit].id;
    const std::uint32_t lanes = view.batches->lanes(), at = ref & ~(fragment_bit | quad_bit);
    const bool fragment = (ref & fragment_bit) != 0, quad = (ref & quad_bit) != 0;
    const BatchStore& store = *(fragment ? view.fragments : quad ? view.quads : view.batches);
    const BatchInfo& info = store.info(at / lanes);
    const auto* rows = reinterpret_cast<const std::uint32_t*>(store.batch(at / lanes));
    const std::uint32_t face = rows[row_corners * lanes + at % lanes] >> number_shift;
    const SetupObject& object = view.objects[info.object];
    const ClusteredMesh& mesh = *object.mesh;
    return object.first_triangle + mesh.triangle[mesh.clusters[info.cluster].first_face + face];
}

void clear_tile(TileBuffer& tile);
/// Draws refs of SetupWorker::triangles into the tile whose corner is (x, y).
void raster_triangles(const RasterView& view, int x, int y, const std::uint32_t* refs,
                      std::uint32_t count, TileBuffer& tile);
/// Draws refs of SetupWorker::quads.
void raster_quads(const RasterView& view, int x, int y, const std::uint32_t* refs,
                  std::uint32_t count, TileBuffer& tile);
/// Draws the fragments of SetupWorker::fragments.
void raster_fragments(const RasterView& view, int x, int y, const std::uint32_t* runs,
                      std::uint32_t count, TileBuffer& tile);
/// Draws a record covered by edges.
void raster_record(const RasterView& view, int x, int y, std::uint32_t record, TileBuffer& tile);
/// Draws a record whose samples are given, a word for each row of the tile, bit 0 on the left.
/// depth: [tile_index] of Depth::scalar, else null.
void raster_rows(const RasterView& view, int x, int y, std::uint32_t record,
                 const std::uint64_t (&rows)[tile_side], const float* depth, TileBuffer& tile);
/// Writes the subtiles that one record owns, so that their depths and refs can be read, except for
/// those that resolve can do without. What has neither an owner nor been written afterwards is empty.
void complete_tile(const RasterView& view, int x, int y, TileBuffer& tile);

}  // namespace scanshade

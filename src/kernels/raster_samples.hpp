// Samples of a tile: who wins them, and subtiles that are written only when needed.
#if defined(SCANSHADE_KERNELS_RASTER_SAMPLES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RASTER_SAMPLES_HPP
#undef SCANSHADE_KERNELS_RASTER_SAMPLES_HPP
#else
#define SCANSHADE_KERNELS_RASTER_SAMPLES_HPP
#endif

#include "kernels/record_depth.hpp"
#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

constexpr int block_vectors = block_samples / N;  // vectors in a block
constexpr int tile_block_columns = tile_side / block_side;

/// Samples of a vector that nearer-or-older surfaces leave to a candidate with depths z.
/// Equal depth: the lower number in the file wins, whatever the order of drawing.
HWY_INLINE MaskF wins(const RasterView& view, VecF z, VecF there, MaskF inside,
                      const std::uint32_t* refs, std::uint32_t ref) {
    const MaskF nearer = hn::And(inside, hn::Gt(z, there));
    const MaskF equal = hn::And(inside, hn::Eq(z, there));
    if (hn::AllFalse(tag_f, equal)) return nearer;
    alignas(64) float older[N] = {};
    const std::uint32_t id = ref_id(view, ref);
    for_each_lane(mask_bits(tag_f, equal), [&](std::uint32_t lane) {
        older[lane] = refs[lane] == no_ref || ref_id(view, refs[lane]) > id ? 1.0f : 0.0f;
    });
    return hn::Or(nearer, hn::And(equal, hn::Gt(hn::Load(tag_f, older), hn::Zero(tag_f))));
}

/// Puts a candidate into a vector of samples.
HWY_INLINE void put(const RasterView& view, VecF z, MaskF inside, std::uint32_t ref, float* depth,
                    std::uint32_t* refs) {
    const VecF there = hn::Load(tag_f, depth);
    const MaskF win = wins(view, z, there, inside, refs, ref);
    hn::Store(hn::IfThenElse(win, z, there), tag_f, depth);
    const VecI old = hn::Load(tag_i, as_int(refs));
    hn::Store(hn::IfThenElse(hn::RebindMask(tag_i, win), hn::Set(tag_i, std::int32_t(ref)), old),
              tag_i, as_int(refs));
}

/// Column and row of a block's samples, vector by vector.
struct BlockGrid {
    alignas(64) float x[block_samples] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) float y[block_samples] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
};
constexpr BlockGrid grid;

inline int block_at(int column, int row) {
    return (row * tile_block_columns + column) * block_samples;
}

// ---- subtiles: whole 16 × 16 samples that are written only when needed

inline int subtile_block(int subtile, int block) {
    return block_at((subtile % 4) * 4 + block % 4, (subtile / 4) * 4 + block / 4);
}

inline void write_subtile(const RasterView& view, int tile_x, int tile_y, int subtile,
                          TileBuffer& tile) {
    if (tile.written[subtile]) return;
    tile.written[subtile] = true;
    const std::uint32_t owner = tile.owner[subtile];
    for (int block = 0; block < 16; ++block) {
        const int at = subtile_block(subtile, block);
        const int x = tile_x + (subtile % 4) * subtile_side + (block % 4) * block_side;
        const int y = tile_y + (subtile / 4) * subtile_side + (block / 4) * block_side;
        for (int v = 0; v < block_vectors; ++v) {
            const VecF z = owner == no_ref ? hn::Zero(tag_f)
                                           : record_depth(view, view.records[owner & ~record_bit],
                                                          block_positions(x, y, v));
            hn::Store(z, tag_f, tile.depth + at + v * N);
            hn::Store(hn::Set(tag_i, std::int32_t(owner)), tag_i, as_int(tile.ref + at + v * N));
        }
    }
}

inline void write_all(const RasterView& view, int tile_x, int tile_y, TileBuffer& tile) {
    for (int s = 0; s < TileBuffer::subtiles; ++s)
        if (view.has_subtile(s)) write_subtile(view, tile_x, tile_y, s, tile);
}

inline void write_owned(const RasterView& view, int tile_x, int tile_y, TileBuffer& tile) {
    for (int s = 0; s < TileBuffer::subtiles; ++s) {
        if (tile.written[s] || tile.owner[s] == no_ref) continue;
        const Record& owner = view.records[tile.owner[s] & ~record_bit];
        const bool has_rows =
            owner.depth == Record::Depth::plane || owner.depth == Record::Depth::spans;
        if (view.leaves_owned && has_rows && !owner.scalar && !owner.normals_disagree) continue;
        write_subtile(view, tile_x, tile_y, s, tile);
    }
}

SCANSHADE_TARGET_END;

#endif

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

/// Puts a candidate into a vector of samples where it is nearer, or as near and lower in number than
/// what is there: the order of drawing changes nothing.
HWY_NOINLINE void put_tied(const RasterView& view, VecF z, MaskF inside, std::uint32_t ref,
                           float* depth, std::uint32_t* refs) {
    const std::uint32_t id = ref_id(view, ref);
    const VecF there = hn::Load(tag_f, depth);
    const std::uint32_t nearer = mask_bits(tag_f, hn::And(inside, hn::Gt(z, there)));
    alignas(64) float candidate[N];
    hn::Store(z, tag_f, candidate);
    for_each_lane(mask_bits(tag_f, hn::And(inside, hn::Ge(z, there))), [&](std::uint32_t lane) {
        if ((nearer >> lane & 1) == 0 && refs[lane] != no_ref && ref_id(view, refs[lane]) <= id)
            return;
        depth[lane] = candidate[lane];
        refs[lane] = ref;
    });
}

/// The same where no depth is equal, as nearly everywhere; else asks for the above.
SCANSHADE_INLINE void put(const RasterView& view, VecF z, MaskF inside, std::uint32_t ref,
                          float* depth, std::uint32_t* refs) {
    const VecF there = hn::Load(tag_f, depth);
    if (HWY_UNLIKELY(!hn::AllFalse(tag_f, hn::And(inside, hn::Eq(z, there)))))
        return put_tied(view, z, inside, ref, depth, refs);
    const MaskF win = hn::And(inside, hn::Gt(z, there));
    hn::Store(hn::IfThenElse(win, z, there), tag_f, depth);
    const VecI old = hn::Load(tag_i, as_int(refs));
    hn::Store(hn::IfThenElse(hn::RebindMask(tag_i, win), hn::Set(tag_i, std::int32_t(ref)), old),
              tag_i, as_int(refs));
}

constexpr int block_at(int column, int row) {
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

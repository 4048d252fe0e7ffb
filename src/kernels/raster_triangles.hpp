// Triangles of batches and fragments, drawn into a tile.
#if defined(SCANSHADE_KERNELS_RASTER_TRIANGLES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RASTER_TRIANGLES_HPP
#undef SCANSHADE_KERNELS_RASTER_TRIANGLES_HPP
#else
#define SCANSHADE_KERNELS_RASTER_TRIANGLES_HPP
#endif

#include "kernels/raster_samples.hpp"
#include "kernels/screen_plane.hpp"

SCANSHADE_TARGET_BEGIN;

/// One triangle of a batch. Its numbers are read where they are needed: most operations take one
/// from memory for all lanes as fast as a register.
class BatchTriangle {
public:
    HWY_INLINE BatchTriangle(const BatchStore& store, std::uint32_t ref)
        : at_(store.batch(ref / std::uint32_t(N)) + ref % std::uint32_t(N)) {}

    HWY_INLINE float row(int r) const { return at_[r * N]; }
    HWY_INLINE int origin_x() const { return int(row(row_origin_x)); }
    HWY_INLINE int origin_y() const { return int(row(row_origin_y)); }
    std::uint32_t extent() const {
        std::uint32_t bits;
        std::memcpy(&bits, at_ + row_extent * N, sizeof bits);
        return bits;
    }

    /// Edge function k at (x, y) from the origin; exact, fused or not.
    HWY_INLINE VecF edge(int k, VecF x, VecF y) const {
        return hn::MulAdd(hn::Set(tag_f, row(row_edges + k)), x,
                          hn::MulAdd(hn::Set(tag_f, row(row_edges + 3 + k)), y,
                                     hn::Set(tag_f, row(row_edges + 6 + k))));
    }

    /// Vector v of the block whose corner is (X, Y) pixels from the origin.
    struct Candidate {
        VecF z;
        MaskF inside;
    };
    HWY_INLINE Candidate candidate(float X, float Y, int v) const {
        const VecF x = hn::Add(hn::Load(tag_f, grid.x + v * N), hn::Set(tag_f, X));
        const VecF y = hn::Add(hn::Load(tag_f, grid.y + v * N), hn::Set(tag_f, Y));
        const VecF least = hn::Min(edge(0, x, y), hn::Min(edge(1, x, y), edge(2, x, y)));
        const ScreenPlane<Lanes> depth = {Lanes(row(row_depth)), Lanes(row(row_depth + 1)),
                                          Lanes(row(row_depth + 2))};
        return {plane_value(depth, Lanes(x), Lanes(y)).v, hn::Ge(least, hn::Zero(tag_f))};
    }

    /// That block; `at`: its index in the tile.
    HWY_INLINE void draw(const RasterView& view, float X, float Y, std::uint32_t ref, int at,
                         TileBuffer& tile) const {
        for (int v = 0; v < block_vectors; ++v) {
            const Candidate c = candidate(X, Y, v);
            put(view, c.z, c.inside, ref, tile.depth + at + v * N, tile.ref + at + v * N);
        }
    }

    /// 2 × 2 blocks from the origin on, all without asking: a mispredicted branch costs more than an
    /// empty block. First all values, which nothing that is stored can change.
    HWY_INLINE void draw_four(const RasterView& view, std::uint32_t ref, int at,
                              TileBuffer& tile) const {
        for (int v = 0; v < block_vectors; ++v) {
            const Candidate c[4] = {candidate(0, 0, v), candidate(4, 0, v), candidate(0, 4, v),
                                    candidate(4, 4, v)};
            for (int i = 0; i < 4; ++i) {
                const int to = at + (i / 2 * tile_block_columns + i % 2) * block_samples + v * N;
                put(view, c[i].z, c[i].inside, ref, tile.depth + to, tile.ref + to);
            }
        }
    }

private:
    const float* at_;
};

/// Blocks from a tile to an origin, which lies on their grid; negative in another tile.
inline int blocks_from(int tile, int origin) { return (origin - tile) >> 2; }

inline void draw_tiny(const RasterView& view, int x, int y, const std::uint32_t* refs,
                      std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; ++i) {
        const BatchTriangle t(*view.batches, refs[i]);
        t.draw(view, 0, 0, refs[i],
               block_at(blocks_from(x, t.origin_x()), blocks_from(y, t.origin_y())), tile);
    }
}

inline void draw_small(const RasterView& view, int x, int y, const std::uint32_t* refs,
                       std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; ++i) {
        const BatchTriangle t(*view.batches, refs[i]);
        const int at = block_at(blocks_from(x, t.origin_x()), blocks_from(y, t.origin_y()));
        // What lies beyond the tile's edge is in no triangle of this list.
        t.draw_four(view, refs[i], at, tile);
    }
}

/// Blocks of medium triangles in two passes: first which ones a triangle may touch, 4 × 4 blocks at
/// once, then one after another. No branch depends on a triangle's shape.
class BlockQueue {
public:
    BlockQueue(const RasterView& view, int x, int y, const std::uint32_t* refs, TileBuffer& tile)
        : view_(view), x_(x), y_(y), refs_(refs), tile_(tile) {}

    /// Queues the blocks of refs[i].
    HWY_INLINE void add(std::uint32_t i) {
        const BatchTriangle t(*view_.batches, refs_[i]);
        const std::uint32_t extent = t.extent();
        const int column = blocks_from(x_, t.origin_x()), row = blocks_from(y_, t.origin_y());
        const int last = view_.tile / block_side - 1;  // of the tile
        const int last_column = std::min(column + int(extent & 0xffff), last);
        const int last_row = std::min(row + int(extent >> 16), last);
        for (int r = std::max(row, 0); r <= last_row; r += 4)
            for (int c = std::max(column, 0); c <= last_column; c += 4)
                add_window(t, i, c, r, c - column, r - row, last_column, last_row);
    }

    HWY_INLINE void draw() {
        for (std::uint32_t k = 0; k < count_; ++k) {
            const std::uint32_t item = std::uint32_t(queue_[k]);
            const std::uint32_t ref = refs_[item >> item_shift];
            const int block = int(item & (tile_blocks - 1));
            const BatchTriangle t(*view_.batches, ref);
            const int column = block % tile_block_columns, row = block / tile_block_columns;
            const float X = float(column * block_side + x_) - t.row(row_origin_x);
            const float Y = float(row * block_side + y_) - t.row(row_origin_y);
            t.draw(view_, X, Y, ref, block * block_samples, tile_);
        }
        count_ = 0;
    }

private:
    static constexpr int item_shift = 8;
    static_assert(tile_blocks == 1 << item_shift);
    static constexpr std::uint32_t capacity = 1024;

    /// The window of 4 × 4 blocks at (column, row) of the tile, (dc, dr) blocks from the origin.
    HWY_INLINE void add_window(const BatchTriangle& t, std::uint32_t i, int column, int row, int dc,
                               int dr, int last_column, int last_row) {
        if (count_ + block_samples > capacity) draw();
        for (int v = 0; v < block_vectors; ++v) {
            const VecF c = hn::Load(tag_f, grid.x + v * N), r = hn::Load(tag_f, grid.y + v * N);
            const VecF X = hn::Mul(hn::Add(c, hn::Set(tag_f, float(dc))), hn::Set(tag_f, 4.0f));
            const VecF Y = hn::Mul(hn::Add(r, hn::Set(tag_f, float(dr))), hn::Set(tag_f, 4.0f));
            VecF least = hn::Set(tag_f, 1e9f);
            for (int k = 0; k < 3; ++k) {
                // The largest value in a block is at the corner that the gradient points to.
                const float A = t.row(row_edges + k), B = t.row(row_edges + 3 + k);
                const float at_corner =
                    t.row(row_edges + 6 + k) + 3 * (std::max(A, 0.0f) + std::max(B, 0.0f));
                const VecF value =
                    hn::MulAdd(hn::Set(tag_f, A), X,
                               hn::MulAdd(hn::Set(tag_f, B), Y, hn::Set(tag_f, at_corner)));
                least = hn::Min(least, value);
            }
            const MaskF in_box = hn::And(hn::Le(c, hn::Set(tag_f, float(last_column - column))),
                                         hn::Le(r, hn::Set(tag_f, float(last_row - row))));
            const MaskF touched = hn::And(in_box, hn::Ge(least, hn::Zero(tag_f)));
            const VecI lane = hn::Iota(tag_i, v * N);
            const VecI block =
                hn::Add(hn::And(lane, hn::Set(tag_i, 3)),
                        hn::Mul(hn::ShiftRight<2>(lane), hn::Set(tag_i, tile_block_columns)));
            const int first = (int(i) << item_shift) + row * tile_block_columns + column;
            count_ += compress_append(hn::Add(block, hn::Set(tag_i, first)),
                                      hn::RebindMask(tag_i, touched), queue_ + count_);
        }
    }

    const RasterView& view_;
    const int x_, y_;
    const std::uint32_t* refs_;
    TileBuffer& tile_;
    std::uint32_t count_ = 0;
    alignas(64) std::int32_t queue_[capacity + 16];
};

inline void draw_medium(const RasterView& view, int x, int y, const std::uint32_t* refs,
                        std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    BlockQueue queue(view, x, y, refs, tile);
    for (std::uint32_t i = 0; i < count; ++i) queue.add(i);
    queue.draw();
}

inline void draw_fragments(const RasterView& view, int x, int y, const std::uint32_t* runs,
                           std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; i += 2) {
        const std::uint32_t first = runs[i] % std::uint32_t(N);
        const float* rows = view.fragments->batch(runs[i] / std::uint32_t(N));
        const float* depth = rows + fragment_depth * N;
        const auto* at = reinterpret_cast<const std::uint32_t*>(rows) + fragment_at * N;
        const auto* id = reinterpret_cast<const std::uint32_t*>(rows) + row_id * N;
        for (std::uint32_t k = first; k < first + runs[i + 1]; ++k) {
            float& there = tile.depth[at[k]];
            std::uint32_t& ref = tile.ref[at[k]];
            if (!(depth[k] > there) &&
                !(depth[k] == there && (ref == no_ref || ref_id(view, ref) > id[k])))
                continue;
            there = depth[k];
            ref = fragment_bit | (runs[i] + k - first);
        }
    }
}

SCANSHADE_TARGET_END;

#endif

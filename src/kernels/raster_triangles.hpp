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
    BatchTriangle() = default;
    /// batches: the first of them, `size` numbers each.
    SCANSHADE_INLINE BatchTriangle(const float* batches, std::size_t size, std::uint32_t ref)
        : at_(batches + ref / std::uint32_t(N) * size + ref % std::uint32_t(N)) {}

    SCANSHADE_INLINE float row(int r) const { return at_[r * N]; }
    SCANSHADE_INLINE int origin_x() const { return int(row(row_origin_x)); }
    SCANSHADE_INLINE int origin_y() const { return int(row(row_origin_y)); }
    std::uint32_t extent() const {
        std::uint32_t bits;
        std::memcpy(&bits, at_ + row_extent * N, sizeof bits);
        return bits;
    }

    /// Edge function k at (x, y) from the origin; exact, fused or not.
    SCANSHADE_INLINE VecF edge(int k, VecF x, VecF y) const {
        return hn::MulAdd(hn::Set(tag_f, row(row_edges + k)), x,
                          hn::MulAdd(hn::Set(tag_f, row(row_edges + 3 + k)), y,
                                     hn::Set(tag_f, row(row_edges + 6 + k))));
    }

    /// What may follow the edge functions at a block's first sample for the largest value in it: that is
    /// at the corner that the gradient points to.
    SCANSHADE_INLINE float rise(int k) const {
        return (block_side - 1) *
               (std::max(row(row_edges + k), 0.0f) + std::max(row(row_edges + 3 + k), 0.0f));
    }

    /// Samples at (x, y) from the origin, into elements of the tile from `at` on.
    SCANSHADE_INLINE void draw(const RasterView& view, VecF x, VecF y, std::uint32_t ref, int at,
                               TileBuffer& tile) const {
        const VecF least = hn::Min(edge(0, x, y), hn::Min(edge(1, x, y), edge(2, x, y)));
        const ScreenPlane<Lanes> depth = {Lanes(row(row_depth)), Lanes(row(row_depth + 1)),
                                          Lanes(row(row_depth + 2))};
        put(view, plane_value(depth, Lanes(x), Lanes(y)).v, hn::Ge(least, hn::Zero(tag_f)), ref,
            tile.depth + at, tile.ref + at);
    }

private:
    const float* at_;
};

/// Blocks from a tile to an origin, which lies on their grid; negative in another tile.
inline int blocks_from(int tile, int origin) { return (origin - tile) >> 2; }

/// A window of 4 × 4 blocks, as row_extent has them: its samples' places, block by block.
constexpr int window_side = 4, window_blocks = window_side * window_side;
struct WindowGrid {
    alignas(64) float x[window_blocks * block_samples], y[window_blocks * block_samples];
    int at[window_blocks];  // element of a tile
    constexpr WindowGrid() : x(), y(), at() {
        for (int block = 0; block < window_blocks; ++block) {
            const int column = block % window_side, row = block / window_side;
            at[block] = block_at(column, row);
            for (int i = 0; i < block_samples; ++i) {
                x[block * block_samples + i] = grid.x[i] + float(column * block_side);
                y[block * block_samples + i] = grid.y[i] + float(row * block_side);
            }
        }
    }
};
constexpr WindowGrid window_grid;

/// The blocks of a window from column or row `first` on that are in [0, last].
constexpr std::uint32_t columns_within(int first, int last) {
    constexpr std::uint32_t every = (1u << window_side) - 1;
    const int below = std::clamp(-first, 0, window_side), beyond = first + window_side - 1 - last;
    return (every << below & every >> std::clamp(beyond, 0, window_side)) * 0x1111u;
}
constexpr std::uint32_t rows_within(int first, int last) {
    constexpr std::uint32_t every = (1u << window_blocks) - 1;
    const int below = std::clamp(-first, 0, window_side), beyond = first + window_side - 1 - last;
    return every << below * window_side & every >> std::clamp(beyond, 0, window_side) * window_side;
}

/// Those of windows that begin at most one window before a tile of `blocks` blocks a side, and in it.
struct WithinTile {
    std::uint16_t columns[window_side + tile_block_columns], rows[window_side + tile_block_columns];
    constexpr explicit WithinTile(int blocks) : columns(), rows() {
        for (int first = -window_side; first < tile_block_columns; ++first) {
            columns[first + window_side] = std::uint16_t(columns_within(first, blocks - 1));
            rows[first + window_side] = std::uint16_t(rows_within(first, blocks - 1));
        }
    }
};
constexpr WithinTile within_tile[] = {WithinTile(4), WithinTile(8), WithinTile(16)};

/// Blocks of triangles in two passes: first which ones a triangle may touch, then one block after
/// another. No branch depends on a triangle's shape.
class BlockQueue {
public:
    BlockQueue(const RasterView& view, int x, int y, TileBuffer& tile)
        : view_(view),
          x_(x),
          y_(y),
          tile_(tile),
          batches_(view.batches->batch(0)),
          batch_size_(view.batches->batch_size()),
          within_(within_tile[__builtin_ctz(unsigned(view.tile / subtile_side))]) {}

    /// Queues a triangle's blocks.
    SCANSHADE_INLINE void add(std::uint32_t ref) {
        const BatchTriangle t(batches_, batch_size_, ref);
        const std::uint32_t extent = t.extent();
        const int columns = int(extent & 0xff), rows = int(extent >> 8 & 0xff);
        const int column = blocks_from(x_, t.origin_x()), row = blocks_from(y_, t.origin_y());
        const std::uint32_t within = within_.columns[std::max(column, -window_side) + window_side] &
                                     within_.rows[std::max(row, -window_side) + window_side];
        next_window(t, ref, column, row, 0, 0);
        add_window(extent >> 16 & within);
        if (columns >= window_side || rows >= window_side)
            add_further(t, ref, column, row, column + columns, row + rows);
    }

    SCANSHADE_INLINE void draw() {
        for (std::uint32_t k = 0; k < count_; ++k) {
            const auto item = std::uint32_t(queue_[k]);
            const Window& w = window_[item / window_blocks];
            const std::uint32_t block = item % window_blocks;
            const VecF X = hn::Set(tag_f, w.x), Y = hn::Set(tag_f, w.y);
            const int at = block_at(w.column, w.row) + window_grid.at[block];
            for (int v = 0; v < block_samples; v += N) {
                const float* x = window_grid.x + block * block_samples + v;
                const float* y = window_grid.y + block * block_samples + v;
                w.triangle.draw(view_, hn::Add(hn::Load(tag_f, x), X),
                                hn::Add(hn::Load(tag_f, y), Y), w.ref, at + v, tile_);
            }
        }
        count_ = windows_ = 0;
    }

private:
    static constexpr std::uint32_t most_windows = 64;

    struct Window {
        BatchTriangle triangle;
        std::uint32_t ref;
        int column, row;  // of the tile's blocks; maybe outside of it
        float x, y;       // pixels from the triangle's origin
    };

    /// Room for a window, filled field by field: a copy of the whole would wait for its parts.
    SCANSHADE_INLINE const Window& next_window(const BatchTriangle& t, std::uint32_t ref,
                                               int column, int row, int columns, int rows) {
        if (windows_ == most_windows) draw();
        Window& w = window_[windows_];
        w.triangle = t, w.ref = ref;
        w.column = column, w.row = row;
        w.x = float(columns * block_side), w.y = float(rows * block_side);
        return w;
    }

    /// Queues these blocks of the window at hand.
    SCANSHADE_INLINE void add_window(std::uint32_t blocks) {
        const std::uint32_t first = windows_++ * window_blocks;
        for (int v = 0; v < window_blocks; v += N)
            count_ +=
                compress_append(hn::Add(hn::Iota(tag_i, v), hn::Set(tag_i, std::int32_t(first))),
                                mask_of(tag_i, blocks >> v & all_lanes), queue_ + count_);
    }

    /// The windows that follow the first one, up to the block (last_column, last_row).
    HWY_NOINLINE void add_further(const BatchTriangle& t, std::uint32_t ref, int column, int row,
                                  int last_column, int last_row) {
        const int last = view_.tile / block_side - 1;
        last_column = std::min(last_column, last), last_row = std::min(last_row, last);
        const float rise[3] = {t.rise(0), t.rise(1), t.rise(2)};
        for (int r = row; r <= last_row; r += window_side)
            for (int c = column; c <= last_column; c += window_side) {
                if (r <= -window_side || c <= -window_side || (r == row && c == column)) continue;
                const Window& w = next_window(t, ref, c, r, c - column, r - row);
                add_window(touched_blocks(w, rise) & columns_within(c, last_column) &
                           rows_within(r, last_row));
            }
    }

    /// Blocks of a window in which no edge function is negative everywhere.
    SCANSHADE_INLINE std::uint32_t touched_blocks(const Window& w, const float (&rise)[3]) const {
        std::uint32_t touched = 0;
        for (int v = 0; v < window_blocks; v += N) {
            const VecF side = hn::Set(tag_f, float(block_side));
            const VecF x = hn::MulAdd(hn::Load(tag_f, grid.x + v), side, hn::Set(tag_f, w.x));
            const VecF y = hn::MulAdd(hn::Load(tag_f, grid.y + v), side, hn::Set(tag_f, w.y));
            VecF least = hn::Add(w.triangle.edge(0, x, y), hn::Set(tag_f, rise[0]));
            for (int k = 1; k < 3; ++k)
                least = hn::Min(least, hn::Add(w.triangle.edge(k, x, y), hn::Set(tag_f, rise[k])));
            touched |= mask_bits(tag_f, hn::Ge(least, hn::Zero(tag_f))) << v;
        }
        return touched;
    }

    const RasterView& view_;
    const int x_, y_;
    TileBuffer& tile_;
    const float* const batches_;
    const std::size_t batch_size_;
    const WithinTile& within_;
    std::uint32_t count_ = 0, windows_ = 0;
    Window window_[most_windows];
    alignas(64) std::int32_t
        queue_[(most_windows + 1) * window_blocks];  // number of the window · window_blocks + block
};

inline void draw_triangles(const RasterView& view, int x, int y, const std::uint32_t* refs,
                           std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    BlockQueue queue(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; ++i) queue.add(refs[i]);
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
        for (std::uint32_t k = first; k < first + runs[i + 1]; ++k) {
            float& there = tile.depth[at[k]];
            std::uint32_t& ref = tile.ref[at[k]];
            const std::uint32_t fragment = fragment_bit | (runs[i] + k - first);
            if (!(depth[k] > there) &&
                !(depth[k] == there &&
                  (ref == no_ref || ref_id(view, ref) > ref_id(view, fragment))))
                continue;
            there = depth[k];
            ref = fragment;
        }
    }
}

SCANSHADE_TARGET_END;

#endif

// Quadrilaterals of batches, drawn whole into a tile: spans first, then blocks.
#if defined(SCANSHADE_KERNELS_RASTER_QUADS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RASTER_QUADS_HPP
#undef SCANSHADE_KERNELS_RASTER_QUADS_HPP
#else
#define SCANSHADE_KERNELS_RASTER_QUADS_HPP
#endif

#include "kernels/raster_samples.hpp"
#include "kernels/screen_quad.hpp"

SCANSHADE_TARGET_BEGIN;

/// Each row's number at the samples of vector v of a block; `from` is that of the block's first row.
/// Up to N numbers from there are read.
SCANSHADE_INLINE VecF of_rows(const float* from, int v) {
    if constexpr (N <= block_side) return hn::Set(tag_f, from[v * N / block_side]);
    const VecI row = hn::ShiftRight<2>(hn::Iota(tag_i, 0));
    return hn::TableLookupLanes(hn::LoadU(tag_f, from + v * N / block_side),
                                hn::IndicesFromVec(tag_f, row));
}

class BatchQuad {
public:
    BatchQuad(const RasterView& view, std::uint32_t ref, int tile_x, int tile_y)
        : view_(view),
          ref_(ref | quad_bit),
          at_(view.quads->batch(ref / std::uint32_t(N)) + ref % std::uint32_t(N)) {
        const auto origin_x = int(row(row_origin_x)), origin_y = int(row(row_origin_y));
        std::uint32_t extent;
        std::memcpy(&extent, at_ + row_extent * N, sizeof extent);
        const int last = view.tile / block_side - 1;  // of the tile
        column_ = (origin_x - tile_x) / block_side, line_ = (origin_y - tile_y) / block_side;
        last_column_ = std::min(column_ + int(extent & 0xff), last);
        last_line_ = std::min(line_ + int(extent >> 8), last);
    }

    void draw(TileBuffer& tile) {
        const int first_line = std::max(line_, 0), first_column = std::max(column_, 0);
        make_spans(first_line);
        for (int line = first_line; line <= last_line_; ++line)
            for (int column = first_column; column <= last_column_; ++column)
                draw_block(column, line, (line - first_line) * block_side, tile);
    }

private:
    SCANSHADE_INLINE float row(int r) const { return at_[r * N]; }

    /// Spans of the rows from the first block's to the last one's, as vectors of rows.
    SCANSHADE_INLINE void make_spans(int first_line) {
        const ScreenQuad<Lanes> quad = quad_from(at_, N);
        const int rows = (last_line_ - first_line + 1) * block_side;
        for (int i = 0; i < rows; i += N) {
            const float y = float((first_line - line_) * block_side + i);
            const QuadSpan<Lanes> span =
                quad_span(quad, Lanes(hn::Add(hn::Iota(tag_f, 0), hn::Set(tag_f, y))));
            hn::StoreU(span.x.v, tag_f, x_ + i);
            hn::StoreU(span.z.v, tag_f, z_ + i);
            hn::StoreU(span.slope.v, tag_f, slope_ + i);
        }
    }

    /// Edge function k at (x, y) from the origin; exact, fused or not.
    SCANSHADE_INLINE VecF edge(int k, VecF x, VecF y) const {
        return hn::MulAdd(hn::Set(tag_f, row(row_edges + k)), x,
                          hn::MulAdd(hn::Set(tag_f, row(row_edges + 4 + k)), y,
                                     hn::Set(tag_f, row(row_edges + 8 + k))));
    }

    SCANSHADE_INLINE void draw_block(int column, int line, int span, TileBuffer& tile) const {
        const int at = block_at(column, line);
        const VecF X = hn::Set(tag_f, float((column - column_) * block_side));
        const VecF Y = hn::Set(tag_f, float((line - line_) * block_side));
        for (int v = 0; v < block_vectors; ++v) {
            const VecF x = hn::Add(hn::Load(tag_f, grid.x + v * N), X);
            const VecF y = hn::Add(hn::Load(tag_f, grid.y + v * N), Y);
            const VecF least = hn::Min(hn::Min(edge(0, x, y), edge(1, x, y)),
                                       hn::Min(edge(2, x, y), edge(3, x, y)));
            const QuadSpan<Lanes> s = {Lanes(of_rows(x_ + span, v)), Lanes(of_rows(z_ + span, v)),
                                       Lanes(of_rows(slope_ + span, v))};
            put(view_, span_depth(s, Lanes(x)).v, hn::Ge(least, hn::Zero(tag_f)), ref_,
                tile.depth + at + v * N, tile.ref + at + v * N);
        }
    }

    static constexpr int room = tile_side + N;
    const RasterView& view_;
    const std::uint32_t ref_;
    const float* at_;
    int column_, line_, last_column_, last_line_;  // blocks, from the tile's first
    // [row from the first that is drawn]
    alignas(64) float x_[room], z_[room], slope_[room];
};

inline void draw_quads(const RasterView& view, int x, int y, const std::uint32_t* refs,
                       std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; ++i) BatchQuad(view, refs[i], x, y).draw(tile);
}

SCANSHADE_TARGET_END;

#endif

// Records drawn into a tile.
#if defined(SCANSHADE_KERNELS_RASTER_RECORDS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RASTER_RECORDS_HPP
#undef SCANSHADE_KERNELS_RASTER_RECORDS_HPP
#else
#define SCANSHADE_KERNELS_RASTER_RECORDS_HPP
#endif

#include "kernels/raster_samples.hpp"
#include "kernels/screen_plane.hpp"

SCANSHADE_TARGET_BEGIN;

/// A block of a record with the samples that it covers; its depths, if they are known, from `depth`.
inline void draw_block(const RasterView& view, std::uint32_t record, int x, int y, int at,
                       std::uint32_t covered, const float* depth, TileBuffer& tile) {
    for (int v = 0; v < block_vectors; ++v) {
        const std::uint32_t bits = covered >> (v * N) & ((1u << N) - 1);
        if (bits == 0) continue;
        const VecF z = depth != nullptr
                           ? hn::LoadU(tag_f, depth + at + v * N)
                           : record_depth(view, view.records[record], block_positions(x, y, v));
        put(view, z, mask_of(tag_f, bits), record | record_bit, tile.depth + at + v * N,
            tile.ref + at + v * N);
    }
}

/// Edge function k of a record at a sample; exact.
inline std::int64_t edge_value(const Record& r, int k, int x, int y) {
    return r.edge_c[k] + r.edge_x[k] * (x - r.origin_x) + r.edge_y[k] * (y - r.origin_y);
}

/// The covered samples of a block by exact edge functions. Far from an edge its value is limited:
/// within a block it changes by less than 2^28.
class BlockEdges {
public:
    explicit BlockEdges(const Record& r) : record_(r) {
        for (int k = 0; k < r.edge_count; ++k)
            for (int i = 0; i < block_samples; ++i)
                step_[k][i] = std::int32_t(r.edge_x[k]) * (i % block_side) +
                              std::int32_t(r.edge_y[k]) * (i / block_side);
    }
    std::uint32_t covered(int x, int y) const {
        constexpr std::int64_t limit = std::int64_t{1} << 30;
        std::uint32_t bits = 0;
        VecI start[4];
        for (int k = 0; k < record_.edge_count; ++k)
            start[k] = hn::Set(
                tag_i, std::int32_t(std::clamp(edge_value(record_, k, x, y), -limit, limit)));
        for (int v = 0; v < block_vectors; ++v) {
            VecI least = hn::Add(start[0], hn::Load(tag_i, step_[0] + v * N));
            for (int k = 1; k < record_.edge_count; ++k)
                least = hn::Min(least, hn::Add(start[k], hn::Load(tag_i, step_[k] + v * N)));
            bits |= mask_bits(tag_i, hn::Gt(least, hn::Set(tag_i, -1))) << (v * N);
        }
        return bits;
    }

private:
    const Record& record_;
    alignas(64) std::int32_t step_[4][block_samples];
};

/// How a record meets the square of `side` samples at (x, y).
enum class Meets { no, partly, fully };
inline Meets meets(const Record& r, int x, int y, int side) {
    bool fully = true;
    for (int k = 0; k < r.edge_count; ++k) {
        const std::int64_t reach = side - 1;
        const std::int64_t here = edge_value(r, k, x, y);
        const std::int64_t zero = 0;
        const std::int64_t most =
            here + reach * (std::max(r.edge_x[k], zero) + std::max(r.edge_y[k], zero));
        const std::int64_t least =
            here + reach * (std::min(r.edge_x[k], zero) + std::min(r.edge_y[k], zero));
        if (most < 0) return Meets::no;
        fully = fully && least >= 0;
    }
    return fully ? Meets::fully : Meets::partly;
}

/// Bounds of a record's depth in the square of `side` samples at (x, y). A plane is monotone in X
/// and in Y, rounding included, so its corners bound it.
struct DepthBounds {
    float nearest, farthest;
};
inline DepthBounds depth_bounds(const Record& r, int x, int y, int side) {
    if (r.depth != Record::Depth::plane) return {r.nearest, r.farthest};
    const float* depth = r.rows + row_depth;
    const ScreenPlane<float> plane = {depth[0], depth[1], depth[2]};
    const float X[2] = {float(x - r.origin_x), float(x - r.origin_x + side - 1)};
    const float Y[2] = {float(y - r.origin_y), float(y - r.origin_y + side - 1)};
    const int px = plane.x > 0 ? 1 : 0, py = plane.y > 0 ? 1 : 0;
    return {plane_value(plane, X[px], Y[py]), plane_value(plane, X[1 - px], Y[1 - py])};
}

/// The farthest depth in a written subtile; 0 if a sample is empty. Two halves of a rectangle together
/// hide what is behind them.
inline float farthest_sample(const TileBuffer& tile, int subtile) {
    VecF least = hn::Set(tag_f, 1e30f);
    for (int block = 0; block < 16; ++block)
        for (int v = 0; v < block_vectors; ++v)
            least =
                hn::Min(least, hn::Load(tag_f, tile.depth + subtile_block(subtile, block) + v * N));
    return hn::GetLane(hn::MinOfLanes(tag_f, least));
}

/// `whole`: the record covers all of the tile.
inline void draw_subtile(const RasterView& view, std::uint32_t record, bool whole, int tile_x,
                         int tile_y, int subtile, TileBuffer& tile) {
    const Record& r = view.records[record];
    const int x = tile_x + (subtile % 4) * subtile_side, y = tile_y + (subtile / 4) * subtile_side;
    const DepthBounds bounds = depth_bounds(r, x, y, subtile_side);
    if (bounds.nearest < tile.farthest[subtile]) return;  // hidden by what covers the subtile
    const Meets meeting = whole ? Meets::fully : meets(r, x, y, subtile_side);
    if (meeting == Meets::no) return;
    if (meeting == Meets::fully && bounds.farthest > tile.nearest[subtile]) {
        tile.owner[subtile] = record | record_bit;
        tile.written[subtile] = false;
        tile.nearest[subtile] = bounds.nearest;
        tile.farthest[subtile] = bounds.farthest;
        return;
    }
    write_subtile(view, tile_x, tile_y, subtile, tile);
    const BlockEdges edges(r);
    for (int block = 0; block < 16; ++block) {
        const int bx = x + (block % 4) * block_side, by = y + (block / 4) * block_side;
        const std::uint32_t covered = meeting == Meets::fully ? 0xffffu : edges.covered(bx, by);
        if (covered != 0)
            draw_block(view, record, bx, by, subtile_block(subtile, block), covered, nullptr, tile);
    }
    tile.nearest[subtile] = std::max(tile.nearest[subtile], bounds.nearest);
    if (meeting == Meets::fully)
        tile.farthest[subtile] = std::max(tile.farthest[subtile], bounds.farthest);
    else
        tile.farthest[subtile] = farthest_sample(tile, subtile);
}

/// What is behind this is hidden in the whole tile.
inline float farthest_of(const TileBuffer& tile) {
    VecF least = hn::LoadU(tag_f, tile.farthest);
    for (int s = N; s < TileBuffer::subtiles; s += N)
        least = hn::Min(least, hn::LoadU(tag_f, tile.farthest + s));
    return hn::GetLane(hn::MinOfLanes(tag_f, least));
}

inline void draw_record(const RasterView& view, int x, int y, std::uint32_t record,
                        TileBuffer& tile) {
    const Record& r = view.records[record];
    // A layer behind all that the tile shows ends here.
    if (depth_bounds(r, x, y, view.tile).nearest < farthest_of(tile)) return;
    const Meets meeting = meets(r, x, y, view.tile);
    if (meeting == Meets::no) return;
    for (int s = 0; s < TileBuffer::subtiles; ++s)
        if (view.has_subtile(s)) draw_subtile(view, record, meeting == Meets::fully, x, y, s, tile);
}

inline void draw_rows(const RasterView& view, int x, int y, std::uint32_t record,
                      const std::uint64_t* rows, const float* depth, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (int row = 0; row < tile_side; row += block_side) {
        const std::uint64_t any = rows[row] | rows[row + 1] | rows[row + 2] | rows[row + 3];
        for (int column = 0; column < tile_side; column += block_side) {
            if ((any >> column & 0xf) == 0) continue;
            std::uint32_t covered = 0;
            for (int k = 0; k < block_side; ++k)
                covered |= std::uint32_t(rows[row + k] >> column & 0xf) << (k * block_side);
            draw_block(view, record, x + column, y + row, tile_index(column, row), covered, depth,
                       tile);
        }
    }
    // Nothing bounds what lies behind or before these samples.
    for (int s = 0; s < TileBuffer::subtiles; ++s) tile.nearest[s] = 1e30f;
}

SCANSHADE_TARGET_END;

#endif

// Visibility inside one tile: which triangle is seen at each sample, and how near.
#define SCANSHADE_SIMD

#include <algorithm>
#include <array>
#include <cstring>

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/raster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/record_depth.hpp"
#include "kernels/screen_plane.hpp"
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
        return hn::MulAdd(hn::Set(tag_f, row(row_edge_x + k)), x,
                          hn::MulAdd(hn::Set(tag_f, row(row_edge_y + k)), y,
                                     hn::Set(tag_f, row(row_edge_c + k))));
    }

    /// The block whose corner is (X, Y) pixels from the origin; `at`: its index in the tile.
    HWY_INLINE void draw(const RasterView& view, float X, float Y, std::uint32_t ref, int at,
                         TileBuffer& tile) const {
        for (int v = 0; v < block_vectors; ++v) {
            const VecF x = hn::Add(hn::Load(tag_f, grid.x + v * N), hn::Set(tag_f, X));
            const VecF y = hn::Add(hn::Load(tag_f, grid.y + v * N), hn::Set(tag_f, Y));
            const VecF least = hn::Min(edge(0, x, y), hn::Min(edge(1, x, y), edge(2, x, y)));
            const MaskF inside = hn::Ge(least, hn::Zero(tag_f));
            const ScreenPlane<Lanes> depth = {Lanes(row(row_depth)), Lanes(row(row_depth + 1)),
                                              Lanes(row(row_depth + 2))};
            put(view, plane_value(depth, Lanes(x), Lanes(y)).v, inside, ref,
                tile.depth + at + v * N, tile.ref + at + v * N);
        }
    }

private:
    const float* at_;
};

inline int block_at(int column, int row) {
    return (row * tile_block_columns + column) * block_samples;
}

/// ---- subtiles: whole 16 × 16 samples that are written only when needed

inline int subtile_block(int subtile, int block) {
    return block_at((subtile % 4) * 4 + block % 4, (subtile / 4) * 4 + block / 4);
}

void write_subtile(const RasterView& view, int tile_x, int tile_y, int subtile, TileBuffer& tile) {
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

void write_all(const RasterView& view, int tile_x, int tile_y, TileBuffer& tile) {
    for (int s = 0; s < TileBuffer::subtiles; ++s)
        if (view.has_subtile(s)) write_subtile(view, tile_x, tile_y, s, tile);
}

void write_owned(const RasterView& view, int tile_x, int tile_y, TileBuffer& tile) {
    for (int s = 0; s < TileBuffer::subtiles; ++s) {
        if (tile.written[s] || tile.owner[s] == no_ref) continue;
        const Record& owner = view.records[tile.owner[s] & ~record_bit];
        if (view.leaves_owned && owner.depth == Record::Depth::plane && !owner.normals_disagree)
            continue;
        write_subtile(view, tile_x, tile_y, s, tile);
    }
}

void draw_tiny(const RasterView& view, int x, int y, const std::uint32_t* refs, std::uint32_t count,
               TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; ++i) {
        const BatchTriangle t(*view.batches, refs[i]);
        t.draw(view, 0, 0, refs[i],
               block_at((t.origin_x() - x) / block_side, (t.origin_y() - y) / block_side), tile);
    }
}

void draw_fragments(const RasterView& view, int x, int y, const std::uint32_t* runs,
                    std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; i += 2) {
        const std::uint32_t first = runs[i] % std::uint32_t(N);
        const float* depth = view.fragments->batch(runs[i] / std::uint32_t(N));
        const auto* at = reinterpret_cast<const std::uint32_t*>(depth) + fragment_at * N;
        const std::uint32_t* id = at + (fragment_id - fragment_at) * N;
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

void draw_small(const RasterView& view, int x, int y, const std::uint32_t* refs,
                std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    for (std::uint32_t i = 0; i < count; ++i) {
        const BatchTriangle t(*view.batches, refs[i]);
        const int at = block_at((t.origin_x() - x) / block_side, (t.origin_y() - y) / block_side);
        // All four, without asking: a mispredicted branch costs more than an empty block. What lies
        // beyond the tile's edge is in no triangle of this list.
        t.draw(view, 0, 0, refs[i], at, tile);
        t.draw(view, 4, 0, refs[i], at + block_samples, tile);
        t.draw(view, 0, 4, refs[i], at + tile_block_columns * block_samples, tile);
        t.draw(view, 4, 4, refs[i], at + (tile_block_columns + 1) * block_samples, tile);
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
        const int column = (t.origin_x() - x_) / block_side, row = (t.origin_y() - y_) / block_side;
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
            const float X = float(column * block_side + x_ - t.origin_x());
            const float Y = float(row * block_side + y_ - t.origin_y());
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
                const float reach = 3 * (std::max(t.row(row_edge_x + k), 0.0f) +
                                         std::max(t.row(row_edge_y + k), 0.0f));
                least = hn::Min(least, hn::Add(t.edge(k, X, Y), hn::Set(tag_f, reach)));
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

void draw_medium(const RasterView& view, int x, int y, const std::uint32_t* refs,
                 std::uint32_t count, TileBuffer& tile) {
    write_all(view, x, y, tile);
    BlockQueue queue(view, x, y, refs, tile);
    for (std::uint32_t i = 0; i < count; ++i) queue.add(i);
    queue.draw();
}

/// ---- records

/// A block of a record with the samples that it covers; its depths, if they are known, from `depth`.
void draw_block(const RasterView& view, std::uint32_t record, int x, int y, int at,
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

/// The covered samples of a block by exact edge functions. Far from an edge its value is limited:
/// within a block it changes by less than 2^28.
class BlockEdges {
public:
    explicit BlockEdges(const Record& r) : record_(r) {
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < block_samples; ++i)
                step_[k][i] = std::int32_t(r.edge_x[k]) * (i % block_side) +
                              std::int32_t(r.edge_y[k]) * (i / block_side);
    }
    std::uint32_t covered(int x, int y) const {
        constexpr std::int64_t limit = std::int64_t{1} << 30;
        std::uint32_t bits = 0;
        VecI start[3];
        for (int k = 0; k < 3; ++k)
            start[k] = hn::Set(tag_i, std::int32_t(std::clamp(value(k, x, y), -limit, limit)));
        for (int v = 0; v < block_vectors; ++v) {
            VecI least = hn::Add(start[0], hn::Load(tag_i, step_[0] + v * N));
            for (int k = 1; k < 3; ++k)
                least = hn::Min(least, hn::Add(start[k], hn::Load(tag_i, step_[k] + v * N)));
            bits |= mask_bits(tag_i, hn::Gt(least, hn::Set(tag_i, -1))) << (v * N);
        }
        return bits;
    }
    std::int64_t value(int k, int x, int y) const {
        return record_.edge_c[k] + record_.edge_x[k] * (x - record_.origin_x) +
               record_.edge_y[k] * (y - record_.origin_y);
    }

private:
    const Record& record_;
    alignas(64) std::int32_t step_[3][block_samples];
};

/// How a triangle meets the square of `side` samples at (x, y).
enum class Meets { no, partly, fully };
Meets meets(const Record& r, const BlockEdges& edges, int x, int y, int side) {
    bool fully = true;
    for (int k = 0; k < 3; ++k) {
        const std::int64_t reach = side - 1;
        const std::int64_t here = edges.value(k, x, y);
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
DepthBounds depth_bounds(const Record& r, int x, int y, int side) {
    if (r.depth != Record::Depth::plane) return {r.nearest, r.farthest};
    const float* depth = r.rows + row_depth;
    const ScreenPlane<float> plane = {depth[0], depth[1], depth[2]};
    const float X[2] = {float(x - r.origin_x), float(x - r.origin_x + side - 1)};
    const float Y[2] = {float(y - r.origin_y), float(y - r.origin_y + side - 1)};
    const int px = plane.x > 0 ? 1 : 0, py = plane.y > 0 ? 1 : 0;
    return {plane_value(plane, X[px], Y[py]), plane_value(plane, X[1 - px], Y[1 - py])};
}

/// `whole`: the triangle covers all of the tile.
void draw_subtile(const RasterView& view, std::uint32_t record, const BlockEdges& edges, bool whole,
                  int tile_x, int tile_y, int subtile, TileBuffer& tile) {
    const Record& r = view.records[record];
    const int x = tile_x + (subtile % 4) * subtile_side, y = tile_y + (subtile / 4) * subtile_side;
    const DepthBounds bounds = depth_bounds(r, x, y, subtile_side);
    if (bounds.nearest < tile.farthest[subtile]) return;  // hidden by what covers the subtile
    const Meets meeting = whole ? Meets::fully : meets(r, edges, x, y, subtile_side);
    if (meeting == Meets::no) return;
    if (meeting == Meets::fully && bounds.farthest > tile.nearest[subtile]) {
        tile.owner[subtile] = record | record_bit;
        tile.written[subtile] = false;
        tile.nearest[subtile] = bounds.nearest;
        tile.farthest[subtile] = bounds.farthest;
        return;
    }
    write_subtile(view, tile_x, tile_y, subtile, tile);
    for (int block = 0; block < 16; ++block) {
        const int bx = x + (block % 4) * block_side, by = y + (block / 4) * block_side;
        const std::uint32_t covered = meeting == Meets::fully ? 0xffffu : edges.covered(bx, by);
        if (covered != 0)
            draw_block(view, record, bx, by, subtile_block(subtile, block), covered, nullptr, tile);
    }
    tile.nearest[subtile] = std::max(tile.nearest[subtile], bounds.nearest);
    if (meeting == Meets::fully)
        tile.farthest[subtile] = std::max(tile.farthest[subtile], bounds.farthest);
}

void draw_record(const RasterView& view, int x, int y, std::uint32_t record, TileBuffer& tile) {
    const Record& r = view.records[record];
    // A layer behind all that the tile shows ends here.
    const float farthest = *std::min_element(tile.farthest, tile.farthest + TileBuffer::subtiles);
    if (depth_bounds(r, x, y, view.tile).nearest < farthest) return;
    const BlockEdges edges(r);
    const Meets meeting = meets(r, edges, x, y, view.tile);
    if (meeting == Meets::no) return;
    for (int s = 0; s < TileBuffer::subtiles; ++s)
        if (view.has_subtile(s))
            draw_subtile(view, record, edges, meeting == Meets::fully, x, y, s, tile);
}

void draw_rows(const RasterView& view, int x, int y, std::uint32_t record,
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

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(draw_tiny);
HWY_EXPORT(draw_fragments);
HWY_EXPORT(draw_small);
HWY_EXPORT(draw_medium);
HWY_EXPORT(draw_record);
HWY_EXPORT(draw_rows);
HWY_EXPORT(write_owned);

void clear_tile(TileBuffer& tile) {
    std::fill(std::begin(tile.owner), std::end(tile.owner), no_ref);
    std::fill(std::begin(tile.written), std::end(tile.written), false);
    std::fill(std::begin(tile.nearest), std::end(tile.nearest), 0.0f);
    std::fill(std::begin(tile.farthest), std::end(tile.farthest), 0.0f);
}
void raster_tiny(const RasterView& view, int x, int y, const std::uint32_t* refs,
                 std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_tiny)(view, x, y, refs, count, tile);
}
void raster_small(const RasterView& view, int x, int y, const std::uint32_t* refs,
                  std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_small)(view, x, y, refs, count, tile);
}
void raster_medium(const RasterView& view, int x, int y, const std::uint32_t* refs,
                   std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_medium)(view, x, y, refs, count, tile);
}
void raster_fragments(const RasterView& view, int x, int y, const std::uint32_t* runs,
                      std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_fragments)(view, x, y, runs, count, tile);
}
void raster_record(const RasterView& view, int x, int y, std::uint32_t record, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_record)(view, x, y, record, tile);
}
void raster_rows(const RasterView& view, int x, int y, std::uint32_t record,
                 const std::uint64_t (&rows)[tile_side], const float* depth, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_rows)(view, x, y, record, rows, depth, tile);
}
void complete_tile(const RasterView& view, int x, int y, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(write_owned)(view, x, y, tile);
}

}  // namespace scanshade
#endif

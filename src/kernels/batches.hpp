// Batches of faces, numbers side by side, and lists of them for each tile.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "scanshade/base/memory.hpp"
#include "scanshade/scene/clusters.hpp"

namespace scanshade {

/// A ref names what is seen at a sample: batch · lanes + lane of a triangle, or with one of these bits
/// a Record, or batch · lanes + lane of a fragment or of a quadrilateral.
inline constexpr std::uint32_t record_bit = 0x80000000u;
inline constexpr std::uint32_t fragment_bit = 0x40000000u;
inline constexpr std::uint32_t quad_bit = 0x20000000u;
inline constexpr std::uint32_t no_ref = 0xffffffffu;

/// Rows of a batch: `lanes` faces side by side, each row one number of all of them. Edge functions
/// and planes count pixels from the face's origin. Those of faces in batches are exact in float: whole
/// numbers below 2^24.
enum BatchRow : int {
    row_corners,   // uint32: as in ClusteredMesh, and back_bit where seen from behind
    row_origin_x,  // float, a multiple of 4
    row_origin_y,  // float
    row_extent,  // uint32: last block of the box, columns | rows << 8, and for triangles << 16 those
                 // of the 4 × 4 blocks from the origin on that they may touch
    row_edges,  // step of ⌊E/256⌋ a pixel to the right for each edge, then a pixel down for each,
                // then the value at the origin; the sample is inside where all are ≥ 0

    // of triangles
    row_depth = row_edges + 3 * 3,  // 3: plane c, x, y
    row_attributes = row_depth + 3,

    // of quadrilaterals, see ScreenQuad
    row_quad_x = row_edges + 3 * 4,            // 4
    row_quad_y = row_quad_x + 4,               // 4
    row_quad_per_height = row_quad_y + 4,      // 4
    row_quad_depth = row_quad_per_height + 4,  // 4
    row_quad_attributes = row_quad_depth + 4,
};
inline constexpr std::uint32_t back_bit = number_bit >> 1;

/// Which values follow in a batch; an offset is −1 where nothing reads the attribute. Each value
/// takes `stride` rows: a triangle's are planes c, x, y, a quadrilateral's stand at its corners.
struct Attributes {
    int stride, rows;   // rows: of a batch
    int main = -1;      // 3: normal · z (Phong); radiance · z (Gouraud); radiance (flat)
    int dark = -1;      // 3: radiance without diffuse reflection, for textures
    int texcoord = -1;  // 2: u z, v z
    int position = -1;  // 3: position · z
};

inline constexpr int most_values = 3 + 3 + 2 + 3;
inline constexpr int most_rows = row_quad_attributes + 4 * most_values;

/// Rows of a batch of fragments: `lanes` samples of triangles too small to be worth planes.
/// row_corners is that of the triangles, the sample's place in their boxes beside it.
enum FragmentRow : int {
    fragment_depth = row_corners + 1,
    fragment_at,      // uint32: index of the sample in its tile
    fragment_values,  // 3: normal · z (Phong); radiance (Gouraud, flat)
    fragment_rows = fragment_values + 3,

    // Gouraud, until light is known: what a batch of triangles has, and the sample
    fragment_weights = fragment_values,  // 9: planes of the corners' weights
    fragment_x = fragment_weights + 9,   // float, from the triangle's origin
    fragment_y,                          // float
    fragment_unscale,                    // what scales a plane's value
    fragment_gouraud_rows,
};

/// Of one triangle, on the average of a cluster.
inline constexpr std::uint32_t most_fragments = 4;

/// What all triangles or fragments of a batch have in common.
struct BatchInfo {
    std::uint32_t object, cluster, material;
    std::uint16_t count;    // triangles, the rest of the lanes is unused
    bool normals_disagree;  // interpolated normals may vanish
};

/// Neighbouring batches, `last` not included.
struct BatchRange {
    std::uint32_t next = 0, last = 0;
};

/// All batches of a frame. Workers take runs of them, so memory that no triangle needs is never
/// touched.
class BatchStore {
public:
    /// Room for `batches` of `rows` rows of `lanes` numbers; keeps the memory where it is enough.
    void reset(std::size_t batches, int rows, int lanes) {
        rows_ = std::size_t(rows), lanes_ = std::size_t(lanes);
        const std::size_t size = batches * rows_ * lanes_;
        if (size > size_) {
            data_.reset(static_cast<float*>(allocate_large(size * sizeof(float))));
            size_ = size;
        }
        if (batches > info_size_) {
            info_.reset(new BatchInfo[batches]);
            info_size_ = batches;
        }
        next_.store(0, std::memory_order_relaxed);
        capacity_ = batches;
    }
    /// First of `count` fresh batches.
    std::uint32_t take(std::uint32_t count) {
        return next_.fetch_add(count, std::memory_order_relaxed);
    }
    std::size_t batch_size() const { return rows_ * lanes_; }
    float* batch(std::uint32_t b) { return data_.get() + b * rows_ * lanes_; }
    const float* batch(std::uint32_t b) const { return data_.get() + b * rows_ * lanes_; }
    BatchInfo& info(std::uint32_t b) { return info_[b]; }
    const BatchInfo& info(std::uint32_t b) const { return info_[b]; }
    /// Its memory left the nearer caches when the frame before was drawn.
    void prefetch(std::uint32_t b) const {
        const float* from = batch(b);
        for (std::size_t i = 0; i < rows_ * lanes_; i += 16) __builtin_prefetch(from + i, 1);
    }
    /// These batches hold nothing.
    void leave_empty(const BatchRange& range) {
        for (std::uint32_t b = range.next; b < range.last; ++b) info_[b].count = 0;
    }
    std::uint32_t lanes() const { return std::uint32_t(lanes_); }
    std::size_t capacity() const { return capacity_; }
    std::size_t used() const { return next_.load(std::memory_order_relaxed); }

private:
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<float[], Free> data_;  // rows begin on whole cache lines
    std::unique_ptr<BatchInfo[]> info_;
    std::size_t size_ = 0, info_size_ = 0, capacity_ = 0, rows_ = 0, lanes_ = 0;
    std::atomic<std::uint32_t> next_{0};
};

/// Batches that a worker takes from a store at once.
inline constexpr std::uint32_t batches_in_run = 16;

/// A worker's batches that nothing is in yet.
struct BatchRun : BatchRange {
    std::uint32_t fresh(BatchStore& store) {
        if (next == last) {
            next = store.take(batches_in_run);
            last = next + batches_in_run;
        }
        store.prefetch(next + 1);
        return next++;
    }
};

/// A list of refs for each tile, in chunks. One worker fills it, any may read it afterwards.
class TileLists {
public:
    void reset(std::size_t tiles) {
        first_.assign(tiles, none);
        last_.assign(tiles, none);
        chunks_.clear();
    }
    [[gnu::always_inline]] void push(std::size_t tile, std::uint32_t ref) {
        std::uint32_t at = last_[tile];
        if (at == none || chunks_[at].count == Chunk::capacity) at = append(tile);
        Chunk& chunk = chunks_[at];
        chunk.ref[chunk.count++] = ref;
    }
    bool empty(std::size_t tile) const { return first_[tile] == none; }

    /// Calls visit(refs, count) for each chunk of a tile.
    template <class Visit>
    void each(std::size_t tile, Visit&& visit) const {
        for (std::uint32_t at = first_[tile]; at != none; at = chunks_[at].next)
            visit(chunks_[at].ref.data(), chunks_[at].count);
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Chunk {
        static constexpr std::uint32_t capacity = 62;
        Chunk() {}  // refs are written before they are read
        std::uint32_t next = none, count = 0;
        std::array<std::uint32_t, capacity> ref;
    };
    [[gnu::noinline]] std::uint32_t append(std::size_t tile) {
        const auto fresh = std::uint32_t(chunks_.size());
        chunks_.emplace_back();
        (last_[tile] == none ? first_[tile] : chunks_[last_[tile]].next) = fresh;
        return last_[tile] = fresh;
    }
    std::vector<std::uint32_t> first_, last_;  // [tile]
    std::vector<Chunk> chunks_;
};

}  // namespace scanshade

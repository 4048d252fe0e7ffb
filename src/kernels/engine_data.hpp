// What the stages of the vector renderer hand on: plain data that crosses between the driver and the
// kernels of every instruction set.
//
//     clusters --set-up--> batches of triangles, lists a tile --raster--> depth and refs of a tile
//              --resolve--> surface points --illuminate--> radiance --encode--> bytes
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scanshade/base/events.hpp"
#include "scanshade/scene/clusters.hpp"
#include "scanshade/scene/settings.hpp"

namespace scanshade {

inline constexpr int block_side = 4;  // a block of 4 × 4 samples is one cache line of depths
inline constexpr int block_samples = block_side * block_side;
inline constexpr int subtile_side = 16;
inline constexpr int tile_side = 64;  // the largest; see RasterView::tile
inline constexpr int tile_samples = tile_side * tile_side;
inline constexpr int tile_blocks = tile_samples / block_samples;

/// A ref names what is seen at a sample: batch · lanes + lane of a triangle, or with one of these bits
/// a Record, or batch · lanes + lane of a fragment or of a quadrilateral.
inline constexpr std::uint32_t record_bit = 0x80000000u;
inline constexpr std::uint32_t fragment_bit = 0x40000000u;
inline constexpr std::uint32_t quad_bit = 0x20000000u;
inline constexpr std::uint32_t no_ref = 0xffffffffu;

/// Index of a tile's sample: blocks row by row, samples of a block row by row.
constexpr int tile_index(int x, int y) {
    return ((y / block_side) * (tile_side / block_side) + x / block_side) * block_samples +
           (y % block_side) * block_side + x % block_side;
}

/// Rows of a batch: `lanes` faces side by side, each row one number of all of them. Edge functions
/// and planes count pixels from the face's origin. Those of faces in batches are exact in float: whole
/// numbers below 2^24.
enum BatchRow : int {
    row_id,        // uint32: the (first) triangle in the whole scene
    row_corners,   // uint32: as in ClusteredMesh, and back_bit where seen from behind
    row_origin_x,  // float, a multiple of 4
    row_origin_y,  // float
    row_extent,    // uint32: last block of the box, columns | rows << 16
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

/// Rows of a batch of fragments: `lanes` samples of triangles too small to be worth planes. row_id and
/// row_corners are those of the triangles.
enum FragmentRow : int {
    fragment_depth = row_corners + 1,
    fragment_at,      // uint32: index of the sample in its tile
    fragment_values,  // 3: normal · z (Phong); weights of the corners, then radiance (Gouraud);
                      // radiance (flat)
    fragment_rows = fragment_values + 3,
};

/// Of one triangle.
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
        const std::size_t size = batches * rows_ * lanes_ + lanes_;
        if (size > size_) {
            data_.reset(new float[size]);
            size_ = size;
        }
        if (batches > info_size_) {
            info_.reset(new BatchInfo[batches]);
            info_size_ = batches;
        }
        // Rows begin on whole cache lines.
        const auto address = reinterpret_cast<std::uintptr_t>(data_.get());
        begin_ = data_.get() + (64 - address % 64) % 64 / sizeof(float);
        next_.store(0, std::memory_order_relaxed);
        capacity_ = batches;
    }
    /// First of `count` fresh batches.
    std::uint32_t take(std::uint32_t count) {
        return next_.fetch_add(count, std::memory_order_relaxed);
    }
    float* batch(std::uint32_t b) { return begin_ + b * rows_ * lanes_; }
    const float* batch(std::uint32_t b) const { return begin_ + b * rows_ * lanes_; }
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
    std::unique_ptr<float[]> data_;
    std::unique_ptr<BatchInfo[]> info_;
    float* begin_ = nullptr;
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
    void push(std::size_t tile, std::uint32_t ref) {
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
        std::uint32_t next = none, count = 0;
        std::array<std::uint32_t, capacity> ref;
    };
    std::uint32_t append(std::size_t tile) {
        const auto fresh = std::uint32_t(chunks_.size());
        chunks_.emplace_back();
        (last_[tile] == none ? first_[tile] : chunks_[last_[tile]].next) = fresh;
        return last_[tile] = fresh;
    }
    std::vector<std::uint32_t> first_, last_;  // [tile]
    std::vector<Chunk> chunks_;
};

/// A face that set-up leaves to the driver.
struct SpecialFace {
    std::uint32_t object, triangle;  // the mesh's number; of a quadrilateral the first
};

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
    static constexpr int slack = 18 * block_samples;  // small triangles look at 2 × 2 blocks always
    alignas(64) float depth[tile_samples + slack];
    alignas(64) std::uint32_t ref[tile_samples + slack];
    std::uint32_t owner[subtiles];                // no_ref: nothing yet
    bool written[subtiles];                       // depth and ref hold the subtile
    float nearest[subtiles], farthest[subtiles];  // bounds of the depths of its samples

    bool shows(int subtile) const { return written[subtile] || owner[subtile] != no_ref; }
};

/// What drawing into a tile reads.
struct RasterView {
    const BatchStore *batches, *fragments, *quads;
    const Record* records;
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
    const float* batch = store.batch(at / lanes);
    return reinterpret_cast<const std::uint32_t*>(batch)[row_id * lanes + at % lanes];
}

void clear_tile(TileBuffer& tile);
/// Draws refs of SetupWorker::tiny, ::small and ::medium into the tile whose corner is (x, y).
void raster_tiny(const RasterView& view, int x, int y, const std::uint32_t* refs,
                 std::uint32_t count, TileBuffer& tile);
void raster_small(const RasterView& view, int x, int y, const std::uint32_t* refs,
                  std::uint32_t count, TileBuffer& tile);
void raster_medium(const RasterView& view, int x, int y, const std::uint32_t* refs,
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

// ---- light at vertices and faces

/// Points to light, one after another.
struct PointArrays {
    float *position[3], *normal[3];
};

/// A mesh's vertex slots in the world.
struct PlacedMesh {
    float to_world[3][4];
    const float* normal[3];  // [slot] unit
};

/// The faces of a cluster in the world, by their places in it; face_numbers of them can be read.
struct FaceArrays {
    const float *centre[3], *normal[3];
};

/// Radiance at the vertex slots of an object; seen from behind, `side` further on.
struct VertexLight {
    const float* radiance[3];
    std::uint32_t first;  // of the cluster's first slot
    std::uint32_t side;
};

/// The cluster_padding vertices from `slot` on.
void place_vertices(const ClusteredMesh& mesh, const PlacedMesh& placed, std::uint32_t slot,
                    bool back, const PointArrays& to);
/// The face that each of a batch is or belongs to, turned to the viewer.
void place_faces(const float* batch, const FaceArrays& faces, const PointArrays& to);

/// Planes of radiance from row `to` on, from those of the corners' weights at row `weights`.
void fill_lit(float* batch, int weights, int to, const VertexLight& light);
/// Radiance of a batch of fragments, in place of the corners' weights.
void fill_fragments_lit(float* batch, const VertexLight& light);
/// Radiance at the corners of a batch of quadrilaterals, from row `to` on.
void fill_quads_lit(float* batch, int to, const VertexLight& light);

// ---- from what is seen to surface points

/// What of a material and an object decides how a sample's values are found.
struct ResolveObject {
    Shading shading;
    bool scalar;  // values by the scalar renderers' functions: quadrilaterals in `patch`
};
struct ResolveMaterial {
    bool textured, reads_normal;
};

struct ResolveView {
    RasterView raster;
    Attributes attributes, quad_attributes;
    bool affine;
    float sample_spacing;      // pixels from a sample to the next
    bool position_from_depth;  // else it is an attribute
    const ResolveObject* objects;
    const ResolveMaterial* materials;
    // A point at distance d along the view: eye + d (ray + x ray_x + y ray_y) in perspective,
    // (ray + x ray_x + y ray_y) + d eye in orthographic projection, x and y pixels.
    float eye[3], ray[3], ray_x[3], ray_y[3];
};

inline constexpr int subtile_samples = subtile_side * subtile_side;

/// The visible surface in one subtile: vectors of samples one after another, those without any
/// surface left out. Lanes without a surface hold numbers of no meaning.
struct Surface {
    /// The samples of one vector that are shaded alike.
    struct Part {
        std::uint32_t vector, lanes;  // number of the vector; a bit a lane
        std::uint32_t material;
        bool lit;  // radiance is there already: Gouraud, flat
    };
    /// A sample whose values the driver finds.
    struct Open {
        std::uint32_t at, ref;  // element of the arrays
        bool zero_normal;       // only the normal is missing: it has no length
    };
    alignas(64) float normal[3][subtile_samples];
    alignas(64) float position[3][subtile_samples];
    alignas(64) float radiance[3][subtile_samples];
    alignas(64) float dark[3][subtile_samples];
    alignas(64) float texcoord[2][subtile_samples];
    alignas(
        64) float texstep[4][subtile_samples];  // du_dx, dv_dx, du_dy, dv_dy to the next sample;
                                                // the first not a number: the driver's task
    alignas(64) float albedo[3][subtile_samples];
    alignas(64) float counted[subtile_samples];  // 1: a surface, 0: none
    std::uint16_t tile_at[subtile_samples];      // [vector] of its first sample in the tile
    std::uint32_t vectors;
    Part part[subtile_samples];
    std::uint32_t part_count;
    std::uint32_t covered;  // samples that show a surface
    std::vector<Open> open;

    std::span<const Part> parts() const { return {part, part_count}; }
};

/// Finds the surface of subtile `subtile` of the tile at (x, y).
void resolve_subtile(const ResolveView& view, int x, int y, int subtile, const TileBuffer& tile,
                     Surface& surface);

// ---- from radiance to the picture

/// Where a frame's samples go; null where nobody asks for it. Rows of `width` values.
struct PictureView {
    int width, height;
    std::uint32_t* rgba;  // bytes r, g, b, 255
    float *r, *g, *b;     // radiance is added
    float* depth;
    std::uint32_t* id;
    float scale;  // 2^EV
    bool srgb;
    const float* srgb_start;  // [257] smallest radiance of each byte; the last is infinite
    float background[3];
    std::uint32_t background_rgba;
};

/// Writes the radiance of subtile `subtile` of the tile at (x, y), background where there is no
/// surface. Returns how many samples were not finite and so are black.
std::uint64_t write_radiance(const PictureView& picture, int x, int y, int subtile,
                             const Surface& surface);

/// Writes background into the samples [x, x + width) × [y, y + height), cut to the picture.
void write_background(const PictureView& picture, int x, int y, int width, int height);

/// What this thread has written becomes visible to the others.
void finish_writing();

/// What one worker of set-up has made.
struct SetupWorker {
    TileLists tiny;       // refs of batches: within one block
    TileLists small;      // within one tile and 2 × 2 blocks
    TileLists medium;     // further
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

/// Numbers in a vector of the instruction set in use; at most 16.
int vector_lanes();

}  // namespace scanshade

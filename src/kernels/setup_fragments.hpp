// Fragments: the samples of triangles that are too small to be worth a batch.
#if defined(SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP
#undef SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP
#else
#define SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP
#endif

#include "kernels/setup_batch.hpp"

SCANSHADE_TARGET_BEGIN;

/// A fragment on its way: its triangle as packed in ClusteredMesh, and which sample of the box it is,
/// where a face of four corners has the last.
constexpr int fragment_shift = 3 * corner_bits, fragment_side_bits = 2;
constexpr int most_fragment_side = 3;  // samples of a box, across and down

/// Where triangles cover the sample that is (x, y) from the first of their boxes.
SCANSHADE_INLINE MaskI covers(const Edges<3>& edges, const Boxes& box, int x, int y) {
    VecI least = hn::Set(tag_i, 0x7fffffff);
    for (int k = 0; k < 3; ++k) {
        VecI v = edges.inside[k];
        for (int i = 0; i < x; ++i) v = hn::Add(v, edges.A[k]);
        for (int i = 0; i < y; ++i) v = hn::Add(v, edges.B[k]);
        least = hn::Min(least, v);
    }
    const MaskI inside = hn::Gt(least, hn::Set(tag_i, -1));
    const VecI w = hn::Sub(box.x1, box.x0), h = hn::Sub(box.y1, box.y0);
    const MaskI in_box =
        hn::And(hn::Gt(w, hn::Set(tag_i, x - 1)), hn::Gt(h, hn::Set(tag_i, y - 1)));
    return hn::And(inside, in_box);
}

/// Writes batches of fragments.
class FragmentWriter {
public:
    FragmentWriter(const ClusterContext& of, BatchStore& store, SetupWorker& worker)
        : of_(of), store_(store), worker_(worker) {}

    /// A batch of `count` fragments, of the triangles `t`; lists those of `kept`. With the bits that
    /// raster and resolve find for a triangle in a batch.
    void write(const Triangles& t, std::uint32_t count, MaskI kept) {
        const VecI last = hn::Set(tag_i, (1 << fragment_side_bits) - 1);
        const VecI place = hn::ShiftRight<fragment_shift>(t.corners.packed);
        const VecI px = hn::Add(t.box.x0, hn::And(place, last));
        const VecI py = hn::Add(t.box.y0, hn::And(hn::ShiftRight<fragment_side_bits>(place), last));
        const Lanes X(to_float(hn::Sub(px, t.ox))), Y(to_float(hn::Sub(py, t.oy)));

        const std::uint32_t number = worker_.fragment_run.fresh(store_);
        store_.info(number) = of_.batch_info(count);
        const RowWriter rows(store_.batch(number));
        const Lanes depth = plane_value(t.depth, X, Y);
        rows.store(fragment_depth, depth.v);
        rows.store_int(row_corners, t.corners.packed);
        rows.store_int(fragment_at, index_in_tile(px, py));
        const Weights w = weights_of(t, of_.view.affine);
        if (of_.object.shading == Shading::gouraud) {
            for (int k = 0; k < 3; ++k) rows.store_plane(fragment_weights + 3 * k, w.of[k]);
            rows.store(fragment_x, X.v), rows.store(fragment_y, Y.v);
            rows.store(fragment_unscale, (of_.view.affine ? Lanes(1) : reciprocal(depth)).v);
        } else if (of_.material.store_normals) {
            store_normals(rows, t.corners, turned_weights(t.corners, w), X, Y);
        }
        list(number, kept, px, py);
    }

private:
    void store_normals(const RowWriter& rows, const Corners<3>& c, const Weights& w, Lanes X,
                       Lanes Y) const {
        for (int axis = 0; axis < 3; ++axis) {
            const float* of_local = of_.object.normal[axis] + of_.cluster.first_vertex;
            VecF n[3];
            for (int k = 0; k < 3; ++k) n[k] = look_up(of_local, c.local[k]);
            rows.store(fragment_values + axis, fused_value(weighted_plane(n, w), X, Y).v);
        }
    }

    /// tile_index of a sample of the picture.
    VecI index_in_tile(VecI x, VecI y) const {
        const VecI last = hn::Set(tag_i, of_.view.tile - 1), three = hn::Set(tag_i, 3);
        const VecI tx = hn::And(x, last), ty = hn::And(y, last);
        const VecI block =
            hn::Add(hn::Mul(hn::ShiftRight<2>(ty), hn::Set(tag_i, tile_side / block_side)),
                    hn::ShiftRight<2>(tx));
        return hn::Add(hn::ShiftLeft<4>(block),
                       hn::Add(hn::ShiftLeft<2>(hn::And(ty, three)), hn::And(tx, three)));
    }

    /// Neighbours that lie in the same tile, as the ref of the first and their number.
    void list(std::uint32_t number, MaskI kept, VecI x, VecI y) {
        const int shift = __builtin_ctz(static_cast<unsigned>(of_.view.tile));
        const VecI numbers =
            hn::Add(hn::Mul(hn::ShiftRightSame(y, shift), hn::Set(tag_i, of_.view.tiles_x)),
                    hn::ShiftRightSame(x, shift));
        alignas(64) std::int32_t tile[N];
        hn::Store(numbers, tag_i, tile);
        // Most batches are one run: each pass takes the first lane's, up to the next that is not of it.
        std::uint32_t rest = mask_bits(tag_i, kept);
        while (rest != 0) {
            const auto begin = std::uint32_t(__builtin_ctz(rest));
            const MaskI same = hn::Eq(numbers, hn::Set(tag_i, tile[begin]));
            const std::uint32_t others = ~(rest & mask_bits(tag_i, same)) >> begin;
            const auto length = std::uint32_t(__builtin_ctz(others));
            worker_.fragments.push(std::size_t(tile[begin]), number * std::uint32_t(N) + begin);
            worker_.fragments.push(std::size_t(tile[begin]), length);
            rest &= ~0u << (begin + length);
        }
    }

    const ClusterContext& of_;
    BatchStore& store_;
    SetupWorker& worker_;
};

SCANSHADE_TARGET_END;

#endif

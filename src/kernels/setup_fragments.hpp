// Fragments: the samples of triangles that are too small to be worth a batch.
#if defined(SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP
#undef SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP
#else
#define SCANSHADE_KERNELS_SETUP_FRAGMENTS_HPP
#endif

#include <algorithm>

#include "kernels/setup_geometry.hpp"

SCANSHADE_TARGET_BEGIN;

/// Where a triangle of a box of up to 2 × 2 samples covers the one that is (x, y) from its first.
inline MaskI covers(const Edges<3>& edges, const Boxes& box, int x, int y) {
    VecI least = hn::Set(tag_i, 0x7fffffff);
    for (int k = 0; k < 3; ++k) {
        VecI v = edges.inside[k];
        if (x) v = hn::Add(v, edges.A[k]);
        if (y) v = hn::Add(v, edges.B[k]);
        least = hn::Min(least, v);
    }
    const MaskI inside = hn::Gt(least, hn::Set(tag_i, -1));
    const VecI w = hn::Sub(box.x1, box.x0), h = hn::Sub(box.y1, box.y0);
    const MaskI in_box =
        hn::And(hn::Gt(w, hn::Set(tag_i, x - 1)), hn::Gt(h, hn::Set(tag_i, y - 1)));
    return hn::And(inside, in_box);
}

/// Packs the covered samples of one cluster into batches of its own.
class FragmentWriter {
public:
    FragmentWriter(const ClusterContext& of, BatchStore& store, SetupWorker& worker)
        : of_(of), store_(store), worker_(worker) {}

    /// Triangles whose boxes hold up to 2 × 2 samples.
    void write(const Triangles& t, MaskI kept) {
        ScreenPlane<Lanes> values[3];
        if (has_weights())
            std::copy_n(weights_of(t, of_.view.affine).of, 3, values);
        else if (of_.material.store_normals)
            normal_planes(t, values);
        else
            std::fill_n(values, 3, ScreenPlane<Lanes>{Lanes(0), Lanes(0), Lanes(0)});
        const VecI id = triangle_ids(of_, t.corners.packed);
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x) {
                const MaskI mask = hn::And(kept, covers(t.edges, t.box, x, y));
                if (hn::AllFalse(tag_i, mask)) continue;
                append(t, values, id, hn::Add(t.box.x0, hn::Set(tag_i, x)),
                       hn::Add(t.box.y0, hn::Set(tag_i, y)), mask);
            }
    }

    void finish() {
        if (count_ == 0) return;
        // Unused lanes name some vertex, too.
        hn::StoreU(hn::Zero(tag_i), tag_i, staged_[row_corners] + count_);
        store_batch(count_);
    }

private:
    // Beside the rows of a batch, where on the picture.
    enum { column = fragment_rows, line, staged_rows };

    bool has_weights() const { return of_.object.shading == Shading::gouraud; }

    void normal_planes(const Triangles& t, ScreenPlane<Lanes> (&normal)[3]) const {
        const Weights w = turned_weights(t.corners, weights_of(t, of_.view.affine));
        for (int axis = 0; axis < 3; ++axis) {
            const float* of_local = of_.object.normal[axis] + of_.cluster.first_vertex;
            VecF n[3];
            for (int k = 0; k < 3; ++k) n[k] = look_up(of_local, t.corners.local[k]);
            normal[axis] = weighted_plane(n, w);
        }
    }

    /// With the bits that raster and resolve find for a triangle in a batch.
    void append(const Triangles& t, const ScreenPlane<Lanes> (&values)[3], VecI id, VecI px,
                VecI py, MaskI mask) {
        const VecF X = to_float(hn::Sub(px, t.ox)), Y = to_float(hn::Sub(py, t.oy));
        const Lanes depth = plane_value(t.depth, Lanes(X), Lanes(Y));
        stage(fragment_depth, depth.v, mask);
        stage(row_id, id, mask);
        stage(row_corners, t.corners.packed, mask);
        VecF unscale = hn::Set(tag_f, 1.0f);
        if (has_weights() && !of_.view.affine) unscale = reciprocal(depth).v;
        for (int i = 0; i < 3; ++i) {
            const ScreenPlane<Lanes>& p = values[i];
            const VecF value = hn::MulAdd(p.x.v, X, hn::MulAdd(p.y.v, Y, p.c.v));
            stage(fragment_values + i, hn::Mul(value, unscale), mask);
        }
        stage(column, px, mask);
        stage(line, py, mask);
        count_ += std::uint32_t(hn::CountTrue(tag_i, mask));
        if (count_ < std::uint32_t(N)) return;
        store_batch(std::uint32_t(N));
        for (auto& row : staged_) hn::Store(hn::Load(tag_i, row + N), tag_i, row);
        count_ -= std::uint32_t(N);
    }

    void stage(int row, VecI v, MaskI mask) {
        hn::StoreU(compress(v, mask), tag_i, staged_[row] + count_);
    }
    void stage(int row, VecF v, MaskI mask) { stage(row, hn::BitCast(tag_i, v), mask); }

    void store_batch(std::uint32_t count) {
        const std::uint32_t number = worker_.fragment_run.fresh(store_);
        store_.info(number) = of_.batch_info(count);
        auto* rows = reinterpret_cast<std::int32_t*>(store_.batch(number));
        for (int r = 0; r < fragment_rows; ++r)
            hn::Store(hn::Load(tag_i, staged_[r]), tag_i, rows + r * N);
        const VecI x = hn::Load(tag_i, staged_[column]), y = hn::Load(tag_i, staged_[line]);
        hn::Store(index_in_tile(x, y), tag_i, rows + fragment_at * N);
        list(number, count, x, y);
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
    void list(std::uint32_t number, std::uint32_t count, VecI x, VecI y) {
        const int shift = __builtin_ctz(static_cast<unsigned>(of_.view.tile));
        const VecI numbers =
            hn::Add(hn::Mul(hn::ShiftRightSame(y, shift), hn::Set(tag_i, of_.view.tiles_x)),
                    hn::ShiftRightSame(x, shift));
        alignas(64) std::int32_t tile[N + 1];
        hn::Store(numbers, tag_i, tile);
        tile[count] = -1;
        for (std::uint32_t begin = 0, end; begin < count; begin = end) {
            for (end = begin + 1; tile[end] == tile[begin];) ++end;
            worker_.fragments.push(std::size_t(tile[begin]), number * std::uint32_t(N) + begin);
            worker_.fragments.push(std::size_t(tile[begin]), end - begin);
        }
    }

    const ClusterContext& of_;
    BatchStore& store_;
    SetupWorker& worker_;
    alignas(64) std::int32_t staged_[staged_rows][2 * N];
    std::uint32_t count_ = 0;
};

SCANSHADE_TARGET_END;

#endif

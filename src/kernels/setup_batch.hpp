// Batches of triangles: their rows, and the lists of the tiles that they touch.
#if defined(SCANSHADE_KERNELS_SETUP_BATCH_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SETUP_BATCH_HPP
#undef SCANSHADE_KERNELS_SETUP_BATCH_HPP
#else
#define SCANSHADE_KERNELS_SETUP_BATCH_HPP
#endif

#include "kernels/setup_geometry.hpp"

SCANSHADE_TARGET_BEGIN;

/// Rows of one batch, and what those of triangles and of quadrilaterals have in common.
class RowWriter {
public:
    explicit RowWriter(float* batch) : batch_(batch) {}

    void store(int row, VecF value) const { hn::Store(value, tag_f, batch_ + row * N); }
    void store_int(int row, VecI value) const {
        hn::Store(value, tag_i, reinterpret_cast<std::int32_t*>(batch_ + row * N));
    }
    void store_plane(int row, const ScreenPlane<Lanes>& plane) const {
        store(row, plane.c.v), store(row + 1, plane.x.v), store(row + 2, plane.y.v);
    }

    void store_face(const ClusterContext& of, const Boxes& box, VecI ox, VecI oy,
                    VecI packed) const {
        store(row_origin_x, to_float(ox));
        store(row_origin_y, to_float(oy));
        const VecI columns = hn::ShiftRight<2>(hn::Sub(box.x1, ox));
        const VecI rows = hn::ShiftRight<2>(hn::Sub(box.y1, oy));
        store_int(row_extent, hn::Or(columns, hn::ShiftLeft<16>(rows)));
        store_int(row_corners, packed);
        store_int(row_id, triangle_ids(of, packed));
    }

    /// Steps of whole pixels from the origin.
    template <int K>
    void store_edges(const Edges<K>& e, const Boxes& box, VecI ox, VecI oy) const {
        const VecI back_x = hn::Sub(ox, box.x0), back_y = hn::Sub(oy, box.y0);
        for (int k = 0; k < K; ++k) {
            const VecI at_origin =
                hn::Add(e.inside[k], hn::Add(hn::Mul(e.A[k], back_x), hn::Mul(e.B[k], back_y)));
            store(row_edges + k, to_float(e.A[k]));
            store(row_edges + K + k, to_float(e.B[k]));
            store(row_edges + 2 * K + k, to_float(at_origin));
        }
    }

private:
    float* batch_;
};

/// The world positions of N vertices of a cluster.
struct WorldPositions {
    VecF axis[3];
};
inline WorldPositions world_positions(const ClusterContext& of, VecI local) {
    const ClusteredMesh& mesh = *of.object.mesh;
    const VecF x = look_up(&mesh.x[of.cluster.first_vertex], local);
    const VecF y = look_up(&mesh.y[of.cluster.first_vertex], local);
    const VecF z = look_up(&mesh.z[of.cluster.first_vertex], local);
    WorldPositions p;
    for (int axis = 0; axis < 3; ++axis) {
        const float* m = of.object.to_world[axis];
        p.axis[axis] =
            hn::MulAdd(hn::Set(tag_f, m[0]), x,
                       hn::MulAdd(hn::Set(tag_f, m[1]), y,
                                  hn::MulAdd(hn::Set(tag_f, m[2]), z, hn::Set(tag_f, m[3]))));
    }
    return p;
}

class BatchWriter {
public:
    BatchWriter(const ClusterContext& of, BatchStore& store, SetupWorker& worker)
        : of_(of), store_(store), worker_(worker), rows_(nullptr) {}

    /// Writes a batch of `count` triangles, and lists those of `kept`.
    void write(const Triangles& t, std::uint32_t count, MaskI kept) {
        const std::uint32_t number = worker_.batch_run.fresh(store_);
        store_.info(number) = of_.batch_info(count);
        rows_ = RowWriter(store_.batch(number));
        rows_.store_edges(t.edges, t.box, t.ox, t.oy);
        rows_.store_plane(row_depth, t.depth);
        rows_.store_face(of_, t.box, t.ox, t.oy, t.corners.packed);
        store_attributes(t.corners, weights_of(t, of_.view.affine));
        bin(number, kept, t.box);
    }

private:
    void store_attributes(const Corners<3>& c, const Weights& w) {
        const Attributes& at = of_.view.attributes;
        if (at.main >= 0 && of_.material.store_normals) store_normals(c, w);
        if (at.main >= 0 && of_.object.shading == Shading::gouraud)
            for (int k = 0; k < 3; ++k) rows_.store_plane(at.main + 3 * k, w.of[k]);
        const ClusteredMesh& mesh = *of_.object.mesh;
        if (at.texcoord >= 0 && of_.material.store_texcoords) {
            store_values(at.texcoord, &mesh.u[of_.cluster.first_vertex], c, w);
            store_values(at.texcoord + 3, &mesh.v[of_.cluster.first_vertex], c, w);
        }
        if (at.position >= 0) store_positions(c, w);
    }

    void store_normals(const Corners<3>& c, const Weights& w) {
        const Weights turned = turned_weights(c, w);
        for (int axis = 0; axis < 3; ++axis)
            store_values(of_.view.attributes.main + 3 * axis,
                         of_.object.normal[axis] + of_.cluster.first_vertex, c, turned);
    }

    void store_positions(const Corners<3>& c, const Weights& w) {
        WorldPositions p[3];
        for (int k = 0; k < 3; ++k) p[k] = world_positions(of_, c.local[k]);
        for (int axis = 0; axis < 3; ++axis)
            store_sum(of_.view.attributes.position + 3 * axis,
                      {p[0].axis[axis], p[1].axis[axis], p[2].axis[axis]}, w);
    }

    void store_values(int row, const float* of_local, const Corners<3>& c, const Weights& w) {
        VecF a[3];
        for (int k = 0; k < 3; ++k) a[k] = look_up(of_local, c.local[k]);
        store_sum(row, a, w);
    }

    void store_sum(int row, const VecF (&a)[3], const Weights& w) {
        rows_.store_plane(row, weighted_plane(a, w));
    }

    void bin(std::uint32_t batch, MaskI kept, const Boxes& box) {
        alignas(64) std::int32_t x0[N], y0[N], x1[N], y1[N];
        hn::Store(box.x0, tag_i, x0), hn::Store(box.y0, tag_i, y0);
        hn::Store(box.x1, tag_i, x1), hn::Store(box.y1, tag_i, y1);
        const int tile_shift = __builtin_ctz(static_cast<unsigned>(of_.view.tile));
        for_each_lane(kept, [&](std::uint32_t lane) {
            const std::uint32_t ref = batch * std::uint32_t(N) + lane;
            const int tx0 = x0[lane] >> tile_shift, tx1 = x1[lane] >> tile_shift;
            const int ty0 = y0[lane] >> tile_shift, ty1 = y1[lane] >> tile_shift;
            const int columns = x1[lane] / 4 - x0[lane] / 4, rows = y1[lane] / 4 - y0[lane] / 4;
            const auto tile = std::size_t(ty0 * of_.view.tiles_x + tx0);
            if (columns == 0 && rows == 0) return worker_.tiny.push(tile, ref);
            const bool one_tile = tx0 == tx1 && ty0 == ty1;
            // Small triangles are drawn in 2 × 2 blocks. The second column must not be beyond the
            // tile's last, where a triangle that the picture's edge cuts may go on.
            const bool cut =
                x1[lane] == of_.view.width - 1 && x0[lane] % tile_side >= tile_side - block_side;
            if (one_tile && columns <= 1 && rows <= 1 && !cut) return worker_.small.push(tile, ref);
            for (int ty = ty0; ty <= ty1; ++ty)
                for (int tx = tx0; tx <= tx1; ++tx)
                    worker_.medium.push(std::size_t(ty * of_.view.tiles_x + tx), ref);
        });
    }

    const ClusterContext& of_;
    BatchStore& store_;
    SetupWorker& worker_;
    RowWriter rows_;
};

SCANSHADE_TARGET_END;

#endif

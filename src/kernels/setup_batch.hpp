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

    /// blocks: in the place that row_extent has for them.
    void store_face(const Boxes& box, VecI ox, VecI oy, VecI packed, VecI blocks) const {
        store(row_origin_x, to_float(ox));
        store(row_origin_y, to_float(oy));
        const VecI columns = hn::ShiftRight<2>(hn::Sub(box.x1, ox));
        const VecI rows = hn::ShiftRight<2>(hn::Sub(box.y1, oy));
        // Those of the 4 × 4 blocks that are in the box, each row a figure of four bits.
        const VecI in_columns =
            hn::Mul(hn::Shr(hn::Set(tag_i, 0xf), beyond(columns)), hn::Set(tag_i, 0x1111));
        const VecI in_rows = hn::Shr(hn::Set(tag_i, 0xffff), hn::ShiftLeft<2>(beyond(rows)));
        const VecI in_box = hn::ShiftLeft<16>(hn::And(in_columns, in_rows));
        store_int(row_extent,
                  hn::Or(hn::Or(columns, hn::ShiftLeft<8>(rows)), hn::And(blocks, in_box)));
        store_int(row_corners, packed);
    }

    template <int K>
    void store_edges(const Edges<K>& e, const VecI (&at_origin)[K]) const {
        for (int k = 0; k < K; ++k) {
            store(row_edges + k, to_float(e.A[k]));
            store(row_edges + K + k, to_float(e.B[k]));
            store(row_edges + 2 * K + k, to_float(at_origin[k]));
        }
    }

private:
    /// How many of four places follow place `last`; lanes without a face may ask anything.
    static VecI beyond(VecI last) {
        const VecI rest = hn::Sub(hn::Set(tag_i, 3), last);
        return hn::Min(hn::Max(rest, hn::Zero(tag_i)), hn::Set(tag_i, 3));
    }

    float* batch_;
};

/// Edge functions at the origins, in steps of whole pixels.
template <int K>
SCANSHADE_INLINE void edges_at_origin(const Edges<K>& e, const Boxes& box, VecI ox, VecI oy,
                                      VecI (&at_origin)[K]) {
    const VecI back_x = hn::Sub(ox, box.x0), back_y = hn::Sub(oy, box.y0);
    for (int k = 0; k < K; ++k)
        at_origin[k] =
            hn::Add(e.inside[k], hn::Add(hn::Mul(e.A[k], back_x), hn::Mul(e.B[k], back_y)));
}

/// Which of the 4 × 4 blocks from the origins on triangles may touch, row by row in the upper half of
/// a number: those in which no edge function is negative everywhere, which is to say where its
/// gradient points to.
SCANSHADE_INLINE VecI touched_blocks(const Edges<3>& e, const VecI (&at_origin)[3]) {
    constexpr int side = 4, rise = block_side - 1;
    const VecI zero = hn::Zero(tag_i);
    VecI at[3], right[3], down[3], next_row[3];
    for (int k = 0; k < 3; ++k) {
        const VecI up = hn::Add(hn::Max(e.A[k], zero), hn::Max(e.B[k], zero));
        right[k] = hn::ShiftLeft<2>(e.A[k]), down[k] = hn::ShiftLeft<2>(e.B[k]);
        at[k] = hn::Add(at_origin[k], hn::Mul(up, hn::Set(tag_i, rise)));
        next_row[k] = hn::Sub(down[k], hn::Mul(right[k], hn::Set(tag_i, side - 1)));
    }
    // A sign is shifted in at the top for each block, so the first one ends up lowest.
    VecI missed = zero;
    const VecI sign = hn::Set(tag_i, std::numeric_limits<std::int32_t>::min());
    for (int block = 0; block < side * side; ++block) {
        const VecI negative = hn::And(hn::Or(hn::Or(at[0], at[1]), at[2]), sign);
        missed =
            hn::Or(hn::BitCast(tag_i, hn::ShiftRight<1>(hn::BitCast(tag_u, missed))), negative);
        for (int k = 0; k < 3; ++k)
            at[k] = hn::Add(at[k], block % side == side - 1 ? next_row[k] : right[k]);
    }
    return hn::AndNot(missed, hn::Set(tag_i, std::int32_t(0xffff0000u)));
}

/// The tiles that boxes reach, as the lists of them have to know of faces `kept`, batch · N + lane.
SCANSHADE_INLINE void list_faces(const SetupView& view, const Boxes& box, MaskI kept,
                                 std::uint32_t batch, TileLists& lists) {
    const int shift = __builtin_ctz(static_cast<unsigned>(view.tile));
    const auto tile_of = [&](VecI at) HWY_ATTR { return hn::ShiftRightSame(at, shift); };
    const VecI x0 = tile_of(box.x0), y0 = tile_of(box.y0), x1 = tile_of(box.x1),
               y1 = tile_of(box.y1);
    alignas(64) std::int32_t first[N], columns[N], rows[N];
    hn::Store(hn::Add(x0, hn::Mul(y0, hn::Set(tag_i, view.tiles_x))), tag_i, first);
    hn::Store(hn::Sub(x1, x0), tag_i, columns);
    hn::Store(hn::Sub(y1, y0), tag_i, rows);
    const MaskI one_tile = hn::And(hn::Eq(x0, x1), hn::Eq(y0, y1));
    const std::uint32_t ref = batch * std::uint32_t(N);
    for_each_lane(hn::And(kept, one_tile),
                  [&](std::uint32_t lane) { lists.push(std::size_t(first[lane]), ref + lane); });
    for_each_lane(hn::AndNot(one_tile, kept), [&](std::uint32_t lane) {
        for (int row = 0; row <= rows[lane]; ++row)
            for (int column = 0; column <= columns[lane]; ++column)
                lists.push(std::size_t(first[lane] + row * view.tiles_x + column), ref + lane);
    });
}

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
        VecI at_origin[3];
        edges_at_origin(t.edges, t.box, t.ox, t.oy, at_origin);
        rows_.store_edges(t.edges, at_origin);
        rows_.store_plane(row_depth, t.depth);
        rows_.store_face(t.box, t.ox, t.oy, t.corners.packed, touched_blocks(t.edges, at_origin));
        store_attributes(t.corners, weights_of(t, of_.view.affine));
        list_faces(of_.view, t.box, kept, number, worker_.triangles);
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

    const ClusterContext& of_;
    BatchStore& store_;
    SetupWorker& worker_;
    RowWriter rows_;
};

SCANSHADE_TARGET_END;

#endif

// Quadrilaterals that are drawn whole: batches of them, and the lists of the tiles that they touch.
#if defined(SCANSHADE_KERNELS_SETUP_QUADS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SETUP_QUADS_HPP
#undef SCANSHADE_KERNELS_SETUP_QUADS_HPP
#else
#define SCANSHADE_KERNELS_SETUP_QUADS_HPP
#endif

#include "kernels/screen_quad.hpp"
#include "kernels/setup_batch.hpp"
#include "kernels/setup_vertices.hpp"

SCANSHADE_TARGET_BEGIN;

/// Twice the signed area of the triangle of each corner and its two neighbours.
struct Turns {
    VecI of[4];
};
inline Turns turns_of(const Corners<4>& c) {
    Turns t;
    for (int k = 0; k < 4; ++k) {
        const int from = (k + 3) % 4, to = (k + 1) % 4;
        t.of[k] = hn::Sub(hn::Mul(hn::Sub(c.x[k], c.x[from]), hn::Sub(c.y[to], c.y[k])),
                          hn::Mul(hn::Sub(c.y[k], c.y[from]), hn::Sub(c.x[to], c.x[k])));
    }
    return t;
}

/// A cluster of quadrilaterals, its vertices transformed.
class QuadSetup {
public:
    QuadSetup(const ClusterContext& of, bool clip, BatchStore& store, SetupWorker& worker)
        : of_(of), clip_(clip), store_(store), worker_(worker) {}

    void run() {
        cull();
        for (std::uint32_t first = 0; first < queued_; first += std::uint32_t(N)) {
            const std::uint32_t count = std::min(queued_ - first, std::uint32_t(N));
            const MaskI used = hn::FirstN(tag_i, count);
            write(first, count, used);
        }
    }

private:
    /// Queues the quadrilaterals that may cover a sample and are strictly convex, clockwise on the
    /// picture. The others are the driver's.
    void cull() {
        const std::uint32_t* corners = &of_.object.mesh->corners[of_.cluster.first_face];
        const VecI zero = hn::Zero(tag_i);
        for (std::uint32_t f = 0; f < of_.cluster.face_count; f += std::uint32_t(N)) {
            const Corners<4> c = fetch<4>(of_.vertices, hn::LoadU(tag_i, as_int(corners + f)));
            const MaskI used =
                hn::FirstN(tag_i, std::min(of_.cluster.face_count - f, std::uint32_t(N)));
            const Boxes box = boxes_of(c, of_.view);
            MaskI alive = hn::And(used, holds_samples(box));
            MaskI clipped = hn::MaskFromVec(zero);
            if (clip_) {
                const Outside outside = outside_of(of_.vertices, c);
                clipped = hn::And(used, hn::AndNot(outside.all, outside.any));
                alive = hn::AndNot(outside.any, alive);
            }
            const MaskI large =
                hn::Gt(hn::Max(box.side_x, box.side_y), hn::Set(tag_i, max_small_extent));
            const Turns turns = turns_of(c);
            MaskI right = hn::Gt(turns.of[0], zero), left = hn::Lt(turns.of[0], zero);
            for (int k = 1; k < 4; ++k) {
                right = hn::And(right, hn::Gt(turns.of[k], zero));
                left = hn::And(left, hn::Lt(turns.of[k], zero));
            }
            const MaskI odd = hn::And(alive, hn::Or(large, hn::Not(hn::Or(right, left))));
            for_each_lane(hn::Or(clipped, odd),
                          [&](std::uint32_t lane) { of_.divert(f + lane, worker_); });
            alive = hn::AndNot(odd, alive);
            const MaskI back = of_.object.mirrored ? left : right;
            if (of_.view.cull_back) alive = hn::AndNot(back, alive);
            queued_ += compress_append(pack(c, left, back), alive, queue_ + queued_);
        }
    }

    void write(std::uint32_t first, std::uint32_t count, MaskI used) {
        const Corners<4> c =
            fetch<4>(of_.vertices, hn::IfThenElseZero(used, hn::LoadU(tag_i, queue_ + first)));
        const Boxes box = boxes_of(c, of_.view);
        const VecI ox = hn::And(box.x0, hn::Set(tag_i, ~3)),
                   oy = hn::And(box.y0, hn::Set(tag_i, ~3));
        VecF z[4];
        for (int k = 0; k < 4; ++k) z[k] = look_up(of_.vertices.depth, c.local[k]);
        const MaskI serve = serves(c, box, ox, oy, z);
        for_each_lane(hn::AndNot(serve, used), [&](std::uint32_t lane) {
            of_.divert(std::uint32_t(queue_[first + lane]) >> number_shift, worker_);
        });
        const MaskI kept = hn::And(serve, used);
        if (hn::AllFalse(tag_i, kept)) return;
        const std::uint32_t number = worker_.quad_run.fresh(store_);
        store_.info(number) = of_.batch_info(count);
        const RowWriter rows(store_.batch(number));
        rows.store_face(box, ox, oy, c.packed, hn::Zero(tag_i));
        const Edges<4> edges = edges_of(c, box, of_.view);
        VecI at_origin[4];
        edges_at_origin(edges, box, ox, oy, at_origin);
        rows.store_edges(edges, at_origin);
        store_corners(rows, c, ox, oy, z);
        store_attributes(rows, c);
        list_faces(of_.view, box, kept, number, worker_.quads);
    }

    MaskI serves(const Corners<4>& c, const Boxes& box, VecI ox, VecI oy,
                 const VecF (&z)[4]) const {
        const Turns turns = turns_of(c);
        const Lanes turn[4] = {Lanes(to_float(turns.of[0])), Lanes(to_float(turns.of[1])),
                               Lanes(to_float(turns.of[2])), Lanes(to_float(turns.of[3]))};
        const Lanes nearest(hn::Max(hn::Max(z[0], z[1]), hn::Max(z[2], z[3])));
        const Lanes farthest(hn::Min(hn::Min(z[0], z[1]), hn::Min(z[2], z[3])));
        return hn::RebindMask(
            tag_i, quads_serve(nearest, farthest, turn, Lanes(to_float(hn::Sub(box.x1, ox))),
                               Lanes(to_float(hn::Sub(box.y1, oy))), Lanes(to_float(box.side_x)),
                               Lanes(to_float(box.side_y)), Lanes(of_.view.steepest))
                       .m);
    }

    /// ScreenQuad's numbers: pixels from the sample of the origin.
    void store_corners(const RowWriter& rows, const Corners<4>& c, VecI ox, VecI oy,
                       const VecF (&z)[4]) const {
        const VecI sample_x = hn::Add(hn::ShiftLeft<8>(ox), hn::Set(tag_i, of_.view.sample_x));
        const VecI sample_y = hn::Add(hn::ShiftLeft<8>(oy), hn::Set(tag_i, of_.view.sample_y));
        const VecF pixel = hn::Set(tag_f, 1.0f / 256);
        VecF y[4];
        for (int k = 0; k < 4; ++k) {
            rows.store(row_quad_x + k, hn::Mul(to_float(hn::Sub(c.x[k], sample_x)), pixel));
            y[k] = hn::Mul(to_float(hn::Sub(c.y[k], sample_y)), pixel);
            rows.store(row_quad_y + k, y[k]);
            rows.store(row_quad_depth + k, z[k]);
        }
        for (int k = 0; k < 4; ++k)
            rows.store(row_quad_per_height + k, per_height(Lanes(hn::Sub(y[(k + 1) % 4], y[k]))).v);
    }

    void store_attributes(const RowWriter& rows, const Corners<4>& c) const {
        const Attributes& at = of_.view.quad_attributes;
        const ClusteredMesh& mesh = *of_.object.mesh;
        const std::uint32_t first = of_.cluster.first_vertex;
        const VecF side = side_of(c.packed);
        for (int k = 0; k < 4; ++k) {
            const auto value = [&](const float* of_local)
                                   HWY_ATTR { return look_up(of_local + first, c.local[k]); };
            for (int axis = 0; axis < 3 && at.main >= 0 && of_.material.store_normals; ++axis)
                rows.store(at.main + 4 * axis + k, hn::Mul(value(of_.object.normal[axis]), side));
            if (at.texcoord >= 0 && of_.material.store_texcoords) {
                rows.store(at.texcoord + k, value(mesh.u.data()));
                rows.store(at.texcoord + 4 + k, value(mesh.v.data()));
            }
            if (at.position < 0) continue;
            const WorldPositions p = world_positions(of_, c.local[k]);
            for (int axis = 0; axis < 3; ++axis)
                rows.store(at.position + 4 * axis + k, p.axis[axis]);
        }
    }

    const ClusterContext& of_;
    const bool clip_;
    BatchStore& store_;
    SetupWorker& worker_;
    alignas(64) std::int32_t queue_[max_cluster_triangles + 2 * cluster_padding];
    std::uint32_t queued_ = 0;
};

SCANSHADE_TARGET_END;

#endif

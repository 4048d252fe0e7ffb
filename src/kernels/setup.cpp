// Set-up: a cluster's vertices to the picture, its triangles to batches and lists a tile.
#define SCANSHADE_SIMD

#include <algorithm>
#include <array>

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/setup.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/setup_batch.hpp"
#include "kernels/setup_fragments.hpp"

SCANSHADE_TARGET_BEGIN;

/// Longest side of a box whose edge functions fit into int32 and, in whole pixels, into float.
constexpr std::int32_t max_small_extent = 32000;

class ClusterSetup {
public:
    ClusterSetup(const SetupView& view, const SetupObject& object, std::uint32_t number, bool clip,
                 BatchStore& batches, BatchStore& fragments, SetupWorker& worker)
        : of_{view,
              object,
              number,
              object.mesh->clusters[number],
              object.material[object.mesh->clusters[number].material],
              {}},
          clip_(clip),
          batches_(batches),
          fragments_(fragments),
          worker_(worker) {}

    void run() {
        transform();
        cull();
        // Two ways to draw the same: which one is a matter of speed alone.
        if (tiny_ * 2 > queued_ && of_.object.fragments && !of_.material.store_texcoords) {
            divide();
            FragmentWriter fragments(of_, fragments_, worker_);
            each(divided_queue_, divided_,
                 [&](const Triangles& t, std::uint32_t, MaskI kept)
                     HWY_ATTR { fragments.write(t, kept); });
            fragments.finish();
        }
        BatchWriter batches(of_, batches_, worker_);
        each(queue_, queued_, [&](const Triangles& t, std::uint32_t count, MaskI kept) HWY_ATTR {
            batches.write(t, count, kept);
        });
    }

private:
    // ---- vertices
    void transform() {
        const ClusteredMesh& mesh = *of_.object.mesh;
        for (std::uint32_t i = 0; i < of_.cluster.vertex_count; i += std::uint32_t(N)) {
            const std::uint32_t slot = of_.cluster.first_vertex + i;
            const VecF x = hn::LoadU(tag_f, &mesh.x[slot]), y = hn::LoadU(tag_f, &mesh.y[slot]),
                       z = hn::LoadU(tag_f, &mesh.z[slot]);
            // Not fused, as the scalar renderers do it.
            const auto row = [&](int r) HWY_ATTR {
                const float* m = of_.object.to_clip[r];
                const VecF sum =
                    hn::Add(hn::Mul(hn::Set(tag_f, m[0]), x), hn::Mul(hn::Set(tag_f, m[1]), y));
                return hn::Add(hn::Add(sum, hn::Mul(hn::Set(tag_f, m[2]), z)),
                               hn::Set(tag_f, m[3]));
            };
            const VecF cx = row(0), cy = row(1), cd = row(2),
                       cw = of_.view.orthographic ? row(3) : cd;
            hn::Store(snap(cx, cw, of_.view.width), tag_i, of_.vertices.x + i);
            hn::Store(snap(cy, cw, of_.view.height), tag_i, of_.vertices.y + i);
            hn::Store(depth(cd, cw), tag_f, of_.vertices.depth + i);
            if (clip_) hn::Store(outcode(cx, cy, cd, cw), tag_i, of_.vertices.outcode + i);
        }
    }

    VecI snap(VecF x, VecF w, int size) const {
        const VecF limit = hn::Set(tag_f, of_.view.guard_band * 256.0f);
        const VecF s = hn::Mul(hn::Div(x, w), hn::Set(tag_f, 256.0f));
        const VecI whole = hn::NearestInt(hn::Min(hn::Max(s, hn::Neg(limit)), limit));
        return hn::Add(whole, hn::Set(tag_i, size * 128));
    }

    VecF depth(VecF d, VecF w) const {
        const VecF near = hn::Set(tag_f, of_.view.near);
        if (!of_.view.orthographic) return hn::Div(near, w);
        const VecF share = hn::Div(hn::Sub(d, near), hn::Set(tag_f, of_.view.far - of_.view.near));
        return hn::Sub(hn::Set(tag_f, 1.0f), hn::Mul(hn::Set(tag_f, 0.5f), share));
    }

    /// The bits of Outcode: near, far, left, right, top, bottom.
    VecI outcode(VecF x, VecF y, VecF d, VecF w) const {
        const VecF g = hn::Mul(hn::Set(tag_f, of_.view.guard_band), w);
        const VecF ng = hn::Neg(g);
        const auto bit = [](MaskF inside, int value) HWY_ATTR {
            return hn::IfThenZeroElse(hn::RebindMask(tag_i, inside), hn::Set(tag_i, value));
        };
        const VecI depth_bits = hn::Or(bit(hn::Ge(d, hn::Set(tag_f, of_.view.near)), 1),
                                       bit(hn::Le(d, hn::Set(tag_f, of_.view.far)), 2));
        const VecI x_bits = hn::Or(bit(hn::Ge(x, ng), 4), bit(hn::Le(x, g), 8));
        const VecI y_bits = hn::Or(bit(hn::Ge(y, ng), 16), bit(hn::Le(y, g), 32));
        return hn::Or(depth_bits, hn::Or(x_bits, y_bits));
    }

    /// Queues the triangles that may cover a sample, corners turned so that their area is positive.
    void cull() {
        const std::uint32_t* corners = &of_.object.mesh->corners[of_.cluster.first_triangle];
        const VecI zero = hn::Zero(tag_i);
        for (std::uint32_t t = 0; t < of_.cluster.triangle_count; t += std::uint32_t(N)) {
            const Corners c = fetch(of_.vertices, hn::LoadU(tag_i, as_int(corners + t)));
            const Boxes box = boxes_of(c, of_.view);
            MaskI alive = hn::Not(hn::Or(hn::Gt(box.x0, box.x1), hn::Gt(box.y0, box.y1)));
            if (clip_) alive = divert_clipped(c, t, alive);
            const MaskI large = hn::And(
                alive, hn::Gt(hn::Max(box.side_x, box.side_y), hn::Set(tag_i, max_small_extent)));
            if (!hn::AllFalse(tag_i, large)) {
                divert(large, t);
                alive = hn::AndNot(large, alive);
            }
            const VecI area = area2(c);
            const MaskI no_area = hn::And(alive, hn::Eq(area, zero));
            if (!hn::AllFalse(tag_i, no_area)) count_no_area(no_area, t);
            const MaskI positive = hn::Gt(area, zero), negative = hn::Lt(area, zero);
            alive = hn::AndNot(no_area, alive);
            const MaskI back = of_.object.mirrored ? negative : positive;
            if (of_.view.cull_back) alive = hn::AndNot(back, alive);
            queue(alive, negative, back, c);
            count_tiny(alive, box);
        }
    }

    /// Corners turned, the side noted, packed again.
    void queue(MaskI alive, MaskI negative, MaskI back, const Corners& c) {
        const VecI second = hn::IfThenElse(negative, c.local[2], c.local[1]);
        const VecI third = hn::IfThenElse(negative, c.local[1], c.local[2]);
        const VecI number = hn::And(c.packed, hn::Set(tag_i, ~std::int32_t(number_bit - 1)));
        const VecI side = hn::IfThenElseZero(back, hn::Set(tag_i, std::int32_t(back_bit)));
        const VecI packed =
            hn::Or(hn::Or(c.local[0], hn::ShiftLeft<corner_bits>(second)),
                   hn::Or(hn::ShiftLeft<2 * corner_bits>(third), hn::Or(number, side)));
        queued_ += compress_append(packed, alive, queue_ + queued_);
    }

    void count_tiny(MaskI alive, const Boxes& box) {
        const VecI two = hn::Set(tag_i, 2);
        const MaskI tiny =
            hn::And(hn::Lt(hn::Sub(box.x1, box.x0), two), hn::Lt(hn::Sub(box.y1, box.y0), two));
        tiny_ += std::uint32_t(hn::CountTrue(tag_i, hn::And(alive, tiny)));
    }

    MaskI divert_clipped(const Corners& c, std::uint32_t first, MaskI alive) {
        VecI code[3];
        for (int k = 0; k < 3; ++k)
            code[k] = hn::GatherIndex(tag_i, of_.vertices.outcode, c.local[k]);
        const VecI zero = hn::Zero(tag_i);
        const MaskI any = hn::Ne(hn::Or(code[0], hn::Or(code[1], code[2])), zero);
        if (hn::AllFalse(tag_i, any)) return alive;
        const MaskI all = hn::Ne(hn::And(code[0], hn::And(code[1], code[2])), zero);
        divert(hn::AndNot(all, any), first);
        return hn::AndNot(any, alive);
    }

    /// Leaves triangles first + lane to the driver.
    void divert(MaskI lanes, std::uint32_t first) {
        for_each_lane(lanes, [&](std::uint32_t lane) {
            if (first + lane < of_.cluster.triangle_count) divert_one(first + lane);
        });
    }
    void divert_one(std::uint32_t t) {
        worker_.special.push_back(
            {of_.object.index, of_.object.mesh->triangle[of_.cluster.first_triangle + t]});
    }

    void count_no_area(MaskI lanes, std::uint32_t first) {
        for_each_lane(lanes, [&](std::uint32_t lane) {
            worker_.events.add(Event::zero_area, first + lane < of_.cluster.triangle_count);
        });
    }

    /// Moves triangles whose box holds up to 2 × 2 samples to a queue of their own, if they cover
    /// any.
    void divide() {
        const VecI one = hn::Set(tag_i, 1);
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < queued_; i += std::uint32_t(N)) {
            const VecI packed = hn::LoadU(tag_i, queue_ + i);
            const Corners c = fetch(of_.vertices, packed);
            const Boxes box = boxes_of(c, of_.view);
            const MaskI larger =
                hn::Or(hn::Gt(hn::Sub(box.x1, box.x0), one), hn::Gt(hn::Sub(box.y1, box.y0), one));
            const MaskI used = hn::FirstN(tag_i, std::min(queued_ - i, std::uint32_t(N)));
            const Edges edges = edges_of(c, box, of_.view);
            MaskI any = hn::MaskFromVec(hn::Zero(tag_i));
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 2; ++x) any = hn::Or(any, covers(edges, box, x, y));
            divided_ += compress_append(packed, hn::And(used, hn::AndNot(larger, any)),
                                        divided_queue_ + divided_);
            kept += compress_append(packed, hn::And(used, larger), queue_ + kept);
        }
        queued_ = kept;
    }

    /// Calls take(triangles, count, kept) for the triangles of a queue, N at a time.
    template <class Take>
    void each(const std::int32_t* queue, std::uint32_t queued, Take&& take) {
        for (std::uint32_t first = 0; first < queued; first += std::uint32_t(N)) {
            const std::uint32_t count = std::min(queued - first, std::uint32_t(N));
            // Lanes without a triangle read the cluster's first vertex, not what is beyond its last.
            const MaskI used = hn::FirstN(tag_i, count);
            const Triangles t = triangles_of(
                of_.vertices, hn::IfThenElseZero(used, hn::LoadU(tag_i, queue + first)), of_.view);
            const MaskI serve = planes_serve_of(t, of_.view);
            const MaskI needles = hn::AndNot(serve, used);
            if (!hn::AllFalse(tag_i, needles))
                for_each_lane(needles, [&](std::uint32_t lane) {
                    divert_one(std::uint32_t(queue[first + lane]) >> number_shift);
                });
            const MaskI kept = hn::And(serve, used);
            if (!hn::AllFalse(tag_i, kept)) take(t, count, kept);
        }
    }

    ClusterContext of_;
    const bool clip_;
    BatchStore &batches_, &fragments_;
    SetupWorker& worker_;
    // What may cover a sample: corners and number as packed in ClusteredMesh.
    alignas(64) std::int32_t queue_[max_cluster_triangles + 2 * cluster_padding];
    std::uint32_t queued_ = 0, tiny_ = 0;
    alignas(64) std::int32_t divided_queue_[max_cluster_triangles + 2 * cluster_padding];
    std::uint32_t divided_ = 0;
};

void setup_one(const SetupView& view, const SetupObject& object, std::uint32_t cluster, bool clip,
               BatchStore& batches, BatchStore& fragments, SetupWorker& worker) {
    ClusterSetup(view, object, cluster, clip, batches, fragments, worker).run();
}

int lanes_here() { return N; }

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(setup_one);
HWY_EXPORT(lanes_here);

void setup_cluster(const SetupView& view, const SetupObject& object, std::uint32_t cluster,
                   bool clip, BatchStore& batches, BatchStore& fragments, SetupWorker& worker) {
    HWY_DYNAMIC_DISPATCH(setup_one)(view, object, cluster, clip, batches, fragments, worker);
}

int vector_lanes() { return HWY_DYNAMIC_DISPATCH(lanes_here)(); }

}  // namespace scanshade
#endif

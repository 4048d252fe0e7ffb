// Set-up: a cluster's vertices to the picture, its triangles to batches and lists a tile.
#define SCANSHADE_SIMD

#include <algorithm>
#include <array>
#include <bitset>
#include <limits>

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/setup.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/setup_batch.hpp"
#include "kernels/setup_fragments.hpp"
#include "kernels/setup_quads.hpp"
#include "kernels/setup_vertices.hpp"

SCANSHADE_TARGET_BEGIN;

/// A cluster of triangles, its vertices transformed.
class TriangleSetup {
public:
    TriangleSetup(const ClusterContext& of, bool clip, const SetupStores& to, SetupWorker& worker)
        : of_(of), clip_(clip), to_(to), worker_(worker) {}

    void run() {
        cull();
        // Two ways to draw the same: which one is a matter of speed alone.
        if (tiny_ * 2 > queued_ && of_.object.fragments && !of_.material.textured) {
            divide();
            FragmentWriter fragments(of_, to_.fragments, worker_);
            each(fragment_queue_, fragments_,
                 [&](const Triangles& t, std::uint32_t count, MaskI kept)
                     HWY_ATTR { fragments.write(t, count, kept); });
        }
        BatchWriter batches(of_, to_.batches, worker_);
        each(queue_, queued_, [&](const Triangles& t, std::uint32_t count, MaskI kept) HWY_ATTR {
            batches.write(t, count, kept);
        });
    }

private:
    /// Queues the triangles that may cover a sample, corners turned so that their area is positive.
    void cull() {
        const std::uint32_t* corners = &of_.object.mesh->corners[of_.cluster.first_face];
        const VecI zero = hn::Zero(tag_i);
        for (std::uint32_t t = 0; t < of_.cluster.face_count; t += std::uint32_t(N)) {
            const Corners<3> c = fetch<3>(of_.vertices, hn::LoadU(tag_i, as_int(corners + t)));
            const Boxes box = boxes_of(c, of_.view);
            MaskI alive = holds_samples(box);
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
            queued_ += compress_append(pack(c, negative, back), alive, queue_ + queued_);
            count_tiny(alive, box);
        }
    }

    void count_tiny(MaskI alive, const Boxes& box) {
        const VecI side = hn::Set(tag_i, most_fragment_side);
        const MaskI tiny =
            hn::And(hn::Lt(hn::Sub(box.x1, box.x0), side), hn::Lt(hn::Sub(box.y1, box.y0), side));
        tiny_ += std::uint32_t(hn::CountTrue(tag_i, hn::And(alive, tiny)));
    }

    MaskI divert_clipped(const Corners<3>& c, std::uint32_t first, MaskI alive) {
        const Outside outside = outside_of(of_.vertices, c);
        divert(hn::AndNot(outside.all, outside.any), first);
        return hn::AndNot(outside.any, alive);
    }

    /// Leaves triangles first + lane to the driver.
    void divert(MaskI lanes, std::uint32_t first) {
        for_each_lane(lanes, [&](std::uint32_t lane) {
            if (first + lane < of_.cluster.face_count) of_.divert(first + lane, worker_);
        });
    }

    void divert_once(std::uint32_t face) {
        if (!diverted_.test(face)) of_.divert(face, worker_);
        diverted_.set(face);
    }

    void count_no_area(MaskI lanes, std::uint32_t first) {
        for_each_lane(lanes, [&](std::uint32_t lane) {
            worker_.events.add(Event::zero_area, first + lane < of_.cluster.face_count);
        });
    }

    /// Leaves larger triangles in the queue, and those for whose fragments there might be no room; puts
    /// the samples that the others cover into a queue of their own.
    void divide() {
        const VecI side = hn::Set(tag_i, most_fragment_side - 1);
        constexpr std::uint32_t most_covered = most_fragment_side * most_fragment_side;
        const std::uint32_t room = most_fragments * of_.cluster.face_count;
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < queued_; i += std::uint32_t(N)) {
            const std::uint32_t count = std::min(queued_ - i, std::uint32_t(N));
            const MaskI used = hn::FirstN(tag_i, count);
            const VecI packed = hn::IfThenElseZero(used, hn::LoadU(tag_i, queue_ + i));
            if (fragments_ + count * most_covered > room) {
                kept += compress_append(packed, used, queue_ + kept);
                continue;
            }
            const Corners<3> c = fetch<3>(of_.vertices, packed);
            const Boxes box = boxes_of(c, of_.view);
            const MaskI larger = hn::Or(hn::Gt(hn::Sub(box.x1, box.x0), side),
                                        hn::Gt(hn::Sub(box.y1, box.y0), side));
            kept += compress_append(packed, hn::And(used, larger), queue_ + kept);
            const Edges<3> edges = edges_of(c, box, of_.view);
            const MaskI small = hn::AndNot(larger, used);
            for (int y = 0; y < most_fragment_side; ++y)
                for (int x = 0; x < most_fragment_side; ++x) {
                    const int place = (x + (y << fragment_side_bits)) << fragment_shift;
                    fragments_ += compress_append(hn::Or(packed, hn::Set(tag_i, place)),
                                                  hn::And(small, covers(edges, box, x, y)),
                                                  fragment_queue_ + fragments_);
                }
        }
        queued_ = kept;
    }

    /// Calls take(triangles, count, kept) for the triangles of a queue, N at a time. In that of
    /// fragments one stands for each.
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
                    divert_once(std::uint32_t(queue[first + lane]) >> number_shift);
                });
            const MaskI kept = hn::And(serve, used);
            if (!hn::AllFalse(tag_i, kept)) take(t, count, kept);
        }
    }

    const ClusterContext& of_;
    const bool clip_;
    const SetupStores& to_;
    SetupWorker& worker_;
    // What may cover a sample: corners and number as packed in ClusteredMesh.
    alignas(64) std::int32_t queue_[max_cluster_triangles + 2 * cluster_padding];
    std::uint32_t queued_ = 0, tiny_ = 0;
    // Such triangles once for each sample that they cover, the sample noted as FragmentWriter has it.
    alignas(64) std::int32_t
        fragment_queue_[most_fragments * max_cluster_triangles + 2 * cluster_padding];
    std::uint32_t fragments_ = 0;
    std::bitset<face_numbers> diverted_;  // for which planes do not serve
};

void setup_one(const SetupView& view, const SetupObject& object, std::uint32_t number, bool clip,
               const SetupStores& to, SetupWorker& worker) {
    ClusterContext of(view, object, number);
    VertexTransform(of, clip).run();
    if (of.cluster.corners == 4)
        QuadSetup(of, clip, to.quads, worker).run();
    else
        TriangleSetup(of, clip, to, worker).run();
}

int lanes_here() { return N; }

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(setup_one);
HWY_EXPORT(lanes_here);

void setup_cluster(const SetupView& view, const SetupObject& object, std::uint32_t cluster,
                   bool clip, const SetupStores& to, SetupWorker& worker) {
    HWY_DYNAMIC_DISPATCH(setup_one)(view, object, cluster, clip, to, worker);
}

void prefetch_cluster(const SetupObject& object, std::uint32_t number) {
    const ClusteredMesh& mesh = *object.mesh;
    const Cluster& cluster = mesh.clusters[number];
    const auto fetch = [](const auto* first, std::uint32_t count) {
        constexpr std::size_t line = 64 / sizeof *first;
        for (std::size_t i = 0; i < count; i += line) __builtin_prefetch(first + i);
    };
    for (const LargeVector<float>* axis : {&mesh.x, &mesh.y, &mesh.z})
        fetch(axis->data() + cluster.first_vertex, cluster.vertex_count);
    fetch(mesh.corners.data() + cluster.first_face, cluster.face_count);
    if (object.shading == Shading::phong)
        for (const float* axis : object.normal)
            fetch(axis + cluster.first_vertex, cluster.vertex_count);
}

int vector_lanes() { return HWY_DYNAMIC_DISPATCH(lanes_here)(); }

}  // namespace scanshade
#endif

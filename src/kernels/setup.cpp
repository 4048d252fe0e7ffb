// Set-up: a cluster's vertices to the picture, its triangles to batches and lists a tile.
#define SCANSHADE_SIMD

#include <algorithm>
#include <array>

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/setup.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/screen_plane.hpp"
#include "kernels/vectors.hpp"
#include "scanshade/num/lanes.hpp"

SCANSHADE_TARGET_BEGIN;

/// Longest side of a box whose edge functions fit into int32 and, in whole pixels, into float.
constexpr std::int32_t max_small_extent = 32000;

/// A cluster's vertices on the picture.
struct ClusterVertices {
    alignas(64) std::int32_t x[max_cluster_vertices];  // 1/256 pixel
    alignas(64) std::int32_t y[max_cluster_vertices];
    alignas(64) float depth[max_cluster_vertices];
    alignas(64) std::int32_t outcode[max_cluster_vertices];
};

/// The corners of N triangles.
struct Corners {
    VecI packed, local[3], x[3], y[3];
};

inline VecI box_first(VecI least, int sample) {
    return hn::ShiftRight<8>(hn::Add(least, hn::Set(tag_i, 255 - sample)));
}
inline VecI box_last(VecI most, int sample) {
    return hn::ShiftRight<8>(hn::Sub(most, hn::Set(tag_i, sample)));
}

/// The samples that the triangles' boxes hold, clipped to the picture.
struct Boxes {
    VecI x0, y0, x1, y1;
    VecI side_x, side_y;  // before clipping, 1/256 pixel
};

inline Boxes boxes_of(const Corners& c, const SetupView& view) {
    const VecI zero = hn::Zero(tag_i);
    const VecI lx = hn::Min(c.x[0], hn::Min(c.x[1], c.x[2]));
    const VecI hx = hn::Max(c.x[0], hn::Max(c.x[1], c.x[2]));
    const VecI ly = hn::Min(c.y[0], hn::Min(c.y[1], c.y[2]));
    const VecI hy = hn::Max(c.y[0], hn::Max(c.y[1], c.y[2]));
    return {hn::Max(zero, box_first(lx, view.sample_x)),
            hn::Max(zero, box_first(ly, view.sample_y)),
            hn::Min(hn::Set(tag_i, view.width - 1), box_last(hx, view.sample_x)),
            hn::Min(hn::Set(tag_i, view.height - 1), box_last(hy, view.sample_y)),
            hn::Sub(hx, lx),
            hn::Sub(hy, ly)};
}

class ClusterSetup {
public:
    ClusterSetup(const SetupView& view, const SetupObject& object, std::uint32_t number, bool clip,
                 BatchStore& store, SetupWorker& worker)
        : view_(view),
          object_(object),
          number_(number),
          cluster_(object.mesh->clusters[number]),
          material_(object.material[cluster_.material]),
          clip_(clip),
          store_(store),
          worker_(worker) {}

    void run() {
        transform();
        cull();
        if (tiny_ * 2 > queued_) drop_uncovered();
        for (std::uint32_t i = 0; i < queued_; i += std::uint32_t(N)) set_up(i);
    }

private:
    // ---- vertices
    void transform() {
        const ClusteredMesh& mesh = *object_.mesh;
        for (std::uint32_t i = 0; i < cluster_.vertex_count; i += std::uint32_t(N)) {
            const std::uint32_t slot = cluster_.first_vertex + i;
            const VecF x = hn::LoadU(tag_f, &mesh.x[slot]), y = hn::LoadU(tag_f, &mesh.y[slot]),
                       z = hn::LoadU(tag_f, &mesh.z[slot]);
            // Not fused, as the scalar renderers do it.
            const auto row = [&](int r) HWY_ATTR {
                const float* m = object_.to_clip[r];
                const VecF sum =
                    hn::Add(hn::Mul(hn::Set(tag_f, m[0]), x), hn::Mul(hn::Set(tag_f, m[1]), y));
                return hn::Add(hn::Add(sum, hn::Mul(hn::Set(tag_f, m[2]), z)),
                               hn::Set(tag_f, m[3]));
            };
            const VecF cx = row(0), cy = row(1), cd = row(2), cw = view_.orthographic ? row(3) : cd;
            hn::Store(snap(cx, cw, view_.width), tag_i, vertices_.x + i);
            hn::Store(snap(cy, cw, view_.height), tag_i, vertices_.y + i);
            hn::Store(depth(cd, cw), tag_f, vertices_.depth + i);
            if (clip_) hn::Store(outcode(cx, cy, cd, cw), tag_i, vertices_.outcode + i);
        }
    }

    VecI snap(VecF x, VecF w, int size) const {
        const VecF limit = hn::Set(tag_f, view_.guard_band * 256.0f);
        const VecF s = hn::Mul(hn::Div(x, w), hn::Set(tag_f, 256.0f));
        const VecI whole = hn::NearestInt(hn::Min(hn::Max(s, hn::Neg(limit)), limit));
        return hn::Add(whole, hn::Set(tag_i, size * 128));
    }

    VecF depth(VecF d, VecF w) const {
        const VecF near = hn::Set(tag_f, view_.near);
        if (!view_.orthographic) return hn::Div(near, w);
        const VecF share = hn::Div(hn::Sub(d, near), hn::Set(tag_f, view_.far - view_.near));
        return hn::Sub(hn::Set(tag_f, 1.0f), hn::Mul(hn::Set(tag_f, 0.5f), share));
    }

    /// The bits of Outcode: near, far, left, right, top, bottom.
    VecI outcode(VecF x, VecF y, VecF d, VecF w) const {
        const VecF g = hn::Mul(hn::Set(tag_f, view_.guard_band), w);
        const VecF ng = hn::Neg(g);
        const auto bit = [](MaskF inside, int value) HWY_ATTR {
            return hn::IfThenZeroElse(hn::RebindMask(tag_i, inside), hn::Set(tag_i, value));
        };
        const VecI depth_bits = hn::Or(bit(hn::Ge(d, hn::Set(tag_f, view_.near)), 1),
                                       bit(hn::Le(d, hn::Set(tag_f, view_.far)), 2));
        const VecI x_bits = hn::Or(bit(hn::Ge(x, ng), 4), bit(hn::Le(x, g), 8));
        const VecI y_bits = hn::Or(bit(hn::Ge(y, ng), 16), bit(hn::Le(y, g), 32));
        return hn::Or(depth_bits, hn::Or(x_bits, y_bits));
    }

    // ---- triangles
    Corners fetch(VecI packed) const {
        Corners c;
        c.packed = packed;
        const VecI local = hn::Set(tag_i, max_cluster_vertices - 1);
        c.local[0] = hn::And(packed, local);
        c.local[1] = hn::And(hn::ShiftRight<corner_bits>(packed), local);
        c.local[2] = hn::And(hn::ShiftRight<2 * corner_bits>(packed), local);
        for (int k = 0; k < 3; ++k) {
            c.x[k] = hn::GatherIndex(tag_i, vertices_.x, c.local[k]);
            c.y[k] = hn::GatherIndex(tag_i, vertices_.y, c.local[k]);
        }
        return c;
    }

    static VecI area2(const Corners& c) {
        return hn::Sub(hn::Mul(hn::Sub(c.x[1], c.x[0]), hn::Sub(c.y[2], c.y[0])),
                       hn::Mul(hn::Sub(c.x[2], c.x[0]), hn::Sub(c.y[1], c.y[0])));
    }

    /// Queues the triangles that may cover a sample, corners turned so that their area is positive.
    void cull() {
        const std::uint32_t* corners = &object_.mesh->corners[cluster_.first_triangle];
        const VecI zero = hn::Zero(tag_i);
        for (std::uint32_t t = 0; t < cluster_.triangle_count; t += std::uint32_t(N)) {
            const Corners c = fetch(hn::LoadU(tag_i, as_int(corners + t)));
            const Boxes box = boxes_of(c, view_);
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
            const MaskI back = object_.mirrored ? negative : positive;
            if (view_.cull_back) alive = hn::AndNot(back, alive);
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
        for (int k = 0; k < 3; ++k) code[k] = hn::GatherIndex(tag_i, vertices_.outcode, c.local[k]);
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
            if (first + lane < cluster_.triangle_count) divert_one(first + lane);
        });
    }
    void divert_one(std::uint32_t t) {
        worker_.special.push_back(
            {object_.index, object_.mesh->triangle[cluster_.first_triangle + t]});
    }

    void count_no_area(MaskI lanes, std::uint32_t first) {
        for_each_lane(lanes, [&](std::uint32_t lane) {
            worker_.events.add(Event::zero_area, first + lane < cluster_.triangle_count);
        });
    }

    // ---- set-up of N triangles of the queue
    struct Edges {
        VecI A[3], B[3];
        VecI c[3];       // at the box's first sample, 1/256 pixel²
        VecI inside[3];  // ⌊(c − bias)/256⌋: ≥ 0 where the sample is inside
    };

    Edges edges_of(const Corners& c, const Boxes& box) const {
        Edges e;
        const VecI zero = hn::Zero(tag_i);
        const VecI px = hn::Add(hn::ShiftLeft<8>(box.x0), hn::Set(tag_i, view_.sample_x));
        const VecI py = hn::Add(hn::ShiftLeft<8>(box.y0), hn::Set(tag_i, view_.sample_y));
        for (int k = 0; k < 3; ++k) {
            const int j = (k + 1) % 3;
            e.A[k] = hn::Sub(c.y[k], c.y[j]);
            e.B[k] = hn::Sub(c.x[j], c.x[k]);
            e.c[k] =
                hn::Add(hn::Mul(e.A[k], hn::Sub(px, c.x[k])), hn::Mul(e.B[k], hn::Sub(py, c.y[k])));
            const MaskI top_left =
                hn::Or(hn::Gt(e.A[k], zero), hn::And(hn::Eq(e.A[k], zero), hn::Gt(e.B[k], zero)));
            const VecI biased = hn::Sub(e.c[k], hn::IfThenZeroElse(top_left, hn::Set(tag_i, 1)));
            e.inside[k] = hn::ShiftRight<8>(biased);
        }
        return e;
    }

    /// Drops triangles whose box holds up to 2 × 2 samples and that cover none of them.
    void drop_uncovered() {
        const VecI one = hn::Set(tag_i, 1);
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < queued_; i += std::uint32_t(N)) {
            const Corners c = fetch(hn::LoadU(tag_i, queue_ + i));
            const Boxes box = boxes_of(c, view_);
            const Edges e = edges_of(c, box);
            const VecI w = hn::Sub(box.x1, box.x0), h = hn::Sub(box.y1, box.y0);
            const MaskI larger = hn::Or(hn::Gt(w, one), hn::Gt(h, one));
            const auto covered = [&](int x, int y) HWY_ATTR {
                VecI least = hn::Set(tag_i, 0x7fffffff);
                for (int k = 0; k < 3; ++k) {
                    VecI v = e.inside[k];
                    if (x) v = hn::Add(v, e.A[k]);
                    if (y) v = hn::Add(v, e.B[k]);
                    least = hn::Min(least, v);
                }
                return hn::Gt(least, hn::Set(tag_i, -1));
            };
            // What a box of one column or row adds here lies outside of its triangle.
            const MaskI any =
                hn::Or(hn::Or(covered(0, 0), covered(1, 0)), hn::Or(covered(0, 1), covered(1, 1)));
            MaskI keep = hn::Or(larger, any);
            if (queued_ - i < std::uint32_t(N))
                keep = hn::And(keep, hn::FirstN(tag_i, queued_ - i));
            kept += compress_append(c.packed, keep, queue_ + kept);
        }
        queued_ = kept;
    }

    void set_up(std::uint32_t first) {
        const std::uint32_t count = std::min(queued_ - first, std::uint32_t(N));
        // Lanes without a triangle read the cluster's first vertex, not what is beyond its last.
        const MaskI used = hn::FirstN(tag_i, count);
        const Corners c = fetch(hn::IfThenElseZero(used, hn::LoadU(tag_i, queue_ + first)));
        const Boxes box = boxes_of(c, view_);
        const Edges e = edges_of(c, box);
        const VecI ox = hn::And(box.x0, hn::Set(tag_i, ~3)),
                   oy = hn::And(box.y0, hn::Set(tag_i, ~3));
        const VecI area = area2(c);
        VecF z[3];
        for (int k = 0; k < 3; ++k) z[k] = hn::GatherIndex(tag_f, vertices_.depth, c.local[k]);

        const ScreenPlane<Lanes> depth = depth_plane(c, z, ox, oy);
        const Lanes nearest_far(hn::Min(z[0], hn::Min(z[1], z[2])));
        const MaskI serve = hn::RebindMask(
            tag_i, planes_serve(depth, nearest_far, Lanes(to_float(area)),
                                Lanes(to_float(hn::Sub(box.x1, ox))),
                                Lanes(to_float(hn::Sub(box.y1, oy))), Lanes(to_float(box.side_x)),
                                Lanes(to_float(box.side_y)), Lanes(view_.steepest))
                       .m);
        const MaskI kept = hn::And(serve, used);
        const MaskI needles = hn::AndNot(serve, used);
        if (!hn::AllFalse(tag_i, needles))
            for_each_lane(needles, [&](std::uint32_t lane) {
                divert_one(std::uint32_t(queue_[first + lane]) >> number_shift);
            });
        if (hn::AllFalse(tag_i, kept)) return;

        const std::uint32_t number = fresh_batch();
        store_.info(number) = {object_.index, number_, material_.material, std::uint16_t(count),
                               object_.normals_disagree[number_] != 0};
        batch_ = store_.batch(number);
        const VecI back_x = hn::Sub(ox, box.x0), back_y = hn::Sub(oy, box.y0);
        store_edges(e, back_x, back_y);
        store_plane(row_depth, depth.c.v, depth.x.v, depth.y.v);
        store(row_origin_x, to_float(ox));
        store(row_origin_y, to_float(oy));
        const VecI columns = hn::ShiftRight<2>(hn::Sub(box.x1, ox));
        const VecI rows = hn::ShiftRight<2>(hn::Sub(box.y1, oy));
        store_int(row_extent, hn::Or(columns, hn::ShiftLeft<16>(rows)));
        store_int(row_corners, c.packed);
        store_ids(c.packed);
        store_attributes(c, weights_of(e, z, area, back_x, back_y));
        bin(number, kept, box);
    }

    std::uint32_t fresh_batch() {
        if (worker_.next_batch == worker_.last_batch) {
            worker_.next_batch = store_.take(batch_run);
            worker_.last_batch = worker_.next_batch + batch_run;
        }
        // Its memory left the nearer caches when the frame before was drawn.
        const char* next = reinterpret_cast<const char*>(store_.batch(worker_.next_batch + 1));
        const std::size_t size = std::size_t(view_.attributes.rows) * N * sizeof(float);
        for (std::size_t at = 0; at < size; at += 64) __builtin_prefetch(next + at, 1);
        return worker_.next_batch++;
    }

    /// Depth as a plane, in double from corners in the order of (y, x): coincident triangles have
    /// the same bits, whichever corner their file names first.
    ScreenPlane<Lanes> depth_plane(const Corners& c, const VecF (&depth)[3], VecI ox,
                                   VecI oy) const {
        VecI x[3] = {c.x[0], c.x[1], c.x[2]}, y[3] = {c.y[0], c.y[1], c.y[2]};
        VecF z[3] = {depth[0], depth[1], depth[2]};
        const auto order = [&](int a, int b) HWY_ATTR {
            const MaskI swap =
                hn::Or(hn::Gt(y[a], y[b]), hn::And(hn::Eq(y[a], y[b]), hn::Gt(x[a], x[b])));
            const MaskF swap_f = hn::RebindMask(tag_f, swap);
            const VecI xa = x[a], ya = y[a];
            const VecF za = z[a];
            x[a] = hn::IfThenElse(swap, x[b], xa), x[b] = hn::IfThenElse(swap, xa, x[b]);
            y[a] = hn::IfThenElse(swap, y[b], ya), y[b] = hn::IfThenElse(swap, ya, y[b]);
            z[a] = hn::IfThenElse(swap_f, z[b], za), z[b] = hn::IfThenElse(swap_f, za, z[b]);
        };
        order(0, 1), order(1, 2), order(0, 1);

        alignas(64) std::int32_t px[3][N], py[3][N], origin_x[N], origin_y[N];
        alignas(64) float pz[3][N], out[3][N];
        for (int k = 0; k < 3; ++k) {
            hn::Store(x[k], tag_i, px[k]);
            hn::Store(y[k], tag_i, py[k]);
            hn::Store(z[k], tag_f, pz[k]);
        }
        hn::Store(hn::Add(hn::ShiftLeft<8>(ox), hn::Set(tag_i, view_.sample_x)), tag_i, origin_x);
        hn::Store(hn::Add(hn::ShiftLeft<8>(oy), hn::Set(tag_i, view_.sample_y)), tag_i, origin_y);
        for (int i = 0; i < N; i += N64) {
            const Lanes64 corner_x[3] = {widen(px[0] + i), widen(px[1] + i), widen(px[2] + i)};
            const Lanes64 corner_y[3] = {widen(py[0] + i), widen(py[1] + i), widen(py[2] + i)};
            const Lanes64 corner_z[3] = {widen(pz[0] + i), widen(pz[1] + i), widen(pz[2] + i)};
            const ScreenPlane<Lanes64> plane = plane_through(
                corner_x, corner_y, corner_z, widen(origin_x + i), widen(origin_y + i));
            store_narrow(plane.c, out[0] + i);
            store_narrow(plane.x, out[1] + i);
            store_narrow(plane.y, out[2] + i);
        }
        return {Lanes(hn::Load(tag_f, out[0])), Lanes(hn::Load(tag_f, out[1])),
                Lanes(hn::Load(tag_f, out[2]))};
    }

    // ---- batches
    void store(int row, VecF value) { hn::Store(value, tag_f, batch_ + row * N); }
    void store_int(int row, VecI value) {
        hn::Store(value, tag_i, reinterpret_cast<std::int32_t*>(batch_ + row * N));
    }
    void store_plane(int row, VecF c, VecF x, VecF y) {
        store(row, c), store(row + 1, x), store(row + 2, y);
    }

    /// Steps of whole pixels from the origin.
    void store_edges(const Edges& e, VecI back_x, VecI back_y) {
        for (int k = 0; k < 3; ++k) {
            const VecI at_origin =
                hn::Add(e.inside[k], hn::Add(hn::Mul(e.A[k], back_x), hn::Mul(e.B[k], back_y)));
            store(row_edge_x + k, to_float(e.A[k]));
            store(row_edge_y + k, to_float(e.B[k]));
            store(row_edge_c + k, to_float(at_origin));
        }
    }

    /// Each triangle's number in the scene.
    void store_ids(VecI packed) {
        const VecI at = hn::And(hn::ShiftRight<number_shift>(packed),
                                hn::Set(tag_i, 2 * max_cluster_vertices - 1));
        const VecI in_mesh =
            hn::GatherIndex(tag_i, as_int(&object_.mesh->triangle[cluster_.first_triangle]), at);
        store_int(row_id, hn::Add(in_mesh, hn::Set(tag_i, std::int32_t(object_.first_triangle))));
    }

    /// The weights λ_i of the corners as planes, times z_i where values travel in perspective.
    struct Weights {
        ScreenPlane<Lanes> of[3];
    };

    Weights weights_of(const Edges& e, const VecF (&z)[3], VecI area, VecI back_x,
                       VecI back_y) const {
        const VecF per_area = hn::Div(hn::Set(tag_f, 1.0f), to_float(area));
        const VecF per_pixel = hn::Mul(per_area, hn::Set(tag_f, 256.0f));
        Weights w;
        for (int k = 0; k < 3; ++k) {
            const int corner = (k + 2) % 3;  // opposite to the edge
            VecF c = hn::Mul(to_float(e.c[k]), per_area);
            VecF x = hn::Mul(to_float(e.A[k]), per_pixel);
            VecF y = hn::Mul(to_float(e.B[k]), per_pixel);
            c = hn::MulAdd(x, to_float(back_x), hn::MulAdd(y, to_float(back_y), c));
            if (!view_.affine) {
                c = hn::Mul(c, z[corner]);
                x = hn::Mul(x, z[corner]);
                y = hn::Mul(y, z[corner]);
            }
            w.of[corner] = {Lanes(c), Lanes(x), Lanes(y)};
        }
        return w;
    }

    void store_attributes(const Corners& c, const Weights& w) {
        const Attributes& at = view_.attributes;
        if (at.main >= 0 && material_.store_normals) store_normals(c, w);
        if (at.main >= 0 && object_.shading == Shading::gouraud)
            for (int k = 0; k < 3; ++k)
                store_plane(at.main + 3 * k, w.of[k].c.v, w.of[k].x.v, w.of[k].y.v);
        const ClusteredMesh& mesh = *object_.mesh;
        if (at.texcoord >= 0 && material_.store_texcoords) {
            store_values(at.texcoord, &mesh.u[cluster_.first_vertex], c, w);
            store_values(at.texcoord + 3, &mesh.v[cluster_.first_vertex], c, w);
        }
        if (at.position >= 0) store_positions(c, w);
    }

    /// Seen from behind, normals are negated.
    void store_normals(const Corners& c, const Weights& w) {
        const MaskI back =
            hn::Ne(hn::And(c.packed, hn::Set(tag_i, std::int32_t(back_bit))), hn::Zero(tag_i));
        const VecF side = hn::IfThenElse(hn::RebindMask(tag_f, back), hn::Set(tag_f, -1.0f),
                                         hn::Set(tag_f, 1.0f));
        Weights turned;
        for (int k = 0; k < 3; ++k)
            turned.of[k] = {w.of[k].c * Lanes(side), w.of[k].x * Lanes(side),
                            w.of[k].y * Lanes(side)};
        for (int axis = 0; axis < 3; ++axis)
            store_values(view_.attributes.main + 3 * axis,
                         object_.normal[axis] + cluster_.first_vertex, c, turned);
    }

    void store_positions(const Corners& c, const Weights& w) {
        const ClusteredMesh& mesh = *object_.mesh;
        VecF p[3][3];
        for (int k = 0; k < 3; ++k) {
            const VecF x = hn::GatherIndex(tag_f, &mesh.x[cluster_.first_vertex], c.local[k]);
            const VecF y = hn::GatherIndex(tag_f, &mesh.y[cluster_.first_vertex], c.local[k]);
            const VecF z = hn::GatherIndex(tag_f, &mesh.z[cluster_.first_vertex], c.local[k]);
            for (int axis = 0; axis < 3; ++axis) {
                const float* m = object_.to_world[axis];
                p[axis][k] = hn::MulAdd(
                    hn::Set(tag_f, m[0]), x,
                    hn::MulAdd(hn::Set(tag_f, m[1]), y,
                               hn::MulAdd(hn::Set(tag_f, m[2]), z, hn::Set(tag_f, m[3]))));
            }
        }
        for (int axis = 0; axis < 3; ++axis)
            store_sum(view_.attributes.position + 3 * axis, p[axis], w);
    }

    void store_values(int row, const float* of_local, const Corners& c, const Weights& w) {
        VecF a[3];
        for (int k = 0; k < 3; ++k) a[k] = hn::GatherIndex(tag_f, of_local, c.local[k]);
        store_sum(row, a, w);
    }

    void store_sum(int row, const VecF (&a)[3], const Weights& w) {
        const auto sum = [&](Lanes ScreenPlane<Lanes>::*part) HWY_ATTR {
            return hn::MulAdd(
                a[0], (w.of[0].*part).v,
                hn::MulAdd(a[1], (w.of[1].*part).v, hn::Mul(a[2], (w.of[2].*part).v)));
        };
        store_plane(row, sum(&ScreenPlane<Lanes>::c), sum(&ScreenPlane<Lanes>::x),
                    sum(&ScreenPlane<Lanes>::y));
    }

    // ---- lists
    void bin(std::uint32_t batch, MaskI kept, const Boxes& box) {
        alignas(64) std::int32_t x0[N], y0[N], x1[N], y1[N];
        hn::Store(box.x0, tag_i, x0), hn::Store(box.y0, tag_i, y0);
        hn::Store(box.x1, tag_i, x1), hn::Store(box.y1, tag_i, y1);
        const int tile_shift = __builtin_ctz(static_cast<unsigned>(view_.tile));
        for_each_lane(kept, [&](std::uint32_t lane) {
            const std::uint32_t ref = batch * std::uint32_t(N) + lane;
            const int tx0 = x0[lane] >> tile_shift, tx1 = x1[lane] >> tile_shift;
            const int ty0 = y0[lane] >> tile_shift, ty1 = y1[lane] >> tile_shift;
            const int columns = x1[lane] / 4 - x0[lane] / 4, rows = y1[lane] / 4 - y0[lane] / 4;
            const auto tile = std::size_t(ty0 * view_.tiles_x + tx0);
            if (columns == 0 && rows == 0) return worker_.tiny.push(tile, ref);
            const bool one_tile = tx0 == tx1 && ty0 == ty1;
            // Small triangles are drawn in 2 × 2 blocks. The second column must not be beyond the
            // tile's last, where a triangle that the picture's edge cuts may go on.
            const bool cut =
                x1[lane] == view_.width - 1 && x0[lane] % tile_side >= tile_side - block_side;
            if (one_tile && columns <= 1 && rows <= 1 && !cut) return worker_.small.push(tile, ref);
            for (int ty = ty0; ty <= ty1; ++ty)
                for (int tx = tx0; tx <= tx1; ++tx)
                    worker_.medium.push(std::size_t(ty * view_.tiles_x + tx), ref);
        });
    }

    const SetupView& view_;
    const SetupObject& object_;
    const std::uint32_t number_;
    const Cluster& cluster_;
    const SetupMaterial& material_;
    const bool clip_;
    BatchStore& store_;
    SetupWorker& worker_;
    ClusterVertices vertices_;
    // What may cover a sample: corners and number as packed in ClusteredMesh.
    alignas(64) std::int32_t queue_[max_cluster_triangles + 2 * cluster_padding];
    std::uint32_t queued_ = 0, tiny_ = 0;
    float* batch_ = nullptr;
};

void setup_one(const SetupView& view, const SetupObject& object, std::uint32_t cluster, bool clip,
               BatchStore& store, SetupWorker& worker) {
    ClusterSetup(view, object, cluster, clip, store, worker).run();
}

int lanes_here() { return N; }

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(setup_one);
HWY_EXPORT(lanes_here);

void setup_cluster(const SetupView& view, const SetupObject& object, std::uint32_t cluster,
                   bool clip, BatchStore& store, SetupWorker& worker) {
    HWY_DYNAMIC_DISPATCH(setup_one)(view, object, cluster, clip, store, worker);
}

int vector_lanes() { return HWY_DYNAMIC_DISPATCH(lanes_here)(); }

}  // namespace scanshade
#endif

// The geometry of N triangles on the picture, as set-up computes it: corners, boxes of samples, edge
// functions and planes.
#if defined(SCANSHADE_KERNELS_SETUP_GEOMETRY_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SETUP_GEOMETRY_HPP
#undef SCANSHADE_KERNELS_SETUP_GEOMETRY_HPP
#else
#define SCANSHADE_KERNELS_SETUP_GEOMETRY_HPP
#endif

#include "kernels/engine_data.hpp"
#include "kernels/lanes64.hpp"
#include "kernels/screen_plane.hpp"
#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

/// A cluster's vertices on the picture.
struct ClusterVertices {
    alignas(64) std::int32_t x[max_cluster_vertices];  // 1/256 pixel
    alignas(64) std::int32_t y[max_cluster_vertices];
    alignas(64) float depth[max_cluster_vertices];
    alignas(64) std::int32_t outcode[max_cluster_vertices];
};

/// A cluster on its way through set-up.
struct ClusterContext {
    ClusterContext(const SetupView& v, const SetupObject& o, std::uint32_t n)
        : view(v),
          object(o),
          number(n),
          cluster(o.mesh->clusters[n]),
          material(o.material[cluster.material]) {}

    const SetupView& view;
    const SetupObject& object;
    std::uint32_t number;
    const Cluster& cluster;
    const SetupMaterial& material;
    ClusterVertices vertices;  // as VertexTransform leaves them

    /// Leaves the cluster's face number `face` to the driver.
    void divert(std::uint32_t face, SetupWorker& worker) const {
        worker.special.push_back({object.index, object.mesh->triangle[cluster.first_face + face]});
    }

    BatchInfo batch_info(std::uint32_t count) const {
        return {object.index, number, material.material, std::uint16_t(count),
                object.normals_disagree[number] != 0};
    }
};

/// The corners of N faces of K corners each.
template <int K>
struct Corners {
    VecI packed, local[K], x[K], y[K];
};

inline VecI box_first(VecI least, int sample) {
    return hn::ShiftRight<8>(hn::Add(least, hn::Set(tag_i, 255 - sample)));
}
inline VecI box_last(VecI most, int sample) {
    return hn::ShiftRight<8>(hn::Sub(most, hn::Set(tag_i, sample)));
}

/// The samples that the faces' boxes hold, clipped to the picture.
struct Boxes {
    VecI x0, y0, x1, y1;
    VecI side_x, side_y;  // before clipping, 1/256 pixel
};

template <int K>
SCANSHADE_INLINE Boxes boxes_of(const Corners<K>& c, const SetupView& view) {
    const VecI zero = hn::Zero(tag_i);
    VecI lx = c.x[0], hx = c.x[0], ly = c.y[0], hy = c.y[0];
    for (int k = 1; k < K; ++k) {
        lx = hn::Min(lx, c.x[k]), hx = hn::Max(hx, c.x[k]);
        ly = hn::Min(ly, c.y[k]), hy = hn::Max(hy, c.y[k]);
    }
    return {hn::Max(zero, box_first(lx, view.sample_x)),
            hn::Max(zero, box_first(ly, view.sample_y)),
            hn::Min(hn::Set(tag_i, view.width - 1), box_last(hx, view.sample_x)),
            hn::Min(hn::Set(tag_i, view.height - 1), box_last(hy, view.sample_y)),
            hn::Sub(hx, lx),
            hn::Sub(hy, ly)};
}

/// Where a box holds any sample.
inline MaskI holds_samples(const Boxes& box) {
    return hn::Not(hn::Or(hn::Gt(box.x0, box.x1), hn::Gt(box.y0, box.y1)));
}

template <int K>
SCANSHADE_INLINE Corners<K> fetch(const ClusterVertices& vertices, VecI packed) {
    Corners<K> c;
    c.packed = packed;
    VecI rest = packed;
    for (int k = 0; k < K; ++k) {
        c.local[k] = hn::And(rest, hn::Set(tag_i, max_cluster_vertices - 1));
        rest = hn::ShiftRight<corner_bits>(rest);
        c.x[k] = look_up(vertices.x, c.local[k]);
        c.y[k] = look_up(vertices.y, c.local[k]);
    }
    return c;
}

/// Corners in their other order where asked for, the side noted, in one number again.
template <int K>
SCANSHADE_INLINE VecI pack(const Corners<K>& c, MaskI turn, MaskI back) {
    VecI packed = hn::Or(hn::And(c.packed, hn::Set(tag_i, ~std::int32_t(number_bit - 1))),
                         hn::IfThenElseZero(back, hn::Set(tag_i, std::int32_t(back_bit))));
    VecI corners = hn::Zero(tag_i);
    for (int k = K - 1; k >= 0; --k)
        corners = hn::Or(hn::ShiftLeft<corner_bits>(corners),
                         hn::IfThenElse(turn, c.local[(K - k) % K], c.local[k]));
    return hn::Or(packed, corners);
}

/// The outcodes of N faces: what is beyond one side with all corners, and with any.
struct Outside {
    MaskI all, any;
};
template <int K>
SCANSHADE_INLINE Outside outside_of(const ClusterVertices& vertices, const Corners<K>& c) {
    VecI all = hn::Set(tag_i, -1), any = hn::Zero(tag_i);
    for (int k = 0; k < K; ++k) {
        const VecI code = look_up(vertices.outcode, c.local[k]);
        all = hn::And(all, code), any = hn::Or(any, code);
    }
    return {hn::Ne(all, hn::Zero(tag_i)), hn::Ne(any, hn::Zero(tag_i))};
}

/// Twice the area, with its sign.
inline VecI area2(const Corners<3>& c) {
    return hn::Sub(hn::Mul(hn::Sub(c.x[1], c.x[0]), hn::Sub(c.y[2], c.y[0])),
                   hn::Mul(hn::Sub(c.x[2], c.x[0]), hn::Sub(c.y[1], c.y[0])));
}

/// Edge functions of N faces, those of the edge from corner k to the next.
template <int K>
struct Edges {
    VecI A[K], B[K];
    VecI c[K];       // at the box's first sample, 1/256 pixel²
    VecI inside[K];  // ⌊(c − bias)/256⌋: ≥ 0 where the sample is inside
};

template <int K>
SCANSHADE_INLINE Edges<K> edges_of(const Corners<K>& c, const Boxes& box, const SetupView& view) {
    Edges<K> e;
    const VecI zero = hn::Zero(tag_i);
    const VecI px = hn::Add(hn::ShiftLeft<8>(box.x0), hn::Set(tag_i, view.sample_x));
    const VecI py = hn::Add(hn::ShiftLeft<8>(box.y0), hn::Set(tag_i, view.sample_y));
    for (int k = 0; k < K; ++k) {
        const int j = (k + 1) % K;
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

/// Depth as a plane, in double from corners in the order of (y, x): coincident triangles have
/// the same bits, whichever corner their file names first.
inline ScreenPlane<Lanes> depth_plane(const Corners<3>& c, const VecF (&depth)[3], VecI ox, VecI oy,
                                      const SetupView& view) {
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

    const Lanes64 px[3] = {widen(x[0]), widen(x[1]), widen(x[2])};
    const Lanes64 py[3] = {widen(y[0]), widen(y[1]), widen(y[2])};
    const Lanes64 pz[3] = {widen(z[0]), widen(z[1]), widen(z[2])};
    const VecI origin_x = hn::Add(hn::ShiftLeft<8>(ox), hn::Set(tag_i, view.sample_x));
    const VecI origin_y = hn::Add(hn::ShiftLeft<8>(oy), hn::Set(tag_i, view.sample_y));
    const ScreenPlane<Lanes64> plane = plane_through(px, py, pz, widen(origin_x), widen(origin_y));
    return {Lanes(narrow(plane.c)), Lanes(narrow(plane.x)), Lanes(narrow(plane.y))};
}

/// Everything about N triangles that batches and fragments are made of. Planes count pixels from
/// (ox, oy), the first sample of the block that the box begins in.
struct Triangles {
    Corners<3> corners;
    Boxes box;
    Edges<3> edges;
    VecI ox, oy, area;
    VecF z[3];
    ScreenPlane<Lanes> depth;
};

inline Triangles triangles_of(const ClusterVertices& vertices, VecI packed, const SetupView& view) {
    Triangles t;
    t.corners = fetch<3>(vertices, packed);
    t.box = boxes_of(t.corners, view);
    t.edges = edges_of(t.corners, t.box, view);
    t.ox = hn::And(t.box.x0, hn::Set(tag_i, ~3));
    t.oy = hn::And(t.box.y0, hn::Set(tag_i, ~3));
    t.area = area2(t.corners);
    for (int k = 0; k < 3; ++k) t.z[k] = look_up(vertices.depth, t.corners.local[k]);
    t.depth = depth_plane(t.corners, t.z, t.ox, t.oy, view);
    return t;
}

/// Where planes serve; the other triangles are the driver's.
inline MaskI planes_serve_of(const Triangles& t, const SetupView& view) {
    const Lanes nearest_far(hn::Min(t.z[0], hn::Min(t.z[1], t.z[2])));
    return hn::RebindMask(
        tag_i, planes_serve(t.depth, nearest_far, Lanes(to_float(t.area)),
                            Lanes(to_float(hn::Sub(t.box.x1, t.ox))),
                            Lanes(to_float(hn::Sub(t.box.y1, t.oy))), Lanes(to_float(t.box.side_x)),
                            Lanes(to_float(t.box.side_y)), Lanes(view.steepest))
                   .m);
}

/// The weights λ_i of the corners as planes, times z_i where values travel in perspective.
struct Weights {
    ScreenPlane<Lanes> of[3];
};

inline Weights weights_of(const Triangles& t, bool affine) {
    const VecI back_x = hn::Sub(t.ox, t.box.x0), back_y = hn::Sub(t.oy, t.box.y0);
    const VecF per_area = hn::Div(hn::Set(tag_f, 1.0f), to_float(t.area));
    const VecF per_pixel = hn::Mul(per_area, hn::Set(tag_f, 256.0f));
    Weights w;
    for (int k = 0; k < 3; ++k) {
        const int corner = (k + 2) % 3;  // opposite to the edge
        VecF c = hn::Mul(to_float(t.edges.c[k]), per_area);
        VecF x = hn::Mul(to_float(t.edges.A[k]), per_pixel);
        VecF y = hn::Mul(to_float(t.edges.B[k]), per_pixel);
        c = hn::MulAdd(x, to_float(back_x), hn::MulAdd(y, to_float(back_y), c));
        if (!affine) {
            c = hn::Mul(c, t.z[corner]);
            x = hn::Mul(x, t.z[corner]);
            y = hn::Mul(y, t.z[corner]);
        }
        w.of[corner] = {Lanes(c), Lanes(x), Lanes(y)};
    }
    return w;
}

/// Σ a_i · (plane of corner i's weight).
inline ScreenPlane<Lanes> weighted_plane(const VecF (&a)[3], const Weights& w) {
    const auto sum = [&](Lanes ScreenPlane<Lanes>::*part) HWY_ATTR {
        return Lanes(
            hn::MulAdd(a[0], (w.of[0].*part).v,
                       hn::MulAdd(a[1], (w.of[1].*part).v, hn::Mul(a[2], (w.of[2].*part).v))));
    };
    return {sum(&ScreenPlane<Lanes>::c), sum(&ScreenPlane<Lanes>::x), sum(&ScreenPlane<Lanes>::y)};
}

/// Seen from behind, normals are negated: −1, else 1.
inline VecF side_of(VecI packed) {
    const MaskI back =
        hn::Ne(hn::And(packed, hn::Set(tag_i, std::int32_t(back_bit))), hn::Zero(tag_i));
    return hn::IfThenElse(hn::RebindMask(tag_f, back), hn::Set(tag_f, -1.0f), hn::Set(tag_f, 1.0f));
}

/// The weights with the triangle's sign.
inline Weights turned_weights(const Corners<3>& c, const Weights& w) {
    const Lanes side(side_of(c.packed));
    Weights turned;
    for (int k = 0; k < 3; ++k)
        turned.of[k] = {w.of[k].c * side, w.of[k].x * side, w.of[k].y * side};
    return turned;
}

SCANSHADE_TARGET_END;

#endif

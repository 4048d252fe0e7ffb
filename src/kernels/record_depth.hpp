// Weights and depth of a Record at a vector of samples, for raster and resolve.
#if defined(SCANSHADE_KERNELS_RECORD_DEPTH_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RECORD_DEPTH_HPP
#undef SCANSHADE_KERNELS_RECORD_DEPTH_HPP
#else
#define SCANSHADE_KERNELS_RECORD_DEPTH_HPP
#endif

#include "kernels/engine_data.hpp"
#include "kernels/screen_plane.hpp"
#include "kernels/screen_quad.hpp"
#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

/// Where the samples of a vector are, in pixels from the picture's corner.
struct Positions {
    VecI x, y;
};

/// Vector v of the block whose corner is (x, y).
inline Positions block_positions(int x, int y, int v) {
    const VecI i = hn::Add(hn::Iota(tag_i, 0), hn::Set(tag_i, v * N));
    return {hn::Add(hn::And(i, hn::Set(tag_i, 3)), hn::Set(tag_i, x)),
            hn::Add(hn::ShiftRight<2>(i), hn::Set(tag_i, y))};
}

/// Numbers of the samples of a vector, N64 at a time, in double.
struct WidePositions {
    alignas(64) std::int32_t x[N], y[N];
    explicit WidePositions(const Positions& at) {
        hn::Store(at.x, tag_i, x);
        hn::Store(at.y, tag_i, y);
    }
};

/// λ_i of a triangle by exact edge functions: whole numbers below 2^53 until the last product.
inline void triangle_weights(const Record& r, const Positions& at, VecF (&lambda)[3]) {
    const WidePositions wide(at);
    alignas(64) float out[3][N];
    for (int part = 0; part < N; part += N64) {
        const Lanes64 x = widen(wide.x + part), y = widen(wide.y + part);
        for (int i = 0; i < 3; ++i) {
            const Lanes64 e =
                (Lanes64(r.weight_x[i]) * x + Lanes64(r.weight_y[i]) * y) + Lanes64(r.weight_c[i]);
            store_narrow(e * Lanes64(r.inv_area), out[i] + part);
        }
    }
    for (int i = 0; i < 3; ++i) lambda[i] = hn::Load(tag_f, out[i]);
}

/// λ_i ≥ 0 of a clipped triangle by homogeneous edge functions, not normalised, N64 at a time.
inline void clipped_weights(const RasterView& view, const Record& r, Lanes64 x, Lanes64 y,
                            Lanes64 (&lambda)[3]) {
    const auto centred = [](Lanes64 p, int sample, int size) HWY_ATTR {
        return (p * Lanes64(256) + Lanes64(sample)) / Lanes64(256) - Lanes64(size / 2.0);
    };
    const Lanes64 X = centred(x, view.sample_x, view.width);
    const Lanes64 Y = centred(y, view.sample_y, view.height);
    hn::Mask<Tag64> any;
    for (int i = 0; i < 3; ++i) {
        const Lanes64 l =
            (Lanes64(r.weight_x[i]) * X + Lanes64(r.weight_y[i]) * Y) + Lanes64(r.weight_c[i]);
        const auto positive = hn::Gt(l.v, hn::Zero(tag_64));
        lambda[i] = Lanes64(hn::IfThenElseZero(positive, l.v));
        any = i == 0 ? positive : hn::Or(any, positive);
    }
    // All three are below zero only for a sample far outside by rounding: take the middle.
    for (int i = 0; i < 3; ++i)
        lambda[i] = Lanes64(hn::IfThenElse(any, lambda[i].v, hn::Set(tag_64, 1.0)));
}

inline VecF clipped_depth(const RasterView& view, const Record& r, const Positions& at) {
    const WidePositions wide(at);
    alignas(64) float out[N];
    for (int part = 0; part < N; part += N64) {
        Lanes64 lambda[3];
        clipped_weights(view, r, widen(wide.x + part), widen(wide.y + part), lambda);
        const Lanes64 sum = lambda[0] + lambda[1] + lambda[2];
        Lanes64 depth = Lanes64(double(view.near)) * (sum * Lanes64(r.sum_to_inv_w));
        if (view.orthographic) {
            depth = Lanes64(0);
            for (int i = 0; i < 3; ++i)
                depth = depth + lambda[i] / sum * Lanes64(double(r.corner_w[i]));
        }
        store_narrow(depth, out + part);
    }
    const VecF z = hn::Load(tag_f, out);
    if (!view.orthographic) return z;
    const VecF share =
        hn::Div(hn::Sub(z, hn::Set(tag_f, view.near)), hn::Set(tag_f, view.far - view.near));
    return hn::Sub(hn::Set(tag_f, 1.0f), hn::Mul(hn::Set(tag_f, 0.5f), share));
}

/// The ScreenQuad of a record or of one face of a batch, whose rows are `stride` numbers apart.
HWY_INLINE ScreenQuad<Lanes> quad_from(const float* rows, int stride) {
    const auto value = [&](int row) HWY_ATTR { return Lanes(rows[row * stride]); };
    ScreenQuad<Lanes> q;
    for (int k = 0; k < 4; ++k) {
        q.x[k] = value(row_quad_x + k), q.y[k] = value(row_quad_y + k);
        q.per_height[k] = value(row_quad_per_height + k), q.z[k] = value(row_quad_depth + k);
    }
    return q;
}

/// Depth, with the bits of the scalar renderers.
inline VecF record_depth(const RasterView& view, const Record& r, const Positions& at) {
    const Lanes x(to_float(hn::Sub(at.x, hn::Set(tag_i, r.origin_x))));
    const Lanes y(to_float(hn::Sub(at.y, hn::Set(tag_i, r.origin_y))));
    if (r.depth == Record::Depth::plane) {
        const float* depth = r.rows + row_depth;
        return plane_value(ScreenPlane<Lanes>{Lanes(depth[0]), Lanes(depth[1]), Lanes(depth[2])}, x,
                           y)
            .v;
    }
    if (r.depth == Record::Depth::spans) return span_depth(quad_span(quad_from(r.rows, 1), y), x).v;
    if (r.depth == Record::Depth::clipped) return clipped_depth(view, r, at);
    VecF lambda[3];
    triangle_weights(r, at, lambda);
    const auto term = [&](int i) HWY_ATTR {
        const std::uint8_t corner = r.order[i];
        return hn::Mul(lambda[corner], hn::Set(tag_f, r.corner_depth[corner]));
    };
    return hn::Add(hn::Add(term(0), term(1)), term(2));
}

SCANSHADE_TARGET_END;

#endif

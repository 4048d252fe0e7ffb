// Weights and depth of a Record at a vector of samples, for raster and resolve.
#if defined(SCANSHADE_KERNELS_RECORD_DEPTH_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RECORD_DEPTH_HPP
#undef SCANSHADE_KERNELS_RECORD_DEPTH_HPP
#else
#define SCANSHADE_KERNELS_RECORD_DEPTH_HPP
#endif

#include "kernels/engine_data.hpp"
#include "kernels/lanes64.hpp"
#include "kernels/screen_plane.hpp"
#include "kernels/screen_quad.hpp"

SCANSHADE_TARGET_BEGIN;

/// Column and row of a block's samples, vector by vector.
struct BlockGrid {
    alignas(64) float x[block_samples] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) float y[block_samples] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
};
constexpr BlockGrid grid;

/// Where the samples of a vector are, in pixels from the picture's corner: whole numbers.
struct Positions {
    VecF x, y;
};

/// Vector v of the block whose corner is (x, y).
SCANSHADE_INLINE Positions block_positions(int x, int y, int v) {
    return {hn::Add(hn::Load(tag_f, grid.x + v * N), hn::Set(tag_f, float(x))),
            hn::Add(hn::Load(tag_f, grid.y + v * N), hn::Set(tag_f, float(y)))};
}

/// λ_i of a triangle by exact edge functions: whole numbers below 2^53 until the last product.
inline void triangle_weights(const Record& r, const Positions& at, VecF (&lambda)[3]) {
    const Lanes64 x = widen(at.x), y = widen(at.y);
    for (int i = 0; i < 3; ++i) {
        const Lanes64 e =
            (Lanes64(r.weight_x[i]) * x + Lanes64(r.weight_y[i]) * y) + Lanes64(r.weight_c[i]);
        lambda[i] = narrow(e * Lanes64(r.inv_area));
    }
}

/// λ_i ≥ 0 of a clipped triangle by homogeneous edge functions, not normalised.
inline void clipped_weights(const RasterView& view, const Record& r, const Positions& at,
                            Lanes64 (&lambda)[3]) {
    const auto centred = [](const Lanes64& p, int sample, int size) HWY_ATTR {
        return (p * Lanes64(256) + Lanes64(sample)) / Lanes64(256) - Lanes64(size / 2.0);
    };
    const Lanes64 X = centred(widen(at.x), view.sample_x, view.width);
    const Lanes64 Y = centred(widen(at.y), view.sample_y, view.height);
    const Lanes64 zero(0);
    Lanes64::Mask any = zero > zero;
    for (int i = 0; i < 3; ++i) {
        const Lanes64 l =
            (Lanes64(r.weight_x[i]) * X + Lanes64(r.weight_y[i]) * Y) + Lanes64(r.weight_c[i]);
        const Lanes64::Mask positive = l > zero;
        lambda[i] = select(positive, l, zero);
        any = mask_or(any, positive);
    }
    // All three are below zero only for a sample far outside by rounding: take the middle.
    for (Lanes64& l : lambda) l = select(any, l, Lanes64(1));
}

inline VecF clipped_depth(const RasterView& view, const Record& r, const Positions& at) {
    Lanes64 lambda[3];
    clipped_weights(view, r, at, lambda);
    const Lanes64 sum = lambda[0] + lambda[1] + lambda[2];
    if (!view.orthographic)
        return narrow(Lanes64(double(view.near)) * (sum * Lanes64(r.sum_to_inv_w)));
    Lanes64 w(0);
    for (int i = 0; i < 3; ++i) w = w + lambda[i] / sum * Lanes64(double(r.corner_w[i]));
    const VecF share = hn::Div(hn::Sub(narrow(w), hn::Set(tag_f, view.near)),
                               hn::Set(tag_f, view.far - view.near));
    return hn::Sub(hn::Set(tag_f, 1.0f), hn::Mul(hn::Set(tag_f, 0.5f), share));
}

/// The ScreenQuad of a record or of one face of a batch, whose rows are `stride` numbers apart.
SCANSHADE_INLINE ScreenQuad<Lanes> quad_from(const float* rows, int stride) {
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
    const Lanes x = Lanes(at.x) - Lanes(r.origin_x), y = Lanes(at.y) - Lanes(r.origin_y);
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

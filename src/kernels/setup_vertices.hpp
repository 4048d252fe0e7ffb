// A cluster's vertices on the picture.
#if defined(SCANSHADE_KERNELS_SETUP_VERTICES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_SETUP_VERTICES_HPP
#undef SCANSHADE_KERNELS_SETUP_VERTICES_HPP
#else
#define SCANSHADE_KERNELS_SETUP_VERTICES_HPP
#endif

#include "kernels/setup_geometry.hpp"

SCANSHADE_TARGET_BEGIN;

/// Longest side of a box whose edge functions fit into int32 and, in whole pixels, into float.
constexpr std::int32_t max_small_extent = 32000;

class VertexTransform {
public:
    /// clip: whether outcodes are asked for.
    VertexTransform(ClusterContext& of, bool clip) : of_(of), clip_(clip) {}

    void run() {
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

private:
    VecI snap(VecF x, VecF w, int size) const {
        const VecF limit = hn::Set(tag_f, of_.view.guard_band * 256.0f);
        const VecF s = hn::Mul(hn::Div(x, w), hn::Set(tag_f, 256.0f));
        const VecI whole = nearest(hn::Min(hn::Max(s, hn::Neg(limit)), limit));
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

    ClusterContext& of_;
    const bool clip_;
};

SCANSHADE_TARGET_END;

#endif

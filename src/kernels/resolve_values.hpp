// The values that shading reads, written into a surface: of faces in batches and of records.
#if defined(SCANSHADE_KERNELS_RESOLVE_VALUES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RESOLVE_VALUES_HPP
#undef SCANSHADE_KERNELS_RESOLVE_VALUES_HPP
#else
#define SCANSHADE_KERNELS_RESOLVE_VALUES_HPP
#endif

#include <limits>

#include "kernels/resolve_lookups.hpp"

SCANSHADE_TARGET_BEGIN;

/// Shorter than this, an interpolated normal is noise.
constexpr float shortest_normal2 = 1e-12f;

class SurfaceValues {
protected:
    SurfaceValues(const ResolveView& view, const TileBuffer& tile, Surface& surface)
        : view_(view), tile_(tile), out_(surface) {}

    template <class Lookup>
    SCANSHADE_INLINE void resolve_values(const Samples& s, const Lookup& batch, Shading shading,
                                         const ResolveMaterial& material, bool normals_disagree,
                                         MaskF mask) {
        const Attributes& at = batch.at;
        const VecF unscale = view_.affine ? hn::Set(tag_f, 1.0f) : s.inv_z;
        if (shading == Shading::phong && material.reads_normal) {
            VecF n[3];
            for (int c = 0; c < 3; ++c) n[c] = batch.value(at.main + at.stride * c);
            if (normals_disagree) note_zero_normals(s, n, mask);
            for (int c = 0; c < 3; ++c) put(out_.normal[c], s.number, n[c], mask);
        }
        if (shading == Shading::phong && at.position >= 0)
            for (int c = 0; c < 3; ++c)
                put(out_.position[c], s.number,
                    hn::Mul(batch.value(at.position + at.stride * c), unscale), mask);
        if (shading != Shading::phong) resolve_lit(s, batch, shading, material, unscale, mask);
        if (material.textured) resolve_texture(s, batch, unscale, mask);
    }

    /// u = U/z, and ∂u/∂x = (∂U/∂x − u ∂z/∂x)/z, z as good as any multiple of 1/w.
    template <class Lookup>
    void resolve_texture(const Samples& s, const Lookup& batch, VecF unscale, MaskF mask) {
        // Levels follow the mapping in perspective, which `edges` does not have.
        const bool steps = Lookup::planes && (!view_.affine || view_.raster.orthographic);
        const VecF spacing = hn::Set(tag_f, view_.sample_spacing);
        for (int c = 0; c < 2; ++c) {
            const int row = batch.at.texcoord + batch.at.stride * c;
            const VecF u = hn::Mul(batch.value(row), unscale);
            put(out_.texcoord[c], s.number, u, mask);
            for (int axis = 0; axis < 2; ++axis) {
                VecF step = not_a_number();
                if (steps) {
                    step = batch.row(row + 1 + axis);
                    if (!view_.affine)
                        step = hn::NegMulAdd(u, batch.row(row_depth + 1 + axis), step);
                    step = hn::Mul(hn::Mul(step, unscale), spacing);
                }
                put(out_.texstep[2 * axis + c], s.number, step, mask);
            }
        }
    }

    static VecF not_a_number() { return hn::Set(tag_f, std::numeric_limits<float>::quiet_NaN()); }

    template <class Lookup>
    void resolve_lit(const Samples& s, const Lookup& batch, Shading shading,
                     const ResolveMaterial& material, VecF unscale, MaskF mask) {
        const Attributes& at = batch.at;
        const auto value = [&](int row) HWY_ATTR {
            return shading == Shading::flat ? batch.row(row) : hn::Mul(batch.value(row), unscale);
        };
        for (int c = 0; c < 3; ++c) {
            put(out_.radiance[c], s.number, value(at.main + at.stride * c), mask);
            if (material.textured)
                put(out_.dark[c], s.number, value(at.dark + at.stride * c), mask);
        }
    }

    // ---- of records without rows

    /// Weights of the corners, sum 1.
    void record_weights(const Samples& s, const Record& r, VecF (&w)[3]) {
        if (r.depth == Record::Depth::clipped) return clipped_record_weights(s, r, w);
        triangle_weights(r, s.at, w);
        if (r.affine) return;
        for (int i = 0; i < 3; ++i) w[i] = hn::Mul(w[i], hn::Set(tag_f, r.corner_depth[i]));
        const VecF scale = reciprocal(Lanes(hn::Add(hn::Add(w[0], w[1]), w[2]))).v;
        for (int i = 0; i < 3; ++i) w[i] = hn::Mul(w[i], scale);
    }

    void clipped_record_weights(const Samples& s, const Record& r, VecF (&w)[3]) {
        Lanes64 lambda[3];
        clipped_weights(view_.raster, r, s.at, lambda);
        if (r.affine)
            for (int i = 0; i < 3; ++i) lambda[i] = lambda[i] * Lanes64(double(r.corner_w[i]));
        const Lanes64 sum = lambda[0] + lambda[1] + lambda[2];
        for (int i = 0; i < 3; ++i) w[i] = narrow(lambda[i] / sum);
    }

    void resolve_record_values(const Samples& s, const Record& r, const VecF (&w)[3], MaskF mask) {
        const Shading shading = view_.objects[r.object].shading;
        const ResolveMaterial& material = view_.materials[r.material];
        const auto sum = [&](float a, float b, float c) HWY_ATTR {
            return hn::MulAdd(
                w[0], hn::Set(tag_f, a),
                hn::MulAdd(w[1], hn::Set(tag_f, b), hn::Mul(w[2], hn::Set(tag_f, c))));
        };
        const auto main = [&](const float(&m)[4][3], int c) HWY_ATTR {
            return shading == Shading::flat ? hn::Set(tag_f, m[0][c])
                                            : sum(m[0][c], m[1][c], m[2][c]);
        };
        if (shading == Shading::phong) {
            const VecF n[3] = {main(r.main, 0), main(r.main, 1), main(r.main, 2)};
            if (material.reads_normal) note_zero_normals(s, n, mask);
            for (int c = 0; c < 3; ++c) put(out_.normal[c], s.number, n[c], mask);
            if (!view_.position_from_depth)
                for (int c = 0; c < 3; ++c)
                    put(out_.position[c], s.number,
                        sum(r.position[0][c], r.position[1][c], r.position[2][c]), mask);
        } else {
            for (int c = 0; c < 3; ++c) {
                put(out_.radiance[c], s.number, main(r.main, c), mask);
                if (material.textured) put(out_.dark[c], s.number, main(r.dark, c), mask);
            }
        }
        if (material.textured)
            for (int c = 0; c < 2; ++c)
                put(out_.texcoord[c], s.number,
                    sum(r.texcoord[0][c], r.texcoord[1][c], r.texcoord[2][c]), mask);
        if (material.textured) put(out_.texstep[0], s.number, not_a_number(), mask);
    }

    // ---- for all of them
    SCANSHADE_INLINE void recover_position(const Samples& s) {
        const ResolveView& v = view_;
        const VecF near = hn::Set(tag_f, v.raster.near);
        VecF ray[3];
        for (int c = 0; c < 3; ++c)
            ray[c] = hn::MulAdd(
                s.at.x, hn::Set(tag_f, v.ray_x[c]),
                hn::MulAdd(s.at.y, hn::Set(tag_f, v.ray_y[c]), hn::Set(tag_f, v.ray[c])));
        if (v.raster.orthographic) {
            const VecF range = hn::Set(tag_f, 2 * (v.raster.far - v.raster.near));
            const VecF d = hn::MulAdd(hn::Sub(hn::Set(tag_f, 1.0f), s.z), range, near);
            for (int c = 0; c < 3; ++c)
                store(out_.position[c], s.number, hn::MulAdd(d, hn::Set(tag_f, v.eye[c]), ray[c]));
        } else {
            const VecF d = hn::Mul(near, s.inv_z);
            for (int c = 0; c < 3; ++c)
                store(out_.position[c], s.number, hn::MulAdd(d, ray[c], hn::Set(tag_f, v.eye[c])));
        }
    }

    SCANSHADE_INLINE void note_zero_normals(const Samples& s, const VecF (&n)[3], MaskF mask) {
        const VecF n2 = hn::MulAdd(n[0], n[0], hn::MulAdd(n[1], n[1], hn::Mul(n[2], n[2])));
        const VecF least = hn::Mul(hn::Set(tag_f, shortest_normal2), hn::Mul(s.z, s.z));
        const MaskF zero = hn::AndNot(hn::Gt(n2, least), mask);
        if (!hn::AllFalse(tag_f, zero)) open_lanes(s.number, mask_bits(tag_f, zero), true);
    }

    void leave_open(std::uint32_t vector, std::uint32_t lanes, std::uint32_t material,
                    Shading shading) {
        open_lanes(vector, lanes, false);
        add_part(vector, lanes, material, shading);
    }

    HWY_NOINLINE void open_lanes(std::uint32_t vector, std::uint32_t lanes, bool zero_normal) {
        for_each_lane(lanes, [&](std::uint32_t lane) {
            out_.open.push_back({vector * std::uint32_t(N) + lane,
                                 tile_.ref[out_.tile_at[vector] + lane], zero_normal});
        });
    }

    /// To the part before, where that is of the same vector and shaded alike. Where all is shaded
    /// alike, one part says how.
    SCANSHADE_INLINE void add_part(std::uint32_t vector, std::uint32_t lanes,
                                   std::uint32_t material, Shading shading) {
        if (view_.shaded_alike && out_.part_count > 0) return;
        const bool lit = shading != Shading::phong;
        if (out_.part_count > 0) {
            Surface::Part& last = out_.part[out_.part_count - 1];
            if (last.vector == vector && last.material == material && last.lit == lit) {
                last.lanes |= lanes;
                return;
            }
        }
        out_.part[out_.part_count++] = {vector, lanes, material, lit};
    }

    static void store(float* to, std::uint32_t vector, VecF v) {
        hn::Store(v, tag_f, to + vector * std::uint32_t(N));
    }
    static void put(float* to, std::uint32_t vector, VecF v, MaskF mask) {
        hn::BlendedStore(v, mask, tag_f, to + vector * std::uint32_t(N));
    }

    const ResolveView& view_;
    const TileBuffer& tile_;
    Surface& out_;
};

SCANSHADE_TARGET_END;

#endif

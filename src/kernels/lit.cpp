// Gouraud and flat shading: the points to light, and their radiance into the planes of batches.
#define SCANSHADE_SIMD

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/lit.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/setup_batch.hpp"

SCANSHADE_TARGET_BEGIN;

VecI load_row(const float* batch, int row) {
    return hn::Load(tag_i, reinterpret_cast<const std::int32_t*>(batch) + row * N);
}

VecI back_of(VecI packed) {
    return hn::IfThenElseZero(
        hn::Ne(hn::And(packed, hn::Set(tag_i, std::int32_t(back_bit))), hn::Zero(tag_i)),
        hn::Set(tag_i, 1));
}

/// The corners of a batch, where VertexLight::radiance has them.
template <int K>
struct CornerSlots {
    CornerSlots(const float* batch, const VertexLight& light) : light_(light) {
        const VecI packed = load_row(batch, row_corners);
        VecI rest = packed;
        for (int k = 0; k < K; ++k) {
            local_[k] = hn::And(rest, hn::Set(tag_i, max_cluster_vertices - 1));
            rest = hn::ShiftRight<corner_bits>(rest);
        }
        back_ = hn::Ne(back_of(packed), hn::Zero(tag_i));
        no_back_ = hn::AllFalse(tag_i, back_);
        no_front_ = hn::AllTrue(tag_i, back_);
    }

    /// Radiance of channel c at the corners k.
    SCANSHADE_INLINE VecF radiance(int c, int k) const {
        const float* front = light_.radiance[c] + light_.first;
        if (no_back_) return look_up(front, local_[k]);
        const VecF from_behind = look_up(front + light_.side, local_[k]);
        if (no_front_) return from_behind;
        return hn::IfThenElse(hn::RebindMask(tag_f, back_), from_behind, look_up(front, local_[k]));
    }

private:
    const VertexLight& light_;
    VecI local_[K];
    MaskI back_;
    bool no_back_, no_front_;
};

void fill_quads_here(float* batch, int to, const VertexLight& light) {
    const CornerSlots<4> slots(batch, light);
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 4; ++k)
            hn::Store(slots.radiance(c, k), tag_f, batch + (to + 4 * c + k) * N);
}

/// Planes of radiance, Σ radiance_i · (plane of corner i's weight).
class LitPlanes {
public:
    LitPlanes(const float* batch, int weights, const VertexLight& light) : slots_(batch, light) {
        for (int r = 0; r < 9; ++r) weight_[r] = hn::Load(tag_f, batch + (weights + r) * N);
    }
    SCANSHADE_INLINE ScreenPlane<Lanes> of(int c) const {
        VecF L[3];
        for (int k = 0; k < 3; ++k) L[k] = slots_.radiance(c, k);
        const auto sum = [&](int part) HWY_ATTR {
            return Lanes(
                hn::MulAdd(L[0], weight_[part],
                           hn::MulAdd(L[1], weight_[3 + part], hn::Mul(L[2], weight_[6 + part]))));
        };
        return {sum(0), sum(1), sum(2)};
    }

private:
    const CornerSlots<3> slots_;
    VecF weight_[9];
};

/// The weights' planes are replaced.
void fill_here(float* batch, int weights, int to, const VertexLight& light) {
    const LitPlanes planes(batch, weights, light);
    for (int c = 0; c < 3; ++c) RowWriter(batch).store_plane(to + 3 * c, planes.of(c));
}

/// With the bits that resolve finds for a triangle in a batch.
void fill_fragments_here(float* batch, const VertexLight& light) {
    const LitPlanes planes(batch, fragment_weights, light);
    const auto row = [&](int r) HWY_ATTR { return Lanes(hn::Load(tag_f, batch + r * N)); };
    const Lanes x = row(fragment_x), y = row(fragment_y), unscale = row(fragment_unscale);
    for (int c = 0; c < 3; ++c)
        RowWriter(batch).store(fragment_values + c, (fused_value(planes.of(c), x, y) * unscale).v);
}

void place_vertices_here(const ClusteredMesh& mesh, const PlacedMesh& placed, std::uint32_t slot,
                         bool back, const PointArrays& to) {
    const VecF side = hn::Set(tag_f, back ? -1.0f : 1.0f);
    for (std::uint32_t i = 0; i < cluster_padding; i += std::uint32_t(N)) {
        const VecF x = hn::LoadU(tag_f, &mesh.x[slot + i]), y = hn::LoadU(tag_f, &mesh.y[slot + i]),
                   z = hn::LoadU(tag_f, &mesh.z[slot + i]);
        for (int r = 0; r < 3; ++r) {
            const float* m = placed.to_world[r];
            const VecF p =
                hn::MulAdd(hn::Set(tag_f, m[0]), x,
                           hn::MulAdd(hn::Set(tag_f, m[1]), y,
                                      hn::MulAdd(hn::Set(tag_f, m[2]), z, hn::Set(tag_f, m[3]))));
            hn::StoreU(p, tag_f, to.position[r] + i);
            const VecF n = hn::LoadU(tag_f, placed.normal[r] + slot + i);
            hn::StoreU(hn::Mul(n, side), tag_f, to.normal[r] + i);
        }
    }
}

void place_faces_here(const float* batch, const FaceArrays& faces, const PointArrays& to) {
    const VecI packed = load_row(batch, row_corners);
    const VecI face = number_of(packed);
    const VecI back = back_of(packed);
    const VecF side = hn::Sub(hn::Set(tag_f, 1.0f), to_float(hn::Add(back, back)));
    for (int c = 0; c < 3; ++c) {
        hn::StoreU(hn::GatherIndex(tag_f, faces.centre[c], face), tag_f, to.position[c]);
        const VecF n = hn::GatherIndex(tag_f, faces.normal[c], face);
        hn::StoreU(hn::Mul(n, side), tag_f, to.normal[c]);
    }
}

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(fill_here);
HWY_EXPORT(fill_fragments_here);
HWY_EXPORT(fill_quads_here);
HWY_EXPORT(place_vertices_here);
HWY_EXPORT(place_faces_here);

void fill_lit(float* batch, int weights, int to, const VertexLight& light) {
    HWY_DYNAMIC_DISPATCH(fill_here)(batch, weights, to, light);
}
void fill_fragments_lit(float* batch, const VertexLight& light) {
    HWY_DYNAMIC_DISPATCH(fill_fragments_here)(batch, light);
}
void fill_quads_lit(float* batch, int to, const VertexLight& light) {
    HWY_DYNAMIC_DISPATCH(fill_quads_here)(batch, to, light);
}
void place_vertices(const ClusteredMesh& mesh, const PlacedMesh& placed, std::uint32_t slot,
                    bool back, const PointArrays& to) {
    HWY_DYNAMIC_DISPATCH(place_vertices_here)(mesh, placed, slot, back, to);
}
void place_faces(const float* batch, const FaceArrays& faces, const PointArrays& to) {
    HWY_DYNAMIC_DISPATCH(place_faces_here)(batch, faces, to);
}

}  // namespace scanshade
#endif

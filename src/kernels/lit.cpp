// Radiance of lit points into the planes of batches: Gouraud and flat shading.
#define SCANSHADE_SIMD

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/lit.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

VecI load_row(const float* batch, int row) {
    return hn::Load(tag_i, reinterpret_cast<const std::int32_t*>(batch) + row * N);
}

VecI side_of(VecI packed) {
    return hn::IfThenElseZero(
        hn::Ne(hn::And(packed, hn::Set(tag_i, std::int32_t(back_bit))), hn::Zero(tag_i)),
        hn::Set(tag_i, 1));
}

/// Σ radiance_i · (plane of corner i's weight): the weights' planes are replaced.
void fill_gouraud(float* batch, int row, const float* const (&radiance)[3],
                  std::int32_t first_point, const VecF (&weight)[9]) {
    const VecI packed = load_row(batch, row_corners);
    const VecI local = hn::Set(tag_i, max_cluster_vertices - 1), side = side_of(packed);
    const VecI corner[3] = {hn::And(packed, local),
                            hn::And(hn::ShiftRight<corner_bits>(packed), local),
                            hn::And(hn::ShiftRight<2 * corner_bits>(packed), local)};
    VecI point[3];
    for (int k = 0; k < 3; ++k)
        point[k] = hn::Add(hn::Add(hn::ShiftLeft<1>(corner[k]), side), hn::Set(tag_i, first_point));
    for (int c = 0; c < 3; ++c) {
        VecF L[3];
        for (int k = 0; k < 3; ++k) L[k] = hn::GatherIndex(tag_f, radiance[c], point[k]);
        for (int part = 0; part < 3; ++part) {
            const VecF sum =
                hn::MulAdd(L[0], weight[part],
                           hn::MulAdd(L[1], weight[3 + part], hn::Mul(L[2], weight[6 + part])));
            hn::Store(sum, tag_f, batch + (row + 3 * c + part) * N);
        }
    }
}

void fill_flat(float* batch, int row, const float* const (&radiance)[3], const LitFaces& faces) {
    const VecI side = side_of(load_row(batch, row_corners));
    const VecI in_mesh =
        hn::Sub(load_row(batch, row_id), hn::Set(tag_i, std::int32_t(faces.first_triangle)));
    // Unused lanes hold anything.
    const VecI last = hn::Set(tag_i, std::int32_t(faces.triangle_count) - 1);
    const VecI triangle = hn::Min(hn::Max(in_mesh, hn::Zero(tag_i)), last);
    const VecI face = hn::GatherIndex(tag_i, as_int(faces.triangle_face), triangle);
    const VecI point = hn::Add(hn::ShiftLeft<1>(face), side);
    for (int c = 0; c < 3; ++c)
        hn::Store(hn::GatherIndex(tag_f, radiance[c], point), tag_f, batch + (row + 3 * c) * N);
}

void fill_here(float* batch, const Attributes& at, const LitFill& lit) {
    if (lit.shading == Shading::flat) {
        fill_flat(batch, at.main, lit.radiance, lit.faces);
        if (lit.dark[0] != nullptr) fill_flat(batch, at.dark, lit.dark, lit.faces);
        return;
    }
    VecF weight[9];
    for (int r = 0; r < 9; ++r) weight[r] = hn::Load(tag_f, batch + (at.main + r) * N);
    fill_gouraud(batch, at.main, lit.radiance, lit.first_point, weight);
    if (lit.dark[0] != nullptr) fill_gouraud(batch, at.dark, lit.dark, lit.first_point, weight);
}

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(fill_here);

void fill_lit(float* batch, const Attributes& attributes, const LitFill& lit) {
    HWY_DYNAMIC_DISPATCH(fill_here)(batch, attributes, lit);
}

}  // namespace scanshade
#endif

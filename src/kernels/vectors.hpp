// What the kernels of the vector renderer share: tags, walking over masks.
#if defined(SCANSHADE_KERNELS_VECTORS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_VECTORS_HPP
#undef SCANSHADE_KERNELS_VECTORS_HPP
#else
#define SCANSHADE_KERNELS_VECTORS_HPP
#endif

#include <hwy/highway.h>

#include "scanshade/num/lanes.hpp"
#include "scanshade/scene/clusters.hpp"

SCANSHADE_TARGET_BEGIN;

using TagF = Lanes::Tag;
using TagI = hn::RebindToSigned<TagF>;
using VecF = hn::Vec<TagF>;
using VecI = hn::Vec<TagI>;
using MaskF = hn::Mask<TagF>;
using MaskI = hn::Mask<TagI>;
constexpr TagF tag_f;
constexpr TagI tag_i;
constexpr hn::RebindToUnsigned<TagF> tag_u;
constexpr int N = int(hn::MaxLanes(TagF()));
constexpr std::uint32_t all_lanes = (1u << N) - 1;  // a bit each

inline const std::int32_t* as_int(const std::uint32_t* p) {
    return reinterpret_cast<const std::int32_t*>(p);
}
inline std::int32_t* as_int(std::uint32_t* p) { return reinterpret_cast<std::int32_t*>(p); }

inline VecF to_float(VecI v) { return hn::ConvertTo(tag_f, v); }

/// Numbers below 2^31 in magnitude, rounded toward zero, and to nearest. Highway's own spend more on
/// numbers beyond than on these.
SCANSHADE_INLINE VecI truncate(VecF v) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    return VecI{_mm512_cvttps_epi32(v.raw)};
#elif HWY_TARGET == HWY_AVX2
    return VecI{_mm256_cvttps_epi32(v.raw)};
#else
    return hn::ConvertTo(tag_i, v);
#endif
}
SCANSHADE_INLINE VecI nearest(VecF v) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    return VecI{_mm512_cvtps_epi32(v.raw)};
#elif HWY_TARGET == HWY_AVX2
    return VecI{_mm256_cvtps_epi32(v.raw)};
#else
    return hn::NearestInt(v);
#endif
}

/// One bit a lane.
template <class Mask, class Tag>
SCANSHADE_INLINE std::uint32_t mask_bits([[maybe_unused]] Tag tag, Mask mask) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    // That is what a mask is; Highway's way leads through memory. By name, because GCC 12 widens the
    // mask without an instruction and, short of registers, spills two bytes and reads back four.
    static_assert(sizeof mask.raw == 2);
    std::uint32_t bits;
    asm("kmovw %1, %0" : "=r"(bits) : "k"(mask.raw));
    return bits;
#else
    static_assert(N <= 8);
    std::uint8_t bytes[8];
    hn::StoreMaskBits(tag, mask, bytes);
    return bytes[0];
#endif
}
template <class Tag>
SCANSHADE_INLINE hn::Mask<Tag> mask_of([[maybe_unused]] Tag tag, std::uint32_t bits) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    return {static_cast<__mmask16>(bits)};
#else
    const std::uint8_t bytes[8] = {std::uint8_t(bits)};
    return hn::LoadMaskBits(tag, bytes);
#endif
}

/// Calls visit(lane) for each lane of a mask, ascending.
template <class Visit>
void for_each_lane(std::uint32_t bits, Visit&& visit) {
    for (; bits != 0; bits &= bits - 1) visit(std::uint32_t(__builtin_ctz(bits)));
}
template <class Visit>
void for_each_lane(MaskI mask, Visit&& visit) {
    for_each_lane(mask_bits(tag_i, mask), visit);
}

/// The faces' places in their cluster, below face_numbers, of numbers packed as in ClusteredMesh.
inline VecI number_of(VecI packed) {
    return hn::And(hn::ShiftRight<number_shift>(packed),
                   hn::Set(tag_i, std::int32_t(face_numbers) - 1));
}

/// Numbers of a cluster's vertices by their local numbers. `of_local` has max_cluster_vertices of them,
/// used or not.
SCANSHADE_INLINE VecF look_up(const float* of_local, VecI local) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    // A quarter of a gather's time: the whole table is permuted, half by half.
    static_assert(max_cluster_vertices == 64);
    const __m512 low = _mm512_permutex2var_ps(_mm512_loadu_ps(of_local), local.raw,
                                              _mm512_loadu_ps(of_local + 16));
    const __m512 high = _mm512_permutex2var_ps(_mm512_loadu_ps(of_local + 32), local.raw,
                                               _mm512_loadu_ps(of_local + 48));
    return VecF{
        _mm512_mask_blend_ps(_mm512_test_epi32_mask(local.raw, _mm512_set1_epi32(32)), low, high)};
#else
    return hn::GatherIndex(tag_f, of_local, local);
#endif
}
SCANSHADE_INLINE VecI look_up(const std::int32_t* of_local, VecI local) {
    return hn::BitCast(tag_i, look_up(reinterpret_cast<const float*>(of_local), local));
}

/// For each mask of eight lanes the numbers of its lanes, then zeros.
struct LanesOfMasks {
    std::uint8_t lane[256][8];
    constexpr LanesOfMasks() : lane() {
        for (unsigned mask = 0; mask < 256; ++mask)
            for (unsigned bit = 0, to = 0; bit < 8; ++bit)
                if ((mask >> bit & 1) != 0) lane[mask][to++] = std::uint8_t(bit);
    }
};
inline constexpr LanesOfMasks lanes_of_masks;

/// The lanes of a mask first; the others have no meaning. Highway's own has a table for AVX2, too, but
/// GCC 12 copies it onto the stack each time.
SCANSHADE_INLINE VecI compress(VecI v, MaskI mask) {
#if HWY_TARGET == HWY_AVX2
    const std::uint8_t* lane = lanes_of_masks.lane[mask_bits(tag_i, mask)];
    const hn::Rebind<std::uint8_t, TagI> bytes;
    const VecI from = hn::PromoteTo(tag_i, hn::LoadU(bytes, lane));
    return hn::TableLookupLanes(v, hn::IndicesFromVec(tag_i, from));
#else
    return hn::Compress(v, mask);
#endif
}

/// Writes the lanes of a mask one after another; what follows them up to N is overwritten, too.
inline std::uint32_t compress_append(VecI v, MaskI mask, std::int32_t* to) {
    hn::StoreU(compress(v, mask), tag_i, to);
    return std::uint32_t(hn::CountTrue(tag_i, mask));
}

SCANSHADE_TARGET_END;

#endif

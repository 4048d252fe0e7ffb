// Compiled with -O3 -ffast-math, unlike everything else: the peer gets what makes it fastest, and
// the comparison of pictures holds it to our result. Includes nothing with inline functions: the
// linker could keep those of this file, which are for other machines.
#include "bench/packet_shading.hpp"

#define ON_EACH_MACHINE \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#define INLINE static inline __attribute__((always_inline))

namespace scanshade::bench {
namespace {

constexpr std::size_t N = 256;  // a block stays in the first cache while the lights pass over it

/// A block of points with what does not depend on the light; wo is the direction to the eye.
struct Block {
    std::size_t count;  // of whole vectors
    float P[3][N], n[3][N], wo[3][N], n_o[N], L[3][N];
};

INLINE float dot3(const float (&a)[3][N], const float (&b)[3][N], std::size_t i) {
    return a[0][i] * b[0][i] + a[1][i] * b[1][i] + a[2][i] * b[2][i];
}

INLINE float larger(float a, float b) { return a > b ? a : b; }

INLINE void load(const Points& points, std::size_t first, const PacketLighting& lighting,
                 Block& b) {
    const std::size_t left = (points.count - first + packet_block - 1) / packet_block;
    b.count = left * packet_block < N ? left * packet_block : N;
    for (std::size_t i = 0; i < b.count; ++i) {
        for (int c = 0; c < 3; ++c) {
            b.P[c][i] = points.position[c][first + i];
            b.n[c][i] = points.normal[c][first + i];
            b.wo[c][i] = lighting.eye[c] - b.P[c][i];
            b.L[c][i] = lighting.base[c];
        }
        const float n_scale = 1 / __builtin_sqrtf(dot3(b.n, b.n, i));
        const float wo_scale = 1 / __builtin_sqrtf(dot3(b.wo, b.wo, i));
        for (int c = 0; c < 3; ++c) {
            b.n[c][i] *= n_scale;
            b.wo[c][i] *= wo_scale;
        }
        b.n_o[i] = dot3(b.n, b.wo, i);
    }
}

template <bool blinn>
// cppcheck-suppress passedByValue ; a copy cannot change with what is stored into b
INLINE void add_light(const PeerLight light, Block& b) {
    for (std::size_t i = 0; i < b.count; ++i) {
        const float dx = light.position[0] - b.P[0][i];
        const float dy = light.position[1] - b.P[1][i];
        const float dz = light.position[2] - b.P[2][i];
        const float d2 = dx * dx + dy * dy + dz * dz;
        const float inv_d = 1 / __builtin_sqrtf(d2);
        const float n_i = (b.n[0][i] * dx + b.n[1][i] * dy + b.n[2][i] * dz) * inv_d;
        const float i_o = (b.wo[0][i] * dx + b.wo[1][i] * dy + b.wo[2][i] * dz) * inv_d;
        // The square of the cosine, as in the shaders.
        const float t = larger(blinn ? n_i + b.n_o[i] : 2 * n_i * b.n_o[i] - i_o, 0);
        float power = blinn ? t * t / (2 + 2 * i_o) : t * t;
        for (int k = 1; k < specular_squarings; ++k) power *= power;
        const float f_att = n_i > 0 ? 1 / (light.c + light.q * d2) : 0;
        for (int c = 0; c < 3; ++c)
            b.L[c][i] += f_att * (light.diffuse[c] * n_i + light.specular[c] * power);
    }
}

template <bool blinn>
INLINE void shade(const Points& points, const PacketLighting& lighting) {
    Block block;
    for (std::size_t first = 0; first < points.count; first += N) {
        load(points, first, lighting, block);
        for (std::size_t l = 0; l < lighting.light_count; ++l)
            add_light<blinn>(lighting.lights[l], block);
        for (int c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < block.count; ++i)
                points.radiance[c][first + i] = block.L[c][i];
    }
}

INLINE std::uint32_t to_byte(float x) {
    const float least = larger(x, 0);
    return static_cast<std::uint32_t>(static_cast<int>((least < 1 ? least : 1) * 255 + 0.5f));
}

}  // namespace

ON_EACH_MACHINE void shade_points(const Points& points, const PacketLighting& lighting) {
    if (lighting.blinn)
        shade<true>(points, lighting);
    else
        shade<false>(points, lighting);
}

ON_EACH_MACHINE void encode_points(const Points& points, std::uint32_t* rgba) {
    for (std::size_t i = 0; i < points.count; ++i)
        rgba[i] = to_byte(points.radiance[0][i]) | to_byte(points.radiance[1][i]) << 8 |
                  to_byte(points.radiance[2][i]) << 16 | 0xff000000u;
}

}  // namespace scanshade::bench

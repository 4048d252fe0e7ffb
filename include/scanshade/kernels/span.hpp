// The data that crosses into shading kernels: plain pointers to float or double, structure of
// arrays, the same for every number type and instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scanshade/num/exponent.hpp"

namespace scanshade {

/// Kernels work on whole groups of this many samples; arrays are padded up to it.
inline constexpr std::size_t span_padding = 16;

inline std::size_t padded(std::size_t count) {
    return (count + span_padding - 1) / span_padding * span_padding;
}

/// Surface points to be lit, all of one material. Arrays have padded(count) elements; what stands
/// in the padding is finite and its result is not read.
template <class T>
struct SurfaceSpan {
    const T* position[3];  // normalised scene space, the scene's radius in [1, 2)
    const T* normal[3];    // towards the viewer's side, any length but 0
    const T* albedo[3];    // factor of the diffuse parameter and of ka; null: 1 everywhere
    T* radiance[3];        // out: L towards the viewer
    const T* counted;      // 0 at samples that events leave out; null: all count
    std::size_t count;
};

/// `count` of the points, from `first` on.
template <class T>
SurfaceSpan<T> part_of(SurfaceSpan<T> span, std::size_t first, std::size_t count) {
    for (int c = 0; c < 3; ++c) {
        span.position[c] += first, span.normal[c] += first, span.radiance[c] += first;
        if (span.albedo[c] != nullptr) span.albedo[c] += first;
    }
    if (span.counted != nullptr) span.counted += first;
    span.count = count;
    return span;
}

/// How a light's intensity depends on the direction: one function of eq/ for each.
enum class LightEmission : std::uint8_t { uniform, spot, cosine };

/// One light as kernels see it. Directions and distances are of s·(light − P): s is a power of two
/// that keeps the squares of far lights finite, and attenuation and radius have it folded in.
template <class T>
struct LightTerm {
    T position[3];     // s · position; directional: towards the light, unit length
    T point_scale;     // s; 0 for directional lights
    T axis[3];         // unit: where a spot or cosine light shines to
    T irradiance[3];   // π I a channel
    T attenuation[3];  // c, l/s, q/s²
    T radius;          // s · radius
    T cos_cutoff;      // spot: cos τ
    T inv_penumbra;    // spot: 1/(cos(τ − penumbra) − cos τ); 0: hard edge
    LightEmission emission;
    bool constant;  // leave out what attenuation says of the distance: nothing
    bool touches;   // some surface may be nearer than the radius
};

/// All light that falls on a scene.
template <class T>
struct Lighting {
    T eye[3];      // s · position of the eye; orthographic: unit vector towards it
    T eye_scale;   // s, a power of two; orthographic: 0. ω_o = normalise(eye − eye_scale · P)
    T ambient[3];  // I_a a channel
    std::vector<LightTerm<T>> lights;
};

inline constexpr std::size_t max_params = 8;
inline constexpr std::size_t max_derived = 2;

/// A material's numbers as kernels see them; what the indices mean is the model's business.
template <class T>
struct MaterialParams {
    T value[max_params][3];         // a number has it in all three
    Exponent exponent[max_params];  // of parameters of kind exponent
    T derived[max_derived];         // what the model computes from the others, once a material
    T ka[3];                        // factor of the ambient light
    T emission[3];                  // radiance added
    bool matt;                      // leave out the specular term, which is black
};

/// What a kernel noticed.
struct SpanEvents {
    std::uint64_t light_at_surface = 0;

    void operator+=(const SpanEvents& more) { light_at_surface += more.light_at_surface; }
};

}  // namespace scanshade

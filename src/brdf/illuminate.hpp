// The light of one material's surface points, for any model and any number type: the same text is
// the scalar twins in float and double and the vector kernel of every instruction set.
#if defined(SCANSHADE_BRDF_ILLUMINATE_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_BRDF_ILLUMINATE_HPP
#undef SCANSHADE_BRDF_ILLUMINATE_HPP
#else
#define SCANSHADE_BRDF_ILLUMINATE_HPP
#endif

#include "brdf/cosines.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/eq/radiometry.hpp"
#include "scanshade/eq/shading.hpp"
#include "scanshade/kernels/span.hpp"

SCANSHADE_TARGET_BEGIN;

/// A material's parameters in the number type of a kernel.
template <Real R>
struct ParamPack {
    const MaterialParams<Scalar<R>>& material;
    int diffuse;           // index of the diffuse parameter, −1: none
    Rgb<R> diffuse_value;  // that parameter, a texture's albedo included

    Rgb<R> rgb(int index) const {
        return index == diffuse ? diffuse_value : uniform_rgb<R>(material.value[index]);
    }
    R number(int index) const { return R(material.value[index][0]); }
    const Exponent& exponent(int index) const { return material.exponent[index]; }
    int choice(int index) const { return static_cast<int>(material.value[index][0]); }
    R derived(int index) const { return R(material.derived[index]); }
    /// The specular parameter is black, and its term may be left out.
    bool matt() const { return material.matt; }
};

/// Index of the parameter with the diffuse role, −1: none.
template <class Model>
constexpr int diffuse_index() {
    int index = 0;
    for (const ParamInfo& param : Model::params) {
        if (param.role == ParamRole::diffuse) return index;
        ++index;
    }
    return -1;
}

/// `albedo`: factor of the diffuse parameter.
template <class Model, Real R>
ParamPack<R> param_pack(const MaterialParams<Scalar<R>>& material, const Rgb<R>& albedo) {
    constexpr int diffuse = diffuse_index<Model>();
    if constexpr (diffuse < 0)
        return {material, diffuse, albedo};
    else
        return {material, diffuse, uniform_rgb<R>(material.value[diffuse]) * albedo};
}

template <Real R>
Vec3<R> load_vec3(const Scalar<R>* const (&from)[3], std::size_t i) {
    return {RealTraits<R>::load(from[0] + i), RealTraits<R>::load(from[1] + i),
            RealTraits<R>::load(from[2] + i)};
}

template <Real R>
Vec3<R> uniform_vec3(const Scalar<R> (&value)[3]) {
    return {R(value[0]), R(value[1]), R(value[2])};
}

/// What scales the irradiance of a light towards −wi at a distance (in the light's units):
/// attenuation and emission.
// Inlined whatever its size: between vectors, a call would store and load every register.
template <Real R>
[[gnu::always_inline]] inline R arriving(const LightTerm<Scalar<R>>& light, const Vec3<R>& wi,
                                         R distance) {
    const R d = max(distance, R(light.radius));
    R factor = light.constant ? reciprocal(R(light.attenuation[0]))
                              : attenuation(d, light.attenuation[0], light.attenuation[1],
                                            light.attenuation[2]);
    if (light.emission == LightEmission::cosine)
        factor = factor * cosine_light(-wi, uniform_vec3<R>(light.axis));
    if (light.emission == LightEmission::spot)
        factor = factor *
                 spot_light(-wi, uniform_vec3<R>(light.axis), light.cos_cutoff, light.inv_penumbra);
    return factor;
}

/// Samples of the vector at i that are nearer to the light than its radius.
template <Real R>
std::uint64_t count_nearer(const SurfaceSpan<Scalar<R>>& span, std::size_t i, R distance,
                           const LightTerm<Scalar<R>>& light) {
    const auto nearer = distance < R(light.radius);
    const auto in_span = RealTraits<R>::iota() < R(static_cast<double>(span.count - i));
    const auto counted = span.counted == nullptr
                             ? in_span
                             : mask_and(in_span, R(0) < RealTraits<R>::load(span.counted + i));
    return count_true(mask_and(nearer, counted));
}

template <class Model, Real R>
SpanEvents illuminate_span(const SurfaceSpan<Scalar<R>>& span, const Lighting<Scalar<R>>& lighting,
                           const MaterialParams<Scalar<R>>& material) {
    SpanEvents events;
    for (std::size_t i = 0; i < span.count; i += RealTraits<R>::width) {
        const Vec3<R> P = load_vec3<R>(span.position, i);
        const Vec3<R> n = normalise(load_vec3<R>(span.normal, i));
        const Vec3<R> wo = normalise(uniform_vec3<R>(lighting.eye) - P * R(lighting.eye_scale));

        Rgb<R> albedo{R(1), R(1), R(1)};
        if (span.albedo[0] != nullptr)
            albedo = {RealTraits<R>::load(span.albedo[0] + i),
                      RealTraits<R>::load(span.albedo[1] + i),
                      RealTraits<R>::load(span.albedo[2] + i)};
        const ParamPack<R> params = param_pack<Model, R>(material, albedo);
        Rgb<R> L =
            ambient_term(uniform_rgb<R>(lighting.ambient), uniform_rgb<R>(material.ka) * albedo) +
            uniform_rgb<R>(material.emission);
        for (const LightTerm<Scalar<R>>& light : lighting.lights) {
            const Vec3<R> to_light = uniform_vec3<R>(light.position) - P * R(light.point_scale);
            const R distance2 = dot(to_light, to_light);
            const R inv_distance = inverse_length(distance2), distance = distance2 * inv_distance;
            const Vec3<R> wi = to_light * inv_distance;
            const Cosines<R> c = cosines(n, wi, wo);
            const R factor = select(c.n_i > R(0), arriving(light, wi, distance), R(0));
            L = L + light_term(factor, uniform_rgb<R>(light.irradiance), Model::f_cos(c, params));
            if (light.touches) events.light_at_surface += count_nearer<R>(span, i, distance, light);
        }
        RealTraits<R>::store(L.r, span.radiance[0] + i);
        RealTraits<R>::store(L.g, span.radiance[1] + i);
        RealTraits<R>::store(L.b, span.radiance[2] + i);
    }
    return events;
}

SCANSHADE_TARGET_END;

#endif

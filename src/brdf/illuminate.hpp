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
    const MaterialParams<Scalar<R>>* material;
    int diffuse;           // index of the diffuse parameter, −1: none
    Rgb<R> diffuse_value;  // that parameter, a texture's albedo included

    Rgb<R> rgb(int index) const {
        return index == diffuse ? diffuse_value : uniform_rgb<R>(material->value[index]);
    }
    R number(int index) const { return R(material->value[index][0]); }
    const Exponent& exponent(int index) const { return material->exponent[index]; }
    int choice(int index) const { return static_cast<int>(material->value[index][0]); }
    R derived(int index) const { return R(material->derived[index]); }
    /// The specular parameter is black, and its term may be left out.
    bool matt() const { return material->matt; }
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
        return {&material, diffuse, albedo};
    else
        return {&material, diffuse, uniform_rgb<R>(material.value[diffuse]) * albedo};
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

/// Attenuation of a light at a distance (in the light's units).
template <Real R>
SCANSHADE_INLINE R attenuation_of(const LightTerm<Scalar<R>>& light, R distance) {
    if (light.constant) return R(1) / R(light.attenuation[0]);
    return attenuation(max(distance, R(light.radius)), light.attenuation[0], light.attenuation[1],
                       light.attenuation[2]);
}

/// What share of its intensity a cosine or spot light sends towards −wi.
template <Real R>
SCANSHADE_INLINE R emission_of(const LightTerm<Scalar<R>>& light, const Vec3<R>& wi) {
    const Vec3<R> axis = uniform_vec3<R>(light.axis);
    if (light.emission == LightEmission::cosine) return cosine_light(-wi, axis);
    return spot_light(-wi, axis, light.cos_cutoff, light.inv_penumbra);
}

/// What scales the irradiance of a light: attenuation and emission.
template <Real R>
SCANSHADE_INLINE R arriving(const LightTerm<Scalar<R>>& light, const Vec3<R>& wi, R distance) {
    const R f_att = attenuation_of(light, distance);
    return light.emission == LightEmission::uniform ? f_att : f_att * emission_of(light, wi);
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

/// Who watches the loop below: nobody, where pictures are drawn.
struct NoWitness {};

/// Writes down what the loop computes at one point, in plain numbers.
template <class Model, class T>
class Witness {
public:
    explicit Witness(PointReport<T>& into) : into_(into) {}

    void point(const Vec3<T>& P, const Vec3<T>& n, const Vec3<T>& wo, const Rgb<T>& albedo) {
        put(P, into_.position), put(n, into_.normal), put(wo, into_.wo);
        put(albedo, into_.albedo);
    }
    void unreflected(const Rgb<T>& ambient, const Rgb<T>& emission) {
        put(ambient, into_.ambient), put(emission, into_.emission);
    }
    void light(const LightTerm<T>& light, const Vec3<T>& wi, T distance, T factor,
               const Cosines<T>& c, const ParamPack<T>& params, const Rgb<T>& f_cos,
               const Rgb<T>& term) {
        LightAtPoint<T>& at = into_.lights.emplace_back();
        put(wi, at.wi);
        const bool near = light.point_scale > 0;
        at.distance = near ? distance / light.point_scale : std::numeric_limits<T>::infinity();
        at.f_att = attenuation_of(light, distance);
        at.emission = light.emission == LightEmission::uniform ? T(1) : emission_of(light, wi);
        at.factor = factor;
        at.cosines = c;
        Model::terms(c, params, at.bracket);
        put(uniform_rgb<T>(light.irradiance), at.irradiance);
        put(f_cos, at.f_cos), put(term, at.term);
    }
    void sum(const Rgb<T>& L) { put(L, into_.radiance); }

private:
    static void put(const Vec3<T>& v, T (&to)[3]) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }
    static void put(const Rgb<T>& v, T (&to)[3]) { to[0] = v.r, to[1] = v.g, to[2] = v.b; }
    PointReport<T>& into_;
};

/// What a material does at points of one albedo, whichever light falls there.
template <class Model, Real R>
struct Reflector {
    Reflector(const Lighting<Scalar<R>>& lighting, const MaterialParams<Scalar<R>>& material,
              const Rgb<R>& of)
        : albedo(of),
          params(param_pack<Model, R>(material, of)),
          ambient(ambient_term(uniform_rgb<R>(lighting.ambient), uniform_rgb<R>(material.ka) * of)),
          emission(uniform_rgb<R>(material.emission)),
          unreflected(ambient + emission) {}

    Rgb<R> albedo;
    ParamPack<R> params;
    Rgb<R> ambient, emission, unreflected;
};

template <class Model, Real R, class Watching = NoWitness>
SpanEvents illuminate_span(const SurfaceSpan<Scalar<R>>& span, const Lighting<Scalar<R>>& lighting,
                           const MaterialParams<Scalar<R>>& of,
                           [[maybe_unused]] Watching witness = {}) {
    constexpr bool watched = !std::is_same_v<Watching, NoWitness>;
    // A copy: what a branch reads through a reference would be computed again for every light.
    const MaterialParams<Scalar<R>> material = of;
    SpanEvents events;
    Reflector<Model, R> reflector(lighting, material, {R(1), R(1), R(1)});
    for (std::size_t i = 0; i < span.count; i += RealTraits<R>::width) {
        const Vec3<R> P = load_vec3<R>(span.position, i);
        const Vec3<R> n = normalise(load_vec3<R>(span.normal, i));
        const Vec3<R> wo =
            normalise(mul_add(P, R(-lighting.eye_scale), uniform_vec3<R>(lighting.eye)));

        if (span.albedo[0] != nullptr)
            reflector = Reflector<Model, R>(
                lighting, material,
                {RealTraits<R>::load(span.albedo[0] + i), RealTraits<R>::load(span.albedo[1] + i),
                 RealTraits<R>::load(span.albedo[2] + i)});
        Rgb<R> L = reflector.unreflected;
        if constexpr (watched) witness.point(P, n, wo, reflector.albedo);
        if constexpr (watched) witness.unreflected(reflector.ambient, reflector.emission);
        for (const LightTerm<Scalar<R>>& light : lighting.lights) {
            const Vec3<R> to_light =
                mul_add(P, R(-light.point_scale), uniform_vec3<R>(light.position));
            const R distance2 = dot(to_light, to_light);
            const R inv_distance = inverse_length(distance2), distance = distance2 * inv_distance;
            const Vec3<R> wi = to_light * inv_distance;
            const Cosines<R> c = cosines(n, wi, wo);
            const R factor = select(c.n_i > R(0), arriving(light, wi, distance), R(0));
            const Rgb<R> f_cos = Model::f_cos(c, reflector.params);
            const Rgb<R> irradiance = uniform_rgb<R>(light.irradiance);
            L = light_term(factor, irradiance, f_cos, L);
            if constexpr (watched)
                witness.light(light, wi, distance, factor, c, reflector.params, f_cos,
                              light_term(factor, irradiance, f_cos));
            if (light.touches) events.light_at_surface += count_nearer<R>(span, i, distance, light);
        }
        if constexpr (watched) witness.sum(L);
        RealTraits<R>::store(L.r, span.radiance[0] + i);
        RealTraits<R>::store(L.g, span.radiance[1] + i);
        RealTraits<R>::store(L.b, span.radiance[2] + i);
    }
    return events;
}

SCANSHADE_TARGET_END;

#endif

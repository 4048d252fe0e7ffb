// Directions at a surface point as the cosines that models read.
#if defined(SCANSHADE_BRDF_COSINES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_BRDF_COSINES_HPP
#undef SCANSHADE_BRDF_COSINES_HPP
#else
#define SCANSHADE_BRDF_COSINES_HPP
#endif

#include "scanshade/brdf/brdf.hpp"
#include "scanshade/eq/reflection.hpp"

SCANSHADE_TARGET_BEGIN;

/// All of them; inlined into a model's loop, whatever the size, what the model does not read is not computed.
/// n, wi and wo are unit vectors. Sines come from cross products, not from 1 − cos²; ω_i·h is half
/// of the length of ω_i + ω_o. Errors are absolute: ≤ 12 u, of sin2_h 12 u sinθ_h.
template <Real R>
SCANSHADE_INLINE Cosines<R> cosines(const Vec3<R>& n, const Vec3<R>& wi, const Vec3<R>& wo) {
    const Vec3<R> sum = wi + wo, h = half_vector(wi, wo), n_cross_h = cross(n, h);
    const R length2 = dot(sum, sum);
    const R n_i = dot(n, wi), n_o = dot(n, wo);
    return {n_i,
            max(n_o, R(1e-12)),
            cos_half(n_i, n_o, wi, wo),
            clamp(dot(mirror_direction(wi, n), wo), R(0), R(1)),
            min(sqrt(length2) * R(0.5), R(1)),
            select(length2 > R(0), min(dot(n_cross_h, n_cross_h), R(1)), R(1)),
            dot(cross(n, wi), cross(n, wo))};
}

SCANSHADE_TARGET_END;

#endif

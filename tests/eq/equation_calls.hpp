// Every function of eq/ as a call that any type of number can make: arrays of numbers in and out.
#if defined(SCANSHADE_TESTS_EQUATION_CALLS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_TESTS_EQUATION_CALLS_HPP
#undef SCANSHADE_TESTS_EQUATION_CALLS_HPP
#else
#define SCANSHADE_TESTS_EQUATION_CALLS_HPP
#endif

#include "scanshade/eq/directions.hpp"
#include "scanshade/eq/fresnel.hpp"
#include "scanshade/eq/microfacet.hpp"
#include "scanshade/eq/radiometry.hpp"
#include "scanshade/eq/raycast.hpp"
#include "scanshade/eq/reflectance.hpp"
#include "scanshade/eq/reflection.hpp"
#include "scanshade/eq/shading.hpp"

SCANSHADE_TARGET_BEGIN;

template <class R>
Vec3<R> vec3_at(const R* x) {
    return {x[0], x[1], x[2]};
}
template <class R>
Vec3<R> constant(double x, double y, double z) {
    return {R(x), R(y), R(z)};
}
template <class R>
Spherical<R> spherical_at(const R* x) {
    return {x[0], x[1]};
}
template <class R>
PlaneCoordinates<R> plane_at(const R* x) {
    return {x[0], x[1]};
}
template <class R>
OrenNayarCoefficients<R> some_roughness() {
    return {R(0.75), R(0.25)};
}
template <class R>
Rgb<R> rgb_of(R x) {
    return {x, x * R(0.5), x * R(0.25)};
}
template <class R>
void put(const Vec3<R>& v, R* y) {
    y[0] = v.x;
    y[1] = v.y;
    y[2] = v.z;
}
template <class R>
void put(const Rgb<R>& c, R* y) {
    y[0] = c.r;
    y[1] = c.g;
    y[2] = c.b;
}

#define EQUATION(name, inputs, outputs, error_u, scale, call, ...) \
    template <class R>                                             \
    void name##_call([[maybe_unused]] const R* x, R* y) {          \
        call;                                                      \
    }
#include "eq/equation_rows.hpp"

SCANSHADE_TARGET_END;

#endif

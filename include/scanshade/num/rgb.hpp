// Colours: three channels of linear radiance, reflectance or the like.
#if defined(SCANSHADE_NUM_RGB_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_RGB_HPP
#undef SCANSHADE_NUM_RGB_HPP
#else
#define SCANSHADE_NUM_RGB_HPP
#endif

#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

/// Intensity of a colour: one number a channel; everything in shading is done channel by channel.
///
///     I = (I^R, I^G, I^B)                                                                (C6)
///
/// in      r, g, b   the channels                     ≥ 0       any unit of light
/// error   none of its own: + and * round once a channel
/// checks  channels never mix                         tests/eq/shading_test.cpp
/// source  the formula sheet
template <class R>
struct Rgb {
    R r, g, b;
};

template <Real R>
Rgb<R> operator+(const Rgb<R>& a, const Rgb<R>& c) {
    return {a.r + c.r, a.g + c.g, a.b + c.b};
}
template <Real R>
Rgb<R> operator*(const Rgb<R>& a, const Rgb<R>& c) {
    return {a.r * c.r, a.g * c.g, a.b * c.b};
}
template <Real R>
Rgb<R> operator*(const Rgb<R>& a, R s) {
    return {a.r * s, a.g * s, a.b * s};
}

/// a s + c and a b + c, channel by channel.
template <Real R>
Rgb<R> mul_add(const Rgb<R>& a, R s, const Rgb<R>& c) {
    return {mul_add(a.r, s, c.r), mul_add(a.g, s, c.g), mul_add(a.b, s, c.b)};
}
template <Real R>
Rgb<R> mul_add(const Rgb<R>& a, const Rgb<R>& b, const Rgb<R>& c) {
    return {mul_add(a.r, b.r, c.r), mul_add(a.g, b.g, c.g), mul_add(a.b, b.b, c.b)};
}

/// The same three numbers in every element.
template <Real R>
Rgb<R> uniform_rgb(const Scalar<R> (&value)[3]) {
    return {R(value[0]), R(value[1]), R(value[2])};
}

SCANSHADE_TARGET_END;

#endif

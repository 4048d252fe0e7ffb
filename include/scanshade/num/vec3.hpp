// Vectors of three numbers.
#if defined(SCANSHADE_NUM_VEC3_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_VEC3_HPP
#undef SCANSHADE_NUM_VEC3_HPP
#else
#define SCANSHADE_NUM_VEC3_HPP
#endif

#include <limits>

#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

template <class R>
struct Vec3 {
    R x, y, z;
};

// Free functions: GCC does not give friends defined inside a class the pragma's target.
template <Real R>
Vec3<R> operator+(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <Real R>
Vec3<R> operator-(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <Real R>
Vec3<R> operator-(const Vec3<R>& a) {
    return {-a.x, -a.y, -a.z};
}
template <Real R>
Vec3<R> operator*(const Vec3<R>& a, R s) {
    return {a.x * s, a.y * s, a.z * s};
}

/// a·b. Error ≤ 3 u Σ|a_k b_k|.
/// a s + c.
template <Real R>
Vec3<R> mul_add(const Vec3<R>& a, R s, const Vec3<R>& c) {
    return {mul_add(a.x, s, c.x), mul_add(a.y, s, c.y), mul_add(a.z, s, c.z)};
}

template <Real R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
    return mul_add(a.z, b.z, mul_add(a.y, b.y, a.x * b.x));
}

template <Real R>
Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// 1/|v| from |v|²; 0 where |v|² is below the smallest normal number, so that what has no length
/// has no direction.
template <Real R>
R inverse_length(R length2) {
    return inverse_sqrt_above(length2, std::numeric_limits<Scalar<R>>::min());
}

/// v/|v|, or the zero vector where |v|² underflows. Error ≤ 4 u a component (Lanes 6 u), for |v|²
/// that neither underflows nor overflows; test: "normalise is exact to 4 u and maps 0 to 0".
template <Real R>
Vec3<R> normalise(const Vec3<R>& v) {
    return v * inverse_length(dot(v, v));
}

SCANSHADE_TARGET_END;

#endif

// Vectors of three numbers.
#if defined(SCANSHADE_NUM_VEC3_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_VEC3_HPP
#undef SCANSHADE_NUM_VEC3_HPP
#else
#define SCANSHADE_NUM_VEC3_HPP
#endif

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

/// (a.x b.x + a.y b.y) + a.z b.z, not fused. Error ≤ 3 u Σ|a_k b_k|.
template <Real R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <Real R>
Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// v/|v|, or the zero vector where |v|² underflows to 0. Error ≤ 4 u a component, for |v|² that
/// neither underflows nor overflows; test: "normalise is exact to 4 u and maps 0 to 0".
template <Real R>
Vec3<R> normalise(const Vec3<R>& v) {
    const R length2 = dot(v, v);
    const auto has_length = length2 > R(0);
    const R inverse = select(has_length, R(1) / sqrt(select(has_length, length2, R(1))), R(0));
    return v * inverse;
}

SCANSHADE_TARGET_END;

#endif

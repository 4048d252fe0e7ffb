// Numbers of 113 bits: the reference that equations in double are measured against.
#if defined(SCANSHADE_NUM_WIDE_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_WIDE_HPP
#undef SCANSHADE_NUM_WIDE_HPP
#else
#define SCANSHADE_NUM_WIDE_HPP
#endif

#include "scanshade/num/functions.hpp"
#include "scanshade/num/quad.hpp"

SCANSHADE_TARGET_BEGIN;

/// A class, so that equations find the functions below by its namespace, wherever they are included.
struct Wide {
    Quad value;

    Wide() = default;
    explicit Wide(Quad x) : value(x) {}
    explicit Wide(float x) : value(static_cast<Quad>(x)) {}
    explicit Wide(double x) : value(static_cast<Quad>(x)) {}
    explicit Wide(int x) : value(static_cast<Quad>(x)) {}
    explicit operator double() const { return static_cast<double>(value); }
};

template <>
struct RealTraits<Wide> {
    using Scalar = double;
};

inline Wide operator-(const Wide& a) { return Wide(-a.value); }
inline Wide operator+(const Wide& a, const Wide& b) { return Wide(a.value + b.value); }
inline Wide operator-(const Wide& a, const Wide& b) { return Wide(a.value - b.value); }
inline Wide operator*(const Wide& a, const Wide& b) { return Wide(a.value * b.value); }
inline Wide operator/(const Wide& a, const Wide& b) { return Wide(a.value / b.value); }
inline bool operator>(const Wide& a, const Wide& b) { return a.value > b.value; }
inline bool operator<(const Wide& a, const Wide& b) { return a.value < b.value; }

inline Wide select(bool mask, const Wide& a, const Wide& b) { return mask ? a : b; }
inline Wide max(const Wide& a, const Wide& b) { return a > b ? a : b; }
inline Wide min(const Wide& a, const Wide& b) { return a < b ? a : b; }
inline Wide abs(const Wide& x) { return Wide(fabsf128(x.value)); }
inline Wide mul_add(const Wide& a, const Wide& b, const Wide& c) { return a * b + c; }
inline Wide sqrt(const Wide& x) { return Wide(sqrtf128(x.value)); }
inline Wide reciprocal(const Wide& x) { return Wide(1) / x; }
inline Wide inverse_sqrt(const Wide& x) { return reciprocal(sqrt(x)); }
inline Wide exp(const Wide& x) { return Wide(expf128(x.value)); }
inline Wide log(const Wide& x) { return Wide(logf128(x.value)); }
inline Wide log1p(const Wide& x) { return Wide(log1pf128(x.value)); }
inline Wide pow(const Wide& x, const Wide& y) { return Wide(powf128(x.value, y.value)); }
inline Wide sin(const Wide& x) { return Wide(sinf128(x.value)); }
inline Wide cos(const Wide& x) { return Wide(cosf128(x.value)); }
inline Wide asin(const Wide& x) { return Wide(asinf128(x.value)); }
inline Wide acos(const Wide& x) { return Wide(acosf128(x.value)); }
inline Wide atan2(const Wide& y, const Wide& x) { return Wide(atan2f128(y.value, x.value)); }

/// π to the last of the 113 bits.
inline Wide wide_pi() { return acos(Wide(-1)); }
template <>
inline Wide inv_pi_as<Wide>() {
    return reciprocal(wide_pi());
}

SCANSHADE_TARGET_END;

#endif

// Dual numbers: a value with its derivative, carried along by the chain rule.
#if defined(SCANSHADE_NUM_DUAL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_DUAL_HPP
#undef SCANSHADE_NUM_DUAL_HPP
#else
#define SCANSHADE_NUM_DUAL_HPP
#endif

#include "scanshade/num/plain.hpp"
#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

/// x + x′ε with ε² = 0. Seed the variable with derivative 1 and evaluate: the result's derivative
/// is exact to rounding. Where the true slope is infinite (a root at 0, an arc at ±1) the slope is
/// `steepest`: large, and 0 times it is 0, so that no NaN arises from a path that does not matter.
struct Dual {
    double value, derivative;

    Dual() = default;
    explicit Dual(float x) : Dual(static_cast<double>(x)) {}
    explicit Dual(double x) : value(x), derivative(0) {}
    explicit Dual(int x) : Dual(static_cast<double>(x)) {}
    Dual(double x, double slope) : value(x), derivative(slope) {}
    explicit Dual(const PlainDual& x) : value(x.value), derivative(x.derivative) {}
};

inline PlainDual plain(const Dual& x) { return {x.value, x.derivative}; }

template <>
struct RealTraits<Dual> {
    using Scalar = double;
};

inline constexpr double steepest = 1e100;

/// slope/divisor · x′, of divisors ≥ 0.
inline double chain(double slope, double divisor, double derivative) {
    return divisor > 0 ? slope / divisor * derivative : slope * steepest * derivative;
}

inline Dual operator-(const Dual& a) { return {-a.value, -a.derivative}; }
inline Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.derivative + b.derivative};
}
inline Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.derivative - b.derivative};
}
inline Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
}
inline Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
}

// Comparisons see the value only; so does what is selected by them.
inline bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
inline bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
inline Dual select(bool mask, const Dual& a, const Dual& b) { return mask ? a : b; }
inline Dual max(const Dual& a, const Dual& b) { return a > b ? a : b; }
inline Dual min(const Dual& a, const Dual& b) { return a < b ? a : b; }
inline Dual abs(const Dual& x) { return x.value < 0 ? -x : x; }

inline Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value);
    return {root, chain(1, 2 * root, x.derivative)};
}
inline Dual mul_add(const Dual& a, const Dual& b, const Dual& c) { return a * b + c; }
inline Dual inverse_sqrt(const Dual& x) {
    const double inverse = 1 / std::sqrt(x.value);
    return {inverse, chain(-0.5 * inverse, x.value, x.derivative)};
}
inline Dual reciprocal(const Dual& x) { return Dual(1) / x; }
inline Dual exp(const Dual& x) {
    const double power = std::exp(x.value);
    return {power, power * x.derivative};
}
inline Dual log(const Dual& x) { return {std::log(x.value), chain(1, x.value, x.derivative)}; }
inline Dual log1p(const Dual& x) {
    return {std::log1p(x.value), chain(1, 1 + x.value, x.derivative)};
}
inline Dual sin(const Dual& x) { return {std::sin(x.value), std::cos(x.value) * x.derivative}; }
inline Dual cos(const Dual& x) { return {std::cos(x.value), -std::sin(x.value) * x.derivative}; }

/// √(1 − x²), without cancellation.
inline double arc_divisor(double x) { return std::sqrt((1 - x) * (1 + x)); }
inline Dual asin(const Dual& x) {
    return {std::asin(x.value), chain(1, arc_divisor(x.value), x.derivative)};
}
inline Dual acos(const Dual& x) {
    return {std::acos(x.value), chain(-1, arc_divisor(x.value), x.derivative)};
}
/// At the origin, which has no angle, the derivative is 0.
inline Dual atan2(const Dual& y, const Dual& x) {
    const double turn = x.value * y.derivative - y.value * x.derivative;
    const double radius2 = x.value * x.value + y.value * y.value;
    return {std::atan2(y.value, x.value), radius2 > 0 ? turn / radius2 : 0};
}

SCANSHADE_TARGET_END;

#endif

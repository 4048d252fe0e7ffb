// Interval arithmetic: where float rounds, an interval keeps both sides.
#if defined(SCANSHADE_NUM_INTERVAL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_INTERVAL_HPP
#undef SCANSHADE_NUM_INTERVAL_HPP
#else
#define SCANSHADE_NUM_INTERVAL_HPP
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanshade/num/plain.hpp"
#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

/// All reals between two floats; ends may be infinite, never NaN. The result of an operation holds
/// the exact result for all reals in its arguments, and with it what float and Lanes compute: they
/// round the exact result of an operation, which the ends do too, outward. So an equation evaluated
/// in Interval encloses its exact value, the float's and every vector's, and the width bounds their
/// error.
struct Interval {
    float low, high;

    Interval() = default;
    explicit Interval(float x) : low(x), high(x) {}
    explicit Interval(int x) : Interval(static_cast<double>(x)) {}
    /// The floats around x: a constant such as π is enclosed by its double's neighbours.
    explicit Interval(double x);
    Interval(float lowest, float highest) : low(lowest), high(highest) {}
    explicit Interval(const PlainInterval& x) : low(x.low), high(x.high) {}

    /// Of a number of any precision up to long double.
    template <class T>
    bool contains(T x) const {
        const auto exact = static_cast<long double>(x);
        return static_cast<long double>(low) <= exact && exact <= static_cast<long double>(high);
    }
};

inline PlainInterval plain(const Interval& x) { return {x.low, x.high}; }

/// A comparison of intervals may hold for some of their reals and not for others.
struct IntervalMask {
    bool may_hold, may_fail;
};

template <>
struct RealTraits<Interval> {
    using Scalar = float;
};

// ---- rounding -----------------------------------------------------------------------------------

inline constexpr float interval_infinity = std::numeric_limits<float>::infinity();

/// The largest float that is not above x.
inline float float_below(double x) {
    const float nearest = static_cast<float>(x);
    return static_cast<double>(nearest) > x ? std::nextafter(nearest, -interval_infinity) : nearest;
}
/// The smallest float that is not below x.
inline float float_above(double x) { return -float_below(-x); }

/// Encloses a double result whose exact value is `nearest` + `rest`, rest no more than half an ulp.
inline Interval enclose(double nearest, double rest) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {float_below(rest < 0 ? std::nextafter(nearest, -infinity) : nearest),
            float_above(rest > 0 ? std::nextafter(nearest, infinity) : nearest)};
}

/// Encloses a function's value between two doubles when every float implementation of it is good
/// to `ulps` units in the last place.
inline Interval widened(double low, double high, double ulps) {
    const auto slack = [ulps](double x) { return ulps * (0x1p-23 * std::abs(x) + 0x1p-149); };
    return {std::isfinite(low) ? float_below(low - slack(low)) : static_cast<float>(low),
            std::isfinite(high) ? float_above(high + slack(high)) : static_cast<float>(high)};
}

inline Interval::Interval(double x) : low(float_below(x)), high(float_above(x)) {}

inline Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

// ---- arithmetic ---------------------------------------------------------------------------------

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }

/// a + b: exact in double but for a rest that is known exactly (Knuth's TwoSum).
inline Interval enclosed_sum(float x, float y) {
    const double a = static_cast<double>(x), b = static_cast<double>(y);
    const double sum = a + b, b_part = sum - a;
    return enclose(sum, (a - (sum - b_part)) + (b - b_part));
}
inline Interval operator+(const Interval& a, const Interval& b) {
    return {enclosed_sum(a.low, b.low).low, enclosed_sum(a.high, b.high).high};
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }

/// a · b of two floats, exact in double; 0 · ∞ is 0, as ∞ stands for large reals only.
inline double exact_product(float a, float b) {
    return a == 0 || b == 0 ? 0.0 : static_cast<double>(a) * static_cast<double>(b);
}
inline Interval operator*(const Interval& a, const Interval& b) {
    const auto [low, high] =
        std::minmax({exact_product(a.low, b.low), exact_product(a.low, b.high),
                     exact_product(a.high, b.low), exact_product(a.high, b.high)});
    return {float_below(low), float_above(high)};
}

/// a/b of two floats, b not 0.
inline Interval enclosed_quotient(float a, float b) {
    if (a == 0) return Interval(0.0f);
    if (std::isinf(b))
        return std::isinf(a)
                   ? Interval{-interval_infinity, interval_infinity}
                   : hull(Interval(0.0f), enclosed_quotient(a, std::copysign(3.4028235e38f, b)));
    const double quotient = static_cast<double>(a) / static_cast<double>(b);
    const float rounded = static_cast<float>(quotient);
    if (exact_product(rounded, b) == static_cast<double>(a)) return Interval(rounded);
    return hull(enclose(quotient, -1), enclose(quotient, 1));
}
/// Where the divisor may be 0 the result is open towards the infinities that are possible.
inline Interval operator/(const Interval& a, const Interval& b) {
    if (b.low > 0 || b.high < 0)
        return hull(hull(enclosed_quotient(a.low, b.low), enclosed_quotient(a.low, b.high)),
                    hull(enclosed_quotient(a.high, b.low), enclosed_quotient(a.high, b.high)));
    if (b.low == 0 && b.high > 0) {
        return {a.low < 0 ? -interval_infinity : enclosed_quotient(a.low, b.high).low,
                a.high > 0 ? interval_infinity : enclosed_quotient(a.high, b.high).high};
    }
    if (b.high == 0 && b.low < 0) return (-a) / (-b);
    return {-interval_infinity, interval_infinity};
}

// ---- comparison ---------------------------------------------------------------------------------

inline IntervalMask operator>(const Interval& a, const Interval& b) {
    return {a.high > b.low, !(a.low > b.high)};
}
inline IntervalMask operator<(const Interval& a, const Interval& b) { return b > a; }
inline IntervalMask mask_and(const IntervalMask& a, const IntervalMask& b) {
    return {a.may_hold && b.may_hold, a.may_fail || b.may_fail};
}
/// Both branches where the mask is undecided.
inline Interval select(const IntervalMask& mask, const Interval& a, const Interval& b) {
    if (!mask.may_fail) return a;
    return mask.may_hold ? hull(a, b) : b;
}
inline Interval max(const Interval& a, const Interval& b) {
    return {std::max(a.low, b.low), std::max(a.high, b.high)};
}
inline Interval min(const Interval& a, const Interval& b) {
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
}
inline Interval abs(const Interval& x) {
    const Interval negated = -x;
    return {std::max({x.low, negated.low, 0.0f}), std::max(x.high, negated.high)};
}

// ---- functions ----------------------------------------------------------------------------------

// The largest error of the float functions of glibc ("Known Maximum Errors in Math Functions") and
// of Highway's contrib/math, whichever is larger; atan2 is num/lanes_functions.hpp's.
inline constexpr double exp_ulps = 1, log_ulps = 4, log1p_ulps = 2, sine_ulps = 3, arc_ulps = 2,
                        atan2_ulps = 6, estimate_ulps = 2;

/// Correctly rounded everywhere; of a negative number as of 0.
inline Interval sqrt(const Interval& x) {
    const auto enclosed_root = [](float square) {
        const double root = std::sqrt(static_cast<double>(std::max(square, 0.0f)));
        const float rounded = static_cast<float>(root);
        if (exact_product(rounded, rounded) == static_cast<double>(square))
            return Interval(rounded);
        return hull(enclose(root, -1), enclose(root, 1));
    };
    return {std::max(enclosed_root(x.low).low, 0.0f), enclosed_root(x.high).high};
}
/// Holds the result of a fused operation too: it rounds the exact a b + c, which is inside.
inline Interval mul_add(const Interval& a, const Interval& b, const Interval& c) {
    return a * b + c;
}
/// 1/√x for x > 0, to the error of vectors that start from an estimate.
inline Interval inverse_sqrt(const Interval& x) {
    return widened(1 / std::sqrt(std::max(double(x.high), 0.0)),
                   1 / std::sqrt(std::max(double(x.low), 0.0)), estimate_ulps);
}
/// 1/x for x ≥ 0, which vectors limit to 2^±100.
inline Interval reciprocal(const Interval& x) {
    const Interval all =
        widened(1 / double(x.high), 1 / std::max(double(x.low), 0.0), estimate_ulps);
    return hull(all, min(max(all, Interval(0x1p-100f)), Interval(0x1p100f)));
}
inline Interval exp(const Interval& x) {
    const Interval wide = widened(std::exp(double(x.low)), std::exp(double(x.high)), exp_ulps);
    return {std::max(wide.low, 0.0f), wide.high};
}
inline Interval log(const Interval& x) {
    return widened(std::log(std::max(double(x.low), 0.0)), std::log(std::max(double(x.high), 0.0)),
                   log_ulps);
}
inline Interval log1p(const Interval& x) {
    return widened(std::log1p(std::max(double(x.low), -1.0)),
                   std::log1p(std::max(double(x.high), -1.0)), log1p_ulps);
}
inline Interval asin(const Interval& x) {
    return widened(std::asin(std::clamp(double(x.low), -1.0, 1.0)),
                   std::asin(std::clamp(double(x.high), -1.0, 1.0)), arc_ulps);
}
inline Interval acos(const Interval& x) {
    return widened(std::acos(std::clamp(double(x.high), -1.0, 1.0)),
                   std::acos(std::clamp(double(x.low), -1.0, 1.0)), arc_ulps);
}

/// Cosine shifted by `phase` to the left: at its ends, and ±1 for each extremum between them.
inline Interval enclosed_wave(const Interval& x, double phase) {
    const double from = double(x.low) + phase, to = double(x.high) + phase;
    if (!(to - from < 2 * pi)) return {-1, 1};
    const auto at = [phase](float angle) {
        return phase == 0 ? std::cos(double(angle)) : std::sin(double(angle));
    };
    auto [low, high] = std::minmax({at(x.low), at(x.high)});
    for (double k = std::ceil(from / pi); k * pi <= to; ++k) {
        low = std::min(low, std::cos(k * pi));
        high = std::max(high, std::cos(k * pi));
    }
    return widened(low, high, sine_ulps);
}
inline Interval cos(const Interval& x) { return enclosed_wave(x, 0); }
inline Interval sin(const Interval& x) { return enclosed_wave(x, -pi / 2); }

/// The angle is extremal at a corner of the box, unless the box has the origin in it or reaches
/// across the negative x axis, where the angle jumps.
inline Interval atan2(const Interval& y, const Interval& x) {
    if (x.low <= 0 && y.low <= 0 && y.high >= 0 && !(y.low == 0 && y.high == 0 && x.low == 0))
        return widened(-pi, pi, atan2_ulps);
    const auto [low, high] = std::minmax(
        {std::atan2(double(y.low), double(x.low)), std::atan2(double(y.low), double(x.high)),
         std::atan2(double(y.high), double(x.low)), std::atan2(double(y.high), double(x.high))});
    return widened(low, high, atan2_ulps);
}

SCANSHADE_TARGET_END;

#endif

// The operations that equations use, for float, double and long double. Lanes (num/lanes.hpp),
// Interval and Dual have the same.
#if defined(SCANSHADE_NUM_REAL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_REAL_HPP
#undef SCANSHADE_NUM_REAL_HPP
#else
#define SCANSHADE_NUM_REAL_HPP
#endif

#include "scanshade/num/target.hpp"

SCANSHADE_TARGET_BEGIN;

/// Types of numbers that every equation is a template over: float, double, Lanes, ...
/// `Scalar` is the type of one element, in which uniform quantities are given; `width` elements
/// are computed at once, loaded from and stored to consecutive places; iota is 0, 1, 2, … in them.
template <class R>
struct RealTraits;

template <class F>
struct ScalarTraits {
    using Scalar = F;
    static constexpr std::size_t width = 1;
    static F load(const F* from) { return *from; }
    static void store(F x, F* to) { *to = x; }
    static F iota() { return 0; }
};
template <>
struct RealTraits<float> : ScalarTraits<float> {};
template <>
struct RealTraits<double> : ScalarTraits<double> {};
template <>
struct RealTraits<long double> : ScalarTraits<long double> {};

template <class R>
using Scalar = typename RealTraits<R>::Scalar;

template <class R>
concept Real = requires {
    typename RealTraits<R>::Scalar;
};

template <class R>
concept ScalarReal = std::is_floating_point_v<R>;

// What a comparison gives is the argument `mask`; both branches of a select are evaluated.
template <ScalarReal R>
R select(bool mask, R a, R b) {
    return mask ? a : b;
}
inline bool mask_and(bool a, bool b) { return a && b; }
inline std::uint64_t count_true(bool mask) { return mask ? 1 : 0; }

/// The second argument is returned where the first is not a number.
template <ScalarReal R>
R max(R a, R b) {
    return a > b ? a : b;
}
template <ScalarReal R>
R min(R a, R b) {
    return a < b ? a : b;
}
template <ScalarReal R>
R sqrt(R x) {
    return std::sqrt(x);
}
/// 1/√x for a normal number x > 0. Error ≤ 1.5 u.
template <ScalarReal R>
R inverse_sqrt(R x) {
    return R(1) / std::sqrt(x);
}
/// 1/√x where x is above a normal number `least` ≥ 0, else 0. Error as inverse_sqrt; Lanes ≤ 4 u.
template <Real R>
R inverse_sqrt_above(R x, Scalar<R> least) {
    const auto above = x > R(least);
    return select(above, inverse_sqrt(select(above, x, R(1))), R(0));
}
/// 1/x for x ≥ 0, as a number between 2^-100 and 2^100 where it is exact. Error ≤ 0.5 u; Lanes ≤ 2 u.
template <ScalarReal R>
R reciprocal(R x) {
    return R(1) / x;
}
/// a b + c. Lanes fuse it where the instruction set can: for shading, never for geometry.
template <ScalarReal R>
R mul_add(R a, R b, R c) {
    return a * b + c;
}
template <ScalarReal R>
R abs(R x) {
    return std::abs(x);
}
template <ScalarReal R>
R exp(R x) {
    return std::exp(x);
}
template <ScalarReal R>
R log(R x) {
    return std::log(x);
}
template <ScalarReal R>
R sin(R x) {
    return std::sin(x);
}
template <ScalarReal R>
R cos(R x) {
    return std::cos(x);
}
template <ScalarReal R>
R atan2(R y, R x) {
    return std::atan2(y, x);
}

/// x limited to [low, high].
template <Real R>
R clamp(R x, R low, R high) {
    return min(max(x, low), high);
}

SCANSHADE_TARGET_END;

#endif

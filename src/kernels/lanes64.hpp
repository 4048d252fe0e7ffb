// As many doubles as a vector has floats, as one number: what float would round too early.
#if defined(SCANSHADE_KERNELS_LANES64_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_LANES64_HPP
#undef SCANSHADE_KERNELS_LANES64_HPP
#else
#define SCANSHADE_KERNELS_LANES64_HPP
#endif

#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

/// Two registers, but for the target that has one number in each.
class Lanes64 {
public:
    using Tag = hn::CappedTag<double, (N > 1 ? N / 2 : 1)>;
    using Half = hn::Vec<Tag>;
    struct Mask {
        hn::Mask<Tag> low, high;
    };
    static constexpr bool two = N > 1;

    Lanes64() = default;
    Lanes64(Half l, Half h) : low(l), high(h) {}
    explicit Lanes64(double value) : low(hn::Set(Tag(), value)), high(low) {}
    explicit Lanes64(int value) : Lanes64(double(value)) {}

    Half low, high;
};

#define SCANSHADE_LANES64_BINARY(op, f)                                        \
    SCANSHADE_INLINE Lanes64 operator op(const Lanes64& a, const Lanes64& b) { \
        const auto low = hn::f(a.low, b.low);                                  \
        if constexpr (Lanes64::two) return {low, hn::f(a.high, b.high)};       \
        return {low, low};                                                     \
    }
SCANSHADE_LANES64_BINARY(+, Add)
SCANSHADE_LANES64_BINARY(-, Sub)
SCANSHADE_LANES64_BINARY(*, Mul)
SCANSHADE_LANES64_BINARY(/, Div)
#undef SCANSHADE_LANES64_BINARY

SCANSHADE_INLINE Lanes64::Mask operator>(const Lanes64& a, const Lanes64& b) {
    return {hn::Gt(a.low, b.low), hn::Gt(a.high, b.high)};
}
SCANSHADE_INLINE Lanes64::Mask mask_or(const Lanes64::Mask& a, const Lanes64::Mask& b) {
    return {hn::Or(a.low, b.low), hn::Or(a.high, b.high)};
}
SCANSHADE_INLINE Lanes64 select(const Lanes64::Mask& mask, const Lanes64& a, const Lanes64& b) {
    return {hn::IfThenElse(mask.low, a.low, b.low), hn::IfThenElse(mask.high, a.high, b.high)};
}

template <>
struct RealTraits<Lanes64> {
    using Scalar = double;
    static constexpr std::size_t width = std::size_t(N);
};

/// Of whole numbers or floats, exactly.
template <class V>
SCANSHADE_INLINE Lanes64 widen(V v) {
    constexpr Lanes64::Tag tag;
#if HWY_TARGET == HWY_SCALAR
    return {hn::PromoteTo(tag, v), hn::PromoteTo(tag, v)};
#else
    const hn::Rebind<hn::TFromV<V>, Lanes64::Tag> half;
    return {hn::PromoteTo(tag, hn::LowerHalf(half, v)), hn::PromoteTo(tag, hn::UpperHalf(half, v))};
#endif
}

/// Rounded to nearest.
SCANSHADE_INLINE VecF narrow(const Lanes64& x) {
    const hn::Rebind<float, Lanes64::Tag> half;
#if HWY_TARGET == HWY_SCALAR
    return hn::DemoteTo(half, x.low);
#else
    return hn::Combine(tag_f, hn::DemoteTo(half, x.high), hn::DemoteTo(half, x.low));
#endif
}

SCANSHADE_TARGET_END;

#endif

// A vector of floats as one number, for [S] files: `hwy/highway.h` is included by then.
#if defined(SCANSHADE_NUM_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_LANES_HPP
#undef SCANSHADE_NUM_LANES_HPP
#else
#define SCANSHADE_NUM_LANES_HPP
#endif

#include <hwy/highway.h>
// math-inl.h uses the operations of highway.h
#include <hwy/contrib/math/math-inl.h>

#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

namespace hn = hwy::HWY_NAMESPACE;

/// What a comparison of Lanes gives. A class of ours, so that its operations are found where a
/// template is instantiated.
struct LanesMask {
    hn::Mask<hn::CappedTag<float, 16>> m;
};

/// As many floats as a register of this target has, at most 16. + − × / and sqrt are IEEE's, element
/// by element, and have the bits of float; mul_add, inverse_sqrt_above and reciprocal are what the target
/// does fastest within their bounds.
class Lanes {
public:
    using Tag = hn::CappedTag<float, 16>;
    using Mask = LanesMask;

    Lanes() = default;
    explicit Lanes(hn::Vec<Tag> value) : v(value) {}
    explicit Lanes(double value) : v(hn::Set(Tag(), static_cast<float>(value))) {}
    explicit Lanes(float value) : v(hn::Set(Tag(), value)) {}
    explicit Lanes(int value) : v(hn::Set(Tag(), static_cast<float>(value))) {}

    hn::Vec<Tag> v;
};

inline Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.v, b.v)); }
inline Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.v, b.v)); }
inline Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.v, b.v)); }
inline Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
inline Lanes operator-(Lanes a) { return Lanes(hn::Neg(a.v)); }
inline Lanes::Mask operator>(Lanes a, Lanes b) { return {hn::Gt(a.v, b.v)}; }
inline Lanes::Mask operator<(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }

template <>
struct RealTraits<Lanes> {
    using Scalar = float;
    static constexpr std::size_t width = hn::MaxLanes(Lanes::Tag());
    static Lanes load(const float* from) { return Lanes(hn::LoadU(Lanes::Tag(), from)); }
    static void store(Lanes x, float* to) { hn::StoreU(x.v, Lanes::Tag(), to); }
    static Lanes iota() { return Lanes(hn::Iota(Lanes::Tag(), 0.0f)); }
};

inline Lanes select(Lanes::Mask mask, Lanes a, Lanes b) {
    return Lanes(hn::IfThenElse(mask.m, a.v, b.v));
}
inline Lanes::Mask mask_and(Lanes::Mask a, Lanes::Mask b) { return {hn::And(a.m, b.m)}; }
inline std::uint64_t count_true(Lanes::Mask mask) { return hn::CountTrue(Lanes::Tag(), mask.m); }
// Where one is a NaN, the second, as the scalar twins have it. That is what the instruction of x86 does.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
inline Lanes max(Lanes a, Lanes b) { return Lanes(hn::Max(a.v, b.v)); }
inline Lanes min(Lanes a, Lanes b) { return Lanes(hn::Min(a.v, b.v)); }
#else
inline Lanes max(Lanes a, Lanes b) { return select(a > b, a, b); }
inline Lanes min(Lanes a, Lanes b) { return select(a < b, a, b); }
#endif
inline Lanes sqrt(Lanes x) { return Lanes(hn::Sqrt(x.v)); }
inline Lanes mul_add(Lanes a, Lanes b, Lanes c) { return Lanes(hn::MulAdd(a.v, b.v, c.v)); }
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
// There are no estimates to start from that would be good enough.
inline Lanes inverse_sqrt(Lanes x) { return Lanes(1.0f) / sqrt(x); }
inline Lanes reciprocal(Lanes x) { return Lanes(1.0f) / x; }
#else
// An estimate of 11.4 bits or better, and one step of Newton's method; from 0 that leads to 0.
inline Lanes inverse_sqrt_above(Lanes x, float least) {
    const auto above = (x > Lanes(least)).m;
    const Lanes y(hn::IfThenElseZero(above, hn::ApproximateReciprocalSqrt(x.v)));
    const Lanes half_xy = x * Lanes(0.5f) * y;
    return y * Lanes(hn::NegMulAdd(half_xy.v, y.v, Lanes(1.5f).v));
}
inline Lanes reciprocal(Lanes x) {
    // Outside of this range the estimate is 0 or infinite, and the step would give NaN.
    const Lanes limited = min(max(x, Lanes(0x1p-100f)), Lanes(0x1p100f));
    const Lanes y(hn::ApproximateReciprocal(limited.v));
    return y * Lanes(hn::NegMulAdd(limited.v, y.v, Lanes(2.0f).v));
}
#endif
inline Lanes abs(Lanes x) { return Lanes(hn::Abs(x.v)); }
inline Lanes exp(Lanes x) { return Lanes(hn::Exp(Lanes::Tag(), x.v)); }  // ≤ 1 ulp, as documented
inline Lanes log(Lanes x) { return Lanes(hn::Log(Lanes::Tag(), x.v)); }  // ≤ 4 ulp, as documented

SCANSHADE_TARGET_END;

#endif

// Two vectors of floats as one number, for [S] files: while the one waits for a result, the processor
// works on the other. Each element has the bits that Lanes has.
#if defined(SCANSHADE_NUM_LANES_PAIR_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_LANES_PAIR_HPP
#undef SCANSHADE_NUM_LANES_PAIR_HPP
#else
#define SCANSHADE_NUM_LANES_PAIR_HPP
#endif

#include "scanshade/num/lanes_functions.hpp"

SCANSHADE_TARGET_BEGIN;

struct LanesPairMask {
    LanesMask first, second;
};

/// Twice as many floats as Lanes, with its operations.
class LanesPair {
public:
    using Mask = LanesPairMask;

    LanesPair() = default;
    LanesPair(Lanes a, Lanes b) : first(a), second(b) {}
    explicit LanesPair(double value) : first(value), second(first) {}
    explicit LanesPair(float value) : first(value), second(first) {}
    explicit LanesPair(int value) : first(value), second(first) {}

    Lanes first, second;
};

template <>
struct RealTraits<LanesPair> {
    using Half = RealTraits<Lanes>;
    using Scalar = float;
    static constexpr std::size_t width = 2 * Half::width;
    static LanesPair load(const float* from) {
        return {Half::load(from), Half::load(from + Half::width)};
    }
    static void store(const LanesPair& x, float* to) {
        Half::store(x.first, to);
        Half::store(x.second, to + Half::width);
    }
    static LanesPair iota() { return {Half::iota(), Half::iota() + Lanes(int(Half::width))}; }
};

inline LanesPair operator-(const LanesPair& a) { return {-a.first, -a.second}; }

#define SCANSHADE_PAIR_UNARY(f) \
    inline LanesPair f(const LanesPair& x) { return {f(x.first), f(x.second)}; }
#define SCANSHADE_PAIR_BINARY(f)                                 \
    inline LanesPair f(const LanesPair& a, const LanesPair& b) { \
        return {f(a.first, b.first), f(a.second, b.second)};     \
    }
SCANSHADE_PAIR_BINARY(operator+)
SCANSHADE_PAIR_BINARY(operator-)
SCANSHADE_PAIR_BINARY(operator*)
SCANSHADE_PAIR_BINARY(operator/)
SCANSHADE_PAIR_BINARY(max)
SCANSHADE_PAIR_BINARY(min)
SCANSHADE_PAIR_UNARY(sqrt)
SCANSHADE_PAIR_UNARY(abs)
SCANSHADE_PAIR_UNARY(exp)
SCANSHADE_PAIR_UNARY(log)
SCANSHADE_PAIR_UNARY(log1p)
SCANSHADE_PAIR_BINARY(atan2)
#undef SCANSHADE_PAIR_UNARY
#undef SCANSHADE_PAIR_BINARY

inline LanesPair::Mask operator>(const LanesPair& a, const LanesPair& b) {
    return {a.first > b.first, a.second > b.second};
}
inline LanesPair::Mask operator<(const LanesPair& a, const LanesPair& b) { return b > a; }
inline LanesPair select(const LanesPair::Mask& mask, const LanesPair& a, const LanesPair& b) {
    return {select(mask.first, a.first, b.first), select(mask.second, a.second, b.second)};
}
inline LanesPair::Mask mask_and(const LanesPair::Mask& a, const LanesPair::Mask& b) {
    return {mask_and(a.first, b.first), mask_and(a.second, b.second)};
}
inline std::uint64_t count_true(const LanesPair::Mask& mask) {
    return count_true(mask.first) + count_true(mask.second);
}
inline LanesPair mul_add(const LanesPair& a, const LanesPair& b, const LanesPair& c) {
    return {mul_add(a.first, b.first, c.first), mul_add(a.second, b.second, c.second)};
}
inline LanesPair inverse_sqrt_above(const LanesPair& x, float least) {
    return {inverse_sqrt_above(x.first, least), inverse_sqrt_above(x.second, least)};
}

SCANSHADE_TARGET_END;

#endif

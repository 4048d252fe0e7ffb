// Elementary functions beyond those of num/real.hpp, and constants, for every number type. The
// vector type has its own in num/lanes_functions.hpp, Interval and Dual in their headers.
#if defined(SCANSHADE_NUM_FUNCTIONS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_FUNCTIONS_HPP
#undef SCANSHADE_NUM_FUNCTIONS_HPP
#else
#define SCANSHADE_NUM_FUNCTIONS_HPP
#endif

#include "scanshade/num/real.hpp"

SCANSHADE_TARGET_BEGIN;

template <ScalarReal R>
R asin(R x) {
    return std::asin(x);
}
template <ScalarReal R>
R acos(R x) {
    return std::acos(x);
}
template <ScalarReal R>
R log1p(R x) {
    return std::log1p(x);
}

/// 1/π rounded to the number type. `R(inv_pi)` would leave a double's error in a long double.
template <Real R>
R inv_pi_as() {
    if constexpr (std::is_same_v<R, long double>)
        return 0.318309886183790671537767526745028724L;
    else
        return R(inv_pi);
}

SCANSHADE_TARGET_END;

#endif

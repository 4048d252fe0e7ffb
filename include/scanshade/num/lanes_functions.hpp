// The functions of num/functions.hpp and the angles of num/real.hpp for vectors of floats.
// Error bounds are those that Highway's contrib/math documents.
#if defined(SCANSHADE_NUM_LANES_FUNCTIONS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_NUM_LANES_FUNCTIONS_HPP
#undef SCANSHADE_NUM_LANES_FUNCTIONS_HPP
#else
#define SCANSHADE_NUM_LANES_FUNCTIONS_HPP
#endif

#include "scanshade/num/lanes.hpp"

SCANSHADE_TARGET_BEGIN;

inline Lanes sin(Lanes x) { return Lanes(hn::Sin(Lanes::Tag(), x.v)); }      // ≤ 3 ulp
inline Lanes cos(Lanes x) { return Lanes(hn::Cos(Lanes::Tag(), x.v)); }      // ≤ 3 ulp
inline Lanes asin(Lanes x) { return Lanes(hn::Asin(Lanes::Tag(), x.v)); }    // ≤ 2 ulp
inline Lanes acos(Lanes x) { return Lanes(hn::Acos(Lanes::Tag(), x.v)); }    // ≤ 2 ulp
inline Lanes log1p(Lanes x) { return Lanes(hn::Log1p(Lanes::Tag(), x.v)); }  // ≤ 2 ulp

/// Angle of (x, y) from +x, in [−π, π]; 0 at the origin, and +π on the negative x axis whatever
/// the sign of a zero y. ≤ 6 ulp: Highway's arctangent 3, of a rounded quotient, and a difference.
inline Lanes atan2(Lanes y, Lanes x) {
    const Lanes ax = abs(x), ay = abs(y), longer = max(ax, ay);
    const Lanes quotient = min(ax, ay) / select(longer > Lanes(0), longer, Lanes(1));
    const Lanes octant = Lanes(hn::Atan(Lanes::Tag(), quotient.v));
    const Lanes quadrant = select(ay > ax, Lanes(pi / 2) - octant, octant);
    const Lanes half = select(x < Lanes(0), Lanes(pi) - quadrant, quadrant);
    return select(y < Lanes(0), -half, half);
}

SCANSHADE_TARGET_END;

#endif

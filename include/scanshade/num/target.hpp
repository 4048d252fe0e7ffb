// Per-target compilation of the headers in num/ and eq/.
//
// Those headers are templates over the number type. A vector type differs for each instruction
// set, and the compiler's target pragma is lexical: a template is compiled for AVX2 only where its
// text stands between the pragmas. So a source file that wants vectors (an [S] file) is compiled
// once a target and includes these headers anew each time; every other file includes them once, in
// the inline namespace `host`. A source file is in one of the two modes throughout, and only plain
// pointers and aggregates cross between targets.
//
// Rules for the headers:
//  - the include guard toggles:   #if defined(GUARD) == defined(HWY_TARGET_TOGGLE)
//  - standard headers are included before SCANSHADE_TARGET_BEGIN: between the pragmas their inline
//    functions would be emitted for a newer machine than the one that runs them
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// Inlined whatever the size: between vectors, a call would store and load every register. A build that
/// counts what is reached defines it as no more than `inline`, or each branch would count once a copy.
#ifndef SCANSHADE_INLINE
#define SCANSHADE_INLINE inline __attribute__((always_inline))
#endif

#ifdef SCANSHADE_SIMD
#define SCANSHADE_TARGET_BEGIN \
    HWY_BEFORE_NAMESPACE();    \
    namespace scanshade {      \
    namespace HWY_NAMESPACE {
#define SCANSHADE_TARGET_END \
    }                        \
    }                        \
    HWY_AFTER_NAMESPACE();   \
    static_assert(true)
#else
#define SCANSHADE_TARGET_BEGIN \
    namespace scanshade {      \
    inline namespace host {
#define SCANSHADE_TARGET_END \
    }                        \
    }                        \
    static_assert(true)
#endif

namespace scanshade {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double inv_pi = 0.318309886183790671538;

}  // namespace scanshade

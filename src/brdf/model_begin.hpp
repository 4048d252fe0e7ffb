// Opens a model file: src/brdf/<SCANSHADE_MODEL>.cpp is compiled once for each instruction set by
// Highway's re-inclusion, and this header with it; so it has no include guard.
#define SCANSHADE_SIMD

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "scanshade/brdf/brdf.hpp"

#define SCANSHADE_TEXT(x) SCANSHADE_TEXT_(x)
#define SCANSHADE_TEXT_(x) #x
#undef HWY_TARGET_INCLUDE
// A blank would become part of the file name.
// clang-format off
#define HWY_TARGET_INCLUDE SCANSHADE_TEXT(brdf/SCANSHADE_MODEL.cpp)
// clang-format on
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "brdf/illuminate.hpp"
#include "scanshade/eq/fresnel.hpp"
#include "scanshade/eq/microfacet.hpp"
#include "scanshade/num/dual.hpp"
#include "scanshade/num/interval.hpp"
#include "scanshade/num/lanes_pair.hpp"

SCANSHADE_TARGET_BEGIN;

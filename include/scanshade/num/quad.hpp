// IEEE's binary128 and the functions of glibc that take it. Some compilers know the type but not
// the declarations of the C library; where both do, these only repeat them.
#pragma once

#include <cmath>

namespace scanshade {

#ifdef __SIZEOF_FLOAT128__
using Quad = __float128;
#else
using Quad = long double;  // machines whose long double is binary128
#endif

}  // namespace scanshade

extern "C" {
scanshade::Quad fabsf128(scanshade::Quad) noexcept;
scanshade::Quad sqrtf128(scanshade::Quad) noexcept;
scanshade::Quad expf128(scanshade::Quad) noexcept;
scanshade::Quad logf128(scanshade::Quad) noexcept;
scanshade::Quad log1pf128(scanshade::Quad) noexcept;
scanshade::Quad powf128(scanshade::Quad, scanshade::Quad) noexcept;
scanshade::Quad sinf128(scanshade::Quad) noexcept;
scanshade::Quad cosf128(scanshade::Quad) noexcept;
scanshade::Quad asinf128(scanshade::Quad) noexcept;
scanshade::Quad acosf128(scanshade::Quad) noexcept;
scanshade::Quad atan2f128(scanshade::Quad, scanshade::Quad) noexcept;
}

// Colours of two renderers of different number types: within a level of 255.
#pragma once

#include <string>

#include "support/pictures.hpp"

namespace scanshade {

/// Pixels that were compared, and those among them that differ by more than a level for a reason.
struct LevelCounts {
    std::uint64_t pixels = 0;
    std::uint64_t exempt =
        0;  // a quantity that light branches on is within its error of the threshold
    std::uint64_t uncertain = 0;  // light changes by that much when the point moves by its error
};

/// The first pixel whose bytes differ by more than one level without a reason; "" if there is none.
std::string level_difference(const Scene& scene, const Settings& settings, const Framebuffer& drawn,
                             const Framebuffer& expected, LevelCounts& counts);

/// How the vector renderer's picture differs from that of a scalar renderer: in depth or id at all, or
/// in colour by more than a level without a reason. "" if it does not. Leaves the picture in `drawn`.
std::string scalar_difference(const Scene& scene, const Settings& settings, RendererKind scalar,
                              Drawn& drawn, LevelCounts& counts);

}  // namespace scanshade

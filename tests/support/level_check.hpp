// Colours of two renderers of different number types: within a level of 255.
#pragma once

#include <string>

#include "support/pictures.hpp"

namespace scanshade {

/// Pixels that were compared, and those among them that differ by more than a level because a
/// quantity that light branches on is within its error of the threshold.
struct LevelCounts {
    std::uint64_t pixels = 0;
    std::uint64_t exempt = 0;
};

/// The first pixel whose bytes differ by more than one level without a reason; "" if there is none.
std::string level_difference(const Scene& scene, const Settings& settings, const Framebuffer& drawn,
                             const Framebuffer& expected, LevelCounts& counts);

/// How the vector renderer's picture differs from that of a scalar renderer: in depth or id at all, or
/// in colour by more than a level without a reason. "" if it does not. Leaves the picture in `drawn`.
std::string scalar_difference(const Scene& scene, const Settings& settings, RendererKind scalar,
                              Drawn& drawn, LevelCounts& counts);

}  // namespace scanshade

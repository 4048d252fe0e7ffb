// Coverage by its definition, in exact integers: what the walker is compared with.
#pragma once

#include <span>

#include "render/walk.hpp"

namespace scanshade {

/// How often a polygon winds around a sample, clockwise on the picture, where the sample is moved
/// up and left by less than anything (the top-left rule).
inline int winding_number(std::span<const SnappedPoint> polygon, SnappedPoint p) {
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const SnappedPoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const __int128 cross =
            __int128(b.x - a.x) * (p.y - a.y) - __int128(b.y - a.y) * (p.x - a.x);
        const bool down = a.y <= p.y;
        // Left of p or through it: counted.
        if (down ? cross <= 0 : cross >= 0) winding += down ? -1 : 1;
    }
    return winding;
}

}  // namespace scanshade

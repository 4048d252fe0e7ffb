// Whether two rivals show the same picture.
#pragma once

#include <cstddef>
#include <string>

#include "bench/rival.hpp"

namespace scanshade::bench {

/// Rivals snap vertices differently, so a pixel near an edge may belong to the next triangle.
/// Colours are compared at covered pixels where both show the same triangles in the 3 × 3 pixels
/// around; a background pixel of both counts as the same triangle.
struct Agreement {
    std::size_t covered = 0;     // pixels where either shows a triangle
    std::size_t same_id = 0;     // of these, where both show the same
    std::size_t compared = 0;    // of these, with equal surroundings
    std::size_t within = 0;      // of these, where no byte differs by more than 1
    std::size_t near = 0;        // the same with 4: a wrong highlight is few pixels, far off
    std::size_t background = 0;  // pixels that differ by more than 1 where neither shows any
    int worst = 0;               // largest difference among the compared

    bool good() const;
    std::string sentence() const;  // by how much
};

Agreement compare(const Picture& a, const Picture& b, int width);

}  // namespace scanshade::bench

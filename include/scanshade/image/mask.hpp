// Some pixels of a picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace scanshade {

/// 1 for each pixel that is meant, 0 for the others, [y·width + x].
struct Mask {
    int width = 0, height = 0;
    std::vector<std::uint8_t> inside;

    Mask() = default;
    Mask(int w, int h) : width(w), height(h), inside(std::size_t(w) * std::size_t(h)) {}
    std::size_t count() const {
        return std::accumulate(inside.begin(), inside.end(), std::size_t{0});
    }
};

}  // namespace scanshade

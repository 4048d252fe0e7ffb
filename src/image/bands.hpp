// Maps of large pictures, made in bands of rows so that what is needed in between stays small.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scanshade {

/// make(begin, end) gives rows begin to end − 1 of a map, as if the picture had no others. Where a
/// value depends on `reach` rows above and below at most, the result is that of the whole picture.
template <class Make>
std::vector<float> map_by_bands(int width, int height, int reach, Make&& make) {
    constexpr int band = 256;  // rows
    const auto at = [width](int row) { return std::ptrdiff_t(row) * width; };
    std::vector<float> map(std::size_t(at(height)));
    for (int y = 0; y < height; y += band) {
        const int end = std::min(y + band, height);
        const int first = std::max(y - reach, 0), last = std::min(end + reach, height);
        const std::vector<float> part = make(first, last);
        std::copy_n(part.begin() + at(y - first), at(end - y), map.begin() + at(y));
    }
    return map;
}

/// Rows begin to end − 1 of a plane.
inline std::vector<float> rows_of(const std::vector<float>& plane, int width, int begin, int end) {
    return {plane.begin() + std::ptrdiff_t(begin) * width,
            plane.begin() + std::ptrdiff_t(end) * width};
}

}  // namespace scanshade

// Pictures in bytes, and the difference between two of them.
#pragma once

#include <cstdint>
#include <vector>

namespace scanshade {

inline constexpr int max_image_side =
    16384;  // pixels; larger is refused before anything is allocated

/// 8-bit RGB, rows from the top, no padding.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // [3·(y·width + x) + channel]

    Image() = default;
    Image(int w, int h) : width(w), height(h), rgb(3 * std::size_t(w) * std::size_t(h)) {}
    std::uint8_t* pixel(int x, int y) {
        return &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    }
    const std::uint8_t* pixel(int x, int y) const { return const_cast<Image*>(this)->pixel(x, y); }
};

/// What `scanshade compare` and the golden tests say about two pictures of the same size.
struct ImageDiff {
    int max_delta = 0;        // largest difference of one byte
    std::uint64_t count = 0;  // pixels that differ in any channel
    Image picture;            // |a − b|, stretched so that the largest difference is 255
};

/// Throws Error(format) where the sizes differ.
ImageDiff diff(const Image& a, const Image& b);

/// IEC 61966-2-1; both map [0, 1] to [0, 1].
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace scanshade

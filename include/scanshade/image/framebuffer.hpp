// What a renderer draws into.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "scanshade/base/memory.hpp"
#include "scanshade/image/image.hpp"
#include "scanshade/scene/settings.hpp"

namespace scanshade {

/// Planes of width · height values, rows from the top.
struct Framebuffer {
    static constexpr std::uint32_t no_triangle = 0xffffffffu;

    int width = 0, height = 0;
    std::vector<float> r, g, b;     // linear radiance, before exposure
    std::vector<float> depth;       // near/w, in (0, 1]; 0: nothing there
    std::vector<std::uint32_t> id;  // triangle, counted through all objects; no_triangle: none

    Framebuffer() = default;
    Framebuffer(int w, int h);
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }
};

/// A picture as windows take it: bytes r, g, b, 255 in this order in memory, rows from the top.
struct PixelBuffer {
    static constexpr int block_side = 16;

    int width = 0, height = 0;

    PixelBuffer() = default;
    PixelBuffer(int w, int h)
        : width(w), height(h), rgba_(std::size_t(w) * std::size_t(h)), blank_(block_count()) {}

    int block_columns() const { return (width + block_side - 1) / block_side; }
    std::size_t block_count() const {
        const int rows = (height + block_side - 1) / block_side;
        return std::size_t(block_columns()) * std::size_t(rows);
    }

    const LargeVector<std::uint32_t>& rgba() const { return rgba_; }  // [y·width + x]
    /// To be written to until the next draw: nothing is known of the pixels any more.
    LargeVector<std::uint32_t>& edit() {
        std::fill(blank_.begin(), blank_.end(), std::uint8_t{0});
        return rgba_;
    }

    /// For renderers: the pixels, and for each block of block_side² of them, rows from the top,
    /// whether it shows the background and nothing else. Who draws keeps that true.
    struct Blanks {
        std::uint32_t* rgba;
        std::uint8_t* blank;
    };
    Blanks draw_over(std::uint32_t background) {
        if (background != background_) edit();
        background_ = background;
        return {rgba_.data(), blank_.data()};
    }

private:
    LargeVector<std::uint32_t> rgba_;
    std::vector<std::uint8_t> blank_;
    std::uint32_t background_ = 0;
};

Image to_image(const PixelBuffer& pixels);

/// Element b is the smallest value of [0, 1] that the sRGB curve, in double, rounds to byte b; the
/// last one, of no byte, is infinite.
const std::array<float, 257>& srgb_byte_starts();

/// Radiance to bytes, once: exposure, clamp to [0, 1], transfer curve, round to nearest. In float:
/// every renderer that writes bytes at once has the same ones.
Image encode(const Framebuffer& frame, Transfer transfer, double exposure_ev);
void encode(const Framebuffer& frame, Transfer transfer, double exposure_ev, PixelBuffer& into);

}  // namespace scanshade

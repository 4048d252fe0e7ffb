// What a renderer draws into.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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
    int width = 0, height = 0;
    std::vector<std::uint32_t> rgba;  // [y·width + x]

    PixelBuffer() = default;
    PixelBuffer(int w, int h) : width(w), height(h), rgba(std::size_t(w) * std::size_t(h)) {}
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

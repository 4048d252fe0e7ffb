// What a renderer draws into.
#pragma once

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

/// Radiance to bytes, once: exposure, clamp to [0, 1], transfer curve, round to nearest.
Image encode(const Framebuffer& frame, Transfer transfer, double exposure_ev);

}  // namespace scanshade

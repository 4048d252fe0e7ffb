// Whether two pictures are the same to the bit.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <string>

#include "scanshade/image/framebuffer.hpp"

namespace scanshade {

/// "" where depth and id of every sample are equal to the bit; else the first difference.
inline std::string visibility_difference(const Framebuffer& a, const Framebuffer& b) {
    if (a.width != b.width || a.height != b.height) return "the sizes differ";
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        const auto bits = [i](const Framebuffer& f) {
            return std::bit_cast<std::uint32_t>(f.depth[i]);
        };
        if (a.id[i] != b.id[i] || bits(a) != bits(b))
            return fmt::format("at ({}, {}) id {} depth {:.9g}, against id {} depth {:.9g}",
                               int(i) % a.width, int(i) / a.width, int(a.id[i]), a.depth[i],
                               int(b.id[i]), b.depth[i]);
    }
    return "";
}

/// The same, of colour as well.
inline std::string difference(const Framebuffer& a, const Framebuffer& b) {
    const std::string visible = visibility_difference(a, b);
    if (!visible.empty()) return visible;
    for (const auto plane : {&Framebuffer::r, &Framebuffer::g, &Framebuffer::b})
        for (std::size_t i = 0; i < a.id.size(); ++i) {
            const float x = (a.*plane)[i], y = (b.*plane)[i];
            if (std::bit_cast<std::uint32_t>(x) != std::bit_cast<std::uint32_t>(y))
                return fmt::format("at ({}, {}) id {} radiance {:.9g}, against {:.9g}",
                                   int(i) % a.width, int(i) / a.width, int(a.id[i]), x, y);
        }
    return "";
}

}  // namespace scanshade

// The background of a picture, which often is there already: block by block, PixelBuffer says where.
#pragma once

#include "kernels/surface.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/render/plan_rows.hpp"

namespace scanshade {

static_assert(subtile_side == PixelBuffer::block_side);

/// The flag of the subtile at (x, y); null where nobody keeps any.
inline std::uint8_t* blank_flag(const PictureView& picture, int x, int y) {
    if (picture.blank == nullptr) return nullptr;
    const int columns = (picture.width + subtile_side - 1) / subtile_side;
    return picture.blank + (y / subtile_side) * columns + x / subtile_side;
}

/// The subtile at (x, y) is going to show something else.
inline void cover(const PictureView& picture, int x, int y) {
    if (std::uint8_t* blank = blank_flag(picture, x, y)) *blank = 0;
}

/// Writes the background into the subtiles of [x, x + side)², cut to the picture, but for those that
/// show it; says how many these were, of all.
PlanSaving draw_background(const PictureView& picture, int x, int y, int side);

}  // namespace scanshade

#include "render/background.hpp"

#include <algorithm>

namespace scanshade {
namespace {

/// Calls visit(x, y, flag) for each subtile of the square that is in the picture.
template <class Visit>
void each_subtile(const PictureView& picture, int x, int y, int side, Visit&& visit) {
    for (int sy = y; sy < std::min(y + side, picture.height); sy += subtile_side)
        for (int sx = x; sx < std::min(x + side, picture.width); sx += subtile_side)
            visit(sx, sy, *blank_flag(picture, sx, sy));
}

}  // namespace

PlanSaving draw_background(const PictureView& picture, int x, int y, int side) {
    if (picture.blank == nullptr) {
        write_background(picture, x, y, side, side);
        return {};
    }
    PlanSaving blank;
    each_subtile(picture, x, y, side, [&](int, int, std::uint8_t flag) {
        ++blank.of;
        blank.saved += flag;
    });
    if (blank.saved == blank.of) return blank;
    // Whole rows of a square are written faster than its subtiles.
    if (blank.saved == 0) write_background(picture, x, y, side, side);
    each_subtile(picture, x, y, side, [&](int sx, int sy, std::uint8_t& flag) {
        if (blank.saved > 0 && flag == 0)
            write_background(picture, sx, sy, subtile_side, subtile_side);
        flag = 1;
    });
    return blank;
}

}  // namespace scanshade

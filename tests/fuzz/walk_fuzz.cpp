// Which samples a polygon covers: the scanline walker against the definition in exact integers.
#include <vector>

#include "fuzz/fuzz.hpp"
#include "render/walk.hpp"
#include "support/random.hpp"
#include "support/winding.hpp"

using namespace scanshade;

namespace {

/// A coordinate within the guard band: on the picture, on its samples, or far away.
std::int32_t coordinate(Rng& rng, int side) {
    constexpr std::int32_t end = (1 << 24) - 1;
    switch (rng.integer(0, 3)) {
        case 0:
            return std::int32_t(rng.integer(-subpixels, (side + 1) * subpixels));
        case 1:
            return std::int32_t(rng.integer(-2, 2 * side + 2)) * (subpixels / 2);
        case 2:
            return std::int32_t(rng.integer(-end, end));
        default:
            return rng.chance(0.5) ? end : -end;
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int side = 12;
    Rng rng(std::span(data, size));
    std::vector<SnappedPoint> polygon(std::size_t(rng.integer(3, 9)));
    for (SnappedPoint& p : polygon) p.x = coordinate(rng, side), p.y = coordinate(rng, side);
    const SampleOffset sample{std::int32_t(rng.integer(0, subpixels - 1)),
                              std::int32_t(rng.integer(0, subpixels - 1))};
    const std::int64_t area = twice_area(polygon);
    if (area == 0) return 0;
    int count[side][side] = {};
    PolygonWalker().walk(polygon, area > 0, sample, side, side, [&](int y, int begin, int end) {
        if (y < 0 || y >= side || begin < 0 || end > side) broken("spans lie in the picture");
        for (int x = begin; x < end; ++x) ++count[y][x];
    });
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const SnappedPoint p{x * subpixels + sample.x, y * subpixels + sample.y};
            const int winding = winding_number(polygon, p);
            if (count[y][x] != ((area > 0 ? winding : -winding) > 0))
                broken("a sample is covered as exact arithmetic says");
        }
    return 0;
}

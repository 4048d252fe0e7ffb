#include "bench/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "scanshade/base/error.hpp"

namespace scanshade::bench {
namespace {

// Shares that must be reached.
constexpr double least_same_id = 0.95;  // another camera or mesh would be far below
constexpr double least_compared = 0.5;  // else the next number says nothing
constexpr double least_within = 0.998;
constexpr double least_near = 0.9999;  // (C7) jumps where cosθ_i = 0, so a few may be anything

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 1 : double(part) / double(whole);
}

int largest_difference(std::uint32_t a, std::uint32_t b) {
    int largest = 0;
    for (int shift = 0; shift < 24; shift += 8)
        largest = std::max(largest, std::abs(int(a >> shift & 255) - int(b >> shift & 255)));
    return largest;
}

}  // namespace

bool Agreement::good() const {
    return share(same_id, covered) >= least_same_id && share(compared, covered) >= least_compared &&
           share(within, compared) >= least_within && share(near, compared) >= least_near &&
           background == 0;
}

std::string Agreement::sentence() const {
    return fmt::format(
        "{:.3f} % of {} covered pixels show the same triangle; of {} away from differing edges "
        "{:.4f} % are within 1 level and {:.4f} % within 4, the worst differs by {}; {} background "
        "pixels differ",
        100 * share(same_id, covered), covered, compared, 100 * share(within, compared),
        100 * share(near, compared), worst, background);
}

Agreement compare(const Picture& a, const Picture& b, int width) {
    SCANSHADE_CHECK(a.id.size() == b.id.size() && a.rgba.size() == b.rgba.size());
    const int height = int(a.id.size()) / width;
    const auto same = [&](int x, int y) {
        const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
        return a.id[i] == b.id[i];
    };
    const auto same_around = [&](int x, int y) {
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                if (!same(u, v)) return false;
        return true;
    };
    Agreement out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            const int difference = largest_difference(a.rgba[i], b.rgba[i]);
            if (a.id[i] == Picture::no_triangle && b.id[i] == Picture::no_triangle) {
                out.background += difference > 1;
                continue;
            }
            ++out.covered;
            if (!same(x, y)) continue;
            ++out.same_id;
            if (!same_around(x, y)) continue;
            ++out.compared;
            out.within += difference <= 1;
            out.near += difference <= 4;
            out.worst = std::max(out.worst, difference);
        }
    return out;
}

}  // namespace scanshade::bench

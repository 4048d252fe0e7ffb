// Where pictures show surfaces, and where those end.
#include <algorithm>
#include <cmath>

#include "image/same_size.hpp"
#include "scanshade/image/metrics.hpp"

namespace scanshade {
namespace {

bool is_covered(const Framebuffer& frame, std::size_t i) {
    return frame.id[i] != Framebuffer::no_triangle;
}

/// Depths of pixels in a row or a column: at(k) is the one k steps from the first of a pair.
class Line {
public:
    Line(const Framebuffer& frame, std::size_t first, std::ptrdiff_t step, int before, int after)
        : frame_(frame), first_(first), step_(step), before_(before), after_(after) {}

    bool covered(int k) const {
        return -k <= before_ && k <= after_ && is_covered(frame_, index(k));
    }
    double depth(int k) const { return double(frame_.depth[index(k)]); }

    /// Depth at `to`, as the surface at its neighbour `from` would have it.
    double continued(int from, int to) const {
        const int behind = from + (from - to);
        return covered(behind) ? 2 * depth(from) - depth(behind) : depth(from);
    }

private:
    std::size_t index(int k) const { return std::size_t(std::ptrdiff_t(first_) + k * step_); }
    const Framebuffer& frame_;
    std::size_t first_;
    std::ptrdiff_t step_;
    int before_, after_;  // pixels there are on either side of the first
};

/// Between the first pixel of the pair and the second.
bool is_edge(const Line& line) {
    if (line.covered(0) != line.covered(1)) return true;
    if (!line.covered(0)) return false;
    constexpr double jump = 0.01;  // of the depth
    const auto misses = [&](int from, int to) {
        return std::abs(line.continued(from, to) - line.depth(to)) > jump * line.depth(to);
    };
    return misses(0, 1) && misses(1, 0);
}

/// Marks the pixels on either side of an edge.
void mark_edges(const Framebuffer& frame, Mask& mask) {
    const int w = frame.width, h = frame.height;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const std::size_t i = frame.index(x, y);
            if (x + 1 < w && is_edge(Line(frame, i, 1, x, w - 1 - x)))
                mask.inside[i] = mask.inside[i + 1] = 1;
            if (y + 1 < h && is_edge(Line(frame, i, w, y, h - 1 - y)))
                mask.inside[i] = mask.inside[i + std::size_t(w)] = 1;
        }
}

/// With the pixels around, also diagonally.
Mask widened(const Mask& mask) {
    Mask result(mask.width, mask.height);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            if (!mask.inside[std::size_t(y) * std::size_t(mask.width) + std::size_t(x)]) continue;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, mask.height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, mask.width - 1); ++u)
                    result.inside[std::size_t(v) * std::size_t(mask.width) + std::size_t(u)] = 1;
        }
    return result;
}

}  // namespace

Regions regions_of(const Framebuffer& a, const Framebuffer& b) {
    check_same_size(a, b);
    Mask edges(a.width, a.height);
    mark_edges(a, edges);
    mark_edges(b, edges);
    const Mask near = widened(edges);

    Regions regions{Mask(a.width, a.height), Mask(a.width, a.height), Mask(a.width, a.height)};
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        const bool both = is_covered(a, i) && is_covered(b, i);
        const bool either = is_covered(a, i) || is_covered(b, i);
        const bool interior = both && !near.inside[i];
        regions.covered.inside[i] = both;
        regions.interior.inside[i] = interior;
        regions.silhouette.inside[i] = !interior && (either || near.inside[i]);
    }
    return regions;
}

}  // namespace scanshade

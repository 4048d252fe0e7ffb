#include "support/level_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "support/lit_points.hpp"
#include "support/same_picture.hpp"

namespace scanshade {
namespace {

bool within_a_level(const Image& a, const Image& b, std::size_t pixel) {
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        if (std::abs(a.rgb[i] - b.rgb[i]) > 1) return false;
    return true;
}

bool at_threshold(LitPoints64& points, int x, int y) {
    const std::vector<LitPoint> here = points.at(x, y);
    return std::any_of(here.begin(), here.end(),
                       [&](const LitPoint& p) { return points.near_threshold(p); });
}

}  // namespace

std::string level_difference(const Scene& scene, const Settings& settings, const Framebuffer& drawn,
                             const Framebuffer& expected, LevelCounts& counts) {
    const auto bytes = [&](const Framebuffer& frame) {
        return encode(frame, settings.transfer, settings.exposure_ev);
    };
    const Image a = bytes(drawn), b = bytes(expected);
    std::unique_ptr<LitPoints64> points;  // made where it is needed
    counts.pixels += drawn.id.size();
    for (std::size_t i = 0; i < drawn.id.size(); ++i) {
        if (within_a_level(a, b, i)) continue;
        if (!points) points = std::make_unique<LitPoints64>(scene, settings);
        const int x = int(i) % drawn.width, y = int(i) / drawn.width;
        if (!at_threshold(*points, x, y))
            return fmt::format(
                "at ({}, {}) id {} radiance ({:.7g}, {:.7g}, {:.7g}), against ({:.7g}, {:.7g}, "
                "{:.7g})",
                x, y, int(drawn.id[i]), drawn.r[i], drawn.g[i], drawn.b[i], expected.r[i],
                expected.g[i], expected.b[i]);
        ++counts.exempt;
    }
    return "";
}

std::string scalar_difference(const Scene& scene, const Settings& settings, RendererKind scalar,
                              Drawn& drawn, LevelCounts& counts) {
    drawn = draw(scene, settings);
    Settings plain = settings;
    plain.renderer = scalar;
    const Framebuffer expected = draw(scene, plain).frame;
    const std::string visible = visibility_difference(drawn.frame, expected);
    if (!visible.empty()) return "visibility: " + visible;
    return level_difference(scene, settings, drawn.frame, expected, counts);
}

}  // namespace scanshade

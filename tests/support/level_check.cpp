#include "support/level_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "support/lit_points.hpp"
#include "support/same_picture.hpp"

namespace scanshade {
namespace {

/// The bytes of one pixel after its radiance has changed by `change`.
std::array<int, 3> bytes_at(const Framebuffer& frame, std::size_t i, const Settings& settings,
                            double change) {
    Framebuffer pixel(1, 1);
    pixel.r[0] = float(double(frame.r[i]) + change);
    pixel.g[0] = float(double(frame.g[i]) + change);
    pixel.b[0] = float(double(frame.b[i]) + change);
    const Image image = encode(pixel, settings.transfer, settings.exposure_ev);
    return {image.rgb[0], image.rgb[1], image.rgb[2]};
}

class LevelCheck {
public:
    LevelCheck(const Scene& scene, const Settings& settings, const Framebuffer& drawn,
               const Framebuffer& expected)
        : scene_(scene), settings_(settings), drawn_(drawn), expected_(expected) {}

    std::string run(LevelCounts& counts) {
        counts.pixels += drawn_.id.size();
        for (std::size_t i = 0; i < drawn_.id.size(); ++i) {
            if (within(i, 0)) continue;
            if (!points_) points_ = std::make_unique<LitPoints64>(scene_, settings_);
            const int x = int(i) % drawn_.width, y = int(i) / drawn_.width;
            const std::vector<LitPoint> points = points_->at(x, y);
            if (std::any_of(points.begin(), points.end(),
                            [&](const LitPoint& p) { return points_->near_threshold(p); })) {
                ++counts.exempt;
                continue;
            }
            double change = 0;
            for (const LitPoint& p : points) change = std::max(change, points_->uncertainty(p));
            if (!within(i, 2 * change)) return text(i, change);
            ++counts.uncertain;
        }
        return "";
    }

private:
    bool within(std::size_t i, double change) const {
        const auto drawn = bytes_at(drawn_, i, settings_, 0);
        const auto low = bytes_at(expected_, i, settings_, -change);
        const auto high = bytes_at(expected_, i, settings_, change);
        for (std::size_t c = 0; c < 3; ++c)
            if (drawn[c] < low[c] - 1 || drawn[c] > high[c] + 1) return false;
        return true;
    }

    std::string text(std::size_t i, double change) const {
        return fmt::format(
            "at ({}, {}) id {} radiance ({:.7g}, {:.7g}, {:.7g}), against ({:.7g}, {:.7g}, "
            "{:.7g}); "
            "the points' errors explain {:.3g}",
            int(i) % drawn_.width, int(i) / drawn_.width, int(drawn_.id[i]), drawn_.r[i],
            drawn_.g[i], drawn_.b[i], expected_.r[i], expected_.g[i], expected_.b[i], change);
    }

    const Scene& scene_;
    const Settings& settings_;
    const Framebuffer &drawn_, &expected_;
    std::unique_ptr<LitPoints64> points_;
};

}  // namespace

std::string level_difference(const Scene& scene, const Settings& settings, const Framebuffer& drawn,
                             const Framebuffer& expected, LevelCounts& counts) {
    return LevelCheck(scene, settings, drawn, expected).run(counts);
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

// Pictures of how a picture came about.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/image/framebuffer.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

enum class DebugView : std::uint8_t {
    none,  // the picture itself
    depth,
    normals,
    barycentrics,
    triangles,
    overdraw,
    plan,
    error_f64,
    error_phong,
};

struct DebugViewInfo {
    std::string_view name;
    std::string_view meaning;
};

/// In the order of the enum.
std::span<const DebugViewInfo> all_debug_views();

using Rgb8 = std::array<std::uint8_t, 3>;

/// What false colours mean: `low` is false_colour(0), `high` is false_colour(1).
struct DebugScale {
    double low, high;
    bool logarithmic;
    std::string unit;
};

struct DebugLegend {
    Rgb8 colour;
    std::string meaning;
};

struct DebugPicture {
    PixelBuffer pixels;
    std::optional<DebugScale> scale;
    std::vector<DebugLegend> legend;
};

/// From dark blue (0) over green to red (1).
Rgb8 false_colour(double t);

/// One sample a pixel. For DebugView::none the picture without a scale. Throws what Renderer throws.
DebugPicture draw_debug_view(const Scene& scene, const Settings& settings, DebugView view);

/// Darkens the pixels where another face begins: the visible edges of the polygons as they stand in
/// the file. `frame` has the ids, `pixels` the picture of the same size.
void draw_wireframe(const Scene& scene, const Framebuffer& frame, PixelBuffer& pixels);

}  // namespace scanshade

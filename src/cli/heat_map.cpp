#include "cli/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/lettering.hpp"
#include "scanshade/image/heat.hpp"

namespace scanshade {
namespace {

constexpr Rgb8 paper{24, 26, 30}, ink{225, 228, 232};
constexpr int gap = 8;          // pixels
constexpr int bar_height = 12;  // of the scale

/// Scale and words, on a strip of their own.
void draw_scale(Image& image, int y, const std::string& title, const std::string& top) {
    fill_rectangle(image, 0, y, image.width, image.height - y, paper);
    const int length = image.width - 2 * gap;
    for (int x = 0; x < length; ++x) {
        Rgb8 colour;
        put_heat(double(x) / std::max(length - 1, 1), colour.data());
        fill_rectangle(image, gap + x, y + gap, 1, bar_height, colour);
    }
    const int line = y + 2 * gap + bar_height;
    draw_lettering(image, gap, line, "0", ink);
    draw_lettering(image, (image.width - lettering_width(title)) / 2, line, title, ink);
    draw_lettering(image, image.width - gap - lettering_width(top), line, top, ink);
}

}  // namespace

Image heat_map(const Metric& metric, const Comparison& pair) {
    const Comparison::Plane errors = error_map(metric, pair);
    float largest = 0;
    for (float error : errors)
        if (std::isfinite(error)) largest = std::max(largest, error);

    const std::string title(metric.symbol), top = fmt::format("{:.3g}", largest);
    const int words = lettering_width("0") + lettering_width(title) + lettering_width(top);
    const int width = std::max(pair.width(), words + 4 * gap);
    Image image(width, pair.height() + 3 * gap + bar_height + letter_height);
    fill_rectangle(image, 0, 0, image.width, image.height, paper);
    const Image map = heat_picture(errors, pair.width(), pair.height(), double(largest));
    for (int y = 0; y < map.height; ++y)
        std::copy_n(map.pixel(0, y), 3 * map.width, image.pixel(0, y));
    draw_scale(image, pair.height(), title, top);
    return image;
}

}  // namespace scanshade

// The colours are a cube helix: Green 2011, "A colour scheme for the display of astronomical
// intensity images", with the paper's start 0.5, −1.5 turns, hue 1 and gamma 1. The way from black
// to white winds around the greys, and never gets darker.
#include "scanshade/image/heat.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scanshade/base/error.hpp"

namespace scanshade {

void put_heat(double t, std::uint8_t* rgb) {
    if (std::isnan(t)) {
        rgb[0] = rgb[2] = 255, rgb[1] = 0;
        return;
    }
    const double grey = std::clamp(t, 0.0, 1.0);
    const double angle = 2 * std::numbers::pi * (0.5 / 3 + 1 - 1.5 * grey);
    const double amplitude = grey * (1 - grey) / 2;
    constexpr double deviation[3][2] = {{-0.14861, 1.78277}, {-0.29227, -0.90649}, {1.97294, 0}};
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = grey + amplitude * (deviation[c][0] * std::cos(angle) +
                                                 deviation[c][1] * std::sin(angle));
        rgb[c] = std::uint8_t(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    }
}

Image heat_picture(std::span<const float> values, int width, int height, double top) {
    Image image(width, height);
    SCANSHADE_CHECK(3 * values.size() == image.rgb.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = double(values[i]);
        put_heat(top > 0 ? value / top : value, &image.rgb[3 * i]);
    }
    return image;
}

}  // namespace scanshade

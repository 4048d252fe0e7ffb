// False colours.
#include "scanshade/image/heat.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/catch.hpp"

using namespace scanshade;

namespace {

std::array<std::uint8_t, 3> heat(double t) {
    std::array<std::uint8_t, 3> rgb{};
    put_heat(t, rgb.data());
    return rgb;
}

}  // namespace

TEST_CASE("heat goes from black to white and never gets darker", "[metrics]") {
    CHECK(heat(0) == std::array<std::uint8_t, 3>{0, 0, 0});
    CHECK(heat(1) == std::array<std::uint8_t, 3>{255, 255, 255});
    CHECK(heat(-3) == heat(0));
    CHECK(heat(7) == heat(1));
    // The paper's middle: at half the grey, red is 0.5 + 0.125 (−0.14861 cos φ + 1.78277 sin φ) with
    // φ = 2π (0.5/3 + 1 − 0.75) = 5π/6.
    CHECK(int(heat(0.5)[0]) ==
          std::lround(255 * (0.5 + 0.125 * (0.14861 * std::sqrt(0.75) + 1.78277 * 0.5))));
    double before = -1;
    for (int i = 0; i <= 100; ++i) {
        const auto c = heat(i / 100.0);
        // Perceived brightness, by which the colours are laid out (ITU-R BT.601).
        const double brightness = 0.30 * c[0] + 0.59 * c[1] + 0.11 * c[2];
        CHECK(brightness > before - 1);
        before = brightness;
    }
    CHECK(heat(std::numeric_limits<double>::quiet_NaN()) ==
          std::array<std::uint8_t, 3>{255, 0, 255});
}

TEST_CASE("a heat picture has its largest value white", "[metrics]") {
    const std::vector<float> values{0, 1, 2, 4};
    const Image image = heat_picture(values, 2, 2, 4);
    CHECK(int(image.pixel(0, 0)[0]) == 0);
    CHECK(int(image.pixel(1, 1)[1]) == 255);
    const auto half = heat(0.5);
    CHECK(std::equal(half.begin(), half.end(), image.pixel(0, 1)));
    const Image none = heat_picture(std::vector<float>(4, 0.0f), 2, 2, 0);
    CHECK(none.rgb == std::vector<std::uint8_t>(12, 0));
}

#include "scanshade/image/image.hpp"

#include <cmath>

#include "scanshade/base/error.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

Image picture(int width, int height, std::initializer_list<int> grey) {
    Image image(width, height);
    std::size_t i = 0;
    for (const int g : grey)
        for (int k = 0; k < 3; ++k) image.rgb[i++] = std::uint8_t(g);
    return image;
}

}  // namespace

TEST_CASE("the difference of pictures counts pixels and is stretched", "[image]") {
    Image a = picture(3, 1, {10, 20, 30}), b = a;
    CHECK(diff(a, b).max_delta == 0);
    CHECK(diff(a, b).count == 0);
    CHECK(diff(a, b).picture.rgb == std::vector<std::uint8_t>(9, 0));
    b.pixel(1, 0)[0] = 24;
    b.pixel(1, 0)[2] = 19;
    b.pixel(2, 0)[1] = 28;
    const ImageDiff d = diff(a, b);
    CHECK(d.max_delta == 4);
    CHECK(d.count == 2);
    CHECK(d.picture.rgb == std::vector<std::uint8_t>{0, 0, 0, 255, 0, 63, 0, 127, 0});
    try {
        diff(a, picture(1, 3, {0, 0, 0}));
        FAIL("sizes differ");
    } catch (const Error& error) {
        CHECK(error.code() == Errc::format);
    }
}

TEST_CASE("sRGB encoding and decoding are inverse and meet at the ends", "[image]") {
    CHECK(srgb_encode(0) == 0);
    CHECK(srgb_encode(1) == Approx(1).epsilon(1e-15));
    CHECK(srgb_decode(1) == Approx(1).epsilon(1e-15));
    CHECK(srgb_encode(0.18) == Approx(0.46135613));  // independent of the code: middle grey
    CHECK(srgb_decode(0.5) == Approx(0.21404114));
    for (int byte = 0; byte < 256; ++byte)
        CHECK(srgb_encode(srgb_decode(byte / 255.0)) == Approx(byte / 255.0).epsilon(1e-6));
}

TEST_CASE("encoding equals the double formula for every radiance", "[image]") {
    // Every 1/64 of a byte step and the neighbours of each rounding threshold.
    std::vector<float> radiance;
    for (int i = -64; i < 256 * 64 + 64; ++i) {
        const double encoded = i / 64.0 / 255;
        const float x = float(encoded > 0 ? srgb_decode(encoded) : encoded);
        radiance.insert(radiance.end(), {std::nextafter(x, -1.0f), x, std::nextafter(x, 2.0f)});
    }
    Framebuffer frame(129, 128);
    REQUIRE(radiance.size() == 3 * frame.r.size());
    for (std::size_t i = 0; i < frame.r.size(); ++i) {
        frame.r[i] = radiance[3 * i];
        frame.g[i] = radiance[3 * i + 1];
        frame.b[i] = radiance[3 * i + 2];
    }
    for (const double exposure : {0.0, 1.7, -3.0}) {
        CAPTURE(exposure);
        const Image srgb = encode(frame, Transfer::srgb, exposure);
        const Image linear = encode(frame, Transfer::linear, exposure);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < radiance.size(); ++i) {
            const double exposed = double(radiance[i]) * std::exp2(exposure);
            const double x = std::min(std::max(exposed, 0.0), 1.0);
            wrong += srgb.rgb[i] != std::uint8_t(std::floor(255 * srgb_encode(x) + 0.5));
            wrong += linear.rgb[i] != std::uint8_t(std::floor(255 * x + 0.5));
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("colours beyond the range clamp, and NaN is black", "[image]") {
    Framebuffer frame(2, 1);
    CHECK(frame.id == std::vector<std::uint32_t>(2, Framebuffer::no_triangle));
    CHECK(frame.depth == std::vector<float>(2, 0.0f));
    frame.r = {INFINITY, -INFINITY};
    frame.g = {NAN, -1};
    frame.b = {1e30f, 0.5f};
    CHECK(encode(frame, Transfer::linear, 0).rgb ==
          std::vector<std::uint8_t>{255, 0, 255, 0, 0, 128});
    CHECK(encode(frame, Transfer::srgb, 0).rgb ==
          std::vector<std::uint8_t>{255, 0, 255, 0, 0, 188});
    CHECK(encode(frame, Transfer::linear, -5000).rgb == std::vector<std::uint8_t>(6, 0));
}

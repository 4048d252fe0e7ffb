// Every measure of error on pictures whose error is known.
#include "scanshade/image/metrics.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

Framebuffer filled(int width, int height, float r, float g, float b) {
    Framebuffer frame(width, height);
    frame.r.assign(frame.r.size(), r);
    frame.g.assign(frame.g.size(), g);
    frame.b.assign(frame.b.size(), b);
    return frame;
}

double value(const char* name, const Comparison& pair, Channels channels = {},
             const Mask* mask = nullptr) {
    return measure(find_metric(name), pair, channels, mask);
}

Framebuffer waves(int width, int height, float phase) {
    Framebuffer frame(width, height);
    for (std::size_t i = 0; i < frame.r.size(); ++i) {
        const float t = float(i) * 0.7f + phase;
        frame.r[i] = 0.5f + 0.4f * std::sin(t);
        frame.g[i] = 0.5f + 0.4f * std::cos(1.7f * t);
        frame.b[i] = 0.5f + 0.3f * std::sin(0.3f * t);
    }
    return frame;
}

}  // namespace

TEST_CASE("equal pictures have no error in any metric", "[metrics]") {
    const Framebuffer frame = waves(37, 23, 0);
    const Comparison pair(frame, frame, Transfer::srgb, 0);
    for (const Metric& metric : all_metrics()) {
        CAPTURE(std::string(metric.name));
        const double none = metric.name == "psnr"   ? std::numeric_limits<double>::infinity()
                            : metric.name == "ssim" ? 1.0
                                                    : 0.0;
        CHECK(measure(metric, pair) == none);
        for (float error : error_map(metric, pair)) CHECK(error == 0);
    }
}

TEST_CASE("a larger error is worse in every metric", "[metrics]") {
    const Framebuffer reference = waves(37, 23, 0);
    const Comparison small(waves(37, 23, 0.01f), reference, Transfer::srgb, 0);
    const Comparison large(waves(37, 23, 0.3f), reference, Transfer::srgb, 0);
    for (const Metric& metric : all_metrics()) {
        const double good = measure(metric, small), bad = measure(metric, large);
        CAPTURE(std::string(metric.name), good, bad);
        CHECK(is_better(metric, good, bad));
        CHECK_FALSE(is_better(metric, bad, good));
        for (float error : error_map(metric, large)) CHECK(error >= 0);
    }
}

TEST_CASE("names of metrics are words that files and options can have", "[metrics]") {
    std::set<std::string> names;
    for (const Metric& metric : all_metrics()) {
        CHECK(names.insert(std::string(metric.name)).second);
        CHECK(metric.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz01") == metric.name.npos);
        CHECK((metric.picture == "linear" || metric.picture == "encoded"));
        CHECK(&find_metric(metric.name) == &metric);
    }
    CHECK_THROWS_WITH(find_metric("rmsf"), Catch::Contains("did you mean 'rmse'"));
}

TEST_CASE("errors of linear light, by hand", "[metrics]") {
    // Two of eight pixels are off: red by 0.3 and green by 0.4, and red by 0.5.
    Framebuffer reference = filled(4, 2, 0.1f, 0.2f, 3.0f), picture = reference;
    picture.r[1] += 0.3f;
    picture.g[1] -= 0.4f;
    picture.r[6] += 0.5f;
    const Comparison pair(picture, reference, Transfer::srgb, 0);
    CHECK(value("mae", pair) == Approx(1.2 / 24));
    CHECK(value("mae", pair, {0, 1}) == Approx(0.8 / 8));
    CHECK(value("mae", pair, {2, 3}) == 0);
    CHECK(value("rmse", pair) == Approx(std::sqrt(0.5 / 24)));
    CHECK(value("rmse", pair, {1, 2}) == Approx(std::sqrt(0.16 / 8)));
    CHECK(value("max", pair) == Approx(0.5));
    CHECK(value("max", pair, {1, 2}) == Approx(0.4));
    CHECK(value("relmse", pair) == Approx((0.34 / 0.02 + 0.16 / 0.05) / 24));
    CHECK(value("over1", pair) == Approx(25));
    CHECK(value("over1", pair, {1, 2}) == Approx(12.5));

    Mask mask(4, 2);
    mask.inside[1] = mask.inside[0] = 1;
    CHECK(value("mae", pair, {}, &mask) == Approx(0.7 / 6));
    CHECK(value("max", pair, {}, &mask) == Approx(0.4));
    CHECK(value("over1", pair, {}, &mask) == Approx(50));
    CHECK(error_map(find_metric("rmse"), pair)[1] == Approx(std::sqrt(0.25 / 3)));
}

TEST_CASE("encoded metrics see what is shown, linear ones what is there", "[metrics]") {
    // Above white there is no difference to be seen.
    const Framebuffer bright = filled(16, 16, 2, 3, 4), brighter = filled(16, 16, 5, 6, 7);
    const Comparison pair(brighter, bright, Transfer::srgb, 0);
    for (const Metric& metric : all_metrics()) {
        CAPTURE(std::string(metric.name));
        const bool seen = metric.picture == "linear";
        CHECK(std::isinf(measure(metric, pair)) == (metric.name == "psnr"));
        CHECK((error_map(metric, pair)[0] > 0) == seen);
    }
    // With less exposure there is: 0.25 and 0.5, through either curve.
    const Comparison dark(filled(16, 16, 0.5f, 0.5f, 0.5f), filled(16, 16, 1, 1, 1),
                          Transfer::linear, -1);
    CHECK(value("psnr", dark) == Approx(10 * std::log10(16.0)));
    CHECK(value("rmse", dark) == Approx(0.5));
    const Comparison curved(filled(16, 16, 0.5f, 0.5f, 0.5f), filled(16, 16, 1, 1, 1),
                            Transfer::srgb, -1);
    CHECK(value("psnr", curved) ==
          Approx(-20 * std::log10(srgb_encode(0.5) - srgb_encode(0.25))).epsilon(1e-5));
}

TEST_CASE("pixels of bytes are off by more than one level from two on", "[metrics]") {
    Image a(256, 1), b(256, 1), c(256, 1);
    for (int x = 0; x < 256; ++x) {
        a.pixel(x, 0)[1] = std::uint8_t(x);
        b.pixel(x, 0)[1] = std::uint8_t(x < 255 ? x + 1 : 254);
        c.pixel(x, 0)[1] = std::uint8_t(x < 254 ? x + 2 : x - 2);
    }
    CHECK(value("over1", Comparison(b, a)) == 0);
    CHECK(value("over1", Comparison(c, a)) == 100);
    CHECK(value("over1", Comparison(c, a), {0, 1}) == 0);
    CHECK(value("psnr", Comparison(b, a), {1, 2}) == Approx(20 * std::log10(255.0)).epsilon(1e-5));
}

TEST_CASE("what is not finite is reported, not averaged away", "[metrics]") {
    const Framebuffer reference = waves(32, 20, 0);
    for (float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Framebuffer picture = reference;
        picture.g[5] = bad;
        Mask with(32, 20), far(32, 20);
        with.inside[5] = 1;
        far.inside[19 * 32 + 31] = 1;
        for (bool swapped : {false, true}) {
            const Comparison pair(swapped ? reference : picture, swapped ? picture : reference,
                                  Transfer::srgb, 0);
            CHECK(pair.not_finite() == 1);
            CHECK(pair.not_finite(&with) == 1);
            CHECK(pair.not_finite(&far) == 0);
            for (const Metric& metric : all_metrics()) {
                CAPTURE(std::string(metric.name), bad, swapped);
                CHECK(std::isnan(measure(metric, pair)));
                CHECK(std::isnan(measure(metric, pair, {}, &with)));
                CHECK_FALSE(std::isnan(measure(metric, pair, {}, &far)));
                CHECK_FALSE(is_better(metric, measure(metric, pair), 0));
            }
        }
    }
    // A neighbour within the filters' reach knows it, too.
    Framebuffer picture = reference;
    picture.g[5] = std::numeric_limits<float>::quiet_NaN();
    const Comparison pair(picture, reference, Transfer::srgb, 0);
    Mask beside(32, 20);
    beside.inside[6] = 1;
    CHECK(std::isnan(value("flip", pair, {}, &beside)));
    CHECK(std::isnan(value("ssim", pair, {}, &beside)));
    CHECK(value("mae", pair, {}, &beside) == 0);
}

TEST_CASE("no pixels, no value; other sizes, no comparison", "[metrics]") {
    const Framebuffer frame = waves(8, 8, 0);
    const Comparison pair(frame, frame, Transfer::srgb, 0);
    const Mask none(8, 8);
    for (const Metric& metric : all_metrics()) CHECK(std::isnan(measure(metric, pair, {}, &none)));
    CHECK_THROWS_AS(Comparison(frame, waves(8, 9, 0), Transfer::srgb, 0), Error);
    CHECK_THROWS_AS(Comparison(Image(3, 4), Image(4, 3)), Error);
}

TEST_CASE("structural similarity is its formula in a window of 11 × 11", "[metrics]") {
    const Framebuffer a = waves(40, 30, 0), b = waves(40, 30, 0.4f);
    const Comparison pair(b, a, Transfer::linear, 0);
    const auto by_definition = [&](int x, int y) {
        double weights = 0, m1 = 0, m2 = 0, v1 = 0, v2 = 0, cov = 0;
        for (int pass = 0; pass < 2; ++pass)
            for (int v = std::max(y - 5, 0); v <= std::min(y + 5, 29); ++v)
                for (int u = std::max(x - 5, 0); u <= std::min(x + 5, 39); ++u) {
                    const double r2 = (u - x) * (u - x) + (v - y) * (v - y);
                    const double w = std::exp(-r2 / (2 * 1.5 * 1.5));
                    const double p = double(a.r[a.index(u, v)]), q = double(b.r[b.index(u, v)]);
                    if (pass == 0) {
                        weights += w, m1 += w * p, m2 += w * q;
                    } else {
                        v1 += w * (p - m1) * (p - m1), v2 += w * (q - m2) * (q - m2);
                        cov += w * (p - m1) * (q - m2);
                    }
                    if (pass == 0 && u == std::min(x + 5, 39) && v == std::min(y + 5, 29))
                        m1 /= weights, m2 /= weights;
                }
        v1 /= weights, v2 /= weights, cov /= weights;
        return (2 * m1 * m2 + 1e-4) * (2 * cov + 9e-4) /
               ((m1 * m1 + m2 * m2 + 1e-4) * (v1 + v2 + 9e-4));
    };
    for (auto [x, y] : {std::pair{20, 15}, {0, 0}, {39, 12}, {3, 29}})
        CHECK(double(pair.ssim_map(0)[a.index(x, y)]) == Approx(by_definition(x, y)).epsilon(1e-5));

    // Without structure only the means count.
    const Comparison flat(filled(9, 9, 0.25f, 0, 0), filled(9, 9, 0.5f, 0, 0), Transfer::linear, 0);
    CHECK(value("ssim", flat, {0, 1}) == Approx((2 * 0.125 + 1e-4) / (0.3125 + 1e-4)));
}

TEST_CASE("structural similarity of a tall picture has no seams", "[metrics]") {
    // Rows repeat after 7; so does the map, away from both ends, wherever it was divided.
    constexpr int w = 4, h = 700;
    Framebuffer a(w, h), b(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            a.g[a.index(x, y)] = 0.5f + 0.4f * std::sin(float(y % 7 * 3 + x));
            b.g[b.index(x, y)] = 0.5f + 0.4f * std::sin(float(y % 7 * 5 + x));
        }
    const Comparison pair(a, b, Transfer::linear, 0);
    const Comparison::Plane& map = pair.ssim_map(1);
    for (int i = 7 * w; i < (h - 14) * w; ++i)
        REQUIRE(map[std::size_t(i)] == map[std::size_t(i + 7 * w)]);
}

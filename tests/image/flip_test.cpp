// FLIP against the program that its authors published.
#include "image/flip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/catch.hpp"

using namespace scanshade;

namespace {

using Picture = std::array<std::vector<float>, 3>;
constexpr int width = 64, height = 48;

/// value(x, y, channel) in [0, 1].
template <class Value>
Picture picture(Value&& value) {
    Picture result;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) result[std::size_t(c)].push_back(float(value(x, y, c)));
    return result;
}

Picture one_colour(const std::array<double, 3>& rgb) {
    return picture([&](int, int, int c) { return rgb[std::size_t(c)]; });
}

/// Ramps with checkers of 8 pixels and stripes of 3, and a blue disc; k changes all of them.
Picture pattern(int k) {
    return picture([&](int x, int y, int c) {
        if (c == 0) return (x * 7 + y * 3 + k * 11 * ((x / 8 + y / 8) % 2)) % 256 / 255.0;
        if (c == 1) return (x * 2 + y * 5 + k * 5 * ((x + y) % 3)) % 256 / 255.0;
        const bool disc = (x - 40) * (x - 40) + (y - 20) * (y - 20) < 100;
        return (disc ? 220 - k * 30 : 60 + k * 8) / 255.0;
    });
}

double mean(const std::vector<float>& map) {
    return std::accumulate(map.begin(), map.end(), 0.0) / double(map.size());
}

double at(const std::vector<float>& map, int x, int y) {
    return double(map[std::size_t(y * width + x)]);
}

}  // namespace

// The numbers are what the authors' Python program (github.com/NVlabs/flip, python/flip_api.py, its
// filters in double) gives for these pictures at its default of 67.02 pixels a degree. Its white point
// is rounded otherwise, which is worth 4e-6.

TEST_CASE("FLIP of plain colours", "[flip]") {
    const struct {
        std::array<double, 3> a, b;
        double flip;
    } rows[] = {
        {{0, 0, 0}, {1, 1, 1}, 0.967380},
        {{0, 1, 0}, {0, 0, 1}, 1.0},  // the largest distance there is
        {{1, 0, 0}, {0, 1, 0}, 0.986662},
        {{0.5, 0.5, 0.5}, {128 / 255.0, 128 / 255.0, 128 / 255.0}, 0.018392},
        {{0.2, 0.4, 0.6}, {0.25, 0.4, 0.55}, 0.133352},
    };
    for (const auto& row : rows) {
        const auto map = flip_map(one_colour(row.a), one_colour(row.b), width, height);
        CHECK(at(map, 20, 20) == Approx(row.flip).margin(1e-5));
        CHECK(at(map, 0, 47) == Approx(row.flip).margin(1e-5));
    }
}

TEST_CASE("FLIP of a picture with ramps, checkers and a disc", "[flip]") {
    const auto map = flip_map(pattern(1), pattern(0), width, height);
    CHECK(mean(map) == Approx(0.262672).margin(2e-5));
    CHECK(double(*std::max_element(map.begin(), map.end())) == Approx(0.914380).margin(2e-5));
    CHECK(at(map, 0, 0) == Approx(0.111746).margin(2e-5));
    CHECK(at(map, 30, 10) == Approx(0.154952).margin(2e-5));
    CHECK(at(map, 40, 20) == Approx(0.406301).margin(2e-5));
    CHECK(at(map, 63, 47) == Approx(0.176761).margin(2e-5));
    CHECK(at(map, 12, 30) == Approx(0.152097).margin(2e-5));
}

TEST_CASE("FLIP of a point and of an edge", "[flip]") {
    const Picture black = one_colour({0, 0, 0}), grey = one_colour({0.5, 0.5, 0.5});
    const Picture point = picture([](int x, int y, int) { return x == 32 && y == 24 ? 1.0 : 0.0; });
    const auto dot = flip_map(point, black, width, height);
    CHECK(mean(dot) == Approx(0.0046587).margin(1e-5));
    CHECK(at(dot, 32, 24) == Approx(0.864906).margin(2e-5));
    CHECK(at(dot, 36, 24) == Approx(0.018021).margin(2e-5));

    const Picture step = picture([](int x, int, int) { return x >= 32 ? 0.6 : 0.5; });
    const auto edge = flip_map(step, grey, width, height);
    CHECK(mean(edge) == Approx(0.155862).margin(2e-5));
    CHECK(double(*std::max_element(edge.begin(), edge.end())) == Approx(0.380078).margin(2e-5));
    CHECK(at(edge, 32, 24) == Approx(0.339055).margin(2e-5));
    CHECK(at(edge, 31, 24) == Approx(0.230087).margin(2e-5));
    CHECK(at(edge, 20, 24) == 0);
}

TEST_CASE("FLIP of a tall picture has no seams", "[flip]") {
    // Rows repeat after 7; so does the map, away from both ends, wherever it was divided.
    constexpr int w = 12, h = 700;
    Picture a, b;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                a[std::size_t(c)].push_back(float((y % 7 * 31 + x * 13 + c * 50) % 256) / 255);
                b[std::size_t(c)].push_back(float((y % 7 * 29 + x * 17 + c * 40) % 256) / 255);
            }
    const auto map = flip_map(a, b, w, h);
    for (int i = 14 * w; i < (h - 21) * w; ++i)
        REQUIRE(map[std::size_t(i)] == map[std::size_t(i + 7 * w)]);
}

TEST_CASE("FLIP takes either picture for the reference", "[flip]") {
    CHECK(flip_map(pattern(1), pattern(0), width, height) ==
          flip_map(pattern(0), pattern(1), width, height));
}

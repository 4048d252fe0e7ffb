// Coverage of single polygons: the walker against brute force in exact integers.
#include "render/walk.hpp"

#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/winding.hpp"

using namespace scanshade;

namespace {

/// Samples that a polygon covers, by the definition: the winding number of the polygon about the
/// sample, where the sample is moved up and left by less than anything (the top-left rule). Each
/// crossing is decided by the sign of an integer.
std::vector<bool> brute_force(const std::vector<SnappedPoint>& polygon, bool positive,
                              SampleOffset sample, int width, int height) {
    std::vector<bool> covered(std::size_t(width * height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const SnappedPoint p = {x * subpixels + sample.x, y * subpixels + sample.y};
            const int winding = winding_number(polygon, p);
            covered[std::size_t(y * width + x)] = (positive ? winding : -winding) > 0;
        }
    return covered;
}

std::vector<int> walked(const std::vector<SnappedPoint>& polygon, bool positive,
                        SampleOffset sample, int width, int height) {
    std::vector<int> count(std::size_t(width * height));
    PolygonWalker walker;
    walker.walk(polygon, positive, sample, width, height, [&](int y, int begin, int end) {
        REQUIRE(y >= 0);
        REQUIRE(y < height);
        REQUIRE(begin >= 0);
        REQUIRE(end <= width);
        for (int x = begin; x < end; ++x) ++count[std::size_t(y * width + x)];
    });
    return count;
}

void require_equal(const std::vector<SnappedPoint>& polygon, SampleOffset sample, int width,
                   int height) {
    const std::int64_t area = twice_area(polygon);
    if (area == 0) return;
    const auto expected = brute_force(polygon, area > 0, sample, width, height);
    const auto got = walked(polygon, area > 0, sample, width, height);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < got.size(); ++i) wrong += got[i] != (expected[i] ? 1 : 0);
    REQUIRE(wrong == 0);
}

}  // namespace

TEST_CASE("random polygons cover what exact arithmetic says", "[render][coverage]") {
    const std::uint64_t seed = 1;
    CAPTURE(seed);
    Rng rng(seed);
    constexpr int side = 24;
    for (int k = 0; k < 3000; ++k) {
        // Some on whole pixels and sample rows, where the rule decides; some far outside.
        const int grid = k % 3 == 0 ? 128 : 1;
        const std::int64_t reach = k % 5 == 0 ? 60000 : side * subpixels;
        std::vector<SnappedPoint> polygon;
        const std::int64_t corners = rng.integer(3, k % 2 == 0 ? 3 : 7);
        for (std::int64_t i = 0; i < corners; ++i)
            polygon.push_back(
                {static_cast<std::int32_t>(rng.integer(-reach / 8, reach) / grid * grid),
                 static_cast<std::int32_t>(rng.integer(-reach / 8, reach) / grid * grid)});
        const SampleOffset sample =
            k % 4 == 0 ? SampleOffset{int(rng.integer(0, 255)), int(rng.integer(0, 255))}
                       : SampleOffset{};
        CAPTURE(k);
        require_equal(polygon, sample, side, side);
    }
}

TEST_CASE("a triangle at the end of the guard band is exact", "[render][coverage]") {
    constexpr std::int32_t far = 32768 * subpixels;
    Rng rng(2);
    for (int k = 0; k < 200; ++k) {
        std::vector<SnappedPoint> polygon;
        for (int i = 0; i < 3; ++i)
            polygon.push_back({static_cast<std::int32_t>(rng.integer(-far, far)),
                               static_cast<std::int32_t>(rng.integer(-far, far))});
        require_equal(polygon, {}, 32, 32);
    }
}

TEST_CASE("the rasterization rules' example: 5 x 5 pixels of two triangles are 15 and 10",
          "[render][coverage]") {
    constexpr std::int32_t a = 0, b = 5 * subpixels;
    const auto count = [](const std::vector<SnappedPoint>& polygon) {
        int sum = 0;
        for (const int n : walked(polygon, twice_area(polygon) > 0, {}, 8, 8)) sum += n;
        return sum;
    };
    // Corners on pixel corners; the diagonal goes through sample points, which belong to one.
    CHECK(count({{a, a}, {b, a}, {b, b}}) + count({{a, a}, {b, b}, {a, b}}) == 25);
    CHECK(count({{a, a}, {b, a}, {b, b}}) == 15);
    CHECK(count({{a, a}, {b, b}, {a, b}}) == 10);
}

TEST_CASE("samples on left and top edges are covered, on right and bottom edges not",
          "[render][coverage]") {
    constexpr std::int32_t c = subpixels / 2;  // sample centres at c + 256 k
    const std::vector<SnappedPoint> square = {
        {c, c}, {c + 512, c}, {c + 512, c + 512}, {c, c + 512}};
    const auto got = walked(square, true, {}, 4, 4);
    const std::vector<int> expected = {1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    CHECK(got == expected);
}

TEST_CASE("the corner that comes first and the direction change no coverage",
          "[render][coverage]") {
    Rng rng(3);
    for (int k = 0; k < 300; ++k) {
        std::vector<SnappedPoint> p;
        for (int i = 0; i < 3; ++i)
            p.push_back({int(rng.integer(-999, 7000)), int(rng.integer(-999, 7000))});
        if (twice_area(p) == 0) continue;
        const auto reference = walked(p, twice_area(p) > 0, {}, 24, 24);
        const std::vector<SnappedPoint> rotated = {p[1], p[2], p[0]}, reversed = {p[2], p[1], p[0]};
        CHECK(walked(rotated, twice_area(rotated) > 0, {}, 24, 24) == reference);
        CHECK(walked(reversed, twice_area(reversed) > 0, {}, 24, 24) == reference);
    }
}

TEST_CASE("moving by whole pixels moves the coverage", "[render][coverage]") {
    Rng rng(4);
    for (int k = 0; k < 200; ++k) {
        std::vector<SnappedPoint> p, moved;
        for (int i = 0; i < 3; ++i) {
            p.push_back({int(rng.integer(0, 2000)), int(rng.integer(0, 2000))});
            moved.push_back({p.back().x + 5 * subpixels, p.back().y + 3 * subpixels});
        }
        if (twice_area(p) == 0) continue;
        const auto here = walked(p, twice_area(p) > 0, {}, 16, 16);
        const auto there = walked(moved, twice_area(p) > 0, {}, 16, 16);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x)
                REQUIRE(here[std::size_t(y * 16 + x)] == there[std::size_t((y + 3) * 16 + x + 5)]);
    }
}

TEST_CASE("long thin pictures are walked exactly", "[render][coverage]") {
    Rng rng(5);
    for (const auto& [width, height] : {std::pair{16384, 16}, std::pair{16, 16384}})
        for (int k = 0; k < 4; ++k) {
            std::vector<SnappedPoint> polygon;
            for (int i = 0; i < 3; ++i)
                polygon.push_back({int(rng.integer(0, width * subpixels)),
                                   int(rng.integer(0, height * subpixels))});
            CAPTURE(width, height, k);
            require_equal(polygon, {}, width, height);
        }
}

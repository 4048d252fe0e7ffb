// Interior and silhouette of what two frames show.
#include <string>

#include "scanshade/base/error.hpp"
#include "scanshade/image/metrics.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// A surface of the given depth in columns begin to end − 1; each pixel has a triangle of its own.
template <class Depth>
void put_surface(Framebuffer& frame, int begin, int end, Depth&& depth) {
    for (int y = 0; y < frame.height; ++y)
        for (int x = begin; x < end; ++x) {
            frame.depth[frame.index(x, y)] = float(depth(x));
            frame.id[frame.index(x, y)] = std::uint32_t(frame.index(x, y));
        }
}

/// The middle row: "." neither, "i" interior, "s" silhouette, "S" silhouette and covered in both.
std::string middle_row(const Framebuffer& a, const Framebuffer& b) {
    const Regions regions = regions_of(a, b);
    std::string row;
    for (int x = 0; x < a.width; ++x) {
        const std::size_t i = a.index(x, a.height / 2);
        const bool covered = regions.covered.inside[i], inner = regions.interior.inside[i];
        CHECK((!inner || covered));
        CHECK_FALSE((inner && regions.silhouette.inside[i]));
        row += inner ? 'i' : !regions.silhouette.inside[i] ? '.' : covered ? 'S' : 's';
    }
    return row;
}

}  // namespace

TEST_CASE("a surface's end is its silhouette, two pixels to either side", "[metrics]") {
    Framebuffer frame(20, 5);
    put_surface(frame, 5, 15, [](int) { return 0.5; });
    CHECK(middle_row(frame, frame) == "...ssSSiiiiiiSSss...");
    CHECK(regions_of(frame, frame).covered.count() == 50);
}

TEST_CASE("what only one frame covers is silhouette, however wide", "[metrics]") {
    Framebuffer a(20, 5), b(20, 5);
    put_surface(a, 5, 15, [](int) { return 0.5; });
    put_surface(b, 0, 20, [](int) { return 0.5; });
    CHECK(middle_row(a, b) == "sssssSSiiiiiiSSsssss");
    CHECK(middle_row(b, a) == "sssssSSiiiiiiSSsssss");
}

TEST_CASE("steep slopes and creases are no edges, jumps of depth are", "[metrics]") {
    Framebuffer frame(20, 5);
    put_surface(frame, 0, 20, [](int x) { return 0.9 - 0.04 * x; });
    CHECK(middle_row(frame, frame) == std::string(20, 'i'));
    put_surface(frame, 10, 20, [](int x) { return 0.54 + 0.02 * (x - 9); });
    CHECK(middle_row(frame, frame) == std::string(20, 'i'));
    put_surface(frame, 10, 20, [](int) { return 0.3; });
    CHECK(middle_row(frame, frame) == "iiiiiiiiSSSSiiiiiiii");
    put_surface(frame, 0, 20, [](int x) { return x < 10 ? 0.5 : 0.49; });
    CHECK(middle_row(frame, frame) == "iiiiiiiiSSSSiiiiiiii");
    // A hundredth of the depth is too little to be another object.
    put_surface(frame, 0, 20, [](int x) { return x < 10 ? 0.5 : 0.503; });
    CHECK(middle_row(frame, frame) == std::string(20, 'i'));
}

TEST_CASE("edges run between rows, too, and corners reach diagonally", "[metrics]") {
    Framebuffer frame(7, 7);
    put_surface(frame, 0, 7, [](int) { return 0.5; });
    frame.id[frame.index(6, 6)] = Framebuffer::no_triangle;
    const Regions regions = regions_of(frame, frame);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 7; ++x) {
            // Ends of edges are (6, 6), (5, 6) and (6, 5).
            const bool near = x >= 5 ? y >= 4 : x == 4 && y >= 5;
            CAPTURE(x, y);
            CHECK(bool(regions.silhouette.inside[frame.index(x, y)]) == near);
            CHECK(bool(regions.interior.inside[frame.index(x, y)]) == !near);
        }
}

TEST_CASE("two views of nothing have no regions", "[metrics]") {
    CHECK(middle_row(Framebuffer(4, 3), Framebuffer(4, 3)) == "....");
    CHECK_THROWS_AS(regions_of(Framebuffer(4, 3), Framebuffer(3, 4)), Error);
}

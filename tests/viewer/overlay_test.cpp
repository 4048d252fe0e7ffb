// Text over the picture.
#include "viewer/overlay.hpp"

#include <algorithm>

#include "cli/lettering.hpp"
#include "support/catch.hpp"

using namespace scanshade;
using namespace scanshade::viewer;

TEST_CASE("lines are broken at spaces where they would be too wide", "[viewer]") {
    const std::string text = "one two three\n\nfour";
    const std::vector<std::string> whole{"one two three", "", "four"};
    CHECK(wrapped(text, 10'000) == whole);
    CHECK(wrapped(text, lettering_width("one two")) ==
          std::vector<std::string>{"one two", "three", "", "four"});
    CHECK(wrapped(text, -5) == std::vector<std::string>{"one", "two", "three", "", "four"});
}

TEST_CASE("the overlay covers its corner and leaves the rest of the picture", "[viewer]") {
    Image picture(400, 300);
    std::fill(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{77});
    draw_overlay(picture, "two\nlines, one with an odd character: \xff");
    const auto count = [&](int byte) {
        return std::count(picture.rgb.begin(), picture.rgb.end(), byte);
    };
    CHECK(count(0) > 3000);    // the box
    CHECK(count(255) > 1000);  // letters
    CHECK(picture.pixel(0, 0)[0] == 0);
    CHECK(picture.pixel(0, 299)[0] == 77);
    CHECK(count(77) > 3 * 400 * 150);

    Image tiny(1, 1);
    draw_overlay(tiny, "larger than the picture");
}

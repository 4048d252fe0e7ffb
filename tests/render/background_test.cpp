// Background that is in a picture already is not written again, and the picture is the same.
#include <algorithm>

#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

LargeVector<std::uint32_t> alone(const Scene& scene, const Settings& settings) {
    PixelBuffer pixels;
    Renderer(scene, settings).draw(pixels);
    return pixels.rgba();
}

Settings one_sample(Settings settings, int threads) {
    settings.width = 93, settings.height = 70;  // blocks are cut off on both sides
    settings.samples = 1;
    settings.threads = threads;
    return settings;
}

PlanSaving unchanged(const FrameStats& stats) { return stats.saved[PlanRow::unchanged_background]; }

/// Blocks of 16 × 16 pixels of one colour.
std::uint64_t blocks_of(const PixelBuffer& pixels, std::uint32_t rgba) {
    constexpr int side = PixelBuffer::block_side;
    std::uint64_t count = 0;
    for (int by = 0; by < pixels.height; by += side)
        for (int bx = 0; bx < pixels.width; bx += side) {
            bool same = true;
            for (int y = by; y < std::min(by + side, pixels.height); ++y)
                for (int x = bx; x < std::min(bx + side, pixels.width); ++x)
                    same &= pixels.rgba()[std::size_t(y * pixels.width + x)] == rgba;
            count += same;
        }
    return count;
}

}  // namespace

TEST_CASE("pictures drawn one over another are those drawn alone", "[engine][plan][background]") {
    for (const int threads : {1, 3}) {
        PixelBuffer pixels;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            const RandomScene random = make_random_scene(seed);
            Settings settings = one_sample(random.settings, threads);
            // The same background for some frames; sometimes another hand in between.
            settings.background = glm::dvec3(0.1 * double(seed / 7 % 3));
            settings.no_plan = seed % 11 == 0;
            if (seed % 13 == 0) settings.renderer = RendererKind::scalar_f32;
            if (seed % 17 == 0) std::ranges::fill(pixels.edit(), 0xff00ff00u);
            if (seed % 19 == 0) settings.width = 64;
            CAPTURE(seed, threads, describe(random));
            Renderer renderer(random.scene, settings);
            for (int frame = 0; frame < 2; ++frame) {
                renderer.draw(pixels);
                CHECK(pixels.rgba() == alone(random.scene, settings));
            }
        }
    }
}

TEST_CASE("the second frame leaves out the background of the first", "[engine][plan][background]") {
    const Scene scene = lit_sphere();
    Settings settings = small_picture();
    settings.width = 200, settings.height = 150;
    Renderer renderer(scene, settings);
    PixelBuffer pixels;
    const PlanSaving first = unchanged(renderer.draw(pixels));
    const std::uint64_t blank = blocks_of(pixels, pixels.rgba()[0]);
    REQUIRE(blank > 20);
    CHECK((first.saved == 0 && first.of == blank));
    CHECK(unchanged(renderer.draw(pixels)).saved == blank);
    pixels.edit()[0] ^= 1;
    CHECK(unchanged(renderer.draw(pixels)).saved == 0);
    CHECK(pixels.rgba() == alone(scene, settings));
}

// Textures: their levels, and the look-up.
#include "scanshade/image/texture.hpp"

#include <cmath>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

Texture grey_texture(int width, int height, std::initializer_list<int> grey) {
    Image image(width, height);
    std::size_t i = 0;
    for (const int g : grey)
        for (int k = 0; k < 3; ++k) image.rgb[i++] = std::uint8_t(g);
    return make_texture(image, "t");
}

Texture random_texture(int width, int height) {
    Rng rng(std::uint64_t(1000 * width + height));
    MipLevel picture{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i) picture.texels.push_back(float(rng.real(0, 1)));
    return make_texture(std::move(picture), "random");
}

/// Black and white squares of `side` texels.
Texture checkerboard(int size, int side) {
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = (x / side + y / side) % 2 == 0 ? 255 : 0;
    return make_texture(image, "checkerboard");
}

double mean(const MipLevel& level, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < level.texels.size(); i += 3) sum += double(level.texels[i]);
    return sum / level.width / level.height;
}

/// A step of so many texels of the picture to the right, and no step down.
TextureGradient texels(const Texture& texture, double count) {
    return {float(count / texture.width()), 0, 0, 0};
}

constexpr TextureGradient magnified{};
constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2},  {64, 64}, {1, 9},   {13, 1},
                                         {5, 3}, {3, 64}, {37, 20}, {127, 2}, {100, 75}};

}  // namespace

TEST_CASE("a texture is decoded once and looked up from its lower left corner", "[image]") {
    // Top row white, black; bottom row mid grey, black.
    const Texture texture = grey_texture(2, 2, {255, 0, 128, 0});
    const auto look_up = [&](float u, float v) { return texture.sample(u, v, magnified)[0]; };
    const float grey = float(srgb_decode(128 / 255.0));
    CHECK(texture.name == "t");
    CHECK(look_up(0.25f, 0.25f) == Approx(grey));
    CHECK(look_up(0.25f, 0.75f) == Approx(1));
    CHECK(look_up(0.75f, 0.25f) == 0);
    CHECK(look_up(0.25f, 0.5f) == Approx((1 + grey) / 2));
    CHECK(look_up(0.5f, 0.75f) == Approx(0.5));
    // The corner belongs to all four texels, on either side of the seam.
    for (const float c : {0.0f, 1.0f, -3.0f}) CHECK(look_up(c, c) == Approx((1 + grey) / 4));
}

TEST_CASE("texture coordinates wrap at any distance, in every level", "[image]") {
    const Texture texture = grey_texture(4, 1, {10, 80, 160, 250});
    for (const double step : {0.0, 1.5, 3.0, 100.0}) {
        const TextureGradient gradient = texels(texture, step);
        const auto look_up = [&](float u, float v) { return texture.sample(u, v, gradient)[0]; };
        for (int i = 0; i < 16; ++i) {
            const float u = float(i) / 16;
            for (const float turns : {-5.0f, -1.0f, 1.0f, 1024.0f}) {
                CAPTURE(u, turns, step);
                CHECK(look_up(u + turns, 0.3f) == look_up(u, 0.3f));
            }
        }
        for (const float huge : {1e30f, -1e30f, 3e38f, -1e-30f, -1e-8f, 0.99999997f}) {
            const float x = look_up(huge, huge);
            CHECK((x >= 0 && x <= 1));
        }
    }
}

TEST_CASE("levels halve each side down to one texel and keep the mean, at any size", "[image]") {
    for (const auto& [width, height] : sizes) {
        CAPTURE(width, height);
        const Texture texture = random_texture(width, height);
        std::size_t smaller = 0;
        for (std::size_t k = 0; k < texture.levels.size(); ++k) {
            const MipLevel& level = texture.levels[k];
            CHECK(level.width == std::max(width >> k, 1));
            CHECK(level.height == std::max(height >> k, 1));
            REQUIRE(level.texels.size() ==
                    3 * std::size_t(level.width) * std::size_t(level.height));
            for (std::size_t c = 0; c < 3; ++c)
                CHECK(mean(level, c) == Approx(mean(texture.levels[0], c)).epsilon(1e-6));
            if (k > 0) smaller += level.texels.size();
        }
        CHECK(texture.levels.back().texels.size() == 3);
        CHECK(smaller <= texture.levels[0].texels.size());
    }
}

TEST_CASE("levels of one colour have it to the bit", "[image]") {
    for (const auto& [width, height] : sizes) {
        CAPTURE(width, height);
        const float colour[3] = {0.1f, 0.7f, 1.0f / 3};
        MipLevel picture{width, height, {}};
        for (int i = 0; i < 3 * width * height; ++i) picture.texels.push_back(colour[i % 3]);
        const Texture texture = make_texture(std::move(picture), "plain");
        std::size_t wrong = 0;
        for (const MipLevel& level : texture.levels)
            for (std::size_t i = 0; i < level.texels.size(); ++i)
                wrong += level.texels[i] != colour[i % 3];
        CHECK(wrong == 0);
    }
}

TEST_CASE("texels of an odd size count by the part of them that is covered", "[image]") {
    MipLevel row{5, 1, {}}, column{1, 3, {}};
    for (const float x : {1.0f, 2.0f, 4.0f, 8.0f, 16.0f}) row.texels.insert(row.texels.end(), 3, x);
    for (const float x : {1.0f, 2.0f, 6.0f}) column.texels.insert(column.texels.end(), 3, x);
    const std::vector<float> half = make_texture(row, "row").levels[1].texels;
    REQUIRE(half.size() == 6);
    CHECK(half[0] == Approx((1 + 2 + 4 / 2.0) / 2.5));
    CHECK(half[3] == Approx((4 / 2.0 + 8 + 16) / 2.5));
    CHECK(make_texture(column, "column").levels[1].texels[1] == Approx(3));
}

TEST_CASE("levels are means of light, not of bytes", "[image]") {
    const Texture texture = checkerboard(16, 1);
    for (const float grey : texture.levels[1].texels) CHECK(grey == 0.5f);
}

TEST_CASE("the level is the logarithm of the longer step, from 0 to the last", "[image]") {
    const Texture texture = random_texture(64, 16);  // 7 levels
    for (int k = 0; k <= 6; ++k) CHECK(texture.level_of(texels(texture, 1 << k)) == k);
    for (double rho = 1; rho < 64; rho *= 1.01)
        CHECK(texture.level_of(texels(texture, rho)) == Approx(std::log2(rho)).margin(2e-7));
    CHECK(texture.level_of({}) == 0);
    CHECK(texture.level_of(texels(texture, 0.99)) == 0);
    CHECK(texture.level_of(texels(texture, 1000)) == 6);
    // In texels of either side, by Pythagoras, the longer of the two steps.
    CHECK(texture.level_of({0, 0.25f, 0, 0}) == 2);
    CHECK(texture.level_of({0, 0, 3.0f / 64, 4.0f / 16}) == Approx(std::log2(5)));
    CHECK(texture.level_of({1.0f / 64, 0, 0, -0.5f}) == 3);
    // From triangles without area or seen edge on.
    CHECK(texture.level_of({NAN, NAN, NAN, NAN}) == 0);
    CHECK(texture.level_of({INFINITY, 0, 0, 0}) == 6);
    CHECK(texture.level_of({3e38f, 3e38f, 0, 0}) == 6);
}

TEST_CASE("colours change without a jump from level to level", "[image]") {
    const Texture texture = random_texture(37, 20);
    constexpr double ratio = 1.001;
    float largest = 0;
    auto before = texture.sample(0.3f, 0.6f, texels(texture, 0.5));
    for (double rho = 0.5; rho < 100; rho *= ratio) {
        const auto now = texture.sample(0.3f, 0.6f, texels(texture, rho));
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(now[c] - before[c]));
        before = now;
    }
    // Two levels are at most 1 apart.
    CHECK(double(largest) <= 1.01 * std::log2(ratio));
    for (std::size_t c = 0; c < 3; ++c)
        CHECK(before[c] == Approx(mean(texture.levels[0], c)).epsilon(1e-5));
}

TEST_CASE("a checkerboard far away is grey; near by it is black and white", "[image]") {
    const Texture texture = checkerboard(64, 4);
    Rng rng(5);
    for (int k = 0; k < 100; ++k) {
        const float u = float(rng.real(-2, 2)), v = float(rng.real(-2, 2));
        CHECK(texture.sample(u, v, texels(texture, 16))[0] == 0.5f);
    }
    CHECK(texture.sample(2.0f / 64, 62.0f / 64, magnified)[0] == 1);
    CHECK(texture.sample(6.0f / 64, 62.0f / 64, magnified)[0] == 0);
}

TEST_CASE("a texture too large to be kept is refused before anything is allocated", "[image]") {
    try {
        make_texture(MipLevel{8193, 8192, {}}, "large");
        FAIL("it is above max_texels");
    } catch (const Error& error) {
        CHECK(error.code() == Errc::format);
        CHECK(std::string(error.what()).find("8193 × 8192") != std::string::npos);
    }
}

#include "scanshade/image/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

using Colour = std::array<float, 3>;

/// The two texels between whose centres `coordinate` lies, and the weight of the second.
struct Tap {
    std::size_t first, second;
    float weight;
};

/// One axis, wrapped. In double: for a float, scaling by the size and taking the fraction is exact
/// enough at any distance from 0.
Tap wrapped_tap(double coordinate, int size) {
    const double wrapped = (coordinate - std::floor(coordinate)) * size - 0.5;  // [-0.5, size-0.5]
    const double whole = std::floor(wrapped);
    const int first = whole < 0 ? size - 1 : int(whole);
    return {std::size_t(first), std::size_t(first + 1 == size ? 0 : first + 1),
            float(wrapped - whole)};
}

Colour lerp(const Colour& a, const Colour& b, float t) {
    return {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)};
}

Colour bilinear(const MipLevel& level, float u, float v) {
    const Tap column = wrapped_tap(double(u), level.width);
    const Tap row = wrapped_tap(1 - (double(v) - std::floor(double(v))), level.height);
    const auto texel = [&](std::size_t x, std::size_t y) -> Colour {
        const float* const t = &level.texels[3 * (y * std::size_t(level.width) + x)];
        return {t[0], t[1], t[2]};
    };
    return lerp(
        lerp(texel(column.first, row.first), texel(column.second, row.first), column.weight),
        lerp(texel(column.first, row.second), texel(column.second, row.second), column.weight),
        row.weight);
}

/// log2 x for finite x > 0, to 5e-8, from operations that round the same on every machine.
double log2_of(double x) {
    int exponent;
    double mantissa = std::frexp(x, &exponent);  // [½, 1)
    if (mantissa < 0.7071067811865476) mantissa *= 2, --exponent;
    // ln m = 2 artanh t: an odd series in |t| < 0.172
    const double t = (mantissa - 1) / (mantissa + 1), tt = t * t;
    constexpr double two_over_ln2 = 2.8853900817779268;
    return exponent + two_over_ln2 * t * (1 + tt * (1.0 / 3 + tt * (1.0 / 5 + tt / 7)));
}

/// The texels of one axis that a texel of the next level covers, and how much of each.
struct Covered {
    int first, count;
    double weight[3];  // sum 1
};

Covered covered(int texel, int size, int next_size) {
    if (size == 1) return {0, 1, {1}};
    if (size % 2 == 0) return {2 * texel, 2, {0.5, 0.5}};
    // A texel is 2 + 1/next_size wide: the middle one of three is covered whole.
    const double width = 2 * next_size + 1;
    return {2 * texel, 3, {(next_size - texel) / width, next_size / width, (texel + 1) / width}};
}

MipLevel next_level(const MipLevel& from) {
    MipLevel to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    to.texels.reserve(3 * std::size_t(to.width) * std::size_t(to.height));
    for (int y = 0; y < to.height; ++y) {
        const Covered rows = covered(y, from.height, to.height);
        for (int x = 0; x < to.width; ++x) {
            const Covered columns = covered(x, from.width, to.width);
            double sum[3] = {};
            for (int j = 0; j < rows.count; ++j)
                for (int i = 0; i < columns.count; ++i) {
                    const std::size_t at = std::size_t(rows.first + j) * std::size_t(from.width) +
                                           std::size_t(columns.first + i);
                    const double weight = rows.weight[j] * columns.weight[i];
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += weight * double(from.texels[3 * at + c]);
                }
            for (const double mean : sum) to.texels.push_back(float(mean));
        }
    }
    return to;
}

void check_size(int width, int height) {
    if (std::int64_t(width) * height > max_texels)
        throw Error(Errc::format, fmt::format("a texture of {} × {} texels is too large; at most "
                                              "{} are taken, as 8192 × 8192 has",
                                              width, height, max_texels));
}

}  // namespace

std::array<float, 3> Texture::sample(float u, float v, const TextureGradient& step) const {
    const double level = level_of(step);
    const auto whole = static_cast<std::size_t>(level);
    const auto fraction = static_cast<float>(level - std::floor(level));
    const Colour fine = bilinear(levels[whole], u, v);
    return fraction > 0 ? lerp(fine, bilinear(levels[whole + 1], u, v), fraction) : fine;
}

double Texture::level_of(const TextureGradient& step) const {
    const auto squared_length = [this](float du, float dv) {
        const double x = double(du) * width(), y = double(dv) * height();
        return x * x + y * y;
    };
    const double squared =
        std::max(squared_length(step.du_dx, step.dv_dx), squared_length(step.du_dy, step.dv_dy));
    if (!(squared > 1)) return 0;
    const double last = double(levels.size() - 1);
    return std::isinf(squared) ? last : std::min(log2_of(squared) / 2, last);
}

Texture make_texture(MipLevel picture, std::string name) {
    check_size(picture.width, picture.height);
    Texture texture{std::move(name), {}};
    texture.levels.push_back(std::move(picture));
    while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
        texture.levels.push_back(next_level(texture.levels.back()));
    return texture;
}

Texture make_texture(const Image& image, std::string name) {
    check_size(image.width, image.height);
    std::array<float, 256> linear;
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = float(srgb_decode(double(i) / 255));
    MipLevel picture{image.width, image.height, {}};
    picture.texels.reserve(image.rgb.size());
    for (const std::uint8_t byte : image.rgb) picture.texels.push_back(linear[byte]);
    return make_texture(std::move(picture), std::move(name));
}

}  // namespace scanshade

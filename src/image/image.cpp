#include "scanshade/image/image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

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

}  // namespace

ImageDiff diff(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height)
        throw Error(Errc::format, fmt::format("pictures of {} × {} and {} × {} pixels cannot be "
                                              "compared; they must have the same size",
                                              a.width, a.height, b.width, b.height));
    ImageDiff result;
    result.picture = Image(a.width, a.height);
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        int largest = 0;
        for (std::size_t k = i; k < i + 3; ++k) {
            const int delta = std::abs(int(a.rgb[k]) - int(b.rgb[k]));
            result.picture.rgb[k] = std::uint8_t(delta);
            largest = std::max(largest, delta);
        }
        result.max_delta = std::max(result.max_delta, largest);
        result.count += largest > 0;
    }
    if (result.max_delta > 0)
        for (std::uint8_t& byte : result.picture.rgb)
            byte = std::uint8_t(byte * 255 / result.max_delta);
    return result;
}

std::array<float, 3> Texture::bilinear(float u, float v) const {
    const Tap column = wrapped_tap(double(u), width);
    const Tap row = wrapped_tap(1 - (double(v) - std::floor(double(v))), height);
    const auto texel = [&](std::size_t x, std::size_t y) {
        return &texels[3 * (y * std::size_t(width) + x)];
    };
    const float* const corner[4] = {texel(column.first, row.first), texel(column.second, row.first),
                                    texel(column.first, row.second),
                                    texel(column.second, row.second)};
    std::array<float, 3> colour;
    for (std::size_t k = 0; k < 3; ++k) {
        const float top = std::lerp(corner[0][k], corner[1][k], column.weight);
        const float bottom = std::lerp(corner[2][k], corner[3][k], column.weight);
        colour[k] = std::lerp(top, bottom, row.weight);
    }
    return colour;
}

Texture make_texture(const Image& image, std::string name) {
    std::array<float, 256> linear;
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = float(srgb_decode(double(i) / 255));
    Texture texture{image.width, image.height, {}, std::move(name)};
    texture.texels.reserve(image.rgb.size());
    for (const std::uint8_t byte : image.rgb) texture.texels.push_back(linear[byte]);
    return texture;
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace scanshade

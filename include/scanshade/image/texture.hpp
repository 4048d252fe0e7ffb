// Textures: a picture at every size, and the one look-up that all renderers share.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scanshade/image/image.hpp"

namespace scanshade {

/// Texels of the largest texture: with its smaller levels, 1 GiB.
inline constexpr std::int64_t max_texels = std::int64_t{1} << 26;

/// A picture in linear float RGB, rows from the top.
struct MipLevel {
    int width = 0, height = 0;
    std::vector<float> texels;  // [3·(y·width + x) + channel]
};

/// How far (u, v) moves from a sample to the next one on the picture, to the right and down.
struct TextureGradient {
    float du_dx = 0, dv_dx = 0, du_dy = 0, dv_dy = 0;
};

/// A picture and its smaller levels, a mip chain: each side is half of the one before, rounded
/// down, to 1 × 1; together they have no more texels than the picture itself.
struct Texture {
    std::string name;
    std::vector<MipLevel> levels;  // [0] the picture

    int width() const { return levels[0].width; }
    int height() const { return levels[0].height; }

    /// Trilinear look-up, both coordinates wrapped: (0, 0) is the lower left corner of the picture,
    /// texel centres at +0.5. Bilinear in the two levels around level_of(step), weighted; where
    /// texels are larger than samples, in the picture alone. u and v finite, step any.
    std::array<float, 3> sample(float u, float v, const TextureGradient& step) const;

    /// log2 ρ, limited to the levels that are there. ρ is the longer one of the steps to the right
    /// and down, in texels of the picture; 0 where that is below 1 or not a number.
    double level_of(const TextureGradient& step) const;
};

/// Makes the levels, from linear texels or from sRGB bytes. A texel of a smaller level is the mean
/// of the area that it covers in the one before; at odd sizes texels count by their covered part.
/// So every level has the mean of the picture. Throws Error(format) above max_texels.
Texture make_texture(MipLevel picture, std::string name);
Texture make_texture(const Image& image, std::string name);

}  // namespace scanshade

// PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "scanshade/image/image.hpp"

namespace scanshade {

inline constexpr std::int64_t max_image_pixels = std::int64_t{max_image_side} * max_image_side;

/// The bytes of a PNG file. Throws Error(usage) for a picture larger than max_image_side.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Writes a file that appears under its name only when it is whole; "-" is standard output. Throws
/// Error(file).
void save_png(const Image& image, const std::filesystem::path& path);

/// A PNG, JPEG, BMP or TGA picture as 8-bit RGB (grey is spread, alpha dropped, 16 bits rounded down).
/// Throws Error(format) where it is none, is damaged or has more than `max_pixels`, before those
/// are decoded.
Image decode_image(std::string_view bytes, std::int64_t max_pixels = max_image_pixels);

/// The same from a file; throws Error(file) where that cannot be read.
Image load_image(const std::filesystem::path& path, std::int64_t max_pixels = max_image_pixels);

}  // namespace scanshade

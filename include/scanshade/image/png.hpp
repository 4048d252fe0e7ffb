// PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scanshade/image/image.hpp"

namespace scanshade {

/// The bytes of a PNG file. Throws Error(usage) for a picture larger than max_image_side.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Writes through a temporary name beside the target, so that no half-written file is ever there
/// under it. "-" writes to standard output. Throws Error(file).
void save_png(const Image& image, const std::filesystem::path& path);

/// Reads a PNG, JPEG, BMP or TGA picture as 8-bit RGB (grey is spread, alpha dropped, 16 bits rounded down).
/// Throws Error: file (cannot be read), format (not a picture, or too large).
Image load_image(const std::filesystem::path& path);

}  // namespace scanshade

#include "scanshade/image/png.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#include "image/picture_file.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"

namespace {

/// The writer asserts that there is memory.
void* or_bad_alloc(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_PNG  // what textures come in; other decoders are less well tested
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
// Cleared: a JPEG scan may name a table that its file does not have.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(memory, size) std::realloc(memory, size)
#define STBI_FREE(memory) std::free(memory)
#define STBI_MAX_DIMENSIONS 16384  // max_image_side, in stb's words
#include <stb/stb_image.h>
#define STBIW_MALLOC(size) or_bad_alloc(std::malloc(size))
#define STBIW_REALLOC_SIZED(memory, old_size, size) or_bad_alloc(std::realloc(memory, size))
#define STBIW_FREE(memory) std::free(memory)
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace scanshade {
namespace {

static_assert(STBI_MAX_DIMENSIONS == max_image_side);

constexpr std::size_t max_file_bytes = std::size_t{1} << 30;

unsigned char* bytes_of(std::string_view text) {
    // stb takes bytes that it only reads without const.
    return const_cast<unsigned char*>(reinterpret_cast<const unsigned char*>(text.data()));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.width > max_image_side ||
        image.height > max_image_side)
        throw Error(Errc::usage,
                    fmt::format("a picture of {} × {} pixels cannot be written; each side must be "
                                "from 1 to {} pixels",
                                image.width, image.height, max_image_side));
    int size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> png(
        stbi_write_png_to_mem(image.rgb.data(), 3 * image.width, image.width, image.height, 3,
                              &size),
        std::free);
    if (!png) throw std::bad_alloc();
    return {png.get(), png.get() + size};
}

void save_png(const Image& image, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> png = encode_png(image);
    const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
    if (path != "-") return write_file(bytes, path);
    std::fflush(stdout);
    if (const int reason = write_all(STDOUT_FILENO, bytes))
        throw Error(Errc::file, fmt::format("standard output could not be written ({})",
                                            std::strerror(reason)));
}

Image decode_image(std::string_view bytes, std::int64_t max_pixels) {
    check_picture_file(bytes);
    const int size = int(std::min(bytes.size(), max_file_bytes));
    int width = 0, height = 0, channels = 0;
    const Error not_a_picture(
        Errc::format, "this is no complete picture; PNG, JPEG, BMP and TGA files can be read");
    if (!stbi_info_from_memory(bytes_of(bytes), size, &width, &height, &channels))
        throw Error(not_a_picture);
    if (width < 1 || height < 1 || width > max_image_side || height > max_image_side)
        throw Error(Errc::format, fmt::format("the picture has {} × {} pixels; each side must be "
                                              "from 1 to {} pixels",
                                              width, height, max_image_side));
    if (std::int64_t(width) * height > max_pixels)
        throw Error(Errc::format, fmt::format("the picture has {} × {} pixels; {} in all may be "
                                              "taken here",
                                              width, height, max_pixels));
    const std::unique_ptr<unsigned char, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes_of(bytes), size, &width, &height, &channels, 3), std::free);
    if (!pixels) {
        if (std::string_view(stbi_failure_reason()) == "outofmem") throw std::bad_alloc();
        throw Error(not_a_picture);
    }
    Image image(width, height);
    std::memcpy(image.rgb.data(), pixels.get(), image.rgb.size());
    return image;
}

Image load_image(const std::filesystem::path& path, std::int64_t max_pixels) {
    const std::string bytes = read_file(path, max_file_bytes);
    try {
        return decode_image(bytes, max_pixels);
    } catch (Error& error) {
        throw error.at(path.string());
    }
}

}  // namespace scanshade

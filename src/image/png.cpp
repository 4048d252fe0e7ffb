#include "scanshade/image/png.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>

#include "scanshade/base/error.hpp"

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
#define STBI_MAX_DIMENSIONS 16384  // max_image_side, in stb's words
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace scanshade {
namespace {

static_assert(STBI_MAX_DIMENSIONS == max_image_side);

constexpr std::size_t max_file_bytes = std::size_t{1} << 30;

Error write_error(const std::string& file, int reason) {
    return std::move(Error(Errc::file, fmt::format("the picture could not be written ({}); it "
                                                   "needs a folder that exists, with space and "
                                                   "permission to write",
                                                   std::strerror(reason)))
                         .at(file));
}

/// All bytes or an error number.
int write_all(int descriptor, const std::vector<std::uint8_t>& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        done += std::size_t(n);
    }
    return 0;
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
    std::error_code reason;
    const auto size = std::filesystem::file_size(path, reason);
    if (reason)
        throw Error(Errc::file, fmt::format("the picture cannot be read ({})", reason.message()))
            .at(path.string());
    if (size > max_file_bytes)
        throw Error(Errc::format, "the file is too large for a picture; at most 1 GiB is read")
            .at(path.string());
    std::vector<std::uint8_t> bytes(size);
    std::ifstream file(path, std::ios::binary);
    errno = 0;
    if (!file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size)))
        throw Error(Errc::file, fmt::format("the picture cannot be read ({})",
                                            std::strerror(errno ? errno : EIO)))
            .at(path.string());
    return bytes;
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
    if (!png) throw Error(Errc::file, "there is not enough memory to encode the picture as PNG");
    return {png.get(), png.get() + size};
}

void save_png(const Image& image, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = encode_png(image);
    if (path == "-") {
        std::fflush(stdout);
        if (const int reason = write_all(STDOUT_FILENO, bytes))
            throw write_error("standard output", reason);
        return;
    }
    std::error_code ignored;
    const std::filesystem::path real = std::filesystem::canonical(path, ignored);
    const std::filesystem::path& target = ignored ? path : real;  // not a link to it
    const bool device = !ignored && !std::filesystem::is_regular_file(target, ignored);
    const std::string name =
        device ? target.string() : fmt::format("{}.{}.part", target.string(), ::getpid());
    const int flags = O_WRONLY | O_CLOEXEC | (device ? 0 : O_CREAT | O_TRUNC);
    const int descriptor = ::open(name.c_str(), flags, 0666);
    if (descriptor < 0) throw write_error(path.string(), errno);
    int reason = write_all(descriptor, bytes);
    if (::close(descriptor) != 0 && !reason) reason = errno;
    if (!device && !reason && std::rename(name.c_str(), target.c_str()) != 0) reason = errno;
    if (!reason) return;
    if (!device) std::remove(name.c_str());
    throw write_error(path.string(), reason);
}

Image load_image(const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = read_bytes(path);
    const int size = int(bytes.size());
    int width = 0, height = 0, channels = 0;
    const Error not_a_picture(
        Errc::format, "this is no complete picture; PNG, JPEG, BMP and TGA files can be read");
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels))
        throw Error(not_a_picture).at(path.string());
    if (width < 1 || height < 1 || width > max_image_side || height > max_image_side)
        throw Error(Errc::format, fmt::format("the picture has {} × {} pixels; each side must be "
                                              "from 1 to {} pixels",
                                              width, height, max_image_side))
            .at(path.string());
    const std::unique_ptr<unsigned char, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 3), std::free);
    if (!pixels) throw Error(not_a_picture).at(path.string());
    Image image(width, height);
    std::memcpy(image.rgb.data(), pixels.get(), image.rgb.size());
    return image;
}

}  // namespace scanshade

#include "scanshade/image/png.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

std::size_t file_count(const TempFolder& folder) {
    return std::size_t(
        std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()));
}

Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            image.pixel(x, y)[0] = std::uint8_t(x);
            image.pixel(x, y)[1] = std::uint8_t(y);
            image.pixel(x, y)[2] = std::uint8_t(x ^ y);
        }
    return image;
}

void check_error(Errc code, const std::string& part, const std::function<void()>& call) {
    try {
        call();
        FAIL("no error, expected: " << part);
    } catch (const Error& error) {
        CAPTURE(error.what());
        CHECK(error.code() == code);
        CHECK(std::string(error.what()).find(part) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("a picture comes back from its file as it was", "[image][png]") {
    const TempFolder folder;
    const fs::path file = folder.path / "a.png";
    const Image image = gradient(37, 23);
    save_png(image, file);
    const Image back = load_image(file);
    CHECK(back.width == 37);
    CHECK(back.height == 23);
    CHECK(back.rgb == image.rgb);
    save_png(gradient(2, 2), file);  // replaces
    CHECK(load_image(file).width == 2);
    CHECK(file_count(folder) == 1);  // no temporary file stays
}

TEST_CASE("writing through a link keeps the link", "[image][png]") {
    const TempFolder folder;
    save_png(gradient(3, 3), folder.path / "real.png");
    fs::create_symlink("real.png", folder.path / "link.png");
    save_png(gradient(5, 5), folder.path / "link.png");
    CHECK(fs::is_symlink(folder.path / "link.png"));
    CHECK(load_image(folder.path / "real.png").width == 5);
}

TEST_CASE("a picture that cannot be written is an error that says why", "[image][png]") {
    const TempFolder folder;
    const Image image = gradient(4, 4);
    check_error(Errc::file, "No such file or directory",
                [&] { save_png(image, folder.path / "none" / "a.png"); });
    check_error(Errc::file, "Is a directory", [&] { save_png(image, folder.path); });
    if (fs::exists("/dev/full")) {
        check_error(Errc::file, "No space left on device", [&] { save_png(image, "/dev/full"); });
        CHECK(fs::exists("/dev/full"));
    }
    CHECK(file_count(folder) == 0);
}

TEST_CASE("sizes that no PNG writer should see are refused first", "[image][png]") {
    Image image;
    check_error(Errc::usage, "0 × 0", [&] { encode_png(image); });
    image.width = max_image_side + 1;
    image.height = 1;
    check_error(Errc::usage, "16384", [&] { encode_png(image); });
    image.width = -1;
    check_error(Errc::usage, "-1", [&] { encode_png(image); });
}

TEST_CASE("files that are no pictures are refused by name", "[image][png]") {
    const TempFolder folder;
    check_error(Errc::file, "none.png", [&] { load_image(folder.path / "none.png"); });
    check_error(Errc::file, "directory", [&] { load_image(folder.path); });
    for (const std::string& bytes : {std::string(), std::string("not a picture"),
                                     std::string("\x89PNG\r\n\x1a\n"), std::string(4096, '\xff')}) {
        folder.write("bad.png", bytes);
        check_error(Errc::format, "bad.png", [&] { load_image(folder.path / "bad.png"); });
    }
    // Cut off at every length: an error or, within the last bytes, a picture; never a crash.
    const auto png = encode_png(gradient(16, 16));
    for (std::size_t length = 0; length < png.size(); length += 7) {
        folder.write("cut.png", std::string(png.begin(), png.begin() + long(length)));
        try {
            const Image image = load_image(folder.path / "cut.png");
            CHECK(image.width == 16);
        } catch (const Error& error) {
            CHECK(error.code() == Errc::format);
        }
    }
}

TEST_CASE("a header that claims too large a picture is refused before decoding", "[image][png]") {
    const TempFolder folder;
    auto png = encode_png(gradient(1, 1));
    png[16] = 0x00, png[17] = 0x01;  // IHDR: width 65537
    folder.write("wide.png", std::string(png.begin(), png.end()));
    check_error(Errc::format, "wide.png", [&] { load_image(folder.path / "wide.png"); });
}

namespace {

std::string big_endian(std::size_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift & 0xff);
    return bytes;
}

/// A PNG of one row, not compressed; checksums are left 0, which the reader does not mind.
std::string tiny_png(int width, int bit_depth, int colour_type, const std::string& row) {
    const auto chunk = [](const std::string& type, const std::string& data) {
        return big_endian(data.size()) + type + data + big_endian(0);
    };
    const std::string raw = std::string(1, '\0') + row;  // filter: none
    const char low = char(raw.size());
    std::string zlib = "\x78\x01\x01";
    zlib += {low, '\0', char(~low), '\xff'};
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", big_endian(std::size_t(width)) + big_endian(1) + char(bit_depth) +
                             char(colour_type) + std::string(3, '\0')) +
           chunk("IDAT", zlib + raw + big_endian(0)) + chunk("IEND", "");
}

}  // namespace

TEST_CASE("grey is spread, alpha dropped and 16 bits are cut", "[image][png]") {
    const TempFolder folder;
    const fs::path file = folder.path / "tiny.png";
    using Bytes = std::vector<std::uint8_t>;
    folder.write("tiny.png", tiny_png(2, 8, 0, "\x10\xf0"));
    CHECK(load_image(file).rgb == Bytes{16, 16, 16, 240, 240, 240});
    folder.write("tiny.png", tiny_png(1, 8, 6, "\x01\x02\x03\x7f"));
    CHECK(load_image(file).rgb == Bytes{1, 2, 3});
    folder.write("tiny.png", tiny_png(1, 16, 2, "\x01\xff\x02\xff\x03\xff"));
    CHECK(load_image(file).rgb == Bytes{1, 2, 3});
}

TEST_CASE("JPEG, BMP and TGA pictures have the size and mean that another decoder gives",
          "[image][png]") {
    const fs::path models = "/usr/share/assimp/models";
    if (!fs::exists(models)) {
        WARN("skipped: assimp-testmodels is not installed");
        return;
    }
    struct Case {
        const char* file;
        int width, height;
        double mean[3];  // by ImageMagick 6.9
    };
    const Case cases[] = {{"OBJ/wal67ar_small.jpg", 250, 250, {73.74, 65.15, 46.12}},
                          {"IQM/Head.jpg", 512, 512, {53.54, 57.84, 22.07}},
                          {"MD2/sydney.bmp", 308, 193, {40.92, 38.05, 35.83}},
                          {"Collada/duckCM.tga", 512, 512, {233.62, 193.01, 15.68}}};
    for (const Case& c : cases) {
        CAPTURE(c.file);
        const Image image = load_image(models / c.file);
        CHECK(image.width == c.width);
        CHECK(image.height == c.height);
        double sum[3] = {};
        for (std::size_t i = 0; i < image.rgb.size(); ++i) sum[i % 3] += image.rgb[i];
        for (int k = 0; k < 3; ++k)
            CHECK(sum[k] / c.width / c.height == Approx(c.mean[k]).margin(0.3));
    }
}

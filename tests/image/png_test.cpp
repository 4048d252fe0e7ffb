#include "scanshade/image/png.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "support/check_error.hpp"
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
    check_error(Errc::file, "it is a folder", [&] { load_image(folder.path); });
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

/// CRC-32 as PNG has it, bit by bit.
std::size_t crc32(const std::string& bytes) {
    std::uint32_t crc = ~0u;
    for (const char c : bytes) {
        crc ^= std::uint8_t(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

/// A PNG of one row, not compressed; `more` is data that no pixel needs.
std::string tiny_png(int width, int bit_depth, int colour_type, const std::string& row,
                     const std::string& more = {}) {
    const auto chunk = [](const std::string& type, const std::string& data) {
        return big_endian(data.size()) + type + data + big_endian(crc32(type + data));
    };
    const std::string raw = std::string(1, '\0') + row;  // filter: none
    const char low = char(raw.size());
    std::string zlib = "\x78\x01\x01";
    zlib += {low, '\0', char(~low), '\xff'};
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", big_endian(std::size_t(width)) + big_endian(1) + char(bit_depth) +
                             char(colour_type) + std::string(3, '\0')) +
           chunk("IDAT", zlib + raw + big_endian(0) + more) + chunk("IEND", "");
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

TEST_CASE("a PNG file with a wrong bit is refused, wherever the bit is", "[image][png]") {
    const auto png = encode_png(gradient(8, 8));
    const std::string good(png.begin(), png.end());
    REQUIRE(decode_image(good).width == 8);
    constexpr std::size_t last_chunk = 12;  // says only that it is the last
    for (std::size_t bit = 0; bit < 8 * (good.size() - last_chunk); bit += 5) {
        CAPTURE(bit);
        std::string bad = good;
        bad[bit / 8] = char(bad[bit / 8] ^ 1 << bit % 8);
        CHECK_THROWS_AS(decode_image(bad), Error);
    }
}

TEST_CASE("a PNG file whose data begin with an empty chunk is refused", "[image][png]") {
    std::string png = tiny_png(2, 8, 0, "ab");
    png.insert(png.find("IDAT") - 4, big_endian(0) + "IDAT" + big_endian(crc32("IDAT")));
    check_error(Errc::format, "begin with an empty chunk", [&] { decode_image(png); });
}

TEST_CASE("a PNG file that ends in a chunk is refused before room is made for it", "[image][png]") {
    std::string png = tiny_png(2, 8, 0, "ab");
    const std::size_t data = png.find("IDAT") - 4, end = png.find("IEND") - 4;
    const std::string beginning = big_endian(0x7fffff00) + "IDATabcd";
    for (std::size_t size = 1; size < beginning.size(); ++size) {
        CAPTURE(size);
        check_error(Errc::format, "the PNG file is cut off",
                    [&] { decode_image(png.substr(0, end) + beginning.substr(0, size)); });
    }
    png.replace(data, 4, big_endian(0x7fffff00));
    check_error(Errc::format, "the PNG file is cut off", [&] { decode_image(png); });
}

TEST_CASE("a PNG file with far more data than pixels is not unpacked", "[image][png]") {
    CHECK(decode_image(tiny_png(2, 8, 0, "ab", std::string(4000, '\0'))).width == 2);
    check_error(Errc::format, "more data than its pixels",
                [] { decode_image(tiny_png(2, 8, 0, "ab", std::string(5000, '\0'))); });
}

namespace {

std::string little_endian(std::size_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += char(value >> 8 * i & 0xff);
    return out;
}

/// The segments of a JPEG file around one of tables of codes.
std::string jpeg_with_table(std::size_t codes) {
    std::string counts(16, '\0');
    for (std::size_t i = 0, left = codes; left > 0; ++i) {
        const std::size_t n = std::min<std::size_t>(left, 255);
        counts[15 - i] = char(n), left -= n;
    }
    const std::string table = std::string(1, '\0') + counts + std::string(codes, '\0');
    const std::string length = {char((table.size() + 2) >> 8), char((table.size() + 2) & 0xff)};
    return "\xff\xd8\xff\xc4" + length + table;
}

/// A grey JPEG of two blocks whose second brightness is more than 32 bits hold: differences of 2¹⁵ − 1 in
/// steps of 2¹⁶ − 1.
std::string jpeg_of_overflowing_steps(bool has_means = true, bool has_rest = true) {
    const auto segment = [](char marker, const std::string& data) {
        return std::string("\xff") + marker + '\0' + char(data.size() + 2) + data;
    };
    // One code of one bit.
    const auto codes = [&](char table, char symbol) {
        return segment('\xc4', table + std::string("\1") + std::string(15, '\0') + symbol);
    };
    return "\xff\xd8" + segment('\xdb', '\x10' + std::string(128, '\xff')) +
           segment('\xc0', std::string("\x08\0\x08\0\x10\1\1\x11\0", 9)) +
           (has_means ? codes('\0', '\x0f') : "") + (has_rest ? codes('\x10', '\0') : "") +
           segment('\xda', std::string("\1\1\0\0\x3f\0", 6)) +
           std::string("\x7f\xff\0\x3f\xff\0\xbf\xff\xd9", 9);
}

}  // namespace

TEST_CASE("brightness beyond all bounds does not stop the decoder", "[image][png]") {
    CHECK(decode_image(jpeg_of_overflowing_steps()).width == 16);
}

TEST_CASE("a scan without the tables of codes that it names is refused", "[image][png]") {
    for (const bool means : {false, true})
        check_error(Errc::format, "a table of codes is missing",
                    [&] { decode_image(jpeg_of_overflowing_steps(means, !means)); });
}

TEST_CASE("a table of codes that is too long for the decoder does not reach it", "[image][png]") {
    for (const std::size_t codes : {257u, 300u, 16u * 255u})
        check_error(Errc::format, "table of codes is too long",
                    [&] { decode_image(jpeg_with_table(codes)); });
    check_error(Errc::format, "no complete picture", [&] { decode_image(jpeg_with_table(256)); });
    // 256 codes, of 8 and 9 bits.
    std::string shorter = jpeg_with_table(256);
    std::swap(shorter[6 + 15], shorter[6 + 8]), std::swap(shorter[6 + 16], shorter[6 + 9]);
    check_error(Errc::format, "table of codes is too long", [&] { decode_image(shorter); });
    // A table that only begins in its segment.
    std::string begun = jpeg_with_table(300);
    begun[4] = 0, begun[5] = 3;
    check_error(Errc::format, "table of codes is too long", [&] { decode_image(begun); });
    // Also behind a scan, and behind what would be skipped.
    const std::string bad = jpeg_with_table(300).substr(2);
    check_error(Errc::format, "table of codes is too long",
                [&] { decode_image("\xff\xd8\xff\xda" + std::string("\0\4\0b\xff", 5) + bad); });
    check_error(Errc::format, "table of codes is too long",
                [&] { decode_image("\xff\xd8\xff\xe1" + std::string("\0\4ab", 4) + bad); });
}

TEST_CASE("BMP and TGA files that are cut off are refused", "[image][png]") {
    const std::string row(12, '\x40');  // 4 pixels
    const std::string bmp = "BM" + little_endian(78, 4) + little_endian(0, 4) +
                            little_endian(54, 4) + little_endian(40, 4) + little_endian(4, 4) +
                            little_endian(2, 4) + little_endian(1, 2) + little_endian(24, 2) +
                            std::string(24, '\0') + row + row;
    const auto tga = [&](int type, const std::string& pixels) {
        return std::string(2, '\0') + char(type) + std::string(9, '\0') + little_endian(4, 2) +
               little_endian(2, 2) + "\x18" + '\0' + pixels;
    };
    const std::string raw = tga(2, row + row);
    const std::string packed = tga(10,
                                   "\x83"
                                   "abc\x03" +
                                       row);
    for (const std::string& file : {bmp, raw, packed}) {
        CAPTURE(file.size());
        CHECK(decode_image(file).width == 4);
        for (std::size_t size = file.size() - 4; size > 20; --size) {
            CAPTURE(size);
            CHECK_THROWS_AS(decode_image(std::string_view(file).substr(0, size)), Error);
        }
    }
}

TEST_CASE("a picture larger than is allowed is refused by its header", "[image][png]") {
    const std::string png = tiny_png(2, 8, 0, "ab");
    CHECK(decode_image(png, 2).width == 2);
    check_error(Errc::format, "2 × 1", [&] { decode_image(png, 1); });
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
    const std::string jpeg = read_file(models / cases[0].file, 1 << 20);
    for (std::size_t size = jpeg.size() / 2; size < jpeg.size(); size += jpeg.size() / 7)
        check_error(Errc::format, "cut off",
                    [&] { decode_image(std::string_view(jpeg).substr(0, size)); });
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

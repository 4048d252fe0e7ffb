#include "image/picture_file.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>

#include "scanshade/base/error.hpp"
#include "scanshade/image/image.hpp"

namespace scanshade {
namespace {

/// Numbers of one to four bytes at a place of a file; beyond its end bytes are 0.
class Numbers {
public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
    std::size_t byte(std::size_t at) const {
        return at < bytes_.size() ? std::uint8_t(bytes_[at]) : 0;
    }
    std::size_t big_endian(std::size_t at, std::size_t size) const {
        std::size_t n = 0;
        for (std::size_t i = 0; i < size; ++i) n = n << 8 | byte(at + i);
        return n;
    }
    std::size_t little_endian(std::size_t at, std::size_t size) const {
        std::size_t n = 0;
        for (std::size_t i = size; i > 0; --i) n = n << 8 | byte(at + i - 1);
        return n;
    }

private:
    std::string_view bytes_;
};

void require(bool good, const char* sentence) {
    if (!good) throw Error(Errc::format, sentence);
}

constexpr std::array<std::uint32_t, 256> crc_steps = [] {
    std::array<std::uint32_t, 256> steps{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
        steps[byte] = crc;
    }
    return steps;
}();

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = ~0u;
    for (const char byte : bytes) crc = crc >> 8 ^ crc_steps[(crc ^ std::uint8_t(byte)) & 0xff];
    return ~crc;
}

/// Checksums; and no more data than pixels can need, as a thousandth of 4 GiB unpacks to all of them.
void check_png(std::string_view bytes) {
    const Numbers numbers(bytes);
    constexpr std::size_t signature = 8, frame = 12;  // a chunk's length, type and checksum
    constexpr std::size_t largest_pixel = 8, spare = 4096;
    const auto side = [&](std::size_t at) {
        return std::min(numbers.big_endian(at, 4), std::size_t(max_image_side));
    };
    const std::size_t enough = 2 * (side(16) * largest_pixel + 1) * side(20) + spare;
    std::size_t data = 0;
    for (std::size_t at = signature; at < bytes.size();) {
        const std::size_t length = numbers.big_endian(at, 4);
        // stb would first make room for as much as the chunk says it has.
        require(at + frame + length <= bytes.size(), "the PNG file is cut off");
        const std::string_view checked = bytes.substr(at + 4, 4 + length);
        require(crc32(checked) == numbers.big_endian(at + 8 + length, 4),
                "the PNG file is damaged: a checksum is wrong");
        if (checked.starts_with("IDAT")) {
            // stb copies into a place that it makes for the first byte.
            require(length > 0 || data > 0,
                    "the PNG file's data begin with an empty chunk; save it with another program");
            data += length;
        }
        require(data <= enough, "the PNG file has more data than its pixels can need");
        if (checked.starts_with("IEND")) return;
        at += frame + length;
    }
}

/// Which of the 2 × 4 tables of codes of a JPEG file are there: [class and number, as the file has them].
using HuffmanTables = std::bitset<256>;

/// The tables of codes of a JPEG segment of so many bytes: stb writes one of more than 256 codes beyond
/// its array, and takes a code of up to 9 bits for another where its number is 255, which means to it
/// that a code has more bits. A table that begins in the segment is read to its end.
void check_huffman_tables(std::string_view bytes, std::size_t length, HuffmanTables& defined) {
    constexpr std::size_t counts = 16;
    const Numbers numbers(bytes);
    for (std::size_t at = 0; at < length;) {
        std::size_t codes = 0, short_codes = 0;
        for (std::size_t bits = 1; bits <= counts; ++bits) {
            codes += numbers.byte(at + bits);
            if (bits <= 9) short_codes = codes;
        }
        require(codes <= 256 && short_codes <= 255,
                "the JPEG file is damaged: a table of codes is too long");
        defined.set(numbers.byte(at));
        at += 1 + counts + codes;
    }
}

/// A scan's segment from its count of components on. What a scan needs by the first and the last of the
/// coefficients that it has: a table for the mean of a block, one for the rest, or both. Refining means
/// needs none.
void check_scan(std::string_view bytes, const HuffmanTables& defined) {
    constexpr std::size_t class_of_rest = 0x10;
    const Numbers numbers(bytes);
    const std::size_t components = numbers.byte(0), after = 1 + 2 * components;
    const bool refines = numbers.byte(after + 2) >> 4 != 0;
    const bool means = numbers.byte(after) == 0 && !refines, rest = numbers.byte(after + 1) > 0;
    for (std::size_t i = 0; i < components; ++i) {
        const std::size_t table = numbers.byte(2 + 2 * i);
        require((!means || defined[table >> 4]) && (!rest || defined[class_of_rest | (table & 15)]),
                "the JPEG file is damaged: a table of codes is missing");
    }
}

/// Up to the first scan a segment's length leads to the next one, for stb as well; behind, whatever
/// looks like a table is held to be one.
void check_jpeg(std::string_view bytes) {
    enum : std::size_t { tables = 0xc4, start = 0xd8, end = 0xd9, scan = 0xda };
    const Numbers numbers(bytes);
    bool header = true;
    HuffmanTables defined;
    for (std::size_t at = 0; at + 2 <= bytes.size();) {
        const std::size_t marker = numbers.byte(at + 1), length = numbers.big_endian(at + 2, 2);
        const bool marked = numbers.byte(at) == 0xff && marker != 0 && marker != 0xff;
        const std::string_view segment = bytes.substr(std::min(at + 4, bytes.size()));
        if (marked && marker == tables && length > 2)
            check_huffman_tables(segment, length - 2, defined);
        if (marked && marker == scan) {
            check_scan(segment, defined);
            header = false;
        }
        if (marked && marker == end && !header) return;
        at += header && marked && marker != start ? 2 + length : 1;
    }
    require(header, "the JPEG file is cut off");  // without a scan it is none for stb
}

/// Rows of pixels that are not packed; stb takes what is missing for black.
void check_bmp(std::string_view bytes) {
    const Numbers numbers(bytes);
    const bool old = numbers.little_endian(14, 4) == 12;
    const auto side = [&](std::size_t at) {
        const auto n = std::int32_t(numbers.little_endian(at, 4));  // negative: from the top
        return std::size_t(n < 0 ? -std::int64_t(n) : n);
    };
    const std::size_t width = old ? numbers.little_endian(18, 2) : side(18);
    const std::size_t height = old ? numbers.little_endian(20, 2) : side(22);
    const std::size_t bits = numbers.little_endian(old ? 24 : 28, 2);
    if (width > std::size_t(max_image_side) || height > std::size_t(max_image_side)) return;
    const std::size_t padding = 3, rows = (width * bits + 31) / 32 * 4 * height;
    require(numbers.little_endian(10, 4) + rows <= bytes.size() + padding,
            "the BMP file is cut off");
}

/// Pixels as they are, or in packets of a first byte for up to 128 pixels.
void check_tga(std::string_view bytes) {
    const Numbers numbers(bytes);
    const std::size_t type = numbers.byte(2), packed = 8;
    if ((type & ~packed) < 1 || (type & ~packed) > 3) return;
    const std::size_t pixel = (numbers.byte(16) + 7) / 8;
    std::size_t left = numbers.little_endian(12, 2) * numbers.little_endian(14, 2);
    std::size_t at = 18 + numbers.byte(0);
    if (numbers.byte(1) == 1) at += numbers.little_endian(5, 2) * ((numbers.byte(7) + 7) / 8);
    for (; (type & packed) != 0 && left > 0 && at < bytes.size(); ++at) {
        const std::size_t count = std::min(left, (numbers.byte(at) & 0x7f) + 1);
        at += (numbers.byte(at) & 0x80) != 0 ? pixel : count * pixel;
        left -= count;
    }
    require(
        (type & packed) != 0 ? left == 0 && at <= bytes.size() : at + left * pixel <= bytes.size(),
        "this is no picture, or a TGA file that is cut off");
}

}  // namespace

void check_picture_file(std::string_view bytes) {
    if (bytes.starts_with('\x89')) return check_png(bytes);
    if (bytes.starts_with('\xff')) return check_jpeg(bytes);
    if (bytes.starts_with("BM")) return check_bmp(bytes);
    check_tga(bytes);
}

}  // namespace scanshade

// Pictures as textures: decoded, made smaller, looked up; and what is written is read again.
#include "fuzz/fuzz.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/image/texture.hpp"

using namespace scanshade;

namespace {

/// CRC-32 as PNG has it.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t crc = ~0u;
    for (const char c : bytes) {
        crc ^= std::uint8_t(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

/// With right checksums, which no fuzzer finds.
std::string mended(std::string png) {
    constexpr std::size_t signature = 8;
    const auto byte = [&](std::size_t at) { return std::uint32_t(std::uint8_t(png[at])); };
    for (std::size_t at = signature; at + 12 <= png.size();) {
        const std::size_t length =
            byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
        if (length > png.size() - at - 12) break;
        const std::uint32_t crc = checksum(std::string_view(png).substr(at + 4, 4 + length));
        for (std::size_t i = 0; i < 4; ++i)
            png[at + 8 + length + i] = char(crc >> (24 - 8 * i) & 0xff);
        at += 12 + length;
    }
    return png;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::int64_t most_pixels = 1 << 16;
    std::string bytes(text_of(data, size));
    if (bytes.starts_with("\x89PNG")) bytes = mended(std::move(bytes));
    try {
        const Image image = decode_image(bytes, most_pixels);
        const Texture texture = make_texture(image, "fuzz");
        for (const float step : {0.0f, 0.1f, 100.0f})
            for (const float value : texture.sample(0.3f, -7.7f, {step, 0, 0, step}))
                if (!(value >= 0 && value <= 1)) broken("a texture's values are those of bytes");
        const std::vector<std::uint8_t> png = encode_png(image);
        if (decode_image(text_of(png.data(), png.size())).rgb != image.rgb)
            broken("a picture comes back from its file as it was");
    } catch (const Error& error) {
        check_sentence(error);
    }
    return 0;
}

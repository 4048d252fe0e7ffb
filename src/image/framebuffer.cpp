#include "scanshade/image/framebuffer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

/// The smallest float whose double formula rounds to each byte, by bisection: positive floats are in
/// the order of their bits.
std::array<float, 257> make_srgb_starts() {
    std::array<float, 257> start{};
    for (std::size_t byte = 1; byte < 256; ++byte) {
        std::uint32_t low = 0, high = std::bit_cast<std::uint32_t>(1.0f);
        while (low < high) {
            const std::uint32_t middle = low + (high - low) / 2;
            if (255 * srgb_encode(double(std::bit_cast<float>(middle))) + 0.5 >= double(byte))
                high = middle;
            else
                low = middle + 1;
        }
        start[byte] = std::bit_cast<float>(low);
    }
    start[256] = INFINITY;
    return start;
}

/// The byte of a value in [0, 1] by a search that a table of guesses makes short.
class SrgbBytes {
public:
    SrgbBytes() {
        std::uint8_t byte = 0;
        for (std::size_t cell = 0; cell < cells; ++cell)
            byte = guess_[cell] = search(float(cell) / float(cells), byte);
    }
    std::uint8_t operator()(float x) const {
        return search(x, guess_[std::min(std::size_t(x * float(cells)), cells - 1)]);
    }

private:
    static constexpr std::size_t cells = 4096;
    std::uint8_t search(float x, std::uint8_t byte) const {
        while (x >= start_[byte + 1u]) ++byte;
        return byte;
    }
    const std::array<float, 257>& start_ = srgb_byte_starts();
    std::array<std::uint8_t, cells> guess_{};
};

}  // namespace

const std::array<float, 257>& srgb_byte_starts() {
    static const std::array<float, 257> starts = make_srgb_starts();
    return starts;
}

Framebuffer::Framebuffer(int w, int h) : width(w), height(h) {
    SCANSHADE_CHECK(w > 0 && h > 0 && w <= max_image_side && h <= max_image_side);
    const std::size_t pixels = std::size_t(w) * std::size_t(h);
    for (std::vector<float>* plane : {&r, &g, &b, &depth}) plane->resize(pixels);
    id.assign(pixels, no_triangle);
}

Image to_image(const PixelBuffer& pixels) {
    Image image(pixels.width, pixels.height);
    for (std::size_t i = 0; i < pixels.rgba().size(); ++i)
        std::memcpy(&image.rgb[3 * i], &pixels.rgba()[i], 3);
    return image;
}

namespace {

/// Calls put(pixel, channel, byte) for all of a frame.
template <class Put>
void encode_with(const Framebuffer& frame, Transfer transfer, double exposure_ev, Put&& put) {
    static const SrgbBytes srgb;
    const float scale = static_cast<float>(std::exp2(exposure_ev));
    const std::vector<float>* const planes[3] = {&frame.r, &frame.g, &frame.b};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::vector<float>& plane = *planes[channel];
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const float exposed = plane[i] * scale;
            const float value = exposed > 0 ? std::min(exposed, 1.0f) : 0;  // NaN is not > 0
            put(i, channel,
                transfer == Transfer::srgb ? srgb(value) : std::uint8_t(value * 255.0f + 0.5f));
        }
    }
}

}  // namespace

Image encode(const Framebuffer& frame, Transfer transfer, double exposure_ev) {
    Image image(frame.width, frame.height);
    encode_with(frame, transfer, exposure_ev,
                [&](std::size_t i, std::size_t channel, std::uint8_t byte) {
                    image.rgb[3 * i + channel] = byte;
                });
    return image;
}

void encode(const Framebuffer& frame, Transfer transfer, double exposure_ev, PixelBuffer& into) {
    LargeVector<std::uint32_t>& rgba = into.edit();
    std::fill(rgba.begin(), rgba.end(), 0xff000000u);
    encode_with(frame, transfer, exposure_ev,
                [&](std::size_t i, std::size_t channel, std::uint8_t byte) {
                    rgba[i] |= std::uint32_t(byte) << (8 * channel);
                });
}

}  // namespace scanshade

#include "scanshade/image/framebuffer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

std::uint8_t to_byte(double fraction) { return std::uint8_t(255 * fraction + 0.5); }

/// The byte of the double formula to_byte(srgb_encode(x)) without a power a pixel: the smallest x
/// of each byte is found once, by bisection with the formula itself.
class SrgbBytes {
public:
    SrgbBytes() {
        for (std::size_t byte = 1; byte < 256; ++byte) start_[byte] = smallest(byte);
        std::uint8_t byte = 0;
        for (std::size_t cell = 0; cell < cells; ++cell)
            byte = guess_[cell] = search(double(cell) / cells, byte);
    }

    /// x in [0, 1].
    std::uint8_t operator()(double x) const {
        return search(x, guess_[std::min(std::size_t(x * cells), cells - 1)]);
    }

private:
    static constexpr std::size_t cells = 4096;

    std::uint8_t search(double x, std::uint8_t byte) const {
        while (byte < 255 && x >= start_[byte + 1u]) ++byte;
        return byte;
    }

    /// Positive doubles are in the order of their bits.
    static double smallest(std::size_t byte) {
        std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(1.0);
        while (low < high) {
            const std::uint64_t middle = low + (high - low) / 2;
            if (to_byte(srgb_encode(std::bit_cast<double>(middle))) >= byte)
                high = middle;
            else
                low = middle + 1;
        }
        return std::bit_cast<double>(low);
    }

    std::array<double, 256> start_{};
    std::array<std::uint8_t, cells> guess_{};
};

}  // namespace

Framebuffer::Framebuffer(int w, int h) : width(w), height(h) {
    SCANSHADE_CHECK(w > 0 && h > 0 && w <= max_image_side && h <= max_image_side);
    const std::size_t pixels = std::size_t(w) * std::size_t(h);
    for (std::vector<float>* plane : {&r, &g, &b, &depth}) plane->resize(pixels);
    id.assign(pixels, no_triangle);
}

Image encode(const Framebuffer& frame, Transfer transfer, double exposure_ev) {
    static const SrgbBytes srgb;
    Image image(frame.width, frame.height);
    const double scale = std::exp2(exposure_ev);
    const std::vector<float>* const planes[3] = {&frame.r, &frame.g, &frame.b};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::vector<float>& plane = *planes[channel];
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const double exposed = double(plane[i]) * scale;
            const double value = exposed > 0 ? std::min(exposed, 1.0) : 0;  // NaN is not > 0
            image.rgb[3 * i + channel] = transfer == Transfer::srgb ? srgb(value) : to_byte(value);
        }
    }
    return image;
}

}  // namespace scanshade

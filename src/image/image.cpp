#include "scanshade/image/image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/same_size.hpp"

namespace scanshade {

ImageDiff diff(const Image& a, const Image& b) {
    check_same_size(a, b);
    ImageDiff result;
    result.picture = Image(a.width, a.height);
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        int largest = 0;
        for (std::size_t k = i; k < i + 3; ++k) {
            const int delta = std::abs(int(a.rgb[k]) - int(b.rgb[k]));
            result.picture.rgb[k] = std::uint8_t(delta);
            largest = std::max(largest, delta);
        }
        result.max_delta = std::max(result.max_delta, largest);
        result.count += largest > 0;
    }
    if (result.max_delta > 0)
        for (std::uint8_t& byte : result.picture.rgb)
            byte = std::uint8_t(byte * 255 / result.max_delta);
    return result;
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace scanshade

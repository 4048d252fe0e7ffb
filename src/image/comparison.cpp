// Two pictures ready to be measured: linear, encoded, and maps on demand.
#include <algorithm>
#include <cmath>
#include <optional>

#include "image/flip.hpp"
#include "image/same_size.hpp"
#include "image/ssim.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/image/metrics.hpp"

namespace scanshade {

struct Comparison::State {
    int width, height;
    Side picture, reference;
    std::vector<std::uint8_t> bad;  // a value is not finite
    std::size_t bad_count = 0;
    std::array<std::optional<Plane>, 3> ssim;
    std::optional<Plane> flip;
};

namespace {

/// As encode() shows it, before rounding to bytes; NaN stays.
float encoded(float linear, float scale, Transfer transfer) {
    const float exposed = linear * scale;
    if (std::isnan(exposed)) return exposed;
    const float value = std::clamp(exposed, 0.0f, 1.0f);
    return transfer == Transfer::srgb ? float(srgb_encode(double(value))) : value;
}

Comparison::Side side_of(const Framebuffer& frame, Transfer transfer, double exposure_ev) {
    Comparison::Side side{{frame.r, frame.g, frame.b}, {}};
    const float scale = static_cast<float>(std::exp2(exposure_ev));
    for (std::size_t c = 0; c < 3; ++c) {
        side.encoded[c].resize(side.linear[c].size());
        parallel_for(side.linear[c].size(), 4096, 0, [&](std::size_t i, std::size_t end, int) {
            for (; i < end; ++i) side.encoded[c][i] = encoded(side.linear[c][i], scale, transfer);
        });
    }
    return side;
}

Comparison::Side side_of(const Image& image) {
    std::array<float, 256> linear;
    for (std::size_t byte = 0; byte < 256; ++byte)
        linear[byte] = float(srgb_decode(double(byte) / 255));
    Comparison::Side side;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = c; i < image.rgb.size(); i += 3) {
            side.linear[c].push_back(linear[image.rgb[i]]);
            side.encoded[c].push_back(float(image.rgb[i]) / 255.0f);
        }
    return side;
}

}  // namespace

Comparison::Comparison(const Framebuffer& picture, const Framebuffer& reference, Transfer transfer,
                       double exposure_ev)
    : state_(std::make_unique<State>()) {
    check_same_size(picture, reference);
    state_->width = picture.width, state_->height = picture.height;
    state_->picture = side_of(picture, transfer, exposure_ev);
    state_->reference = side_of(reference, transfer, exposure_ev);
    state_->bad.resize(picture.r.size());
    for (const Side* side : {&state_->picture, &state_->reference})
        for (const Plane& plane : side->linear)
            for (std::size_t i = 0; i < plane.size(); ++i)
                state_->bad[i] |= !std::isfinite(plane[i]);
    state_->bad_count =
        std::size_t(std::count(state_->bad.begin(), state_->bad.end(), std::uint8_t{1}));
}

Comparison::Comparison(const Image& picture, const Image& reference)
    : state_(std::make_unique<State>()) {
    check_same_size(picture, reference);
    state_->width = picture.width, state_->height = picture.height;
    state_->picture = side_of(picture);
    state_->reference = side_of(reference);
}

Comparison::~Comparison() = default;
Comparison::Comparison(Comparison&&) noexcept = default;
Comparison& Comparison::operator=(Comparison&&) noexcept = default;

int Comparison::width() const { return state_->width; }
int Comparison::height() const { return state_->height; }
const Comparison::Side& Comparison::picture() const { return state_->picture; }
const Comparison::Side& Comparison::reference() const { return state_->reference; }

const Comparison::Plane& Comparison::ssim_map(std::size_t channel) const {
    std::optional<Plane>& map = state_->ssim[channel];
    if (!map)
        map = scanshade::ssim_map(picture().encoded[channel], reference().encoded[channel], width(),
                                  height());
    return *map;
}

const Comparison::Plane& Comparison::flip_map() const {
    std::optional<Plane>& map = state_->flip;
    if (!map) map = scanshade::flip_map(picture().encoded, reference().encoded, width(), height());
    return *map;
}

std::size_t Comparison::not_finite(const Mask* mask) const {
    if (!mask || state_->bad_count == 0) return state_->bad_count;
    std::size_t count = 0;
    for (std::size_t i = 0; i < state_->bad.size(); ++i) count += state_->bad[i] && mask->inside[i];
    return count;
}

}  // namespace scanshade

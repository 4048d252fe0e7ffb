#include "report/reference_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "scanshade/base/error.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade {

std::optional<std::size_t> allowed_faults(std::size_t checked, double share, double confidence) {
    SCANSHADE_CHECK(share > 0 && share < 1 && confidence > 0 && confidence < 1);
    // P(X = k) by its logarithm: (1 − share)^checked may be too small for a double.
    double log_probability = double(checked) * std::log1p(-share), at_most = 0;
    std::optional<std::size_t> allowed;
    for (std::size_t k = 0; k <= checked; ++k) {
        at_most += std::exp(log_probability);
        if (at_most > 1 - confidence) break;
        allowed = k;
        log_probability += std::log(double(checked - k) / double(k + 1) * share / (1 - share));
    }
    return allowed;
}

namespace {

/// `count` of the values, each as likely as any other, in ascending order.
std::vector<std::size_t> random_part(std::vector<std::size_t> values, std::size_t count) {
    if (values.size() <= count) return values;
    std::mt19937_64 random(1);
    for (std::size_t i = 0; i < count; ++i)  // std::shuffle differs between libraries
        std::swap(values[i], values[i + random() % (values.size() - i)]);
    values.resize(count);
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace

ReferenceCheck::ReferenceCheck(const Scene& scene, const Settings& reference,
                               const Framebuffer& shown)
    : transfer_(reference.transfer), exposure_ev_(reference.exposure_ev) {
    std::vector<std::size_t> visible;
    for (std::size_t i = 0; i < shown.id.size(); ++i)
        if (shown.id[i] != Framebuffer::no_triangle) visible.push_back(i);
    covered_ = visible.size();
    pixels_ = random_part(std::move(visible), checked_pixels);
    if (pixels_.empty()) return;

    Mask mask(shown.width, shown.height);
    for (std::size_t i : pixels_) mask.inside[i] = 1;
    Framebuffer frame;
    Renderer(scene, reference).draw(frame, mask);
    reference_ = bytes_of(frame);
}

std::size_t ReferenceCheck::allowed() const {
    if (checked() == covered())  // all of them: no chance in it
        return std::size_t(std::floor(double(checked()) * allowed_share));
    return *allowed_faults(checked(), allowed_share, promised_confidence);
}

std::size_t ReferenceCheck::off(const Framebuffer& picture, double levels) const {
    if (pixels_.empty()) return 0;
    const Image bytes = bytes_of(picture);
    std::size_t count = 0;
    for (std::size_t i = 0; i < bytes.rgb.size(); i += 3) {
        int largest = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            largest = std::max(largest, std::abs(int(bytes.rgb[k]) - int(reference_.rgb[k])));
        count += double(largest) > levels;
    }
    return count;
}

Image ReferenceCheck::bytes_of(const Framebuffer& frame) const {
    Framebuffer row(int(pixels_.size()), 1);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        row.r[i] = frame.r[pixels_[i]];
        row.g[i] = frame.g[pixels_[i]];
        row.b[i] = frame.b[pixels_[i]];
    }
    return encode(row, transfer_, exposure_ev_);
}

}  // namespace scanshade

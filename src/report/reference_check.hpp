// Compares pictures with the reference at a random sample of their pixels.
#pragma once

#include <optional>
#include <vector>

#include "scanshade/image/framebuffer.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// What a picture promises: at most this share of its covered pixels is faulty, with at least that
/// confidence. 8192 pixels are the fewest, as a power of two, whose being all right proves it.
inline constexpr double allowed_share = 0.001, promised_confidence = 0.999;
inline constexpr std::size_t checked_pixels = 8192;

/// How many of `checked` things, drawn at random, may be faulty so that at most `share` of all of
/// them are, with at least `confidence`: the largest k with P(X ≤ k) ≤ 1 − confidence, where X is
/// binomial. Nothing where even k = 0 does not prove it.
std::optional<std::size_t> allowed_faults(std::size_t checked, double share, double confidence);

class ReferenceCheck {
public:
    /// Draws checked_pixels of the pixels that have an id in `shown`, all where there are no more,
    /// by `reference`, settings of a scalar renderer. Which they are depends on the ids alone.
    ReferenceCheck(const Scene& scene, const Settings& reference, const Framebuffer& shown);

    std::size_t covered() const { return covered_; }
    std::size_t checked() const { return pixels_.size(); }
    std::size_t allowed() const;  // faults among them

    /// Checked pixels whose bytes are more than `levels` off in some channel.
    std::size_t off(const Framebuffer& picture, double levels) const;

private:
    Image bytes_of(const Framebuffer& frame) const;  // a row of the checked pixels

    Transfer transfer_;
    double exposure_ev_;
    std::size_t covered_ = 0;
    std::vector<std::size_t> pixels_;  // ascending
    Image reference_;
};

}  // namespace scanshade

// Times of things that are compared with each other.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scanshade/render/renderer.hpp"

namespace scanshade {

/// At least one value.
double median(std::vector<double> values);

struct Times {
    double median = 0, min = 0;  // ms
    std::size_t runs = 0;
};
Times times_of(const std::vector<double>& ms);

/// The median of differences, and an interval that holds the true one with at least 95 %
/// confidence, whatever their distribution. With fewer than 6 values it is that of all values.
struct Difference {
    double median = 0, low = 0, high = 0;  // ms

    /// 0 is in the interval: there may be no difference at all.
    bool is_noise() const { return low <= 0 && high >= 0; }
};

/// a[i] − b[i], where run i of both took place at about the same time. As many of each, at least 1.
Difference paired_difference(const std::vector<double>& a, const std::vector<double>& b);

/// How often each of the things to compare is run.
struct Rounds {
    std::size_t warm_ups = 1, runs = 9;
    std::uint64_t seed = 1;
};

/// [subject][run]
using FrameTable = std::vector<std::vector<FrameStats>>;

/// Runs all subjects once in every round, so that a machine that gets slower or hotter meanwhile
/// does so for all of them; in an order that the seed shuffles anew each round, so that none always
/// finds the caches as the same other one left them. Ends early, after a whole round, when
/// `stopped`; then all subjects have the same smaller number of runs, perhaps none.
FrameTable time_interleaved(std::span<const std::function<FrameStats()>> subjects,
                            const Rounds& rounds, const std::function<bool()>& stopped);

/// One number of each frame.
template <class Number>
std::vector<double> of_frames(const std::vector<FrameStats>& frames, Number number) {
    std::vector<double> values;
    for (const FrameStats& frame : frames) values.push_back(number(frame));
    return values;
}

inline std::vector<double> frame_ms(const std::vector<FrameStats>& frames) {
    return of_frames(frames, [](const FrameStats& frame) { return frame.frame_ms; });
}

}  // namespace scanshade

#include "scanshade/report/timing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

/// How many of n sorted values may be cut off at each end so that the rest still holds the true
/// median with 95 % confidence: each value is below it with probability 1/2.
std::size_t cut_off(std::size_t n) {
    double probability = std::pow(0.5, double(n));  // of exactly k values below
    double below = probability;                     // of at most k
    std::size_t k = 0;
    for (; below <= 0.025 && k < n / 2; ++k) {
        probability *= double(n - k) / double(k + 1);
        below += probability;
    }
    return k == 0 ? 0 : k - 1;
}

}  // namespace

double median(std::vector<double> values) {
    SCANSHADE_CHECK(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Times times_of(const std::vector<double>& ms) {
    return {median(ms), *std::min_element(ms.begin(), ms.end()), ms.size()};
}

Difference paired_difference(const std::vector<double>& a, const std::vector<double>& b) {
    SCANSHADE_CHECK(a.size() == b.size());
    std::vector<double> differences(a.size());
    std::transform(a.begin(), a.end(), b.begin(), differences.begin(), std::minus<>());
    const double middle = median(differences);
    std::sort(differences.begin(), differences.end());
    const std::size_t cut = cut_off(differences.size());
    return {middle, differences[cut], differences[differences.size() - 1 - cut]};
}

FrameTable time_interleaved(std::span<const std::function<FrameStats()>> subjects,
                            const Rounds& rounds, const std::function<bool()>& stopped) {
    FrameTable frames(subjects.size());
    std::vector<std::size_t> order(subjects.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 random(rounds.seed);
    for (std::size_t round = 0; round < rounds.warm_ups + rounds.runs; ++round) {
        if (stopped()) break;
        for (std::size_t i = order.size(); i > 1; --i)  // std::shuffle differs between libraries
            std::swap(order[i - 1], order[random() % i]);
        for (const std::size_t subject : order) {
            FrameStats frame = subjects[subject]();
            if (round >= rounds.warm_ups) frames[subject].push_back(std::move(frame));
        }
    }
    return frames;
}

}  // namespace scanshade

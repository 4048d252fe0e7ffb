// Fits and times of reports.
#include <algorithm>
#include <cmath>

#include "scanshade/report/fit.hpp"
#include "scanshade/report/timing.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

TEST_CASE("a power law without noise is found exactly, with an interval of no width", "[report]") {
    std::vector<double> x, y;
    for (int i = 0; i < 6; ++i) {
        x.push_back(std::exp2(i));
        y.push_back(3 * std::pow(x.back(), 1.25));
    }
    const auto fit = fit_power(x, y);
    REQUIRE(fit);
    CHECK(fit->slope.value == Approx(1.25));
    CHECK(fit->slope.low == Approx(1.25));
    CHECK(fit->slope.high == Approx(1.25));
    CHECK(fit->constant.value == Approx(3));
    CHECK(fit->points == 6);
}

TEST_CASE("a line is found with its constant, however different the sizes", "[report]") {
    const std::vector<double> x{1, 1e2, 1e4, 1e6};
    std::vector<double> y;
    for (const double value : x) y.push_back(0.5 + 2e-3 * value);
    const auto fit = fit_line(x, y);
    REQUIRE(fit);
    CHECK(fit->constant.value == Approx(0.5));
    CHECK(fit->slope.value == Approx(2e-3));
}

TEST_CASE("the interval of a fit is that of a worked example", "[report]") {
    // By hand: y = 1, 2, 2 over x = 1, 2, 3 has slope 1/2 and residuals -1/6, 1/3, -1/6; the rest
    // is 1/6 with one degree of freedom, so the half width is 12.706 √(1/6 / 2).
    const std::vector<double> x{std::exp(1), std::exp(2), std::exp(3)};
    const auto fit = fit_power(x, {std::exp(1), std::exp(2), std::exp(2)});
    REQUIRE(fit);
    CHECK(fit->slope.value == Approx(0.5));
    CHECK(fit->slope.high - fit->slope.value == Approx(12.706 * std::sqrt(1.0 / 12)));
    CHECK(fit->slope.value - fit->slope.low == Approx(12.706 * std::sqrt(1.0 / 12)));
}

TEST_CASE("intervals of fits hold the truth in 95 of 100 noisy trials", "[report]") {
    for (const int points : {4, 6, 12}) {
        Rng random(42);
        int held = 0;
        constexpr int trials = 2000;
        for (int t = 0; t < trials; ++t) {
            std::vector<double> x, y;
            for (int i = 0; i < points; ++i) {
                // The sum of twelve is close to a normal deviate.
                double noise = -6;
                for (int k = 0; k < 12; ++k) noise += random.real(0, 1);
                x.push_back(std::exp2(i));
                y.push_back(2 * std::pow(x.back(), 0.7) * std::exp(0.1 * noise));
            }
            const auto fit = fit_power(x, y);
            REQUIRE(fit);
            held += fit->slope.low <= 0.7 && fit->slope.high >= 0.7;
        }
        CAPTURE(points, held);
        CHECK(held > 0.935 * trials);
        CHECK(held < 0.965 * trials);
    }
}

TEST_CASE("too few points, or all at one place, have no fit", "[report]") {
    CHECK_FALSE(fit_power({1, 2}, {1, 2}));
    CHECK_FALSE(fit_power({2, 2, 2}, {1, 2, 3}));
    CHECK_FALSE(fit_power({0, 1, 2}, {1, 2, 3}));
    CHECK_FALSE(fit_power({1, 2, 3}, {0, 1, 2}));
    CHECK_FALSE(fit_line({1, 2, 3}, {0, 1, 2}));
    CHECK_FALSE(fit_line({5, 5, 5}, {1, 1, 1}));
    CHECK_FALSE(fit_power({}, {}));
}

TEST_CASE("medians, and times from them", "[report]") {
    CHECK(median({3, 1, 2}) == 2);
    CHECK(median({4, 1, 3, 2}) == 2.5);
    CHECK(median({7}) == 7);
    const Times times = times_of({5, 1, 3});
    CHECK(times.median == 3);
    CHECK(times.min == 1);
    CHECK(times.runs == 3);
}

TEST_CASE("paired differences: which values bound the median with 95 % confidence", "[report]") {
    // From tables of the sign test: of 6 values the extremes, of 9 the second, of 20 the sixth.
    const struct {
        int n, rank;
    } rows[] = {{6, 1}, {8, 1}, {9, 2}, {12, 3}, {15, 4}, {20, 6}, {25, 8}, {1, 1}, {5, 1}};
    for (const auto& row : rows) {
        std::vector<double> a, b;
        for (int i = 1; i <= row.n; ++i) a.push_back(10 * i + i), b.push_back(10 * i);
        const Difference d = paired_difference(a, b);
        CAPTURE(row.n);
        CHECK(d.low == row.rank);
        CHECK(d.high == row.n + 1 - row.rank);
        CHECK(d.median == (row.n + 1) / 2.0);
        CHECK_FALSE(d.is_noise());
    }
    CHECK(paired_difference({1, 2, 1, 2, 1, 2}, {2, 1, 2, 1, 2, 1}).is_noise());
}

TEST_CASE("subjects take turns: each once a round, in orders that the seed decides", "[report]") {
    const auto order_of = [](std::uint64_t seed) {
        std::vector<int> order;
        std::vector<std::function<FrameStats()>> subjects;
        for (int s = 0; s < 3; ++s)
            subjects.emplace_back([&order, s] {
                order.push_back(s);
                FrameStats stats;
                stats.frame_ms = double(order.size());
                return stats;
            });
        const FrameTable frames = time_interleaved(subjects, {2, 5, seed}, [] { return false; });
        for (const auto& runs : frames) CHECK(runs.size() == 5);
        CHECK(frames[0][0].frame_ms > 6);  // warm-ups are not kept
        return order;
    };
    const std::vector<int> order = order_of(1);
    REQUIRE(order.size() == 3 * 7);
    for (std::size_t round = 0; round < 7; ++round) {
        std::vector<int> now(order.begin() + long(3 * round), order.begin() + long(3 * round + 3));
        std::sort(now.begin(), now.end());
        CHECK(now == std::vector<int>{0, 1, 2});
    }
    CHECK(order == order_of(1));
    CHECK(order != order_of(2));
}

TEST_CASE("a stopped measurement ends after a whole round", "[report]") {
    int drawn = 0;
    const std::function<FrameStats()> subject = [&] { return ++drawn, FrameStats{}; };
    const std::function<FrameStats()> subjects[] = {subject, subject};
    const FrameTable frames = time_interleaved(subjects, {1, 100, 1}, [&] { return drawn >= 7; });
    CHECK(drawn == 8);
    CHECK(frames[0].size() == 3);
    CHECK(frames[1].size() == 3);
}

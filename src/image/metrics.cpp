// The table of measures.
#include "scanshade/image/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade {
namespace {

using Side = Comparison::Side;
using Space = Comparison::Planes Side::*;

double difference(const Comparison& pair, Space space, std::size_t channel, std::size_t i) {
    return double((pair.picture().*space)[channel][i]) -
           double((pair.reference().*space)[channel][i]);
}

/// The mean of error(channel) over channels.
template <class Error>
double mean(Channels channels, Error&& error) {
    double sum = 0;
    for (std::size_t c = channels.first; c < channels.last; ++c) sum += error(c);
    return sum / double(channels.last - channels.first);
}

template <class Error>
double largest(Channels channels, Error&& error) {
    double result = 0;
    for (std::size_t c = channels.first; c < channels.last; ++c)
        result = std::max(result, error(c));
    return result;
}

double absolute(const Comparison& pair, Channels channels, std::size_t i) {
    return mean(channels,
                [&](std::size_t c) { return std::abs(difference(pair, &Side::linear, c, i)); });
}

template <Space space>
double squared(const Comparison& pair, Channels channels, std::size_t i) {
    return mean(channels, [&](std::size_t c) {
        const double d = difference(pair, space, c, i);
        return d * d;
    });
}

double largest_absolute(const Comparison& pair, Channels channels, std::size_t i) {
    return largest(channels,
                   [&](std::size_t c) { return std::abs(difference(pair, &Side::linear, c, i)); });
}

/// 1 where a channel is off by more than a level. Levels of bytes are a whole number apart, to some
/// 1e-5 in float.
double over_one_level(const Comparison& pair, Channels channels, std::size_t i) {
    return largest(channels, [&](std::size_t c) {
        return std::abs(difference(pair, &Side::encoded, c, i)) * 255 > 1.0001 ? 1.0 : 0.0;
    });
}

/// Against the reference's square, and 0.01 so that black does not divide by 0.
double relative_squared(const Comparison& pair, Channels channels, std::size_t i) {
    return mean(channels, [&](std::size_t c) {
        const double d = difference(pair, &Side::linear, c, i);
        const double reference = double(pair.reference().linear[c][i]);
        return d * d / (reference * reference + 0.01);
    });
}

double structural(const Comparison& pair, Channels channels, std::size_t i) {
    return mean(channels, [&](std::size_t c) { return double(pair.ssim_map(c)[i]); });
}

double flip(const Comparison& pair, Channels, std::size_t i) { return double(pair.flip_map()[i]); }

double same(double x) { return x; }
double root(double x) { return std::sqrt(x); }
double percent(double x) { return 100 * x; }
double from_one(double x) { return 1 - x; }
/// Of a mean square, for a peak of 1.
double decibels(double mean_square) { return -10 * std::log10(mean_square); }

constexpr Metric metrics[] = {
    {"mae", "mean absolute error", "MAE", "1", "linear", Better::lower, true, "mean of |a − r|",
     absolute, Pool::mean, same, same},
    {"rmse", "root mean square error", "RMSE", "1", "linear", Better::lower, true,
     "square root of the mean of (a − r)²", squared<&Side::linear>, Pool::mean, root, root},
    {"psnr", "peak signal to noise ratio", "PSNR", "dB", "encoded", Better::higher, true,
     "−10 log10 of the mean of (a − r)², peak 1", squared<&Side::encoded>, Pool::mean, decibels,
     root},
    {"max", "largest difference", "max", "1", "linear", Better::lower, true, "max of |a − r|",
     largest_absolute, Pool::max, same, same},
    {"over1", "pixels off by more than 1 level", ">1 level", "%", "encoded", Better::lower, true,
     "share of pixels with a channel of |a − r| > 1/255", over_one_level, Pool::mean, percent,
     same},
    {"relmse", "relative mean square error", "relMSE", "1", "linear", Better::lower, true,
     "mean of (a − r)²/(r² + 0.01), Rousselle, Knaus, Zwicker 2011", relative_squared, Pool::mean,
     same, root},
    {"ssim", "structural similarity", "SSIM", "1", "encoded", Better::higher, true,
     "Wang, Bovik, Sheikh, Simoncelli 2004; Gaussian window, σ = 1.5", structural, Pool::mean, same,
     from_one},
    {"flip", "FLIP", "FLIP", "1", "encoded", Better::lower, false,
     "Andersson et al. 2020, mean, 67 pixels a degree", flip, Pool::mean, same, same},
};

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::span<const Metric> all_metrics() { return metrics; }

const Metric& find_metric(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Metric& metric : metrics) {
        if (metric.name == name) return metric;
        names.push_back(metric.name);
    }
    throw Error(Errc::usage,
                fmt::format("metric '{}' is unknown{}", name, suggestion(name, names)));
}

double measure(const Metric& metric, const Comparison& pair, Channels channels, const Mask* mask) {
    const std::size_t pixels = pair.reference().linear[0].size();
    SCANSHADE_CHECK(channels.first < channels.last && channels.last <= 3);
    SCANSHADE_CHECK(!mask || mask->inside.size() == pixels);
    if (pair.not_finite(mask) > 0) return no_value;
    double pooled = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (mask && !mask->inside[i]) continue;
        const double error = metric.pixel(pair, channels, i);
        pooled = metric.pool == Pool::mean ? pooled + error : std::max(pooled, error);
        ++count;
    }
    if (count == 0) return no_value;
    return metric.finish(metric.pool == Pool::mean ? pooled / double(count) : pooled);
}

Comparison::Plane error_map(const Metric& metric, const Comparison& pair) {
    Comparison::Plane map(pair.reference().linear[0].size());
    for (std::size_t i = 0; i < map.size(); ++i)
        map[i] = float(metric.shown(metric.pixel(pair, {}, i)));
    return map;
}

bool is_better(const Metric& metric, double a, double b) {
    return metric.better == Better::lower ? a < b : a > b;
}

}  // namespace scanshade

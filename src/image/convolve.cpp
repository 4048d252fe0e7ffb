#include "image/convolve.hpp"

#include <algorithm>
#include <cmath>

#include "scanshade/base/parallel.hpp"

namespace scanshade {
namespace {

/// One value: weights against values that lie `stride` apart, at place `at` of `count`.
double weigh(const double* values, std::ptrdiff_t stride, std::ptrdiff_t at, std::ptrdiff_t count,
             std::span<const double> weights, Border border) {
    const auto radius = std::ptrdiff_t(weights.size() / 2);
    double sum = 0, used = 0;
    for (std::ptrdiff_t k = -radius; k <= radius; ++k) {
        const double weight = weights[std::size_t(k + radius)];
        const std::ptrdiff_t place = std::clamp<std::ptrdiff_t>(at + k, 0, count - 1);
        if (border == Border::cut && place != at + k) continue;
        sum += weight * values[place * stride];
        used += weight;
    }
    return border == Border::cut ? sum / used : sum;
}

}  // namespace

DoublePlane convolve(const DoublePlane& plane, int width, int height,
                     std::span<const double> across, std::span<const double> down, Border border) {
    const auto w = std::size_t(width), h = std::size_t(height);
    DoublePlane rows(plane.size()), result(plane.size());
    const auto for_rows = [&](auto&& row) {
        parallel_for(h, 16, 0, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t y = begin; y < end; ++y) row(y);
        });
    };
    for_rows([&](std::size_t y) {
        for (std::size_t x = 0; x < w; ++x)
            rows[y * w + x] = weigh(&plane[y * w], 1, std::ptrdiff_t(x), width, across, border);
    });
    for_rows([&](std::size_t y) {
        for (std::size_t x = 0; x < w; ++x)
            result[y * w + x] = weigh(&rows[x], width, std::ptrdiff_t(y), height, down, border);
    });
    return result;
}

std::vector<double> gaussian(int radius, double sigma) {
    std::vector<double> weights;
    double sum = 0;
    for (int k = -radius; k <= radius; ++k) {
        weights.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace scanshade

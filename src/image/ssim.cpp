// Structural similarity: Wang, Bovik, Sheikh, Simoncelli 2004, "Image quality assessment: from
// error visibility to structural similarity", equation 13,
//
//     SSIM = (2 μ_a μ_b + C_1) (2 σ_ab + C_2) / ((μ_a² + μ_b² + C_1) (σ_a² + σ_b² + C_2))
//
// with means, variances and the covariance under a Gaussian window of 11 × 11 pixels, σ = 1.5, and
// C_1 = (0.01 L)², C_2 = (0.03 L)², L = 1. At the border the window is cut: the paper leaves that
// open, and so every pixel has a value, also of a picture that is smaller than the window.
#include "image/ssim.hpp"

#include "image/bands.hpp"
#include "image/convolve.hpp"

namespace scanshade {
namespace {

constexpr int radius = 5;
constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;

std::vector<float> ssim_of(const std::vector<float>& a, const std::vector<float>& b, int width,
                           int height) {
    static const std::vector<double> window = gaussian(radius, 1.5);
    const auto mean_of = [&](auto&& value) {
        DoublePlane plane(a.size());
        for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = value(double(a[i]), double(b[i]));
        return convolve(plane, width, height, window, window, Border::cut);
    };
    const DoublePlane mean_a = mean_of([](double x, double) { return x; });
    const DoublePlane mean_b = mean_of([](double, double y) { return y; });
    const DoublePlane squares = mean_of([](double x, double y) { return x * x + y * y; });
    const DoublePlane products = mean_of([](double x, double y) { return x * y; });

    std::vector<float> map(a.size());
    for (std::size_t i = 0; i < map.size(); ++i) {
        const double product = mean_a[i] * mean_b[i];
        const double square = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
        const double covariance = products[i] - product, variances = squares[i] - square;
        map[i] =
            float((2 * product + c1) * (2 * covariance + c2) / ((square + c1) * (variances + c2)));
    }
    return map;
}

}  // namespace

std::vector<float> ssim_map(const std::vector<float>& a, const std::vector<float>& b, int width,
                            int height) {
    return map_by_bands(width, height, radius, [&](int begin, int end) {
        return ssim_of(rows_of(a, width, begin, end), rows_of(b, width, begin, end), width,
                       end - begin);
    });
}

}  // namespace scanshade

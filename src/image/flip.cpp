// FLIP for pictures of low dynamic range: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström,
// Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images". All constants are the
// paper's. Two ways are gone side by side and joined at the end:
//
//     ΔE = ΔE_c^(1 − ΔE_f)
//
// ΔE_c, colour: what the eye cannot resolve is filtered away in an opponent space, and the rest
// compared in L*a*b* with the Hunt effect, by the HyAB distance. ΔE_f, features: edges and points
// that only one of the pictures has make a difference more visible.
#include "image/flip.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "image/bands.hpp"
#include "image/convolve.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/image/image.hpp"

namespace scanshade {
namespace {

using Picture = std::array<std::vector<float>, 3>;  // sRGB
using Planes = std::array<DoublePlane, 3>;

struct Size {
    int width, height;
};

/// Calls body(pixel) for all pixels.
template <class Body>
void for_pixels(const Size& size, Body&& body) {
    parallel_for(std::size_t(size.width) * std::size_t(size.height), 4096, 0,
                 [&](std::size_t begin, std::size_t end, int) {
                     for (std::size_t i = begin; i < end; ++i) body(i);
                 });
}

glm::dvec3 at(const Planes& planes, std::size_t i) {
    return {planes[0][i], planes[1][i], planes[2][i]};
}

void put(Planes& planes, std::size_t i, const glm::dvec3& value) {
    for (int c = 0; c < 3; ++c) planes[std::size_t(c)][i] = value[c];
}

Planes planes_of(const Size& size) {
    Planes planes;
    for (DoublePlane& plane : planes)
        plane.resize(std::size_t(size.width) * std::size_t(size.height));
    return planes;
}

// --- colours ---

/// Linear sRGB to X, Y, Z over those of white: from the chromaticities of the primaries and of the
/// white point D65 (IEC 61966-2-1), so that each row sums to 1.
glm::dmat3 make_rgb_to_xyz() {
    const auto xyz = [](double x, double y) { return glm::dvec3(x, y, 1 - x - y) / y; };
    const glm::dvec3 white = xyz(0.3127, 0.3290);
    const glm::dmat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
    const glm::dvec3 luminance = glm::inverse(primaries) * white;
    glm::dmat3 matrix;
    for (int c = 0; c < 3; ++c) matrix[c] = primaries[c] * luminance[c] / white;
    return matrix;
}
const glm::dmat3 rgb_to_xyz = make_rgb_to_xyz();
const glm::dmat3 xyz_to_rgb = glm::inverse(rgb_to_xyz);

/// Lightness and two opponent colours of three numbers that are X, Y, Z or functions of them.
glm::dvec3 opponents(const glm::dvec3& f) {
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

glm::dvec3 xyz_of_opponents(const glm::dvec3& v) {
    const double y = (v.x + 16) / 116;
    return {y + v.y / 500, y, y - v.z / 200};
}

/// CIE 1976: the cube root with a straight part near 0.
double lab_curve(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

/// L*a*b* whose colours fade with the lightness (Hunt).
glm::dvec3 hunt_lab(const glm::dvec3& rgb) {
    const glm::dvec3 xyz = rgb_to_xyz * rgb;
    const glm::dvec3 lab = opponents({lab_curve(xyz.x), lab_curve(xyz.y), lab_curve(xyz.z)});
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

/// HyAB distance, raised to q_c = 0.7.
double colour_distance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7);
}

/// Distances to [0, 1]: those up to p_c = 0.4 of the largest one, of green and blue, take p_t = 0.95
/// of it, as only they tell renderings of one scene apart.
double redistributed(double distance) {
    static const double largest = colour_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    const double knee = 0.4 * largest;
    return distance < knee ? 0.95 * distance / knee
                           : 0.95 + 0.05 * (distance - knee) / (largest - knee);
}

// --- filters ---

/// One term of a contrast sensitivity function, a sqrt(π/b) exp(−π² x²/b), x in degrees.
struct Sensitivity {
    double a, b;
};
struct ChannelSensitivity {
    Sensitivity first, second;
};
constexpr ChannelSensitivity sensitivities[3] = {
    {{1, 0.0047}, {0, 1}},          // achromatic
    {{1, 0.0053}, {0, 1}},          // red - green
    {{34.1, 0.04}, {13.5, 0.025}},  // blue - yellow
};

std::vector<double> sensitivity_filter(double b, int radius, double pixels_per_degree) {
    constexpr double pi = std::numbers::pi;
    return gaussian(radius, std::sqrt(b / (2 * pi * pi)) * pixels_per_degree);
}

/// Of all sensitivity filters: three times the σ of the widest.
int seen_radius(double pixels_per_degree) {
    constexpr double pi = std::numbers::pi, widest = 0.04;
    return int(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
}

/// The plane as the eye sees it. A sum of two Gaussians is no product of rows and columns, so each
/// term is filtered alone, and they are added in proportion to their sums over the filter.
DoublePlane seen(const DoublePlane& plane, const Size& size, const ChannelSensitivity& channel,
                 double pixels_per_degree) {
    constexpr double pi = std::numbers::pi;
    const int radius = seen_radius(pixels_per_degree);
    double weight = 0;
    const auto term = [&](const Sensitivity& s) {
        const auto filter = sensitivity_filter(s.b, radius, pixels_per_degree);
        const double sum = 1 / filter[std::size_t(radius)];  // before it was divided by it
        weight = s.a * std::sqrt(pi / s.b) * sum * sum;
        return convolve(plane, size.width, size.height, filter, filter, Border::repeat);
    };
    DoublePlane result = term(channel.first);
    if (channel.second.a == 0) return result;
    const double first_weight = weight;
    const DoublePlane second = term(channel.second);
    const double part = weight / (first_weight + weight);
    for_pixels(size, [&](std::size_t i) { result[i] += part * (second[i] - result[i]); });
    return result;
}

/// Derivatives of a Gaussian along a row: of its edges (first) or points (second), positive weights
/// with sum 1 and negative ones with sum −1.
struct FeatureFilters {
    std::vector<double> smooth, edge, point;
};

void balance(std::vector<double>& weights) {
    double positive = 0, negative = 0;
    for (double w : weights) (w > 0 ? positive : negative) += std::abs(w);
    for (double& w : weights) w /= w > 0 ? positive : negative;
}

double feature_sigma(double pixels_per_degree) { return 0.5 * 0.082 * pixels_per_degree; }
int feature_radius(double pixels_per_degree) {
    return int(std::ceil(3 * feature_sigma(pixels_per_degree)));
}

FeatureFilters feature_filters(double pixels_per_degree) {
    const double sigma = feature_sigma(pixels_per_degree);
    const int radius = feature_radius(pixels_per_degree);
    FeatureFilters filters;
    filters.smooth = filters.edge = filters.point = gaussian(radius, sigma);
    for (int k = -radius; k <= radius; ++k) {
        filters.edge[std::size_t(k + radius)] *= -k;
        filters.point[std::size_t(k + radius)] *= k * k / (sigma * sigma) - 1;
    }
    balance(filters.edge);
    balance(filters.point);
    return filters;
}

/// Length of the filter's answers along x and along y, at each pixel.
DoublePlane feature(const DoublePlane& lightness, const Size& size,
                    const std::vector<double>& derivative, const std::vector<double>& smooth) {
    DoublePlane x =
        convolve(lightness, size.width, size.height, derivative, smooth, Border::repeat);
    const DoublePlane y =
        convolve(lightness, size.width, size.height, smooth, derivative, Border::repeat);
    for_pixels(size, [&](std::size_t i) { x[i] = std::hypot(x[i], y[i]); });
    return x;
}

// --- a picture, ready to be compared ---

struct Seen {
    Planes colour;  // Hunt-adjusted L*a*b* of the filtered picture
    DoublePlane edges, points;
};

Seen look_at(const Picture& srgb, const Size& size, double pixels_per_degree) {
    Planes opponent = planes_of(size);
    for_pixels(size, [&](std::size_t i) {
        const auto linear = [&](std::size_t c) { return srgb_decode(double(srgb[c][i])); };
        put(opponent, i, opponents(rgb_to_xyz * glm::dvec3(linear(0), linear(1), linear(2))));
    });

    Seen result;
    for (std::size_t c = 0; c < 3; ++c)
        result.colour[c] = seen(opponent[c], size, sensitivities[c], pixels_per_degree);
    for_pixels(size, [&](std::size_t i) {
        const glm::dvec3 rgb = xyz_to_rgb * xyz_of_opponents(at(result.colour, i));
        put(result.colour, i, hunt_lab(glm::clamp(rgb, 0.0, 1.0)));
    });

    DoublePlane& lightness = opponent[0];
    for_pixels(size, [&](std::size_t i) { lightness[i] = (lightness[i] + 16) / 116; });
    const FeatureFilters filters = feature_filters(pixels_per_degree);
    result.edges = feature(lightness, size, filters.edge, filters.smooth);
    result.points = feature(lightness, size, filters.point, filters.smooth);
    return result;
}

std::vector<float> flip_of(const Picture& a, const Picture& b, const Size& size,
                           double pixels_per_degree) {
    const Seen first = look_at(a, size, pixels_per_degree);
    const Seen second = look_at(b, size, pixels_per_degree);
    std::vector<float> map(a[0].size());
    for_pixels(size, [&](std::size_t i) {
        const double colour =
            redistributed(colour_distance(at(first.colour, i), at(second.colour, i)));
        const double features = std::max(std::abs(first.edges[i] - second.edges[i]),
                                         std::abs(first.points[i] - second.points[i]));
        map[i] = float(std::pow(colour, 1 - std::sqrt(features / std::numbers::sqrt2)));
    });
    return map;
}

}  // namespace

std::vector<float> flip_map(const std::array<std::vector<float>, 3>& a,
                            const std::array<std::vector<float>, 3>& b, int width, int height,
                            double pixels_per_degree) {
    const int reach = std::max(seen_radius(pixels_per_degree), feature_radius(pixels_per_degree));
    return map_by_bands(width, height, reach, [&](int begin, int end) {
        const auto band = [&](const Picture& picture) {
            Picture part;
            for (std::size_t c = 0; c < 3; ++c) part[c] = rows_of(picture[c], width, begin, end);
            return part;
        };
        return flip_of(band(a), band(b), {width, end - begin}, pixels_per_degree);
    });
}

}  // namespace scanshade

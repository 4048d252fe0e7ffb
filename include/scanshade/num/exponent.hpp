// A specular exponent, split once a material. Plain data: crosses between targets.
#pragma once

#include <cmath>
#include <cstdint>

namespace scanshade {

/// An exponent s ≥ 0 as whole + fraction: the whole part is raised by squaring, the rest by
/// exp(f·log x), which is left out where it is 0.
struct Exponent {
    std::uint32_t whole = 0;
    double fraction = 0;  // ≥ 0; below 1 as make_exponent splits
    float least = 0;      // what is not above it has a power below 2^-100, and so 0
};

/// s in [0, 4e9].
inline Exponent make_exponent(double s) {
    const double whole = std::floor(s);
    // Without the floor, highlights fade into numbers too small to be normal, at which processors
    // take a hundred times longer.
    const double least = s >= 1 ? std::exp2(-100 / s) : 0;
    return {static_cast<std::uint32_t>(whole), s - whole, static_cast<float>(least)};
}

/// The same exponent with nothing raised by squaring.
inline Exponent by_exp_log(const Exponent& s) { return {0, s.whole + s.fraction, s.least}; }

/// Relative error of xˢ by pow_shininess, in u of its number type, for x ≥ 2^-20.
inline double power_error_u(const Exponent& s) {
    const double whole = s.whole > 0 ? s.whole - 1.0 : 0.0;
    return whole + (s.fraction > 0 ? 5 + 10 * s.fraction * 20 * 0.6931471805599453 : 0);
}

}  // namespace scanshade

// An equation, a parameter that goes to its extremes, and how far off the result may be there.
#pragma once

#include <span>
#include <string_view>

#include "scanshade/num/dual.hpp"
#include "scanshade/num/rgb.hpp"
#include "scanshade/num/vec3.hpp"
#include "scanshade/num/wide.hpp"
#include "scanshade/report/equation_stability.hpp"

namespace scanshade {

/// One text, a function of the swept parameter, in each type of number. A result of one number is
/// the vector's x.
template <class R>
using SweptFn = Vec3<R> (*)(R x);

struct PrintedForm {
    SweptFn<float> f32;
    SweptFn<double> f64;

    template <class Lambda>
    constexpr PrintedForm(Lambda text) : f32(text), f64(text) {}
};
struct OurForm {
    SweptFn<float> f32;
    SweptFn<double> f64;
    SweptFn<Dual> dual;

    template <class Lambda>
    constexpr OurForm(Lambda text) : f32(text), f64(text), dual(text) {}
};

/// Where the points of a sweep lie between its ends.
enum class Spacing {
    linear,
    logarithmic,
    from_zero,  // 0, then logarithmic
    whole,      // the whole numbers nearest to those of from_zero
};

struct EquationSweep {
    std::string_view number;    // in the formula sheet: "B17d"
    std::string_view title;     // what and where
    std::string_view variable;  // what is swept, with its unit
    Spacing spacing;
    double low, high;
    PrintedForm printed;
    OurForm ours;
    SweptFn<Wide> exact;

    /// Of our form in ulp of the result, given x and the condition number there.
    double (*bound)(double x, double condition);
    std::string_view because;  // the reason for that bound
    std::string_view choice;   // which form is used, and why
    bool misprint = false;     // the printed form is wrong, whatever the arithmetic
    bool gives_up = false;  // ours may answer 0 where no digit is sure: the caller knows what to do
};

/// All of them, in the order of the sheet.
std::span<const EquationSweep> direction_sweeps();
std::span<const EquationSweep> reflection_sweeps();
std::span<const EquationSweep> microfacet_sweeps();
std::span<const EquationSweep> oren_nayar_sweeps();
std::span<const EquationSweep> shading_sweeps();
std::span<const EquationSweep> raycast_sweeps();

// ---- for the texts of the sweeps

template <class R>
Vec3<R> one(R x) {
    return {x, R(0), R(0)};
}
template <class R>
Rgb<R> grey(R x) {
    return {x, x, x};
}
inline double number_of(float x) { return double(x); }
inline double number_of(double x) { return x; }
inline double number_of(const Dual& x) { return x.value; }
inline double number_of(const Wide& x) { return double(x); }

/// A direction in the plane of x and z, by its angle from z.
template <class R>
Vec3<R> from_z(R theta) {
    return {sin(theta), R(0), cos(theta)};
}
/// A direction in the plane of x and z, by its angle from x: cosines stay exact near 0.
template <class R>
Vec3<R> from_x(R elevation) {
    return {cos(elevation), R(0), sin(elevation)};
}
template <class R>
Vec3<R> z_axis() {
    return {R(0), R(0), R(1)};
}

}  // namespace scanshade

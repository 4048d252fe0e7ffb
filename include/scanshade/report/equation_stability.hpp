// Equations and reflection models at the extremes of their parameters: the error of the printed
// form and of the computed one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scanshade/report/watch.hpp"

namespace scanshade {

/// A form in one type of number along a sweep, against the exact value.
struct SweepErrors {
    double worst_ulp = 0;  // of the results that are numbers
    double worst_at = 0;   // the parameter there
    std::size_t nan = 0;   // results that are no numbers
    std::size_t inf = 0;   // infinite results of finite exact ones
    std::size_t zero = 0;  // answers of 0 that are declared: no digit of the result would be sure
    std::size_t over = 0;  // results beyond the bound, NaN and Inf among them
    std::vector<double> ulp;  // a point; NaN where the result is no finite number
};

/// One sweep: an equation or a model, one parameter, everything else fixed.
struct SweepResult {
    std::string number;    // in the formula sheet
    std::string title;     // what and where
    std::string variable;  // what is swept, with its unit
    std::string choice;    // which form is used, and why
    std::string because;   // why the bound is as it is
    bool misprint;         // the printed form is wrong, whatever the arithmetic
    bool logarithmic;      // how to plot x
    std::vector<double> x;
    std::vector<double> bound;  // of our form, in ulp, a point
    double condition;           // the largest along the sweep
    std::optional<SweepErrors> printed_f32, printed_f64;
    SweepErrors ours_f32, ours_f64;

    bool kept() const { return ours_f32.over + ours_f64.over == 0; }
    /// Whether the printed form breaks our form's bound, or is no number somewhere.
    bool printed_fails() const { return printed_f32 && printed_f32->over + printed_f64->over > 0; }
};

struct EquationStability {
    std::vector<SweepResult> equations;
    std::vector<SweepResult> models;

    /// One sentence for each bound that is broken.
    std::vector<std::string> faults() const;
};

/// Sweeps that measure_equation_stability() makes: what it adds to the steps.
std::size_t equation_sweep_count();

/// Takes well under a second. Stops between two sweeps when asked to.
EquationStability measure_equation_stability(Steps& steps);

}  // namespace scanshade

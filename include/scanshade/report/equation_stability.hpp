// Equations and reflection models at the extremes of their parameters: the error of the printed
// form and of the computed one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scanshade/report/document.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/plot.hpp"
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
    bool plotted = true;   // a plot of its own, besides the row of the table
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
    bool partial = false;  // stopped before everything was measured
    std::vector<SweepResult> equations;
    std::vector<SweepResult> models;  // of the registry, along with their choices

    /// One sentence for each bound that is broken.
    std::vector<std::string> faults() const;
};

/// Takes about a second. Stops between two sweeps when asked to.
EquationStability measure_equation_stability(const Watch& watch);

/// What was found, in a few sentences.
std::string equation_verdict(const EquationStability& equations);

/// "name" and "rows" of equations and models, for report_json and report_csv: a row for each form
/// in each type of number, axis "equations" or "models".
Json equation_scenes_json(const EquationStability& equations);

/// The error along each sweep, to be drawn into the report's folder.
std::vector<Plot> equation_plots(const EquationStability& equations);

/// The sections about equations and models: a table, and a figure of each plot where they were
/// drawn.
void add_equation_sections(const EquationStability& equations, bool plots_drawn, Page& page);

}  // namespace scanshade

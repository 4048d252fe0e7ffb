// Where numbers are in danger: equations at their extremes, and pictures of hard scenes.
#pragma once

#include <string>
#include <vector>

#include "scanshade/report/equation_stability.hpp"
#include "scanshade/report/subject.hpp"
#include "scanshade/report/watch.hpp"

namespace scanshade {

struct StabilityReport {
    Provenance provenance;
    bool partial = false;  // stopped before everything was measured
    EquationStability equations;

    /// One sentence for each bound that is broken.
    std::vector<std::string> faults() const;
};

/// Measures equations and models. `settings` are those of the command.
StabilityReport measure_stability(const std::vector<ReportInput>& inputs, const Settings& settings,
                                  const Watch& watch);

/// report.json, stability.csv, plots and index.html, into a folder that exists. Returns warnings:
/// what could not be drawn. Throws Error(file).
std::vector<std::string> write_stability_report(const StabilityReport& report,
                                                const std::string& folder);

}  // namespace scanshade

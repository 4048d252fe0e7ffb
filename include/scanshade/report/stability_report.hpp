// Where numbers are in danger: equations at their extremes, and pictures of hard scenes.
#pragma once

#include <string>
#include <vector>

#include "scanshade/report/equation_stability.hpp"
#include "scanshade/report/picture_stability.hpp"
#include "scanshade/report/subject.hpp"
#include "scanshade/report/watch.hpp"

namespace scanshade {

struct StabilityReport {
    Provenance provenance;
    bool partial = false;  // stopped before everything was measured
    EquationStability equations;
    PictureStability pictures;

    /// One sentence for each bound that is broken.
    std::vector<std::string> faults() const;
};

/// Measures equations, models, generated hard scenes, and then `scenes`. `settings` are those of the
/// command.
StabilityReport measure_stability(const std::vector<ReportInput>& scenes, const Settings& settings,
                                  const Watch& watch, const MakeDrawing& make = make_drawing);

/// report.json, stability.csv, plots, pictures and index.html, into a folder that exists. Returns warnings:
/// what could not be drawn. Throws Error(file).
std::vector<std::string> write_stability_report(const StabilityReport& report,
                                                const std::string& folder);

}  // namespace scanshade

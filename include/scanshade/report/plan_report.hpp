// What each row of the plan saves, measured; and that it changes no bit of the picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scanshade/report/subject.hpp"
#include "scanshade/report/watch.hpp"

namespace scanshade {

/// The time of frames with and without something that the plan leaves out.
struct PlanGain {
    Times with, without;  // the plan as it is, and with this row's work done
    Difference saved;     // without − with, run by run
    double share;         // saved, of the frame without; below 0: it costs more than it saves
};

/// A row of the plan on one scene.
struct PlanRowResult {
    PlannedRow row;
    std::optional<PlanGain> gain;  // of a row that applies
    std::string change;            // how the picture differs without the row; empty: it does not
};

struct PlanSceneResult {
    std::string name;
    int width, height, samples;  // samples a pixel
    std::uint64_t triangles;
    std::size_t lights;
    std::vector<PlanRowResult> rows;     // those that were reached, in the order of PlanRow
    std::optional<PlanGain> whole_plan;  // against leaving out nothing
    std::string whole_change;            // as PlanRowResult::change
};

struct PlanReport {
    Provenance provenance;
    bool partial = false;  // stopped before everything was measured
    std::vector<PlanSceneResult> scenes;

    /// One sentence for each row that changes a picture, which none may.
    std::vector<std::string> faults() const;
};

/// Draws with the plan and without each row in turn. Throws Error(usage) where the settings ask for
/// no plan; `provenance` is that of the first input.
PlanReport measure_plan(const std::vector<ReportInput>& inputs, const Rounds& rounds,
                        const Watch& watch, const MakeDrawing& make = make_drawing);

/// How two pictures differ in any bit of colour, depth and triangle, in words; empty where they are
/// the same.
std::string picture_change(const Framebuffer& a, const Framebuffer& b);

/// report.json, plan.csv, plots and index.html, into a folder that exists. Returns warnings: what
/// could not be drawn. Throws Error(file).
std::vector<std::string> write_plan_report(const PlanReport& report, const std::string& folder);

}  // namespace scanshade

// What a frame costs: its time, stage by stage, against what there is of everything.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/report/fit.hpp"
#include "scanshade/report/subject.hpp"
#include "scanshade/report/watch.hpp"

namespace scanshade {

/// How much there is of everything in a frame.
struct SpeedAmounts {
    double pixels = 0, triangles = 0, lights = 0, samples = 0 /* a pixel */, threads = 0;
    double covered = 0;  // samples that show a surface
};

/// One thing that is varied while everything else stays.
struct SpeedAxis {
    std::string_view name;
    std::string_view unit;   // what a cost is given for: "pixel"; empty: time is not proportional
    const char* plot_label;  // gnuplot commands
    double (*amount)(const SpeedAmounts&);  // the number that is varied
    double (*work)(const SpeedAmounts&);    // what a cost is counted by
    /// The variants of a scene, from little to much.
    std::vector<ReportInput> (*variants)(const ReportInput&);
};

/// pixels, lights, samples, threads: what any scene can be varied in; then triangles, which
/// `triangle_scene()` can.
std::span<const SpeedAxis> speed_axes();

/// A shape in fewer or more triangles, always the same size on the picture.
ReportInput triangle_scene(const Settings& settings, int tessellation);

struct StageTimes {
    std::string name;  // "frame" is all of it
    Times times;
};

struct SpeedPoint {
    SpeedAmounts amounts;
    std::vector<StageTimes> stages;  // those that ran, and "frame" first

    /// nullptr where that stage did not run.
    const Times* find(std::string_view stage) const;
};

/// How the time of a stage grows along an axis.
struct SpeedFit {
    std::string stage;
    std::optional<Fit> power;  // time ~ amount^slope
    std::optional<Fit> cost;   // time = constant + slope · work, in ms; of axes with a unit
};

struct SpeedAxisResult {
    const SpeedAxis* axis;
    std::vector<SpeedPoint> points;
    std::vector<SpeedFit> fits;
};

struct SpeedSceneResult {
    std::string name, renderer;
    std::vector<SpeedAxisResult> axes;
};

struct SpeedReport {
    Provenance provenance;
    bool partial = false;  // stopped before everything was measured
    std::vector<SpeedSceneResult> scenes;
};

/// Each scene with one sample a pixel unless the settings were given another number on the command
/// line; and a sphere in more and more triangles, drawn with `settings`.
SpeedReport measure_speed(const std::vector<ReportInput>& inputs, const Settings& settings,
                          const Rounds& rounds, const Watch& watch,
                          const MakeDrawing& make = make_drawing);

/// Fits of every stage that all points have.
std::vector<SpeedFit> fit_stages(const SpeedAxis& axis, const std::vector<SpeedPoint>& points);

/// report.json, speed.csv, plots and index.html, into a folder that exists. Returns warnings: what
/// could not be drawn. Throws Error(file).
std::vector<std::string> write_speed_report(const SpeedReport& report, const std::string& folder);

}  // namespace scanshade

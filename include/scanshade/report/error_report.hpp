// What each approximation costs in error and saves in time.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scanshade/image/metrics.hpp"
#include "scanshade/report/fit.hpp"
#include "scanshade/report/subject.hpp"
#include "scanshade/report/watch.hpp"

namespace scanshade {

/// One way to draw a scene, and what tells it from the others.
struct ErrorMethod {
    std::string name;    // "gouraud, perspective, tessellation ×2"
    std::string series;  // what it is without its amount: "gouraud, perspective"
    std::vector<std::pair<std::string, std::string>> parameters;  // as options spell them
    double amount = 0;      // what the methods of a series differ in; 0: nothing
    bool as_given = false;  // what the scene and the options ask for
    ReportInput input;
};

/// What the methods of an axis are compared with.
struct ErrorReference {
    Framebuffer picture;
    std::string what;      // one sentence
    double own_rmse;       // how far it is from the truth, about; linear
    std::string own_from;  // how that is known: one sentence
};

/// Pixels that an error is averaged over: all; those that both pictures cover; those of them with
/// no edge near by; the others that either covers.
enum class ErrorRegion { all, covered, interior, silhouette };
inline constexpr std::size_t error_region_count = 4;
std::span<const std::string_view> error_region_names();

/// What theory says: error ~ amount^(−order) for the methods of a shading.
struct ExpectedOrder {
    std::string_view shading, metric;
    ErrorRegion region;
    double order;
    std::string_view why;
};

/// One kind of error, apart from the other kinds.
struct ErrorAxis {
    std::string_view name;      // "aliasing"
    std::string_view question;  // one sentence
    std::string_view against;   // what amounts are: "samples"; empty where there are none
    std::vector<ErrorMethod> (*methods)(const ReportInput&);
    ErrorReference (*reference)(const ReportInput&, const MakeDrawing&);
    std::span<const ExpectedOrder> expected{};
};

/// numerical, aliasing, interpolation, model: what any scene is measured along.
std::span<const ErrorAxis> error_axes();

/// A scene of its own, and the axis that it is measured along.
struct ErrorStudy {
    ReportInput input;
    const ErrorAxis* axis;
};
/// A diffuse sphere under an oblique light, for which theory says how fast the error of each shading
/// falls with finer polygons; and the same sphere with a highlight.
std::vector<ErrorStudy> convergence_studies(const Settings& settings);

/// [metric of all_metrics()]
struct RegionErrors {
    std::size_t pixels = 0;
    std::vector<double> values;
    std::vector<std::array<double, 3>> channels;  // of the whole picture only
};

/// What a method came to.
struct ErrorRow {
    ErrorMethod method;  // without its scene
    std::array<RegionErrors, error_region_count> regions;
    std::uint64_t memory = 0;  // bytes that it holds beside the scene and the picture; 0: unknown
    std::uint64_t triangles = 0;
    std::string picture;         // name of its PNG
    std::optional<Times> time;   // nothing: interrupted before
    std::vector<double> run_ms;  // run i of all rows took place at about the same time
    bool on_front = false;       // no row is both faster and nearer to the reference, by RMSE

    double error(std::string_view metric, ErrorRegion region = ErrorRegion::all) const;
    /// 1/(MSE · seconds); infinite without an error.
    double efficiency() const;
};

/// How fast an error falls: error ~ amount^(−order).
struct ErrorOrder {
    std::string series, against;  // "samples", or "time"
    std::string_view metric;
    ErrorRegion region;
    Estimate order;
    const ExpectedOrder* expected = nullptr;
};

struct ErrorAxisResult {
    const ErrorAxis* axis;
    std::string reference, own_from;
    double own_rmse;
    std::string reference_picture;
    std::vector<ErrorRow> rows;
    std::vector<ErrorOrder> orders;
};

struct ErrorSceneResult {
    std::string name;
    int width, height;
    std::vector<ErrorAxisResult> axes;
    std::vector<std::string> verdict;  // sentences; the first says the most
};

struct ErrorReport {
    Provenance provenance;
    bool partial = false;  // stopped before everything was measured
    std::vector<ErrorSceneResult> scenes;
};

/// Takes a picture of the report under its name.
using KeepPicture = std::function<void(const std::string& file, const Image&)>;

/// All axes of each scene, with one sample a pixel but where samples are what is varied; then the
/// spheres, drawn with `settings`.
ErrorReport measure_error(const std::vector<ReportInput>& inputs, const Settings& settings,
                          const Rounds& rounds, const Watch& watch, const KeepPicture& keep,
                          const MakeDrawing& make = make_drawing);

/// Along one axis alone; `name` begins the names of its pictures.
ErrorAxisResult measure_error_axis(const ErrorAxis& axis, const ReportInput& input,
                                   const std::string& name, const Rounds& rounds, Steps& steps,
                                   const KeepPicture& keep, const MakeDrawing& make = make_drawing);

/// report.json, error.csv, plots and index.html, into a folder that exists and has the pictures.
/// Returns warnings: what could not be drawn. Throws Error(file).
std::vector<std::string> write_error_report(const ErrorReport& report, const std::string& folder);

}  // namespace scanshade

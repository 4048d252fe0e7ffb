// Pictures of scenes that are hard for numbers: whether every renderer draws the same, and how far
// the geometry that all of them share is from the exact one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/report/document.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/plot.hpp"
#include "scanshade/report/subject.hpp"
#include "scanshade/report/watch.hpp"

namespace scanshade {

/// What a picture must keep to, besides what all must: no NaN or Inf, the same triangle at every
/// sample in every renderer, and geometry within what rounding can come to.
struct PictureBounds {
    int levels = 1;              // largest difference of a byte from scalar-f64
    std::uint64_t beyond = 0;    // pixels that may differ by more than one level
    double displacement = 1;     // 1/256 pixel: of a vertex, and of edges beside moved samples
    std::uint64_t mistaken = 0;  // samples at which rounded depth chooses another triangle
    std::string_view reason =
        "rounding to a byte can make a level of any difference; snapping moves a vertex by up to "
        "0.71/256 pixel, rounding to float by less";
};

/// One renderer's picture of a scene, against that of scalar-f64.
struct RendererResult {
    std::string renderer;          // "scalar-f32", "simd avx2", ...
    std::uint64_t not_finite = 0;  // samples of a radiance or depth that is NaN or Inf, and those
                                   // that were drawn black instead
    std::uint64_t other_id = 0;    // samples that show another triangle, or at another depth
    int levels = 0;                // largest difference of a byte
    std::uint64_t differing = 0;   // pixels with any difference
    std::uint64_t beyond = 0;      // pixels with a difference of more than one level
    EventCounts events;            // of the frame
};

/// The geometry that all renderers share against transform, clip and projection in double without
/// snapping: one sample a pixel, triangles, both sides.
struct GeometryResult {
    std::uint64_t vertices = 0;  // that were compared: between near and far, in the guard band
    double displacement = 0;     // 1/256 pixel, the largest of a vertex
    std::uint64_t samples = 0;   // that some triangle covers
    std::uint64_t moved = 0;     // samples that some triangle covers in one of the two only
    std::uint64_t opened = 0;    // of these: with nothing there in one of the two
    double edge_distance = 0;    // 1/256 pixel, the largest of such a sample from the exact edge
    double bound_share = 0;      // the largest share of any displacement or distance in what
                                 // rounding can come to there; not above 1
    std::uint64_t mistaken = 0;  // other samples at which another triangle is nearest
};

/// A scene in all renderers.
struct PictureCaseResult {
    std::string name, difficulty;  // what is hard about it, in a sentence
    bool generated = true;         // else it is one of the user's scenes
    int width = 0, height = 0;
    std::uint64_t triangles = 0;
    PictureBounds bounds;
    EventCounts loading;                    // events of loading
    std::vector<RendererResult> renderers;  // scalar-f64 first
    GeometryResult geometry;
    Image picture;  // of the vector renderer
};

struct PictureStability {
    bool partial = false;  // stopped before everything was measured
    std::vector<PictureCaseResult> cases;

    /// One sentence for each bound that is broken.
    std::vector<std::string> faults() const;
};

/// Draws the table of hard cases and then `scenes`, each by scalar-f64, scalar-f32 and the simd
/// renderer on every instruction set of this machine. The number of steps that `watch` hears of is
/// that of scenes. Afterwards kernels use the best instruction set.
PictureStability measure_picture_stability(const std::vector<ReportInput>& scenes,
                                           const Watch& watch,
                                           const MakeDrawing& make = make_drawing);

/// "name" and "rows" of each case, for report_json and report_csv: a row for each renderer and one
/// for the geometry, axis "pictures".
Json picture_scenes_json(const PictureStability& pictures);

/// Plots over all cases, to be drawn into the report's folder.
std::vector<Plot> picture_plots(const PictureStability& pictures);

/// A PNG of each case beside the page. Throws Error(file).
void write_pictures(const PictureStability& pictures, const std::string& folder);

/// The section about pictures: what was found, plots where they were drawn, a figure and a row of
/// the tables for each case.
void add_picture_section(const PictureStability& pictures, bool plots_drawn, Page& page);

}  // namespace scanshade

// What the files of the error report share.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scanshade/report/error_report.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/plot.hpp"

namespace scanshade {

/// Of the reference of the aliasing axis.
inline constexpr int reference_samples = 1024;

enum class Retessellate { shapes, smooth };  // all shapes; or only those whose polygons are not it

/// The scene with its shapes made again from `factor` times as many quads along an edge, at least
/// one. Meshes from files stay.
Scene retessellated(const Scene& scene, double factor, Retessellate which = Retessellate::shapes);

/// Triangles of its smooth shapes, each mesh counted once.
double predicted_triangles(const Scene& scene, double factor);

/// The axis `interpolation`.
std::vector<ErrorMethod> interpolation_methods(const ReportInput& input);
ErrorReference interpolation_reference(const ReportInput& input, const MakeDrawing& make);

/// Where samples are no subject: one a pixel.
ReportInput with_one_sample(ReportInput input);

/// The mean square of what a picture shows, to its root.
double root_mean_square(const Framebuffer& frame);

/// Fits how fast errors fall along the axis, and what that says of the reference's own error.
void finish_orders(ErrorAxisResult& result);

/// Marks the rows that none is better than in both time and error.
void mark_front(std::vector<ErrorRow>& rows);

/// What is as good as what and takes less time, in sentences; the first says the most.
std::vector<std::string> verdict_of(const ErrorSceneResult& scene);

/// Bytes that this process holds from its allocator; 0 where that is not known.
std::uint64_t held_bytes();

/// The whole page.
std::string error_page(const ErrorReport& report, bool with_plots);

/// Names of the plot of an axis of scene `number`, from 1.
std::string error_plot_file(const ErrorAxisResult& result, std::size_t number);

/// "3.1e-05", short enough for a table.
std::string short_number(double value);

}  // namespace scanshade

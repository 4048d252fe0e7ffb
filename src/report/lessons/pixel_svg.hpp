// A few pixels so large that one can see which sample is where.
#pragma once

#include <string>
#include <vector>

#include "report/svg_plot.hpp"
#include "scanshade/image/image.hpp"

namespace scanshade {

/// Corners in pixels of the picture, y down.
using Outline = std::vector<PlotPoint>;

/// Each pixel as a square with a dot on its sample, and the outlines above them. For pictures of a
/// few hundred pixels.
std::string pixel_svg(const Image& image, const std::vector<Outline>& outlines);

}  // namespace scanshade

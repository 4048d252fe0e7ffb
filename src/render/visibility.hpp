// Visibility: which triangle is seen at each sample. One computation for every renderer.
#pragma once

#include <functional>

#include "render/faces.hpp"
#include "render/frame.hpp"

namespace scanshade {

/// Depth at a sample of a drawn face, in float, by the way its values travel. One function for
/// every renderer.
float depth_at(const DrawnFace& face, const Frame& frame, SnappedPoint p);

/// The corners of a face's coverage: its snapped vertices, or what clipping leaves of it. False,
/// and the reason counted, where nothing of it can be drawn.
bool drawn_corners(const DrawnFace& face, const Frame& frame, EventCounts& events,
                   std::vector<SnappedPoint>& out);

/// Called with a drawn face and samples [x_begin, x_end) of row y that it covers.
using CoverageVisitor = std::function<void(const DrawnFace& face, int y, int x_begin, int x_end)>;

/// Visits the coverage of every drawn face at frame.sample, in the order of the scene: clips what
/// reaches too far, leaves out what is empty or culled. Counts the events.
void visit_coverage(Frame& frame, const CoverageVisitor& visit);

/// Fills frame.depth and frame.id for frame.sample. Nearer depth wins, equal depth the lower id,
/// so the order of drawing has no part in it.
void find_visible(Frame& frame);

}  // namespace scanshade

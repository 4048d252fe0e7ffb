// From the state to the pixels that a window shows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scanshade/render/plan.hpp"
#include "scanshade/render/renderer.hpp"
#include "viewer/view_state.hpp"

namespace scanshade::viewer {

/// What the panel says about a frame.
struct FrameReport {
    FrameStats stats;
    std::vector<PlannedStage> stages;
    std::vector<PlannedRow> rows;
    std::optional<DebugScale> scale;
    std::vector<DebugLegend> legend;
};

/// Draws the sides of a state.
class Picture {
public:
    /// While something moves with one sample a pixel, and debug views that take long stay away: the
    /// plain picture is drawn. Throws Error and keeps the last picture.
    void draw(const ViewState& state, bool moving);

    const PixelBuffer& pixels() const { return shown_; }
    const FrameReport& report(std::size_t side) const { return reports_[side]; }
    bool final() const { return final_; }  // nothing would be better at rest

private:
    void draw_side(const ViewState& state, std::size_t side, bool moving);

    std::array<PixelBuffer, 2> drawn_;
    std::array<FrameReport, 2> reports_;
    PixelBuffer shown_;
    bool final_ = false;
};

}  // namespace scanshade::viewer

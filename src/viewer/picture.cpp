#include "viewer/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scanshade::viewer {
namespace {

/// Longer than a frame of a movement may take.
bool takes_long(DebugView view) {
    return view == DebugView::error_f64 || view == DebugView::overdraw;
}

void draw_with_edges(const ViewState& state, const Settings& settings, Renderer& renderer,
                     PixelBuffer& pixels, FrameStats& stats) {
    Framebuffer frame;
    stats = renderer.draw(frame);
    pixels = PixelBuffer(frame.width, frame.height);
    encode(frame, settings.transfer, settings.exposure_ev, pixels);
    draw_wireframe(state.scene(), frame, pixels);
}

}  // namespace

void Picture::draw_side(const ViewState& state, std::size_t number, bool moving) {
    const Side& side = state.side(number);
    const Settings settings = moving ? state.settings_while_moving(number) : side.settings;
    FrameReport report;
    Renderer renderer(state.scene(), settings);
    const DebugView view = moving && takes_long(side.view) ? DebugView::none : side.view;
    if (view != DebugView::none) {
        DebugPicture debug = draw_debug_view(state.scene(), settings, view);
        report.stats = renderer.draw(drawn_[number]);
        drawn_[number] = std::move(debug.pixels);
        report.scale = std::move(debug.scale);
        report.legend = std::move(debug.legend);
    } else if (side.wireframe) {
        draw_with_edges(state, settings, renderer, drawn_[number], report.stats);
    } else {
        report.stats = renderer.draw(drawn_[number]);
    }
    report.stages = explain_stages(renderer.plan());
    report.rows = explain_rows(renderer.plan(), report.stats.saved);
    reports_[number] = std::move(report);
}

void Picture::draw(const ViewState& state, bool moving) {
    if (!state.split()) {
        draw_side(state, state.active_number(), moving);
        std::swap(shown_, drawn_[state.active_number()]);
    } else {
        for (std::size_t side = 0; side < 2; ++side) draw_side(state, side, moving);
        shown_ = drawn_[0];
        const auto first = static_cast<std::ptrdiff_t>(
            std::clamp(std::lround(state.divider() * shown_.width), 0L, long{shown_.width}));
        const auto from = drawn_[1].rgba().begin();
        const auto to = shown_.edit().begin();
        for (int y = 0; y < shown_.height; ++y) {
            const auto row = std::ptrdiff_t{y} * shown_.width;
            std::copy(from + row + first, from + row + shown_.width, to + row + first);
        }
    }
    const auto rests = [&](std::size_t number) {
        const Side& side = state.side(number);
        return side.settings.samples == 1 && !takes_long(side.view);
    };
    final_ =
        !moving || (rests(state.active_number()) && (!state.split() || (rests(0) && rests(1))));
}

}  // namespace scanshade::viewer

// What is drawn on the picture.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/camera_control.hpp"
#include "viewer/light_control.hpp"
#include "viewer/ui.hpp"

namespace scanshade::viewer {
namespace {

constexpr ImU32 ink = IM_COL32(255, 255, 255, 255), paper = IM_COL32(0, 0, 0, 170);
constexpr ImU32 edge_ink = IM_COL32(255, 220, 90, 255), row_ink = IM_COL32(110, 220, 255, 255);
constexpr ImU32 light_ink = IM_COL32(255, 240, 150, 255);

/// From pixels of the picture to the window's points.
class Page {
public:
    Page(double left)
        : list_(*ImGui::GetBackgroundDrawList()),
          left_(float(left)),
          scale_(1 / ImGui::GetIO().DisplayFramebufferScale.x) {}

    ImVec2 at(double x, double y) const { return {left_ + float(x) * scale_, float(y) * scale_}; }
    void line(double x0, double y0, double x1, double y1, ImU32 colour, float width) {
        list_.AddLine(at(x0, y0), at(x1, y1), colour, width);
    }
    void dot(double x, double y, ImU32 colour) { list_.AddCircleFilled(at(x, y), 3.5f, colour, 8); }
    void text(ImVec2 where, const std::string& text, ImU32 colour = ink) {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        list_.AddRectFilled({where.x - 3, where.y - 1},
                            {where.x + size.x + 3, where.y + size.y + 1}, paper);
        list_.AddText(where, colour, text.c_str());
    }
    void box(ImVec2 from, ImVec2 to, ImU32 colour) { list_.AddRectFilled(from, to, colour); }

private:
    ImDrawList& list_;
    float left_, scale_;
};

const InspectedSample* inspected(const Ui& ui) {
    if (!ui.inspection || ui.moving) return nullptr;
    for (const InspectedSample& sample : ui.inspection->samples)
        if (sample.covered) return &sample;
    return nullptr;
}

/// The polygon with its corners, the row of the sample, and where it crosses.
void draw_inspected(Page& page, const InspectedSample& s) {
    const std::size_t n = s.corners.size();
    const std::vector<std::string> names = corner_names(s);
    // A patch's corners stand as A B C D: around it they are A B D C.
    constexpr std::size_t around[] = {0, 1, 3, 2};
    const auto corner = [&](std::size_t i) -> const InspectedCorner& {
        return s.corners[s.f64.travel == Travel::patch ? around[i % n] : i % n];
    };
    for (std::size_t i = 0; i < n; ++i)
        if (corner(i).on_picture && corner(i + 1).on_picture)
            page.line(corner(i).x, corner(i).y, corner(i + 1).x, corner(i + 1).y, edge_ink, 2);
    if (s.f64.scanline) {
        page.line(s.f64.scanline->ab_x, s.y, s.f64.scanline->cd_x, s.y, row_ink, 2);
        page.dot(s.f64.scanline->ab_x, s.y, row_ink);
        page.dot(s.f64.scanline->cd_x, s.y, row_ink);
    }
    page.dot(s.x, s.y, ink);
    double cx = 0, cy = 0;
    for (const InspectedCorner& c : s.corners) cx += c.x / double(n), cy += c.y / double(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (!s.corners[i].on_picture) continue;
        // Outside of the corner, away from the middle.
        const double dx = s.corners[i].x - cx, dy = s.corners[i].y - cy;
        const double length = std::max(std::hypot(dx, dy), 1e-9);
        const ImVec2 at =
            page.at(s.corners[i].x + 14 * dx / length, s.corners[i].y + 14 * dy / length);
        page.text({at.x - 4, at.y - 8}, names[i], edge_ink);
    }
}

/// The light as a spot, and a line to what it shines at.
void draw_light(Page& page, const ViewState& state) {
    const auto number = state.selected_light();
    if (!number) return;
    const Light& light = state.scene().lights[*number];
    const Camera camera = state.camera();
    const Settings& settings = state.settings();
    const glm::dvec3 centre = state.bounds().centre;
    const glm::dvec3 from = shown_position(light, centre, 1.2 * state.bounds().radius);
    const auto a = project(camera, settings.width, settings.height, from);
    const auto b = project(camera, settings.width, settings.height, centre);
    if (!a || !b) return;
    page.line(a->x, a->y, b->x, b->y, light_ink, 2);
    page.dot(a->x, a->y, light_ink);
    const ImVec2 at = page.at(a->x, a->y);
    page.text({at.x + 8, at.y - 8},
              fmt::format("light {}: {}", *number + 1,
                          light_kind_names()[static_cast<std::size_t>(light.kind)]),
              light_ink);
}

void draw_divider(Page& page, const ViewState& state) {
    const Settings& settings = state.settings();
    const double x = state.divider() * settings.width;
    page.line(x, 0, x, settings.height, ink, 2);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string text = fmt::format("{}{} {}", side == state.active_number() ? "▸ " : "",
                                             side == 0 ? "A" : "B", state.method(side));
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        ImVec2 at = page.at(x, 0);
        at.y = 8;
        at.x += side == 0 ? -width - 10 : 10;
        page.text(at, text);
    }
}

void draw_scale(Page& page, const DebugScale& scale, ImVec2 at) {
    constexpr int steps = 64;
    constexpr float width = 4, height = 14;
    for (int i = 0; i < steps; ++i) {
        const Rgb8 c = false_colour(i / double(steps - 1));
        page.box({at.x + float(i) * width, at.y}, {at.x + float(i + 1) * width, at.y + height},
                 IM_COL32(c[0], c[1], c[2], 255));
    }
    const double middle =
        scale.logarithmic ? std::sqrt(scale.low * scale.high) : (scale.low + scale.high) / 2;
    const float end = steps * width;
    page.text({at.x, at.y + height + 3}, fmt::format("{:.3g}", scale.low));
    page.text({at.x + end / 2 - 15, at.y + height + 3}, fmt::format("{:.3g}", middle));
    page.text({at.x + end - 15, at.y + height + 3},
              fmt::format("{:.3g} {}", scale.high, scale.unit));
}

/// The scale of false colours, or what colours mean, in the lower left corner of a side.
void draw_legend(Page& page, const FrameReport& report, ImVec2 corner) {
    if (report.scale) draw_scale(page, *report.scale, {corner.x + 12, corner.y - 44});
    float y = corner.y - 12 - 20 * float(report.legend.size());
    for (const DebugLegend& row : report.legend) {
        page.box({corner.x + 12, y}, {corner.x + 28, y + 16},
                 IM_COL32(row.colour[0], row.colour[1], row.colour[2], 255));
        page.text({corner.x + 36, y}, row.meaning);
        y += 20;
    }
}

}  // namespace

void build_overlays(const ViewState& state, const Picture& picture, const Ui& ui, double left) {
    Page page(left);
    const Settings& settings = state.settings();
    for (std::size_t side = 0; side < 2; ++side) {
        if (!state.split() && side != state.active_number()) continue;
        const double x = state.split() && side == 1 ? state.divider() * settings.width : 0;
        draw_legend(page, picture.report(side), page.at(x, settings.height));
    }
    if (const InspectedSample* sample = inspected(ui)) draw_inspected(page, *sample);
    if (ui.light_is_moving) draw_light(page, state);
    if (state.split()) draw_divider(page, state);
}

}  // namespace scanshade::viewer

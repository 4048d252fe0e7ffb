// Which samples a polygon covers: each exactly once, or cracks and double pixels.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "render/debug_pass.hpp"
#include "report/lessons/pixel_svg.hpp"
#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/render/inspect.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade::lessons {
namespace {

/// The corners on the picture of each triangle that is seen, as the renderer has them.
std::vector<Outline> seen_triangles(const ReportInput& input, const Framebuffer& frame) {
    std::map<std::uint32_t, Outline> found;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const std::uint32_t id = frame.id[frame.index(x, y)];
            if (id == Framebuffer::no_triangle || found.contains(id)) continue;
            const Inspection seen = inspect_pixel(input.scene, input.settings, x, y);
            for (const InspectedCorner& c : seen.samples.front().corners)
                found[id].push_back({c.x, c.y});
        }
    std::vector<Outline> out;
    for (auto& [id, outline] : found) out.push_back(std::move(outline));
    return out;
}

/// Whether a triangle covers a sample: with its edges or without them. Exact: corners are
/// multiples of 1/256.
bool covers(const Outline& t, double x, double y, bool with_edges) {
    std::array<double, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [ax, ay] = t[i];
        const auto [bx, by] = t[(i + 1) % 3];
        side[i] = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    }
    const auto [least, most] = std::minmax_element(side.begin(), side.end());
    return with_edges ? *least >= 0 || *most <= 0 : *least > 0 || *most < 0;
}

using Counts = std::vector<int>;  // [pixel] how many triangles cover it

Counts count(const std::vector<Outline>& triangles, int width, int height, bool with_edges) {
    Counts counts;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            counts.push_back(
                int(std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) {
                    return covers(t, x + 0.5, y + 0.5, with_edges);
                })));
    return counts;
}

Counts drawn_counts(const ReportInput& input) {
    const std::vector<double> coverage = DebugPass(input.scene, input.settings, false).coverage();
    return {coverage.begin(), coverage.end()};
}

/// Grey: once; yellow to red: more often.
Image count_picture(const Counts& counts, int width, int height) {
    constexpr std::uint8_t colours[][3] = {
        {24, 28, 36}, {190, 194, 200}, {240, 200, 60}, {214, 60, 40}};
    Image out(width, height);
    for (std::size_t i = 0; i < counts.size(); ++i)
        std::copy_n(colours[std::min(counts[i], 3)], 3, &out.rgb[3 * i]);
    return out;
}

/// Samples inside the fan, on edges of two triangles or more, that nobody draws. A corner of two
/// triangles is on the rim of the fan and not inside.
double cracks(const Counts& drawn, const Counts& with_edges, const std::vector<Outline>& triangles,
              int width) {
    const auto on_rim = [&](int x, int y) {
        return 2 == std::count_if(triangles.begin(), triangles.end(), [&](const Outline& t) {
                   return std::any_of(t.begin(), t.end(), [&](const PlotPoint& p) {
                       return p.x == x + 0.5 && p.y == y + 0.5;
                   });
               });
    };
    double n = 0;
    for (int i = 0; i < int(drawn.size()); ++i)
        n += drawn[std::size_t(i)] == 0 && with_edges[std::size_t(i)] > 1 &&
             !on_rim(i % width, i / width);
    return n;
}
double doubled(const Counts& counts) {
    return double(std::count_if(counts.begin(), counts.end(), [](int n) { return n > 1; }));
}

void add_closed_surface(LessonWork& work) {
    ReportInput torus;
    torus.scene = single_object_scene(make_shape_mesh(*find_shape("torus"), 12), {});
    torus.settings.width = 320, torus.settings.height = 240;
    const DebugPicture view = draw_debug_view(torus.scene, torus.settings, DebugView::overdraw);
    const Counts counts = drawn_counts(torus);
    work.paragraph(
        "So a closed surface has no holes: seen from outside, a ray enters it as often as it "
        "leaves, and each sample is covered an even number of times, exactly. No tolerance is "
        "needed.");
    work.figures(
        {work.picture("torus", torus, "a torus"),
         work.picture("overdraw", to_image(view.pixels),
                      fmt::format("how many faces cover a pixel, from 0 (dark blue) to {:g} "
                                  "(red)",
                                  view.scale->high))});
    work.measured("torus: samples that are covered",
                  double(counts.size() - std::size_t(std::count(counts.begin(), counts.end(), 0))));
    work.measured("torus: samples covered an odd number of times",
                  double(std::count_if(counts.begin(), counts.end(), [](int n) { return n % 2; })));
}

void fill_fill_rule(LessonWork& work) {
    work.paragraph(
        "A pixel is drawn where its sample, the centre, lies inside a triangle. Where an edge "
        "meets a sample exactly, somebody must own it: if both neighbours do, it is drawn twice, "
        "which shows where colours are added; if none does, there is a crack. The top-left rule "
        "gives it to the triangle for which the edge is a left or a top one. Corners are snapped "
        "to 1/256 pixel, so that the question has an exact answer in integers.");
    const ReportInput input = work.input();
    const Framebuffer frame = draw_planes(input);
    const std::vector<Outline> triangles = seen_triangles(input, frame);
    const int w = frame.width, h = frame.height;
    const Counts rule = drawn_counts(input);
    const Counts with = count(triangles, w, h, true), without = count(triangles, w, h, false);
    const Image colours =
        to_image(draw_debug_view(input.scene, input.settings, DebugView::triangles).pixels);
    work.figures(
        {work.plot("triangles", pixel_svg(colours, triangles),
                   "The fan as it is drawn: which triangle has which pixel. Dots are samples."),
         work.plot("rule", pixel_svg(count_picture(rule, w, h), triangles),
                   "How often each sample is covered by the top-left rule: grey is once."),
         work.plot("with", pixel_svg(count_picture(with, w, h), triangles),
                   "If each triangle took all samples on its edges: yellow twice, red more."),
         work.plot("without", pixel_svg(count_picture(without, w, h), triangles),
                   "If none did: dark cracks along the edges that meet samples.")});
    work.measured("top-left rule: samples drawn twice", doubled(rule));
    work.measured("top-left rule: samples on inner edges that nobody draws",
                  cracks(rule, with, triangles, w));
    work.measured("with all edges: samples drawn twice or more", doubled(with));
    work.measured("without edges: samples on inner edges that nobody draws",
                  cracks(without, with, triangles, w));
    add_closed_surface(work);
}

constexpr LessonEquation equations[] = {
    {"D2", "0 ≤ u, v,  u + v ≤ 1", "in_triangle"},
};
constexpr LessonCommand commands[] = {
    {"render", "-o fan.png"},
    {"inspect", "--pixel 12,11"},
    {"render", "--resolution 240,240 -o large.png"},
};
constexpr LessonQuestion questions[] = {
    {"Why is a small tolerance at edges no remedy for cracks?",
     "It draws samples near an edge twice, and which ones depends on rounding. Exact integers need "
     "no tolerance."},
    {"What does snapping cost?",
     "Corners move by at most 1/512 pixel in each direction. Neighbours share corners, so they "
     "move together and no crack opens."},
    {"In the overdraw view of a closed surface a pixel has an odd count. What is wrong?",
     "The mesh is not closed there, a sample is lost or drawn twice, or the camera is inside."},
};

}  // namespace

constinit const LessonInfo fill_rule{
    "fill-rule",
    "The fill rule",
    "Samples on an edge belong to exactly one of two triangles: neither cracks nor double pixels.",
    equations,
    commands,
    questions,
    fill_fill_rule};

}  // namespace scanshade::lessons

// What a picture does not need, and what leaving it out is worth.
#include <fmt/format.h>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/render/debug_view.hpp"

namespace scanshade::lessons {
namespace {

constexpr std::size_t frames = 9;

/// Medians of frames with and without the plan, in turns.
void measure_times(LessonWork& work, const ReportInput& with, const ReportInput& without) {
    const Drawing drawings[] = {make_drawing(with.scene, with.settings),
                                make_drawing(without.scene, without.settings)};
    PixelBuffer pixels;
    const std::function<FrameStats()> subjects[] = {[&] { return drawings[0].pixels(pixels); },
                                                    [&] { return drawings[1].pixels(pixels); }};
    const FrameTable table = time_interleaved(subjects, {2, frames, 1}, [] { return false; });
    work.measured("a frame with the plan, median", times_of(frame_ms(table[0])).median, "ms");
    work.measured("a frame without it, median", times_of(frame_ms(table[1])).median, "ms");
}

double different_values(const Framebuffer& a, const Framebuffer& b) {
    double n = 0;
    for (std::size_t i = 0; i < a.r.size(); ++i)
        n += a.r[i] != b.r[i] || a.g[i] != b.g[i] || a.b[i] != b.b[i] || a.depth[i] != b.depth[i] ||
             a.id[i] != b.id[i];
    return n;
}

void fill_plan(LessonWork& work) {
    work.paragraph(
        "The fastest work is none. Before anything is drawn, the plan asks of each kind of work "
        "whether this scene needs it, and leaves it out only where no bit of the picture can "
        "change: clusters of triangles outside of the view, highlights of matt materials, "
        "distances of lights that do not weaken, points that nobody sees.");
    const ReportInput with = work.input(), without = work.input({{"no-plan", "true"}});
    const DebugPicture view = draw_debug_view(with.scene, with.settings, DebugView::plan);
    work.figures(
        {work.picture("picture", with, "the scene"),
         work.picture("work", to_image(view.pixels),
                      "which work each pixel took: bright ones are lit, dark ones only show the "
                      "background, in the darkest tiles nothing was drawn at all")});
    Renderer renderer(with.scene, with.settings);
    Framebuffer frame;
    const FrameStats stats = renderer.draw(frame);
    std::vector<std::vector<Cell>> rows;
    double left_out = 0;
    for (const PlannedRow& row : explain_rows(renderer.plan(), stats.saved)) {
        left_out += row.left_out;
        rows.push_back({{std::string(row.info->name), "whole"},
                        {row.left_out ? "left out" : "done", row.left_out ? "good" : "faint"},
                        {row.left_out ? row.amount() : "", "whole"},
                        {row.reason}});
    }
    work.table({"work", "", "how much", "why"}, rows);
    work.measured("kinds of work left out", left_out);
    work.measured("pixels that differ in colour, depth or triangle without the plan",
                  different_values(frame, draw_planes(without)));
    measure_times(work, with, without);
}

constexpr LessonCommand commands[] = {
    {"explain", ""},
    {"explain", "--cull none"},
    {"render", "--no-plan --stats - -o no-plan.png"},
    {"render", "--stats - -o plan.png"},
};
constexpr LessonQuestion questions[] = {
    {"Why is leaving out back faces no row of the plan, but an option?",
     "At a silhouette a sample may show a back face, even of a closed mesh. Leaving it out can "
     "change a pixel, and a row of the plan must change none."},
    {"How can one be sure that a row changes no bit?",
     "By drawing with and without it and comparing colours, depths and triangles of all pixels: "
     "the tests do that for each row on random scenes."},
    {"Which work cannot be decided before the picture is known?",
     "What is hidden. It is found while drawing; so light is evaluated after visibility, once a "
     "sample."},
};

}  // namespace

constinit const LessonInfo plan{
    "plan",
    "What the plan leaves out",
    "Work that a picture does not need, found before drawing, without changing a bit of it.",
    {},
    commands,
    questions,
    fill_plan};

}  // namespace scanshade::lessons

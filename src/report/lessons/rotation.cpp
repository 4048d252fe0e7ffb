// Interpolation along edges and spans depends on how a polygon lies on the screen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/num/target.hpp"

namespace scanshade::lessons {
namespace {

/// The picture turned by so many degrees, the scene as it is.
LessonOptions turned(const std::string& interpolation, double degrees) {
    const double a = degrees * pi / 180;
    return {{"interpolation", interpolation},
            {"camera-view-up", fmt::format("{:.9f},{:.9f},0", std::sin(a), std::cos(a))}};
}

/// Radiance in the middle of the quadrilateral, which is that of the picture.
Curve middles(const LessonWork& work, const std::string& interpolation) {
    Curve curve{interpolation, {}};
    for (int degrees = 0; degrees <= 90; degrees += 3) {
        const Framebuffer frame = draw_planes(work.input(turned(interpolation, degrees)));
        curve.points.push_back(
            {double(degrees), radiance_at(frame, frame.width / 2, frame.height / 2)});
    }
    return curve;
}

double range(const Curve& curve) {
    const auto [low, high] =
        std::minmax_element(curve.points.begin(), curve.points.end(),
                            [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; });
    return high->y - low->y;
}

void fill_rotation(LessonWork& work) {
    work.paragraph(
        "As first printed, values travel along the two edges that a scanline meets and then along "
        "the span between them. On a triangle that is the same as barycentric interpolation. On a "
        "quadrilateral it is not: which edges meet a scanline depends on how the polygon lies on "
        "the screen, so its inside changes when it turns, though its corners do not. In an "
        "animation the surface seems to flow.");
    std::vector<Figure> edges;
    for (const int degrees : {0, 30, 45, 60})
        edges.push_back(work.picture(fmt::format("edges-{}", degrees), turned("edges", degrees),
                                     fmt::format("edges, turned by {}°", degrees)));
    work.figures(edges);
    work.figures(
        {work.picture("patch-45", turned("patch", 45), "patch: bilinear in (u, v), at 45°"),
         work.picture("perspective-45", turned("perspective", 45),
                      "perspective: two triangles, at 45°; their common edge shows")});
    std::vector<Curve> curves;
    for (const std::string interpolation : {"edges", "patch", "perspective"}) {
        curves.push_back(middles(work, interpolation));
        work.measured(fmt::format("{}: change of the middle while it turns", interpolation),
                      range(curves.back()), "radiance");
    }
    work.figures({work.plot("middle",
                            line_plot({"turn in degrees", "radiance in the middle", 0, 90}, curves),
                            "The middle of the quadrilateral while it turns. Only edges depends on "
                            "the turn. The others disagree with each other, but each with itself "
                            "never.")});
}

constexpr LessonEquation equations[] = {
    {"C2", "I_X = (1 − v)[(1 − u) I_A + u I_B] + v[(1 − u) I_C + u I_D]", "bilinear"},
    {"C3", "I_AB = I_A (y − B_y)/(A_y − B_y) + I_B (A_y − y)/(A_y − B_y)", "along_edge"},
    {"C3", "I_X = I_AB ((AC)_x − x)/((AC)_x − (AB)_x) + I_AC (x − (AB)_x)/((AC)_x − (AB)_x)",
     "along_span"},
};
constexpr LessonCommand commands[] = {
    {"render", "--camera-view-up 1,1,0 -o edges.png"},
    {"render", "--camera-view-up 1,1,0 --interpolation patch -o patch.png"},
    {"render", "--camera-view-up 1,1,0 --interpolation perspective -o perspective.png"},
    {"inspect", "--camera-view-up 1,1,0 --pixel 120,120"},
};
constexpr LessonQuestion questions[] = {
    {"What does edges give for the middle of a square at 0° and at 45°?",
     "At 0° both ends of the span are the middles of edges, and the mean of all four corners comes "
     "out. At 45° they are two corners, and the mean of those two comes out."},
    {"Why is there no such dependence in triangles?",
     "Three values at the corners determine one linear function, and linear interpolation along "
     "any lines gives that function. Four corners determine no linear function in general."},
    {"Modern hardware draws triangles only. What does that cost here?",
     "The result depends on which diagonal cuts the quadrilateral: the radiance has a kink along "
     "it."},
};

}  // namespace

constinit const LessonInfo rotation{
    "rotation",
    "Bilinear interpolation and rotation",
    "Interpolated along edges and spans, a quadrilateral changes its inside when it turns.",
    equations,
    commands,
    questions,
    fill_rotation};

}  // namespace scanshade::lessons

// Interpolation on the screen against interpolation in space.
#include <fmt/format.h>

#include <glm/glm.hpp>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/eq/shading.hpp"

namespace scanshade::lessons {
namespace {

/// How far along a floor a place is that lies t of the way on the screen, between edges of whose
/// distances along the view one is `ratio` times the other.
double in_perspective(double ratio, double t) {
    const double w = 1 / along_edge(1.0, 1 / ratio, 0.0, 1.0, t);
    return (w - 1) / (ratio - 1);
}

/// Of the far edge of the floor to the near one.
double depth_ratio(const Scene& scene) {
    const Camera& camera = *scene.camera;
    const Object& floor = scene.objects.front();
    const auto distance = [&](double z) {
        const glm::dvec3 edge = glm::dvec3(floor.to_world * glm::dvec4(0, 0, z, 1));
        return glm::dot(edge - camera.position, camera.focal_point - camera.position);
    };
    return distance(-1) / distance(1);
}

/// The picture's error with the floor cut into n × n quadrilaterals.
Curve errors_of(const LessonWork& work) {
    const ReportInput edges = work.input({{"interpolation", "edges"}, {"samples", "1"}});
    const ReportInput right = work.input({{"interpolation", "perspective"}, {"samples", "1"}});
    Curve curve{"edges", {}};
    for (const int n : {1, 2, 4, 8, 16, 32, 64, 128}) {
        const Framebuffer frame = draw_planes(with_tessellation(edges, n));
        const Framebuffer reference = draw_planes(with_tessellation(right, n));
        curve.points.push_back({double(n), level_rmse(frame, reference, edges.settings)});
    }
    return curve;
}

void fill_perspective(LessonWork& work) {
    work.paragraph(
        "A projection keeps lines straight but not their middles: equal steps in space become "
        "smaller steps on the screen the farther away they are. Values that are interpolated "
        "linearly on the screen (edges) therefore slide towards the far side. What does travel "
        "linearly on the screen is 1/w, and a/w for each value a; their quotient is a "
        "(perspective).");
    const auto drawn = [&](const std::string& interpolation, int n) {
        const ReportInput input = work.input({{"interpolation", interpolation}});
        return work.picture(fmt::format("{}-{}", interpolation, n), with_tessellation(input, n),
                            fmt::format("{}, {} × {} quadrilaterals", interpolation, n, n));
    };
    work.figures(
        {drawn("perspective", 1), drawn("edges", 1), drawn("edges", 4), drawn("edges", 16)});
    const double ratio = depth_ratio(work.input().scene);
    const auto truth = [&](double t) { return in_perspective(ratio, t); };
    const Axes axes{"part of the way up, on the screen", "part of the way along the floor", 0, 1};
    const Curve errors = errors_of(work);
    work.measured("one quadrilateral: RMSE of edges", errors.points.front().y, "levels of 255");
    work.measured("128 × 128 quadrilaterals: RMSE of edges", errors.points.back().y,
                  "levels of 255");
    work.measured("half-way up on the screen, in truth", truth(0.5), "of the floor");
    work.figures(
        {work.plot("depth",
                   line_plot(axes, {sampled("perspective", axes, truth),
                                    sampled("edges", axes, [](double t) { return t; })}),
                   fmt::format("A floor whose far edge is {:.2g} times as far away as its near "
                               "one.",
                               ratio)),
         work.plot(
             "error",
             line_plot({"quadrilaterals along a side", "RMSE in levels of 255", 1, 128, true, true},
                       {errors}),
             "Smaller polygons have less depth within each: the classic remedy.")});
}

constexpr LessonEquation equations[] = {
    {"C3", "I_AB = I_A (y − B_y)/(A_y − B_y) + I_B (A_y − y)/(A_y − B_y)", "along_edge"},
    {"C3", "I_X = I_AB ((AC)_x − x)/((AC)_x − (AB)_x) + I_AC (x − (AB)_x)/((AC)_x − (AB)_x)",
     "along_span"},
};
constexpr LessonCommand commands[] = {
    {"render", "--interpolation perspective -o perspective.png"},
    {"render", "--interpolation edges -o edges.png"},
    {"render", "--interpolation edges --projection orthographic -o orthographic.png"},
};
constexpr LessonQuestion questions[] = {
    {"In which projection are edges and perspective the same on triangles?",
     "In the orthographic one: w is the same everywhere, so nothing is lost by leaving it out."},
    {"Why is interpolated light more forgiving than a texture?",
     "Its error is the same in (u, v), but light varies slowly over a polygon, while a texture has "
     "edges that show every shift; straight lines of the texture even bend."},
    {"Depth itself is interpolated too. Why is near/w linear on the screen?",
     "On a plane in space 1/w is a linear function of the screen's x and y. So a depth buffer of "
     "near/w needs no division in a span."},
};

}  // namespace

constinit const LessonInfo perspective{
    "perspective",
    "Linear on the screen, or in space",
    "On a floor that runs away from the eye, linear interpolation on the screen bends textures.",
    equations,
    commands,
    questions,
    fill_perspective};

}  // namespace scanshade::lessons

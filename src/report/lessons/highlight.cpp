// A highlight between vertices, which interpolated light cannot show.
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"

namespace scanshade::lessons {
namespace {

constexpr int turns = 60;                // of a sphere, over two of its faces
constexpr double degrees_a_face = 22.5;  // sixteen faces around

/// The brightest pixel while the sphere turns below light and camera.
Curve peaks(const ReportInput& still, std::string label) {
    Curve curve{std::move(label), {}};
    for (int i = 0; i <= turns; ++i) {
        const double degrees = 2 * degrees_a_face * i / turns;
        ReportInput turned = still;
        turned.scene.objects[0].to_world =
            glm::rotate(still.scene.objects[0].to_world, glm::radians(degrees), {0, 1, 0});
        curve.points.push_back({degrees, peak_radiance(draw_planes(turned))});
    }
    return curve;
}

double lowest(const Curve& curve) {
    double y = curve.points.front().y;
    for (const PlotPoint& p : curve.points) y = std::min(y, p.y);
    return y;
}

void fill_highlight(LessonWork& work) {
    work.paragraph(
        "Gouraud shading evaluates light at vertices. A highlight that falls between them is not "
        "sampled, so it is not there; where a vertex happens to lie in it, it is smeared over all "
        "faces around that vertex. In words of signals: the highlight has higher frequencies than "
        "the vertices can carry.");
    const ReportInput gouraud = work.input({{"shading", "gouraud"}, {"samples", "1"}});
    const ReportInput phong = work.input({{"shading", "phong"}, {"samples", "1"}});
    const int fine = 8 * phong.scene.objects[0].tessellation;
    const Framebuffer lost = draw_planes(gouraud), kept = draw_planes(phong);
    const Framebuffer finer = draw_planes(with_tessellation(gouraud, fine));
    work.figures(
        {work.picture("phong", {{"shading", "phong"}}, "phong shading"),
         work.picture("gouraud", {{"shading", "gouraud"}}, "gouraud shading"),
         work.picture("gouraud-fine", with_tessellation(work.input({{"shading", "gouraud"}}), fine),
                      "gouraud shading of 64 times as many polygons")});
    work.measured("brightest pixel, phong shading", peak_radiance(kept), "radiance");
    work.measured("brightest pixel, gouraud shading", peak_radiance(lost), "radiance");
    work.measured("brightest pixel, gouraud shading, 64 times the polygons", peak_radiance(finer),
                  "radiance");

    const Axes axes{"turn in degrees", "radiance of the brightest pixel", 0, 2 * degrees_a_face};
    const Curve at_pixels = peaks(phong, "phong"), at_vertices = peaks(gouraud, "gouraud");
    work.measured("lowest peak while the sphere turns, phong shading", lowest(at_pixels),
                  "radiance");
    work.measured("lowest peak while the sphere turns, gouraud shading", lowest(at_vertices),
                  "radiance");
    work.figures({work.plot("turning", line_plot(axes, {at_pixels, at_vertices}),
                            "The sphere turns by two of its faces; light and camera stay. Under "
                            "gouraud shading the highlight pulses as vertices pass through it.")});
}

constexpr LessonEquation equations[] = {
    {"C3", "I_X = I_AB ((AC)_x − x)/((AC)_x − (AB)_x) + I_AC (x − (AB)_x)/((AC)_x − (AB)_x)",
     "along_span"},
    {"C5", "N_X = N_AB ((AC)_x − x)/((AC)_x − (AB)_x) + N_AC (x − (AB)_x)/((AC)_x − (AB)_x)",
     "span_normal"},
    {"B12", "L_o = L_i (k_d cosθ_i + k_s cosⁿθ_r)", "phong_reflection"},
};
constexpr LessonCommand commands[] = {
    {"render", "--shading gouraud -o gouraud.png"},
    {"render", "--shading gouraud --set shininess=8 -o wide.png"},
    {"inspect", "--shading gouraud --pixel 200,110"},
};
constexpr LessonQuestion questions[] = {
    {"Interpolated light never exceeds the light at the corners. What follows for highlights?",
     "Weights are between 0 and 1 and sum to 1, so inside a polygon no value exceeds the largest "
     "of its corners: a maximum inside a face is lost, never exaggerated."},
    {"Why does a lower exponent make gouraud shading look right?",
     "The highlight gets wider than a face. What varies slowly between two vertices is close to "
     "linear, and then linear interpolation is close to right."},
    {"By which factor must polygons be made smaller when the exponent is four times as large?",
     "The highlight's width goes with 1/√n, so edges must be half as long: four times the "
     "polygons."},
};

}  // namespace

constinit const LessonInfo highlight{
    "highlight",
    "The highlight that Gouraud shading loses",
    "Light that is interpolated between vertices misses what lies between them.",
    equations,
    commands,
    questions,
    fill_highlight};

}  // namespace scanshade::lessons

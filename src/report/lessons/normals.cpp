// Where vertex normals come from, and when there are none.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/num/target.hpp"

namespace scanshade::lessons {
namespace {

/// The largest angle in degrees between a corner's normal and the box's diagonal there.
double lean(const Mesh& box) {
    double worst = 0;
    for (std::size_t v = 0; v < box.vertex_count(); ++v) {
        const glm::dvec3 corner = box.origin + box.unit * glm::dvec3(box.x[v], box.y[v], box.z[v]);
        const glm::dvec3 normal(box.nx[v], box.ny[v], box.nz[v]);
        // By atan2: arccos loses half of the digits near 0.
        worst = std::max(
            worst, std::atan2(glm::length(glm::cross(corner, normal)), glm::dot(corner, normal)));
    }
    return worst * 180 / pi;
}

/// The box alone, without creases, its normals averaged in three ways.
void show_weights(LessonWork& work) {
    std::vector<Figure> weights;
    for (const std::string source : {"average", "area", "angle"}) {
        const LessonOptions options{{"normals", source},
                                    {"crease", "180"},
                                    {"resolution", "200,180"},
                                    {"camera-focal-point", "-2.4,0,0"},
                                    {"camera-view-angle", "17"}};
        const ReportInput input = work.input(options);
        const double degrees =
            work.measured(fmt::format("box, {}: a corner's normal leans by up to", source),
                          lean(*input.scene.objects.front().mesh), "degrees");
        weights.push_back(
            work.picture("weight-" + source, with_object(input, 0),
                         fmt::format("--normals {}: leans by {:.1f}°", source, degrees)));
    }
    work.figures(weights);
}

void fill_normals(LessonWork& work) {
    work.paragraph(
        "A mesh without normals gets them from its faces: the mean of the normals around a vertex, "
        "which hides the polygons of a round thing. Applied to a box the same mean hides its "
        "edges. A crease angle tells the two apart: faces that meet at more than this angle share "
        "no normal.");
    std::vector<Figure> creases;
    for (const int degrees : {10, 60, 180})
        creases.push_back(work.picture(fmt::format("crease-{}", degrees),
                                       {{"crease", fmt::format("{}", degrees)}},
                                       fmt::format("crease angle {}°", degrees)));
    work.figures(creases);
    work.paragraph(
        "At 10° every edge is a crease, also those of the prism; at 180° none is. The box is made "
        "of triangles, and at some of its corners two triangles of a side meet, at others one. The "
        "plain mean counts such a side twice, so its normal leans and the light on the box is "
        "lopsided. Weighted by area it leans as well; weighted by the angle at the corner it does "
        "not, however a side is cut.");
    show_weights(work);
    const ReportInput sheet = with_object(work.input({{"crease", "180"}}), 2);
    work.paragraph(
        "The sheet on the right has two sides over the same corners. Its face normals are "
        "opposite, their sum is zero, and zero has no direction. The program takes the face's "
        "normal there, and counts the event: scanshade info shows it.");
    work.measured("normals of the sheet that cancelled",
                  double(sheet.scene.objects.front().mesh->events[Event::cancelled_normal]));
}

constexpr LessonEquation equations[] = {
    {"C1", "N = Σ N_i / ‖Σ N_i‖", "vertex_normal"},
};
constexpr LessonCommand commands[] = {
    {"render", "--crease 10 -o creased.png"},
    {"render", "--crease 180 -o smooth.png"},
    {"render", "--crease 180 --normals angle -o angle.png"},
    {"info", "--crease 180"},
};
constexpr LessonQuestion questions[] = {
    {"A cylinder with caps and sixteen sides: which crease angles show it as one expects?",
     "More than 22.5°, the angle between neighbouring sides, and less than 90°, that between side "
     "and cap."},
    {"Why do meshes in files often have several normals at one position?",
     "At a crease each side has its own. The position is one, the normals are as many as there are "
     "smooth regions around it."},
    {"What would happen if a cancelled normal were made unit without a check?",
     "0/0: NaN in all three coordinates, which interpolation spreads over the faces around it."},
};

}  // namespace

constinit const LessonInfo normals{
    "normals",
    "Averaged normals and creases",
    "The mean of face normals: round things become smooth, boxes become wrong, sheets have none.",
    equations,
    commands,
    questions,
    fill_normals};

}  // namespace scanshade::lessons

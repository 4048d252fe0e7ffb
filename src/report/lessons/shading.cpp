// Where light is evaluated: three shadings of one scene.
#include <fmt/format.h>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"

namespace scanshade::lessons {
namespace {

struct Way {
    std::string shading, place;
};
const Way ways[] = {{"flat", "once a face"}, {"gouraud", "at vertices"}, {"phong", "at pixels"}};

void fill_shading(LessonWork& work) {
    work.paragraph(
        "Light is dear to evaluate, so it was first evaluated rarely: once a face (flat), then at "
        "vertices with the result interpolated (gouraud), then at every pixel with an interpolated "
        "normal (phong). The brdf is the same in all three pictures, and so are the polygons: the "
        "silhouette shows them even where the shading hides them.");
    std::vector<Figure> figures, errors;
    const ReportInput reference = work.input({{"samples", "1"}, {"shading", "phong"}});
    const Framebuffer at_pixels = draw_planes(reference);
    for (const auto& [shading, place] : ways) {
        figures.push_back(work.picture(shading, {{"shading", shading}},
                                       fmt::format("{}: light {}", shading, place)));
        if (shading == "phong") continue;
        const ReportInput input = work.input({{"samples", "1"}, {"shading", shading}});
        const Framebuffer frame = draw_planes(input);
        const double rmse =
            work.measured(fmt::format("{}: RMSE from phong shading", shading),
                          level_rmse(frame, at_pixels, input.settings), "levels of 255");
        errors.push_back(work.picture(
            shading + "-error", level_heat(frame, at_pixels, input.settings, 128),
            fmt::format("how far {} is from phong: black 0, white 128 levels of 255; RMSE {:.1f}",
                        shading, rmse)));
    }
    work.figures(figures);
    work.paragraph(
        "The difference is largest where the radiance bends most between two vertices: at "
        "highlights, and where the surface turns away from the light.");
    work.figures(errors);
    const Mesh& mesh = *reference.scene.objects.front().mesh;
    work.measured("faces, the most that flat shading can light", double(mesh.face_count()));
    work.measured("vertices, the most that gouraud shading can light", double(mesh.vertex_count()));
    Framebuffer frame;
    const FrameStats stats = Renderer(reference.scene, reference.settings).draw(frame);
    work.measured("pixels that phong shading lights", double(stats.covered_samples));
}

constexpr LessonEquation equations[] = {
    {"C1", "N = Σ N_i / ‖Σ N_i‖", "vertex_normal"},
    {"C7", "f_att I_i [k_d (N·L) + k_s (R·V)ⁿ], or with (N·H)ⁿ", "light_term"},
};
constexpr LessonCommand commands[] = {
    {"render", "--shading flat -o flat.png"},
    {"render", "--shading gouraud -o gouraud.png"},
    {"render", "--shading phong -o phong.png"},
    {"sheet", "-o sheet.png"},
};
constexpr LessonQuestion questions[] = {
    {"Which parts of the three pictures are the same, and why?",
     "The silhouette and the visible faces: shading decides where light is evaluated, not which "
     "samples a polygon covers. The background, too, and the parts that only ambient light "
     "reaches."},
    {"When does gouraud shading light more points than phong shading?",
     "When vertices outnumber pixels: a fine mesh far away. Then even flat shading lights more."},
    {"'Phong' names two things. Which of them is chosen by --shading, which by --brdf?",
     "--shading phong is Phong's interpolation of normals, light at every pixel. --brdf phong is "
     "his reflection model with the mirror direction. Either can be used without the other."},
};

}  // namespace

constinit const LessonInfo shading{
    "shading",
    "Flat, Gouraud, Phong",
    "One scene, one brdf, three shadings: light once a face, at vertices, at pixels.",
    equations,
    commands,
    questions,
    fill_shading};

}  // namespace scanshade::lessons

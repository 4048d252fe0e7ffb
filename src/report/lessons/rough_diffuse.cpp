// Lambert's surface against a rough one.
#include <fmt/format.h>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/eq/reflection.hpp"

namespace scanshade::lessons {
namespace {

/// How bright the disc is at 90 % of its radius, against its middle.
double rim_share(const Framebuffer& frame, double radius) {
    const int row = frame.height / 2, middle = frame.width / 2;
    return radiance_at(frame, middle + int(0.9 * radius), row) / radiance_at(frame, middle, row);
}

void fill_rough_diffuse(LessonWork& work) {
    work.paragraph(
        "The full moon is a flat disc: its rim is about as bright as its middle. Lambert's law "
        "would make it a ball that darkens as cosθ. Oren and Nayar take a rough surface for "
        "V-shaped cavities of Lambertian facets: seen from where the light comes, the facets that "
        "face the light are those that one sees, so the rim stays bright.");
    const double radius = 100.5 / (10 * std::tan(6.25 * pi / 180));
    std::vector<Figure> figures{work.picture("lambert", {{"brdf", "lambert"}}, "lambert")};
    std::vector<Curve> rows;
    const LessonOptions once{{"samples", "1"}, {"resolution", "201,201"}};
    const auto add = [&](const ReportInput& input, const std::string& name) {
        const Framebuffer frame = draw_planes(input);
        Curve row = row_curve(frame, frame.height / 2, name);
        for (PlotPoint& p : row.points) p.x = (p.x - 100.5) / radius;
        rows.push_back(std::move(row));
        work.measured(fmt::format("{}: rim against middle, at 90 % of the radius", name),
                      rim_share(frame, radius));
    };
    LessonOptions lambert = once;
    lambert.emplace_back("brdf", "lambert");
    add(work.input(lambert), "lambert");
    for (const double sigma : {0.2, 0.6, 1.2}) {
        const std::string name = fmt::format("σ = {:g}", sigma);
        figures.push_back(work.picture(fmt::format("sigma-{:g}", sigma),
                                       with_parameter(work.input(), "sigma", sigma),
                                       "oren-nayar, " + name));
        add(with_parameter(work.input(once), "sigma", sigma), name);
    }
    work.figures(figures);
    work.figures({work.plot(
        "row", line_plot({"distance from the middle, of the radius", "radiance", -1, 1}, rows),
        "Radiance across the ball.")});
    const LessonOptions beside{{"light", "directional:-1,0,-0.3"}};
    LessonOptions beside_lambert = beside;
    beside_lambert.emplace_back("brdf", "lambert");
    work.paragraph(
        "Under light from the side the difference is small; the roughness shows towards the light "
        "only.");
    work.figures({work.picture("side-lambert", beside_lambert, "lambert, light from the right"),
                  work.picture("side", beside, "oren-nayar, σ = 0.6, light from the right")});
}

constexpr LessonEquation equations[] = {
    {"B6", "f_r = ρ_d/π", "lambert_brdf"},
    {"B20", "A = 1 − σ²/(2(σ² + 0.33)),   B = 0.45 σ²/(σ² + 0.09)", "oren_nayar_coefficients"},
    {"B20", "f_r = ρ/π (A + B max(0, cos(θ_i − θ_o)) sinα tanβ)", "oren_nayar_f_cos"},
};
constexpr LessonCommand commands[] = {
    {"render", "--brdf lambert -o lambert.png"},
    {"render", "--set sigma=1.2 -o rough.png"},
    {"render", "--set sigma=0 -o smooth.png"},
};
constexpr LessonQuestion questions[] = {
    {"What is left of B20 at σ = 0?", "A = 1 and B = 0: Lambert's ρ/π."},
    {"Does a rough surface reflect more light than a smooth one?",
     "No: A falls with σ, so the middle is darker. Light is given back towards where it came from "
     "instead of into all directions alike."},
    {"B20 is printed with cos(θ_i − θ_o). Which angle is meant?",
     "The difference of azimuths, φ_i − φ_o. With polar angles the model would brighten the side "
     "away from the light as much; docs/equations.md lists the correction and its test."},
};

}  // namespace

constinit const LessonInfo rough_diffuse{"rough-diffuse",
                                         "Rough and matt: Lambert against Oren-Nayar",
                                         "Why the full moon is a disc and not a ball.",
                                         equations,
                                         commands,
                                         questions,
                                         fill_rough_diffuse};

}  // namespace scanshade::lessons

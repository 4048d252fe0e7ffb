// Light sources: how they weaken with distance, and where they shine to.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/eq/radiometry.hpp"
#include "scanshade/eq/shading.hpp"

namespace scanshade::lessons {
namespace {

constexpr double degree = pi / 180;

/// The floor from straight above, so that a row of pixels is a line on the floor.
LessonOptions from_above(double angle) {
    return {{"camera-position", "0,10,0"},
            {"camera-focal-point", "0,0,0"},
            {"camera-view-up", "0,0,-1"},
            {"camera-view-angle", fmt::format("{}", angle)},
            {"projection", "orthographic"},
            {"resolution", "320,8"},
            {"samples", "1"}};
}

/// Along x in units of the scene. The picture of 8 rows shows 2 · 10 tan(angle/2) units from top to
/// bottom.
Curve floor_curve(const ReportInput& input, double angle, std::string label) {
    const Framebuffer frame = draw_planes(input);
    const double unit = frame.height / (20 * std::tan(angle / 2 * degree));
    Curve curve = row_curve(frame, frame.height / 2, std::move(label));
    for (PlotPoint& p : curve.points) p.x = (p.x - frame.width / 2.0) / unit;
    return curve;
}

// ---- attenuation

struct Law {
    const char *name, *file;
    double c, l, q;

    double at(double d) const { return scanshade::attenuation(d, c, l, q); }
};
constexpr Law laws[] = {{"c = 1", "constant", 1, 0, 0},
                        {"c = 1, l = 1", "linear", 1, 1, 0},
                        {"c = 1, q = 1", "softened", 1, 0, 1},
                        {"q = 1", "square", 0, 0, 1}};

LessonOptions lamp(const Law& law) {
    return {{"light", fmt::format("point:0,0.6,0:1,1,1:{},{},{}", law.c, law.l, law.q)}};
}

double saturated(const Framebuffer& frame) {
    double count = 0;
    for (std::size_t i = 0; i < frame.r.size(); ++i) count += frame.r[i] >= 1;
    return count;
}

/// The largest relative difference between what is drawn along the floor and C7 by hand.
double difference_by_hand(const LessonWork& work, const Law& law) {
    constexpr double angle = 1.2, height = 0.6, kd = 0.8;
    LessonOptions options = from_above(angle);
    options.push_back(lamp(law).front());
    double worst = 0;
    for (const PlotPoint& p : floor_curve(work.input(options), angle, "").points) {
        if (std::abs(p.x) > 4.9 * 0.8) continue;
        const double z = 0.5 * 20 * std::tan(angle / 2 * degree) / 8;  // of the row's centre
        const double d = std::sqrt(p.x * p.x + z * z + height * height);
        const double by_hand = kd * height / d * law.at(d);
        worst = std::max(worst, std::abs(p.y - by_hand) / by_hand);
    }
    return worst;
}

void fill_attenuation(LessonWork& work) {
    work.paragraph(
        "Light of a small lamp spreads over spheres, so it weakens with the square of the "
        "distance. Classic pictures use f_att = 1/(c + l d + q d²) instead: c keeps it finite "
        "close to the lamp, l makes the fall gentler than physics, c alone switches it off. The "
        "darkening on this floor is f_att times cosθ_i, which falls with the distance as well.");
    std::vector<Figure> figures;
    std::vector<Curve> near, far;
    const Axes near_axes{"distance d", "f_att", 0, 4, false, false, 0, 2};
    const Axes far_axes{"distance d", "f_att", 0.1, 100, true, true};
    for (const Law& law : laws) {
        figures.push_back(work.picture(law.file, lamp(law), law.name));
        const auto value = [&](double d) { return law.at(std::max(d, 0.01)); };
        near.push_back(sampled(law.name, near_axes, value));
        far.push_back(sampled(law.name, far_axes, value));
        LessonOptions once = lamp(law);
        once.emplace_back("samples", "1");
        work.measured(fmt::format("{}: pixels too bright to show", law.name),
                      saturated(draw_planes(work.input(once))), "pixels");
    }
    work.figures(figures);
    work.figures(
        {work.plot("near", line_plot(near_axes, near), "Close to the lamp."),
         work.plot("far", line_plot(far_axes, far),
                   "Over three powers of ten: far away all that counts is the highest power.")});
    work.measured("c = 1, q = 1: largest difference of a drawn row from C7 by hand, relative",
                  difference_by_hand(work, laws[2]));
}

constexpr LessonEquation attenuation_equations[] = {
    {"C7", "f_att = 1/(c + l d + q d²)", "attenuation"},
    {"A5", "dω = dA cosθ / r²", "solid_angle_of_area"},
};
constexpr LessonCommand attenuation_commands[] = {
    {"render", "--light point:0,0.6,0:1,1,1:0,0,1 -o square.png"},
    {"render", "--light point:0,0.6,0:1,1,1:0.2,0,1 -o softened.png"},
    {"inspect", "--pixel 120,90"},
};
constexpr LessonQuestion attenuation_questions[] = {
    {"Why is there no attenuation for directional light?",
     "It comes from so far away that all distances in the scene are the same in proportion."},
    {"A disc of area A lights a point on its axis as 1/(A/π + d²). What does that say about c?",
     "c = A/π with q = 1 is the attenuation of a lamp of finite size, times its own area: the "
     "constant is physics, too. The Cornell box of models/scenes uses it."},
    {"What does a renderer gain where c alone is set?",
     "Distances need not be computed: the row 'attenuation' of scanshade explain says so."},
};

// ---- spot and cosine lights

ReportInput one_light(const ReportInput& input, std::size_t light) {
    ReportInput out = input;
    out.scene.lights = {input.scene.lights.at(light)};
    return out;
}

/// A light's factor along a line below it, over the angle from its axis.
double emitted(const Light& light, double angle) {
    const Vec3<double> w{std::sin(angle), -std::cos(angle), 0}, down{0, -1, 0};
    if (light.kind == LightKind::cosine) return cosine_light(w, down);
    const double cutoff = std::cos(light.cutoff_deg * degree);
    const double inner = std::cos((light.cutoff_deg - light.penumbra_deg) * degree);
    return spot_light(w, down, cutoff, inner > cutoff ? 1 / (inner - cutoff) : 0);
}

/// What each light sends out, and what of it arrives on the floor.
void plot_lights(LessonWork& work) {
    constexpr double angle = 2;
    const char* names[] = {"spot", "soft spot", "cosine"};
    const Axes angles{"angle from the axis, degrees", "I(ω)/I₀", 0, 100};
    std::vector<Curve> emission, floor;
    const ReportInput input = work.input(from_above(angle));
    for (std::size_t i = 0; i < std::size(names); ++i) {
        const Light& light = input.scene.lights[i];
        emission.push_back(sampled(
            names[i], angles, [&](double a) { return emitted(light, a * degree); }, 401));
        floor.push_back(floor_curve(one_light(input, i), angle, names[i]));
    }
    const double end = floor.front().points.back().x;
    work.figures(
        {work.plot("emission", line_plot(angles, emission), "What the lights send out."),
         work.plot("floor", line_plot({"place on the floor", "radiance", -end, end}, floor),
                   "What arrives along a line on the floor, drawn with phong shading.")});
}

void fill_lights(LessonWork& work) {
    work.paragraph(
        "A spot light shines into a cone of half angle τ, with a hard rim as printed or with a "
        "soft one inside of it. A cosine light is a small flat lamp: full ahead, nothing to the "
        "sides or behind. Both are point lights whose intensity depends on the direction.");
    const int fine = 64;
    work.figures(
        {work.picture("phong", {{"shading", "phong"}}, "phong shading"),
         work.picture("gouraud", {{"shading", "gouraud"}}, "gouraud shading of the same floor"),
         work.picture("gouraud-fine", with_tessellation(work.input({{"shading", "gouraud"}}), fine),
                      "gouraud shading, 64 × 64 faces")});
    work.paragraph(
        "The rim of a spot is a high frequency. Gouraud shading samples it at vertices only: the "
        "pool of light takes the shape of the faces that touch it.");
    plot_lights(work);
    const ReportInput phong = work.input({{"samples", "1"}, {"shading", "phong"}});
    const ReportInput coarse = work.input({{"samples", "1"}, {"shading", "gouraud"}});
    const Framebuffer at_pixels = draw_planes(phong);
    work.measured("gouraud shading: RMSE from phong shading",
                  level_rmse(draw_planes(coarse), at_pixels, phong.settings), "levels of 255");
    work.measured(
        "gouraud shading, 64 × 64 faces: RMSE from phong shading",
        level_rmse(draw_planes(with_tessellation(coarse, fine)), at_pixels, phong.settings),
        "levels of 255");
}

constexpr LessonEquation light_equations[] = {
    {"A14", "I(ω) = I₀ (ω·d),   0 behind", "cosine_light"},
    {"A15", "I(ω) = I₀ where ∠(ω, d) < τ, else 0", "spot_light"},
};
constexpr LessonCommand light_commands[] = {
    {"render", "--shading gouraud -o gouraud.png"},
    {"render", "--light spot:0,2.5,0:0,-1,0:40 -o spot.png"},
    {"render", "--light cosine:0,1,0:0.5,-1,0 -o cosine.png"},
};
constexpr LessonQuestion light_questions[] = {
    {"On the floor below a cosine light, which power of the cosine does the radiance follow?",
     "The fourth: one cosine from the lamp, one from the floor, two from the square of the "
     "distance if q alone is set. Here, without attenuation, it is the second."},
    {"Why does the program compare cosines and not angles with the cutoff?",
     "The cosine falls from 0° to 180°, so it is the same comparison without an arccos for each "
     "point."},
    {"Why does the hard rim need more samples than the soft one?",
     "It is a step. A step has all frequencies, so any number of samples a pixel leaves stairs, "
     "only smaller ones. The soft rim is wider than a pixel."},
};

}  // namespace

constinit const LessonInfo attenuation{
    "attenuation",
    "Attenuation",
    "How a lamp weakens with distance: constant, linear, quadratic.",
    attenuation_equations,
    attenuation_commands,
    attenuation_questions,
    fill_attenuation};

constinit const LessonInfo lights{
    "lights",
    "Spot and cosine lights",
    "Lights that do not shine into all directions alike, and what vertices make of their rims.",
    light_equations,
    light_commands,
    light_questions,
    fill_lights};

}  // namespace scanshade::lessons

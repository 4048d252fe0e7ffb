// How much light a highlight gives back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/brdf_values.hpp"
#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/num/target.hpp"

namespace scanshade::lessons {
namespace {

constexpr double exponents[] = {0.25, 20, 400};

MaterialParams<double> half_and_half(std::string_view brdf, double n) {
    const bool modified = brdf == "modified-phong";
    const std::string from = "the lesson";
    return resolve_material({}, brdf,
                            {{modified ? "rho_d" : "kd", {0.5}, from, {}},
                             {modified ? "rho_s" : "ks", {0.5}, from, {}},
                             {modified ? "n" : "shininess", {n}, from, {}}})
        .params;
}

/// The ball in a furnace: light of radiance 1 from all directions, as many lights at equal
/// distances on a spiral. What reflects all of it cannot be told from the background.
ReportInput furnace(const LessonWork& work, std::string_view brdf, double n) {
    constexpr int count = 500;
    ReportInput input = work.input({{"brdf", std::string(brdf)},
                                    {"samples", "1"},
                                    {"background", "1,1,1"},
                                    {"exposure", "-1"}});
    input.scene.lights.clear();
    const double golden = pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), a = golden * i;
        Light light;
        light.kind = LightKind::directional;
        light.direction = {r * std::cos(a), r * std::sin(a), z};
        light.intensity = glm::dvec3(4.0 / count);  // E = π I for a solid angle of 4π/count
        input.scene.lights.push_back(light);
    }
    return with_parameter(std::move(input), brdf == "phong" ? "shininess" : "n", n);
}

Curve albedo_curve(std::string_view name, double n) {
    const BrdfInfo& brdf = *find_brdf(name);
    const MaterialParams<double> params = half_and_half(name, n);
    Curve curve{fmt::format("n = {:g}", n), {}};
    for (int degrees = 0; degrees <= 88; degrees += 2)
        curve.points.push_back({double(degrees), albedo(brdf, params, degrees * pi / 180)});
    return curve;
}

double largest(const std::vector<Curve>& curves) {
    double y = 0;
    for (const Curve& curve : curves)
        for (const PlotPoint& p : curve.points) y = std::max(y, p.y);
    return y;
}

/// Under one light, and in the furnace.
void show_model(LessonWork& work, const std::string& brdf) {
    const std::string name = brdf == "phong" ? "shininess" : "n";
    std::vector<Figure> figures;
    for (const double n : exponents)
        figures.push_back(
            work.picture(fmt::format("{}-{:g}", brdf, n),
                         with_parameter(work.input({{"brdf", brdf}, {"exposure", "-1"}}), name, n),
                         fmt::format("{}, n = {:g}, one light", brdf, n)));
    for (const double n : {exponents[0], exponents[1]})
        figures.push_back(work.picture(fmt::format("{}-furnace-{:g}", brdf, n),
                                       furnace(work, brdf, n),
                                       fmt::format("{}, n = {:g}, in a furnace", brdf, n)));
    work.figures(figures);
}

Figure albedo_plot(LessonWork& work, const std::string& brdf) {
    std::vector<Curve> curves;
    for (const double n : exponents) curves.push_back(albedo_curve(brdf, n));
    work.measured(fmt::format("{}: largest albedo", brdf), largest(curves));
    work.measured(fmt::format("{}: albedo at n = {:g}, from above", brdf, exponents[2]),
                  curves.back().points.front().y);
    return work.plot(
        brdf + "-albedo",
        line_plot({"θ_o in degrees", "albedo ρ(ω_o)", 0, 90, false, false, 0, 1.6}, curves),
        brdf + ": the part of uniform light that a viewer sees again.");
}

void fill_energy(LessonWork& work) {
    work.paragraph(
        "A surface must not give back more light than it gets. Phong's model keeps the peak of the "
        "highlight whatever its width, so a wide one (n < 1) gives back too much and a narrow one "
        "almost nothing. The modified model is normalised: its factor (n + 2)/2 raises the peak as "
        "the lobe narrows, so that ρ_s is the reflected part.");
    for (const char* brdf : {"phong", "modified-phong"}) show_model(work, brdf);
    work.paragraph(
        "In the furnace light of the same radiance comes from everywhere. A ball that gives back "
        "all of it would vanish before the background; a brighter one breaks the law, a darker one "
        "loses light. k_d = k_s = ρ_d = ρ_s = ½ everywhere.");
    std::vector<Figure> plots;
    for (const char* brdf : {"phong", "modified-phong"}) plots.push_back(albedo_plot(work, brdf));
    work.figures(plots);
    const Framebuffer frame = draw_planes(furnace(work, "modified-phong", 20));
    work.measured("modified-phong, n = 20: middle of the ball in the furnace",
                  radiance_at(frame, frame.width / 2, frame.height / 2));
    work.measured("modified-phong, n = 20: albedo from above, by quadrature",
                  albedo(*find_brdf("modified-phong"), half_and_half("modified-phong", 20), 0));
}

constexpr LessonEquation equations[] = {
    {"B5", "ρ(ω_o) = ∫ f_r(ω_i → ω_o) cosθ_i dω_i", "albedo_term"},
    {"B12", "L_o = L_i (k_d cosθ_i + k_s cosⁿθ_r)", "phong_reflection"},
    {"B14", "f_r = ρ_d/π + ρ_s (n + 2)/(2π) cosⁿθ_r,   ρ_d + ρ_s ≤ 1", "modified_phong_brdf"},
};
constexpr LessonCommand commands[] = {
    {"render", "--set n=400 --exposure -1 -o modified.png"},
    {"render", "--brdf phong --set shininess=400 --exposure -1 -o phong.png"},
    {"explain", "--brdf phong"},
};
constexpr LessonQuestion questions[] = {
    {"Why does the modified model lose light towards grazing angles?",
     "Part of its lobe points below the surface. What would go there is not given back, so the "
     "albedo falls below ρ_d + ρ_s."},
    {"Which of the two is reciprocal?",
     "The modified one: cosθ_r is the same with light and viewer exchanged. Phong's reflected "
     "light has no cosθ_i in its specular part, so its f_r has 1/cosθ_i."},
    {"A narrower highlight of the modified model saturates the picture. Is that wrong?",
     "No: the same light in a smaller angle is brighter. Exposure, not the model, is to be "
     "changed."},
};

}  // namespace

constinit const LessonInfo energy{
    "energy",
    "Energy: Phong against modified Phong",
    "What a highlight gives back: too much, almost nothing, or what its parameter says.",
    equations,
    commands,
    questions,
    fill_energy};

}  // namespace scanshade::lessons

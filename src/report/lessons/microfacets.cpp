// Rough mirrors: D, G and F one at a time; and Fresnel's F beside Schlick's.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/eq/fresnel.hpp"
#include "scanshade/eq/microfacet.hpp"

namespace scanshade::lessons {
namespace {

constexpr double degree = pi / 180;

// ---- microfacets

std::string distribution_plot(double m) {
    const Axes axes{"θ_h in degrees", "D(h) in 1/sr", 0, 90};
    const double norm = gaussian_norm(m);
    const auto at = [&](auto&& density) {
        return [=](double degrees) {
            const double c = std::cos(degrees * degree), s = std::sin(degrees * degree);
            return density(std::max(c, 0.0), s * s);
        };
    };
    return line_plot(
        axes,
        {sampled("ggx", axes, at([=](double c, double s2) { return D_ggx(c, s2, m); })),
         sampled("beckmann", axes, at([=](double c, double s2) { return D_beckmann(c, s2, m); })),
         sampled("blinn", axes, at([=](double c, double s2) { return D_blinn(c, s2, m); })),
         sampled("gaussian", axes,
                 at([=](double c, double s2) { return D_gaussian(c, s2, m, norm); }))});
}

/// G for a viewer above: h is half-way to the light.
std::string shadowing_plot() {
    const Axes axes{"θ_i in degrees", "G", 0, 90};
    const auto smith = [](double m) {
        return [=](double degrees) {
            return 4 * smith_over_4_cos_o(std::cos(degrees * degree), 1.0, m);
        };
    };
    const auto cavity = [](double degrees) {
        const double half = std::cos(degrees / 2 * degree);
        return G_v_cavity(std::cos(degrees * degree), 1.0, half, half);
    };
    return line_plot(
        axes,
        {sampled("v-cavity", axes, cavity), sampled("smith, m = 0.2", axes, smith(0.2)),
         sampled("smith, m = 0.5", axes, smith(0.5)), sampled("smith, m = 1", axes, smith(1))});
}

void fill_microfacets(LessonWork& work) {
    work.paragraph(
        "Torrance and Sparrow take a rough surface for many small mirrors. Three factors say what "
        "they do: D, how many of them lie so that they reflect light to the viewer; G, how many of "
        "those are neither in the shadow of others nor hidden by them; F, how much a mirror "
        "reflects. Here one factor changes in each row, and the others stay.");
    const auto strip = [&](const std::string& name, const std::vector<std::string>& values,
                           double m) {
        std::vector<Figure> figures;
        for (const std::string& value : values)
            figures.push_back(work.picture(
                fmt::format("{}-{}", name, value),
                with_parameter(work.input({{"set", fmt::format("{}={}", name, value)}}), "m", m),
                fmt::format("{} = {}", name, value)));
        return figures;
    };
    const ReportInput smith = work.input({{"samples", "1"}, {"set", "m=0.6"}});
    const ReportInput cavity =
        work.input({{"samples", "1"}, {"set", "m=0.6"}, {"set", "shadowing=v-cavity"}});
    const Framebuffer with_smith = draw_planes(smith), with_cavity = draw_planes(cavity);
    std::vector<Figure> shadowings = strip("shadowing", {"smith", "v-cavity"}, 0.6);
    shadowings.push_back(work.picture("shadowing-difference",
                                      level_heat(with_cavity, with_smith, smith.settings, 64),
                                      "where the two differ: white is 64 levels"));
    work.figures(strip("distribution", {"ggx", "beckmann", "blinn", "gaussian"}, 0.3));
    work.figures(shadowings);
    work.figures(strip("f0", {"0.04", "0.3", "0.95"}, 0.3));
    work.figures(
        {work.plot("D", distribution_plot(0.3),
                   "D at m = 0.3. GGX has the longest tail: its highlights glow."),
         work.plot("G", shadowing_plot(),
                   "G for a viewer above. V-shaped cavities hide nothing until 60°, and do not "
                   "know the roughness.")});
    work.measured("D(0) of ggx at m = 0.3", D_ggx(1.0, 0.0, 0.3), "1/sr");
    work.measured("largest difference of smith and v-cavity",
                  level_max(with_cavity, with_smith, smith.settings), "levels of 255");
}

constexpr LessonEquation facet_equations[] = {
    {"B16", "f_r = F(θ_i) G(ω_i, ω_o) D(h)/(4 cosθ_i cosθ_o)", "torrance_sparrow_f_cos"},
    {"B17d", "D(h) = m²/(π ((n·h)² (m² − 1) + 1)²)", "D_ggx"},
    {"B17c", "D(h) = e^(((n·h)² − 1)/(m² (n·h)²))/(π m² (n·h)⁴)", "D_beckmann"},
    {"B18a", "G = min{1, 2 (n·h)(n·ω_o)/(ω_o·h), 2 (n·h)(n·ω_i)/(ω_o·h)}", "G_v_cavity"},
    {"B18b", "G(ω_i, ω_o) = G(ω_i) G(ω_o)", "smith_over_4_cos_o"},
};
constexpr LessonCommand facet_commands[] = {
    {"render", "--set distribution=beckmann -o beckmann.png"},
    {"render", "--set shadowing=v-cavity --set m=0.6 -o v-cavity.png"},
    {"render", "--set f0=0.95,0.64,0.54 --set rho=0 -o copper.png"},
    {"inspect", "--pixel 120,80"},
};
constexpr LessonQuestion facet_questions[] = {
    {"Why is D a density over solid angle, and not a probability?",
     "It counts facets by their directions; ∫ D cosθ_h dω = 1 says that their areas, projected "
     "onto the surface, fill it. So D may be far above 1 where the facets are nearly parallel."},
    {"B16 divides by cosθ_i cosθ_o. Why does it not blow up at grazing angles?",
     "G goes to 0 there at least as fast: at grazing angles almost all facets are hidden. The "
     "program computes G/(4 cosθ_o) in one, so that no 0/0 arises."},
    {"Which factor gives metals their colour?",
     "F: F(0) of a metal differs from channel to channel. D and G are geometry and have no "
     "colour."},
};

// ---- fresnel

double exact(double degrees, double eta) {
    return fresnel_dielectric(std::max(std::cos(degrees * degree), 0.0), 1 / eta);
}
double schlick(double degrees, double eta) {
    const double f0 = normal_reflectance(1 / eta);
    return fresnel_schlick(Rgb<double>{f0, f0, f0}, std::max(std::cos(degrees * degree), 0.0)).g;
}

struct Substance {
    const char* name;
    double eta;
};
constexpr Substance substances[] = {{"water", 1.33}, {"glass", 1.5}, {"diamond", 2.42}};

void fill_fresnel(LessonWork& work) {
    work.paragraph(
        "How much a smooth surface reflects follows from Fresnel's equations: little from above, "
        "all at grazing angles. Schlick's polynomial has the same value at both ends and needs no "
        "root. Its error is small between them, but not small in proportion where F itself is "
        "small.");
    const LessonOptions by_fresnel{{"set", "fresnel=dielectric"}};
    const LessonOptions by_schlick{{"set", "fresnel=schlick"}};
    const ReportInput a = work.input(by_fresnel), b = work.input(by_schlick);
    const Framebuffer fresnel_frame = draw_planes(a), schlick_frame = draw_planes(b);
    work.figures(
        {work.picture("exact", by_fresnel, "Fresnel's equations, η = 1.5"),
         work.picture("schlick", by_schlick, "Schlick's polynomial, F(0) = 0.04"),
         work.picture("difference", level_heat(schlick_frame, fresnel_frame, a.settings, 16),
                      "the difference: white is 16 levels")});
    const Axes axes{"θ_i in degrees", "F", 0, 90};
    const Axes error_axes{"θ_i in degrees", "Schlick − Fresnel", 0, 90};
    std::vector<Curve> values, errors;
    for (const auto& [name, eta] : substances) {
        values.push_back(sampled(name, axes, [eta = eta](double d) { return exact(d, eta); }));
        values.push_back(
            sampled("by Schlick", axes, [eta = eta](double d) { return schlick(d, eta); }));
        values.back().dashed = true;
        errors.push_back(sampled(
            name, error_axes, [eta = eta](double d) { return schlick(d, eta) - exact(d, eta); }));
        const auto worst = std::max_element(
            errors.back().points.begin(), errors.back().points.end(),
            [](const PlotPoint& p, const PlotPoint& q) { return std::abs(p.y) < std::abs(q.y); });
        work.measured(fmt::format("{}: largest error of Schlick, at {:.1f}°", name, worst->x),
                      worst->y);
    }
    work.measured("largest difference of the pictures",
                  level_max(schlick_frame, fresnel_frame, a.settings), "levels of 255");
    work.figures(
        {work.plot("F", line_plot(axes, values), "Reflectance over the angle of incidence."),
         work.plot("error", line_plot(error_axes, errors), "The error of Schlick's polynomial.")});
}

constexpr LessonEquation fresnel_equations[] = {
    {"B11", "F = (F_s + F_p)/2", "fresnel_dielectric"},
    {"B19", "F(0) = ((η_i − η_o)/(η_i + η_o))²", "normal_reflectance"},
    {"B19", "F(θ_i) = F(0) + (1 − F(0))(1 − cosθ_i)⁵", "fresnel_schlick"},
};
constexpr LessonCommand fresnel_commands[] = {
    {"render", "--set fresnel=dielectric -o exact.png"},
    {"render", "--set fresnel=schlick -o schlick.png"},
    {"render", "--set eta=2.42 -o diamond.png"},
};
constexpr LessonQuestion fresnel_questions[] = {
    {"At which angle is F_p zero, and what is that good for?",
     "At Brewster's angle, arctan(η_o/η_i): 56° for glass in air. Reflected light is polarised "
     "there, so a polarising filter takes reflections away."},
    {"Of which angle is F in a microfacet model?",
     "Of the angle between light and half vector, not the surface's normal: the facet is the "
     "mirror."},
    {"Why is the error of Schlick's polynomial zero at 0° and at 90°?",
     "At 0° it is F(0) by construction, and (1 − cosθ)⁵ is 1 at 90°, where everything is "
     "reflected."},
};

}  // namespace

constinit const LessonInfo microfacets{
    "microfacets",   "Microfacets: D, G, F", "Torrance and Sparrow's three factors, one at a time.",
    facet_equations, facet_commands,         facet_questions,
    fill_microfacets};

constinit const LessonInfo fresnel{
    "fresnel",
    "Schlick against Fresnel",
    "How much a surface reflects at each angle, exactly and by a polynomial.",
    fresnel_equations,
    fresnel_commands,
    fresnel_questions,
    fill_fresnel};

}  // namespace scanshade::lessons

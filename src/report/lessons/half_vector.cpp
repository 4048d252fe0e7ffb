// Mirror direction against half vector.
#include <fmt/format.h>

#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/num/target.hpp"

namespace scanshade::lessons {
namespace {

/// The highlight alone on the ball, for a light that stands so many degrees beside the camera.
ReportInput ball(const LessonWork& work, const std::string& brdf, double degrees) {
    const double a = degrees * pi / 180;
    ReportInput input = work.input(
        {{"brdf", brdf},
         {"light", fmt::format("directional:{:.9f},0,{:.9f}", -std::sin(a), -std::cos(a))},
         {"resolution", "96,96"},
         {"samples", "1"},
         {"transfer", "linear"},
         {"set", "kd=0"},
         {"camera-position", "-0.9,0.8,6"},
         {"camera-focal-point", "-0.9,0.8,0"},
         {"camera-view-angle", "16"}});
    return with_object(input, 0);
}

/// By what the exponent must be multiplied for blinn-phong to come nearest to phong.
double matching_factor(const LessonWork& work, double exponent, double degrees) {
    const ReportInput phong = ball(work, "phong", degrees);
    const ReportInput blinn = ball(work, "blinn-phong", degrees);
    const Framebuffer wanted = draw_planes(with_parameter(phong, "shininess", exponent));
    return least_at(0.5, 8, [&](double factor) {
        const Framebuffer got = draw_planes(with_parameter(blinn, "shininess", factor * exponent));
        return level_rmse(got, wanted, phong.settings);
    });
}

/// Which factor fits best, for all exponents and for lights from the side.
void plot_factors(LessonWork& work) {
    Curve by_exponent{"best factor", {}}, by_angle{"best factor", {}};
    for (const double n : {4.0, 10.0, 25.0, 60.0, 150.0, 400.0})
        by_exponent.points.push_back({n, matching_factor(work, n, 10)});
    for (const double degrees : {5.0, 30.0, 60.0, 90.0, 120.0})
        by_angle.points.push_back({degrees, matching_factor(work, 60, degrees)});
    const Axes exponents{"exponent n of phong", "factor", 4, 400, true, false, 0, 5};
    const Axes angles{
        "angle between light and camera, degrees", "factor", 0, 120, false, false, 0, 5};
    const auto four = [](double) { return 4.0; };
    const auto across = [](double degrees) {
        const double c = std::cos(degrees / 2 * pi / 180);
        return 4 * c * c;
    };
    Curve along = sampled("4, along", angles, four);
    Curve beside = sampled("4 cos²θ, across", angles, across);
    Curve theory = sampled("4", exponents, four);
    along.dashed = beside.dashed = theory.dashed = true;
    work.figures(
        {work.plot("exponents", line_plot(exponents, {by_exponent, theory}),
                   "The factor that makes the two pictures of the ball most alike, by search for "
                   "the least RMSE; light beside the camera."),
         work.plot("angles", line_plot(angles, {by_angle, along, beside}),
                   "The same for n = 60 and a light that moves away: across the plane of light and "
                   "camera the mirror direction turns slower than twice the normal, by cosθ, so no "
                   "factor fits both ways.")});
    work.measured("best factor for n = 60, light near the camera", by_angle.points.front().y);
    work.measured("best factor for n = 60, light at 120°", by_angle.points.back().y);
}

void fill_half_vector(LessonWork& work) {
    work.paragraph(
        "Phong's model raises the cosine of the angle between viewer and mirror direction, (R·V)ⁿ; "
        "Blinn's the cosine of the angle between normal and half vector, (N·H)ⁿ. The second angle "
        "is about half of the first, and cos⁴ᵃ(θ/2) ≈ cosᵃ θ for small θ: Blinn-Phong needs about "
        "four times the exponent. Printed as an approximation with the same exponent, it is none.");
    work.figures({work.picture("phong", LessonOptions{}, "phong, n = 40"),
                  work.picture("blinn-40", {{"brdf", "blinn-phong"}}, "blinn-phong, n = 40"),
                  work.picture("blinn-160", {{"brdf", "blinn-phong"}, {"set", "shininess=160"}},
                               "blinn-phong, n = 160")});
    work.paragraph(
        "On the ball the two can be matched. On the floor they cannot: towards grazing angles "
        "Blinn's highlight is a streak, as wet roads show it, while Phong's stays round.");
    plot_factors(work);
}

constexpr LessonEquation equations[] = {
    {"B7", "ω_r = 2 (ω_i·n) n − ω_i", "mirror_direction"},
    {"B15", "h = (ω_i + ω_o)/‖ω_i + ω_o‖", "half_vector"},
    {"C7", "f_att I_i [k_d (N·L) + k_s (R·V)ⁿ], or with (N·H)ⁿ", "light_term"},
};
constexpr LessonCommand commands[] = {
    {"render", "--brdf phong -o phong.png"},
    {"render", "--brdf blinn-phong --set shininess=160 -o blinn.png"},
    {"inspect", "--brdf blinn-phong --pixel 120,90"},
};
constexpr LessonQuestion questions[] = {
    {"Where does the four come from?",
     "Near its peak cosⁿθ ≈ exp(−nθ²/2). Half the angle is a quarter of θ², so four times the "
     "exponent gives the same curve."},
    {"Why is the half vector cheaper for a directional light and an orthographic camera?",
     "H is then the same everywhere, while R must be computed from each normal."},
    {"Which of the two can still show light where R·V < 0?",
     "Blinn-Phong: N·H is not negative as long as light and viewer are above the surface. So its "
     "highlight has no hard end where the mirror direction is more than 90° away."},
};

}  // namespace

constinit const LessonInfo half_vector{
    "half-vector",
    "Phong against Blinn-Phong",
    "Mirror direction or half vector: which exponents match, and where none does.",
    equations,
    commands,
    questions,
    fill_half_vector};

}  // namespace scanshade::lessons

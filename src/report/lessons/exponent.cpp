// The exponent of a highlight over four powers of ten.
#include <fmt/format.h>

#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/eq/reflection.hpp"

namespace scanshade::lessons {
namespace {

constexpr double degrees = 180 / pi;

/// Where cosˢ is a half, in degrees.
double half_width(double s) { return std::acos(std::pow(0.5, 1 / s)) * degrees; }

/// The same from the picture: how wide the highlight is above half its peak. The ball fills
/// `radius` pixels; where the normal is turned by δ the mirror direction is by 2δ.
double drawn_half_width(const Framebuffer& frame, double radius) {
    double bright = 0;
    const int row = frame.height / 2;
    for (int x = 0; x < frame.width; ++x)
        bright += radiance_at(frame, x, row) > 0.5 * 0.7;  // k_s of the scene
    return 2 * std::asin(std::min(bright / 2 / radius, 1.0)) * degrees;
}

void fill_exponent(LessonWork& work) {
    work.paragraph(
        "The exponent n of cosⁿ sets the width of a highlight and nothing else: the peak stays "
        "k_s. Its half width is arccos(2^(−1/n)), about 67°/√n: a hundred times the exponent is a "
        "tenth of the width.");
    std::vector<Figure> figures;
    for (const int s : {1, 10, 100, 1000, 10000})
        figures.push_back(work.picture(fmt::format("{}", s),
                                       {{"set", fmt::format("shininess={}", s)}},
                                       fmt::format("n = {}", s)));
    work.figures(figures);

    const Axes angles{"angle from the mirror direction, degrees", "cosⁿ", 0, 90};
    std::vector<Curve> lobes;
    for (const double s : {1.0, 10.0, 100.0, 1000.0, 10000.0})
        lobes.push_back(sampled(
            fmt::format("n = {:g}", s), angles,
            [&](double a) { return pow_shininess(std::cos(a / degrees), make_exponent(s)); }, 721));
    const Axes exponents{"exponent n", "half width in degrees", 1, 10000, true, true};
    const ReportInput plain =
        work.input({{"samples", "1"}, {"resolution", "201,201"}, {"set", "kd=0"}});
    const double radius = 100.5 / (10 * std::tan(6.25 / degrees));
    Curve drawn{"drawn", {}};
    for (const double s : {4.0, 10.0, 25.0, 60.0, 150.0, 400.0, 1000.0, 2500.0, 10000.0})
        drawn.points.push_back(
            {s, drawn_half_width(draw_planes(with_parameter(plain, "shininess", s)), radius)});
    Curve theory = sampled("arccos(2^(−1/n))", exponents, half_width);
    theory.dashed = true;
    work.figures(
        {work.plot("lobes", line_plot(angles, lobes), "The highlight over the angle."),
         work.plot("width", line_plot(exponents, {drawn, theory}),
                   "Its half width, from pictures with one sample a pixel and from the equation. "
                   "At the end the highlight is narrower than a pixel: there what is drawn is a "
                   "matter of luck, and samples must help.")});
    work.measured("half width at n = 100, drawn",
                  drawn_half_width(draw_planes(with_parameter(plain, "shininess", 100)), radius),
                  "degrees");
    work.measured("half width at n = 100, by the equation", half_width(100), "degrees");
    work.measured("highlight at n = 10000, in pixels of this picture",
                  2 * radius * std::sin(half_width(10000) / 2 / degrees), "pixels");
}

constexpr LessonEquation equations[] = {
    {"B12", "xˢ", "pow_shininess"},
    {"B12", "L_o = L_i (k_d cosθ_i + k_s cosⁿθ_r)", "phong_reflection"},
};
constexpr LessonCommand commands[] = {
    {"render", "--set shininess=10 -o 10.png"},
    {"render", "--set shininess=10000 --samples 1 -o one.png"},
    {"render", "--set shininess=10000 --samples 256 -o many.png"},
    {"inspect", "--set shininess=10000 --pixel 100,100"},
};
constexpr LessonQuestion questions[] = {
    {"Why does the peak not rise when the highlight gets narrower?",
     "This model is not normalised: it leaves the peak and so loses light, about as 1/n. The "
     "lesson on energy shows the normalised form."},
    {"How can xⁿ with a whole n be computed with few products?",
     "By squaring: x, x², x⁴, ... and the product of those that the bits of n name, at most 2 log2 "
     "n products. Each squaring doubles the relative error, so it is about n units of rounding."},
    {"What happens to a small highlight under one sample a pixel when the ball moves?",
     "It flickers: sometimes a sample meets it, sometimes none does. That is aliasing, and no "
     "property of the model."},
};

}  // namespace

constinit const LessonInfo exponent{
    "exponent",
    "Exponents from 1 to 10000",
    "The exponent sets the width of a highlight, not its peak; narrow ones need samples.",
    equations,
    commands,
    questions,
    fill_exponent};

}  // namespace scanshade::lessons

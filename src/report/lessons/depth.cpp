// How far apart two surfaces must be for a depth buffer to tell them apart.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"

namespace scanshade::lessons {
namespace {

struct Planes {
    double near, far;
};

/// What a depth buffer keeps of a distance w, in its own type of number; nearer is larger.
struct Format {
    const char *name, *file;
    double (*kept)(double w, const Planes& p);
    double (*next)(double kept);  // the next number that differs, farther away
    double (*distance)(double kept, const Planes& p);
};

/// near: 0, far: 1, and 1/w linear between them, as projections were first written.
double standard(double w, const Planes& p) { return p.far * (w - p.near) / (w * (p.far - p.near)); }
double from_standard(double z, const Planes& p) {
    return p.far * p.near / (p.far - z * (p.far - p.near));
}

constexpr double no_more = std::numeric_limits<double>::infinity();

/// A format of so many bits in fixed point.
template <int bits>
constexpr Format fixed(const char* name, const char* file) {
    constexpr double steps = (1 << bits) - 1;
    return {name, file,
            [](double w, const Planes& p) { return -std::round(standard(w, p) * steps) / steps; },
            [](double z) { return z - 1 / steps; },
            [](double z, const Planes& p) { return from_standard(-z, p); }};
}

const Format formats[] = {
    fixed<16>("16 bits", "standard-16"),
    fixed<24>("24 bits", "standard-24"),
    {"float", "standard-float",
     [](double w, const Planes& p) { return -double(float(standard(w, p))); },
     [](double z) { return double(std::nextafter(float(z), -2.0f)); },
     [](double z, const Planes& p) { return from_standard(-z, p); }},
    {"float, reversed", "reversed-float",
     [](double w, const Planes& p) { return double(float(p.near / w)); },
     [](double z) { return double(std::nextafter(float(z), -2.0f)); },
     [](double z, const Planes& p) { return p.near / z; }},
};
const Format &standard_float = formats[2], &reversed_float = formats[3];

/// The distance between two neighbouring numbers of the format, at w; infinite beyond the last.
double resolution(const Format& format, double w, const Planes& p) {
    const double z = format.kept(w, p);
    const double here = format.distance(z, p), there = format.distance(format.next(z), p);
    return there > here ? there - here : no_more;
}

/// The two objects of the scene, each drawn alone, and the nearer one at each pixel by what the
/// format keeps of their depths; of equal ones the first.
Framebuffer resolved(const Framebuffer& a, const Framebuffer& b, const Format& format,
                     const Planes& p) {
    Framebuffer out = a;
    for (std::size_t i = 0; i < out.depth.size(); ++i) {
        if (b.depth[i] == 0) continue;
        const auto kept = [&](const Framebuffer& f) {
            return f.depth[i] == 0 ? -no_more : format.kept(p.near / double(f.depth[i]), p);
        };
        if (kept(b) <= kept(a)) continue;
        out.r[i] = b.r[i], out.g[i] = b.g[i], out.b[i] = b.b[i];
        out.id[i] = b.id[i], out.depth[i] = b.depth[i];
    }
    return out;
}

/// Pixels of the road that show the plain.
double lost_pixels(const Framebuffer& got, const Framebuffer& road) {
    double count = 0;
    for (std::size_t i = 0; i < road.id.size(); ++i)
        count += road.depth[i] > 0 && got.depth[i] != road.depth[i];
    return count;
}

Curve resolution_curve(const Format& format, const Axes& axes, const Planes& planes) {
    Curve curve{format.name, {}};
    const auto value = [&](double w) { return resolution(format, w, planes); };
    for (const PlotPoint& p : sampled("", axes, value, 121).points)
        if (p.y < no_more) curve.points.push_back(p);
    curve.dashed = &format == &standard_float;  // it lies over that of 24 bits
    return curve;
}

void fill_depth(LessonWork& work) {
    work.paragraph(
        "A projection gives far distances few of the numbers between 0 and 1: half of them are "
        "spent before the distance has doubled from the near plane. Floats are dense near 0 and "
        "sparse near 1. The classic order, 0 at the near plane and 1 far away, puts the sparse end "
        "where numbers are scarce already; in the reversed order, near/w, the one makes up for the "
        "other.");
    const ReportInput input = work.input();
    const Planes planes{*input.scene.camera->near, *input.scene.camera->far};
    const Framebuffer plain = draw_planes(with_object(input, 0));
    const Framebuffer road = draw_planes(with_object(input, 1));
    std::vector<Figure> figures;
    std::vector<Curve> curves;
    const Axes axes{
        "distance w", "resolution, in units of the scene", planes.near, planes.far, true, true};
    for (const Format& format : formats) {
        const Framebuffer frame = resolved(plain, road, format, planes);
        const double lost = work.measured(fmt::format("{}: pixels of the road lost", format.name),
                                          lost_pixels(frame, road), "pixels");
        figures.push_back(
            work.picture(format.file, shown(frame, input.settings),
                         fmt::format("{}: {:.0f} pixels of the road lost", format.name, lost)));
        curves.push_back(resolution_curve(format, axes, planes));
        work.measured(fmt::format("{}: resolution at w = 100", format.name),
                      resolution(format, 100, planes), "units");
    }
    work.figures(figures);
    work.paragraph(
        fmt::format("The road lies 0.01 above the plain, the near plane at {:g}, the far one at "
                    "{:g}. Both surfaces were drawn alone, and then each format was given their "
                    "depths. Where it keeps the same number for both, or they swap, the plain "
                    "shows through.",
                    planes.near, planes.far));
    work.figures(
        {work.plot("resolution", line_plot(axes, curves),
                   "From each number to its neighbour, with the formats' own numbers. Standard "
                   "depth loses with w², reversed float only with w. Standard float is no better "
                   "than 24 bits: between ½ and 1 a float has 24 bits, too.")});
    work.measured("standard float against reversed, at w = 100",
                  resolution(standard_float, 100, planes) / resolution(reversed_float, 100, planes),
                  "times");
}

constexpr LessonEquation equations[] = {
    {"C3", "I_X = I_AB ((AC)_x − x)/((AC)_x − (AB)_x) + I_AC (x − (AB)_x)/((AC)_x − (AB)_x)",
     "along_span"},
};
constexpr LessonCommand commands[] = {
    {"render", "-o depth.png"},
    {"render", "--camera-position 0,200,0 -o high.png"},
    {"inspect", "--pixel 160,120"},
};
constexpr LessonQuestion questions[] = {
    {"The near plane moves from 0.0001 to 0.001: what does each format gain?",
     "Standard formats ten times the resolution everywhere, for it goes with w²/near. Reversed "
     "float gains nothing: its relative resolution is that of floats."},
    {"Why does the far plane hardly matter?",
     "With far much larger than near, z is about 1 − near/w: far drops out. This program uses "
     "near/w itself, and far only clips."},
    {"Would reversing help a buffer of 24-bit integers?",
     "No: integers are equally dense everywhere, so the order does not matter."},
};

}  // namespace

constinit const LessonInfo depth{"depth",
                                 "Depth: standard against reversed",
                                 "Which distances a depth buffer can tell apart, in fixed point, "
                                 "in float, and in float reversed.",
                                 equations,
                                 commands,
                                 questions,
                                 fill_depth};

}  // namespace scanshade::lessons

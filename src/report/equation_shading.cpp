// Sweeps of chapter C: normals, interpolation, illumination.
#include <cmath>
#include <limits>

#include "report/equation_sweep.hpp"
#include "report/printed_forms.hpp"
#include "scanshade/eq/shading.hpp"

namespace scanshade {
namespace {

/// Two normals that cancel but for an angle x.
template <class R>
struct Cancelling {
    Vec3<R> a, b;
    explicit Cancelling(R x) : a(from_z(R(0.5))), b(-from_z(R(0.5) - x)) {}
};

/// A few roundings of the sum's terms.
template <class R>
R noise() {
    return R(4) * R(std::numeric_limits<Scalar<R>>::epsilon());
}

// Corners of a quadrilateral as a file gives them, going around.
template <class R>
struct Corners {
    R v0 = R(0.25), v1 = R(0.5), v2 = R(1), v3 = R(0.75);
};

// An edge from a height of 256000 down by x, met a quarter of the way; in 1/256 pixel. And a span.
template <class R>
struct Interval256 {
    R begin = R(256000), end, at;
    explicit Interval256(R x)
        : end(R(256000) + x), at(R(256000) + R(std::floor(number_of(x) / 4))) {}
};

constexpr auto file_corners = [](auto x) {
    using R = decltype(x);
    const Corners<R> c;
    return one(bilinear(c.v0, c.v1, c.v3, c.v2, x, R(0.75)));
};
constexpr auto edge = [](auto x) {
    using R = decltype(x);
    const Interval256 y(x);
    return one(along_edge(R(0.25), R(1), y.begin, y.end, y.at));
};
constexpr auto span = [](auto x) {
    using R = decltype(x);
    const Interval256 s(x);
    return one(along_span(R(0.25), R(1), s.begin, s.end, s.at));
};

/// Light at x from the normal, viewer at −1.25 rad: N·L and R·V.
template <class R>
struct Turning {
    R n_l, r_v;
    explicit Turning(R x) : n_l(cos(x)), r_v(cos(x - R(1.25))) {}
};
Wide lit(Wide x) {
    const Turning t(x);
    const Wide r_v = max(t.r_v, Wide(0));
    return t.n_l > Wide(0) ? printed::light_term(Wide(0.5), Wide(0.25), Wide(10), t.n_l, r_v)
                           : Wide(0);
}

constexpr double far_q = 0x1p-33;  // 1/length²

constexpr EquationSweep sweeps[] = {
    {"C1", "vertex normal of two faces that nearly cancel", "angle from opposite, rad",
     Spacing::from_zero, 1e-8, 3,
     [](auto x) {
         const Cancelling n(x);
         return printed::vertex_normal(n.a + n.b);
     },
     [](auto x) {
         using R = decltype(x);
         const Cancelling n(x);
         return vertex_normal(n.a + n.b, R(2), noise<R>());
     },
     [](Wide x) {
         const Cancelling n(x);
         return printed::vertex_normal(n.a + n.b);
     },
     [](double x, double) { return 6 + 4 / x; },
     "each normal is rounded, and their sum is as short as the angle is small",
     "as printed, but 0 where the sum is below its own noise: the caller takes the face's normal",
     false, true},
    {"C2", "corners in a file's order", "u", Spacing::linear, 0, 1,
     [](auto x) {
         using R = decltype(x);
         const Corners<R> c;
         return one(bilinear(c.v0, c.v1, c.v2, c.v3, x, R(0.75)));
     },
     file_corners, file_corners, [](double, double) { return 6.0; },
     "5 u: two products and two sums on each path",
     "as printed, for corners (0,0) (1,0) (0,1) (1,1): a file goes around, so its third and fourth "
     "change places"},
    {"C3", "edge from a horizontal one to 4000 pixels high", "height, 1/256 pixel", Spacing::whole,
     0, 1e6,
     [](auto x) {
         using R = decltype(x);
         const Interval256 y(x);
         return one(printed::along_edge(R(0.25), R(1), y.begin, y.end, y.at));
     },
     edge, edge, [](double, double) { return 6.0; },
     "4 u: heights are whole numbers, so their differences are exact",
     "as printed, but a horizontal edge has the value of its first end: printed, 0/0"},
    {"C3", "span from an empty one to 4000 pixels wide", "width, 1/256 pixel", Spacing::whole, 0,
     1e6,
     [](auto x) {
         using R = decltype(x);
         const Interval256 s(x);
         return one(printed::along_span(R(0.25), R(1), s.begin, s.end, s.at));
     },
     span, span, [](double, double) { return 6.0; }, "as an edge",
     "as printed, but an empty span has the value of its first end: printed, 0/0"},
    {"C4", "normal in the middle of a quadrilateral whose normals nearly cancel",
     "angle from opposite, rad", Spacing::from_zero, 1e-8, 3,
     [](auto x) {
         using R = decltype(x);
         const Cancelling n(x);
         return printed::unit(bilinear(n.a, n.b, n.a, n.b, R(0.5), R(0.5)));
     },
     [](auto x) {
         using R = decltype(x);
         const Cancelling n(x);
         return bilinear_normal(n.a, n.b, n.a, n.b, R(0.5), R(0.5));
     },
     [](Wide x) {
         const Cancelling n(x);
         return printed::unit(n.a + n.b);
     },
     [](double x, double) { return 6 + 4 / x; }, "as C1",
     "as printed, made unit, but 0 where the length is 0: the caller takes the face's normal",
     false, true},
    {"C5", "normal in the middle of a span whose ends nearly cancel", "angle from opposite, rad",
     Spacing::from_zero, 1e-8, 3,
     [](auto x) {
         using R = decltype(x);
         const Cancelling n(x);
         return printed::unit(printed::along_span(n.a, n.b, R(-1), R(1), R(0)));
     },
     [](auto x) {
         using R = decltype(x);
         const Cancelling n(x);
         return span_normal(n.a, n.b, R(-1), R(1), R(0));
     },
     [](Wide x) {
         const Cancelling n(x);
         return printed::unit(n.a + n.b);
     },
     [](double x, double) { return 6 + 4 / x; }, "as C1", "as C4", false, true},
    {"C7", "attenuation 1/(1 + q d²), q = 2⁻³³", "distance d", Spacing::logarithmic, 1e-20, 1e20,
     [](auto x) {
         using R = decltype(x);
         return one(printed::attenuation(x, R(1), R(0), R(far_q)));
     },
     [](auto x) {
         using S = Scalar<decltype(x)>;
         return one(attenuation(x, S(1), S(0), S(far_q)));
     },
     [](Wide x) { return one(printed::attenuation(x, Wide(1), Wide(0), Wide(far_q))); },
     [](double, double) { return 5.0; }, "5 u, of positive terms",
     "1/(c + d (l + q d)): printed, d² overflows before the result vanishes"},
    {"C7", "light that goes behind the surface, n = 10", "θ_i, rad", Spacing::linear, 0, 3.14,
     [](auto x) {
         using R = decltype(x);
         const Turning t(x);
         return one(printed::light_term(R(0.5), R(0.25), R(10), t.n_l, t.r_v));
     },
     [](auto x) {
         using R = decltype(x);
         const Turning t(x);
         const Rgb<R> k_d = grey(R(0.5)), k_s = grey(R(0.25));
         const Rgb<R> bracket = phong_reflection(k_d, k_s, make_exponent(10), t.n_l, t.r_v);
         return one(select(t.n_l > R(0), light_term(R(1), grey(R(1)), bracket).r, R(0)));
     },
     [](Wide x) { return one(lit(x)); }, [](double, double) { return 40.0; },
     "n + 9 u, and n times the rounding of the cosine",
     "nothing is reflected where N·L ≤ 0: printed, the highlight shines through the surface"},
    {"C7", "highlight by R·V, for which N·H stands in print, n = 20", "θ_h, rad",
     Spacing::logarithmic, 1e-3, 0.7,
     [](auto x) { return one(printed::pow(cos(x), decltype(x)(20))); },
     [](auto x) { return one(pow_shininess(cos(x + x), make_exponent(20))); },
     [](Wide x) { return one(pow(cos(x + x), Wide(20))); },
     [](double, double condition) { return 40 + 2 * condition; },
     "n − 1 u, and n times the rounding of the cosine",
     "phong takes R·V and blinn-phong N·H, and none stands for the other: with the same n the "
     "printed ≈ is off by half of the highlight's fall",
     true},
};

}  // namespace

std::span<const EquationSweep> shading_sweeps() { return sweeps; }

}  // namespace scanshade

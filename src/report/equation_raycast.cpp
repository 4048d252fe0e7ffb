// Sweeps of chapter D: planes and spheres.
#include "report/equation_sweep.hpp"
#include "report/printed_forms.hpp"
#include "scanshade/eq/raycast.hpp"

namespace scanshade {
namespace {

/// The point (1/4, 1/2) of a parallelogram that leans by x from upright.
template <class R>
struct Leaning {
    Vec3<R> P = {R(1), R(2), R(3)}, u = {R(1), R(1), R(0)}, v, X;
    explicit Leaning(R x) : v{-sin(x), sin(x), cos(x)}, X(P + u * R(0.25) + v * R(0.5)) {}
};
template <class R>
Vec3<R> both(const PlaneCoordinates<R>& c) {
    return {c.u, c.v, R(0)};
}

/// A ray from the origin in a direction of no axis, and the centre of a sphere at a distance along
/// it and aside.
template <class R>
struct Slanting {
    Vec3<R> p1 = {R(3) / R(13), R(4) / R(13), R(12) / R(13)}, S;
    Slanting(R distance, R aside)
        : S(p1 * distance + Vec3<R>{R(4) / R(5), -R(3) / R(5), R(0)} * aside) {}
};
template <class R>
Vec3<R> origin() {
    return {R(0), R(0), R(0)};
}
Wide half_chord_of_unit() { return sqrt(Wide(0.75)); }  // of a line half a radius from the centre

/// From 1 above a sphere of radius x, at a slope of 4 in 5: where the line comes down.
template <class R>
struct AboveHuge {
    Vec3<R> P0 = {R(0), R(1), R(0)}, p1 = {R(3) / R(5), -R(4) / R(5), R(0)}, S;
    explicit AboveHuge(R radius) : S{R(0), -radius, R(0)} {}
};

constexpr double distance = 1e6;
double hit_near_to(double radius) { return distance - 0.866 * radius; }

constexpr EquationSweep sweeps[] = {
    {"D2", "parallelogram that leans from upright", "lean, rad", Spacing::from_zero, 1e-8, 1.5,
     [](auto x) {
         const Leaning l(x);
         return both(printed::plane_coordinates(l.X, l.P, l.u, l.v));
     },
     [](auto x) {
         const Leaning l(x);
         return both(plane_coordinates(l.X, l.P, l.u, l.v));
     },
     [](Wide) {
         return Vec3<Wide>{Wide(0.25), Wide(0.5), Wide(0)};
     },
     [](double, double) { return 24.0; }, "12 u of the solution, and the rounding of X and v",
     "the two of the three equations in which the parallelogram is largest: the printed pair has "
     "the determinant 0 in an upright plane"},
    {"D3", "sphere at 5 for directions of any length", "‖p_1‖", Spacing::logarithmic, 1e-3, 1e3,
     [](auto x) {
         using R = decltype(x);
         const Vec3<R> p1 = {x, R(0), R(0)}, S = {R(5), R(0.5), R(0)};
         return one(printed::ray_sphere(origin<R>(), p1, S, R(1)).t_near);
     },
     [](auto x) {
         using R = decltype(x);
         const Vec3<R> p1 = {x, R(0), R(0)}, S = {R(5), R(0.5), R(0)};
         return one(ray_sphere(origin<R>(), p1, S, R(1)).t_near);
     },
     [](Wide x) { return one((Wide(5) - half_chord_of_unit()) / x); },
     [](double, double) { return 24.0; }, "a few u of each length, of which none cancels",
     "p_1 is made unit, and t divided by its length: printed, t is right for unit directions only",
     true},
    {"D3", "half the chord of a unit sphere far away", "distance", Spacing::logarithmic, 2, 1e6,
     [](auto x) {
         using R = decltype(x);
         const Slanting s(x, R(0.5));
         const SphereHits<R> h = printed::ray_sphere(origin<R>(), s.p1, s.S, R(1));
         return one((h.t_far - h.t_near) * R(0.5));
     },
     [](auto x) {
         using R = decltype(x);
         const Slanting s(x, R(0.5));
         const SphereHits<R> h = ray_sphere(origin<R>(), s.p1, s.S, R(1));
         return one((h.t_far - h.t_near) * R(0.5));
     },
     [](Wide) { return one(half_chord_of_unit()); }, [](double x, double) { return 12 + 6 * x; },
     "the centre and both t are rounded as numbers of the distance's size, which no form can mend",
     "D as ‖v − t_0 p_1‖, whose error grows with the distance: that of v·v − t_0² with its square"},
    {"D3", "spheres of any radius at a distance of 1e6", "radius", Spacing::logarithmic, 1e-6, 1e6,
     [](auto x) {
         using R = decltype(x);
         const Slanting s(R(distance), x * R(0.5));
         return one(printed::ray_sphere(origin<R>(), s.p1, s.S, x).t_near);
     },
     [](auto x) {
         using R = decltype(x);
         const Slanting s(R(distance), x * R(0.5));
         return one(ray_sphere(origin<R>(), s.p1, s.S, x).t_near);
     },
     [](Wide x) { return one(Wide(distance) - half_chord_of_unit() * x); },
     [](double x, double) { return 24 + 12 * (distance + x) / hit_near_to(x); },
     "lengths are rounded as numbers of the distance's size; t is shorter than it",
     "D and t² as products of sums and differences: the printed squares lose small spheres, whose "
     "hit jumps by as much as 250"},
    {"D3", "from 1 above a sphere, down at a slope", "radius", Spacing::logarithmic, 1, 1e6,
     [](auto x) {
         const AboveHuge a(x);
         return one(printed::ray_sphere(a.P0, a.p1, a.S, x).t_near);
     },
     [](auto x) {
         const AboveHuge a(x);
         return one(ray_sphere(a.P0, a.p1, a.S, x).t_near);
     },
     [](Wide x) {
         const Wide b = Wide(4) / Wide(5) * (Wide(1) + x), c = Wide(1) + x + x;
         return one(c / (b + sqrt(b * b - c)));
     },
     [](double, double) { return 24.0; },
     "distance and radius are exact here, and so is their difference; a rounded centre would move "
     "the sphere by an ulp of its radius, in every form",
     "the nearer root as (‖v‖ − R)(‖v‖ + R) over the farther one: t_0 − t cancels"},
    {"D3", "the same picture at any scale", "scale", Spacing::logarithmic, 1e-18, 1e18,
     [](auto x) {
         using R = decltype(x);
         const Slanting s(x * R(5), x * R(0.5));
         return one(printed::ray_sphere(origin<R>(), s.p1, s.S, x).t_near);
     },
     [](auto x) {
         using R = decltype(x);
         const Slanting s(x * R(5), x * R(0.5));
         return one(ray_sphere(origin<R>(), s.p1, s.S, x).t_near);
     },
     [](Wide x) { return one((Wide(5) - half_chord_of_unit()) * x); },
     [](double, double) { return 36.0; }, "a few u of each length, of which none cancels",
     "both forms square lengths, so a float ends at 1e19: scenes are normalised to a size of 1"},
};

}  // namespace

std::span<const EquationSweep> raycast_sweeps() { return sweeps; }

}  // namespace scanshade

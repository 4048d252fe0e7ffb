#include "scanshade/eq/raycast.hpp"

#include <cmath>

#include "report/printed_forms.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace scanshade;
using V = Vec3<double>;

namespace {

V random_point(Rng& rng) { return {rng.real(-2, 2), rng.real(-2, 2), rng.real(-2, 2)}; }
double length(const V& v) { return std::sqrt(dot(v, v)); }

}  // namespace

TEST_CASE("(D1) a segment meets a plane where its point lies in it", "[eq]") {
    Rng rng(81);
    for (int k = 0; k < 500; ++k) {
        const V P0 = random_point(rng), p1 = random_point(rng), n = random_point(rng);
        const double D = rng.real(-1, 1);
        const PlaneHit<double> h = segment_plane(P0, p1, n, D);
        CHECK(std::abs(dot(n, P0 + p1 * h.t) + D) < 1e-10 * (1 + std::abs(h.t)));
        const bool sides_differ = (dot(n, P0) + D) * (dot(n, P0 + p1) + D) < 0;
        CHECK(h.hit == (sides_differ ? 1 : 0));
    }
    const V z = {0, 0, 1};
    CHECK(segment_plane(V{0, 0, 1}, V{1, 0, 0}, z, 0.0).hit == 0);   // parallel
    CHECK(segment_plane(V{0, 0, 1}, V{0, 0, -1}, z, 0.0).hit == 1);  // at its end
    CHECK(segment_plane(V{0, 0, 0}, V{0, 0, -1}, z, 0.0).hit == 1);  // at its start
    CHECK(segment_plane(V{0, 0, 1}, V{0, 0, -0.9}, z, 0.0).hit == 0);
}

TEST_CASE("(D2) coordinates go round in every orientation", "[eq]") {
    Rng rng(82);
    for (int k = 0; k < 1000; ++k) {
        const V P = random_point(rng);
        const V u = random_point(rng), v = random_point(rng), n = cross(u, v);
        if (length(n) < 0.3) continue;
        const double a = rng.real(-2, 2), b = rng.real(-2, 2);
        const auto c = plane_coordinates(P + u * a + v * b, P, u, v);
        CHECK(c.u == Approx(a).margin(1e-12));
        CHECK(c.v == Approx(b).margin(1e-12));
    }
    // In an upright plane the printed two equations, of x and y, have determinant 0.
    const V u = {1, 1, 0}, v = {0, 0, 2}, X = V{1, 2, 3} + u * 0.25 + v * 0.5;
    CHECK(std::isnan(printed::plane_coordinates(X, V{1, 2, 3}, u, v).u));
    const auto c = plane_coordinates(X, V{1, 2, 3}, u, v);
    CHECK((c.u == 0.25 && c.v == 0.5));
    const auto none = plane_coordinates(X, V{1, 2, 3}, u, u * 2.0);
    CHECK(in_parallelogram(none) == 0);
}

TEST_CASE("(D2) parallelogram and triangle contain their border", "[eq]") {
    const auto in = [](double u, double v) {
        const PlaneCoordinates<double> c = {u, v};
        return std::pair(in_parallelogram(c), in_triangle(c));
    };
    CHECK(in(0, 0) == std::pair(1.0, 1.0));
    CHECK(in(1, 0) == std::pair(1.0, 1.0));
    CHECK(in(0.5, 0.5) == std::pair(1.0, 1.0));
    CHECK(in(0.75, 0.75) == std::pair(1.0, 0.0));
    CHECK(in(1, 1) == std::pair(1.0, 0.0));
    CHECK(in(-0.01, 0.5) == std::pair(0.0, 0.0));
    CHECK(in(0.5, 1.01) == std::pair(0.0, 0.0));
}

TEST_CASE("(D3) hits lie on the sphere, whatever the length of the direction", "[eq]") {
    Rng rng(83);
    int hits = 0;
    for (int k = 0; k < 1000; ++k) {
        const V P0 = random_point(rng), S = random_point(rng);
        const V p1 = random_direction(rng, -1) * rng.real(0.1, 10);
        const double R = rng.real(0.2, 2);
        const SphereHits<double> h = ray_sphere(P0, p1, S, R);
        CHECK(h.t_near <= h.t_far);
        const V d = normalise(p1), at = S - P0;
        const double off = length(cross(at, d));
        CHECK(h.hit == (off <= R ? 1 : 0));
        if (h.hit == 0) continue;
        ++hits;
        CHECK(length(P0 + p1 * h.t_near - S) == Approx(R).epsilon(1e-10));
        CHECK(length(P0 + p1 * h.t_far - S) == Approx(R).epsilon(1e-10));
    }
    CHECK(hits > 100);
    // As printed, t_0 = v·p_1 is right for a unit vector only.
    const V P0 = {0, 0, 0}, p1 = {2, 0, 0}, S = {3, 0, 0};
    const SphereHits<double> wrong = printed::ray_sphere(P0, p1, S, 1.0);
    CHECK(wrong.hit == 1);
    CHECK(length(p1 * wrong.t_near - S) != Approx(1));
    CHECK(ray_sphere(P0, p1, S, 1.0).t_near == 1);
    CHECK(ray_sphere(P0, p1, S, 1.0).t_far == 2);
}

TEST_CASE("(D3) small far and huge near spheres keep their digits in float", "[eq]") {
    using F = Vec3<float>;
    // A sphere of radius 1 at 1e4; the line passes 0.5 beside its centre.
    const F far_centre = {1e4f, 0.5f, 0};
    const float half = std::sqrt(0.75f);
    const SphereHits<float> far_hit = ray_sphere(F{0, 0, 0}, F{1, 0, 0}, far_centre, 1.0f);
    CHECK(far_hit.hit == 1);
    CHECK(std::abs((far_hit.t_far - far_hit.t_near) - 2 * half) < 0.01f);
    const SphereHits<float> far_printed =
        printed::ray_sphere(F{0, 0, 0}, F{1, 0, 0}, far_centre, 1.0f);
    CHECK(std::abs((far_printed.t_far - far_printed.t_near) - 2 * half) > 0.2f);
    // From 1 above a sphere of radius 1e6, straight down: printed, t_0 − t is 0 or 1 by chance.
    const SphereHits<float> huge = ray_sphere(F{0, 1, 0}, F{0, -1, 0}, F{0, -1e6f, 0}, 1e6f);
    CHECK(huge.t_near == Approx(1).epsilon(1e-5));
    // The same at a slant of 60°: distance to the surface 2.
    const F slant = {std::sqrt(0.75f), -0.5f, 0};
    CHECK(ray_sphere(F{0, 1, 0}, slant, F{0, -1e6f, 0}, 1e6f).t_near == Approx(2).epsilon(1e-3));
    const SphereHits<float> huge_printed =
        printed::ray_sphere(F{0, 1, 0}, slant, F{0, -1e6f, 0}, 1e6f);
    CHECK(std::abs(huge_printed.t_near - 2) > 0.02f);
}

#include "scanshade/eq/directions.hpp"

#include <cmath>

#include "report/printed_forms.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

constexpr double u64 = 0x1p-53;

Vec3<double> random_direction(Rng& rng) {
    while (true) {
        const Vec3<double> v = {rng.real(-1, 1), rng.real(-1, 1), rng.real(-1, 1)};
        if (dot(v, v) > 1e-3) return unit_direction(v);
    }
}

}  // namespace

TEST_CASE("(A1) unit directions have length 1 and do not depend on the scale", "[eq]") {
    Rng rng(11);
    for (int k = 0; k < 1000; ++k) {
        const Vec3<double> v = {rng.real(-9, 9), rng.real(-9, 9), rng.real(-9, 9)};
        const Vec3<double> w = unit_direction(v), scaled = unit_direction(v * 0x1p100);
        CHECK(std::abs(std::sqrt(dot(w, w)) - 1) <= 6 * u64);
        CHECK(w.x == scaled.x);
        CHECK(w.y == scaled.y);
        CHECK(w.z == scaled.z);
        const long double length =
            std::sqrt((long double)v.x * (long double)v.x + (long double)v.y * (long double)v.y +
                      (long double)v.z * (long double)v.z);
        CHECK(std::abs(double((long double)w.x - (long double)v.x / length)) <=
              4 * u64 * std::abs(w.x));
    }
    const Vec3<double> zero = unit_direction(Vec3<double>{0, 0, 0});
    CHECK(dot(zero, zero) == 0);
}

TEST_CASE("(A2) (A3) (A4) angles and vectors go round in every quadrant", "[eq]") {
    Rng rng(12);
    for (int k = 0; k < 2000; ++k) {
        const Vec3<double> w = random_direction(rng);
        const Spherical<double> s = to_spherical(w);
        REQUIRE(s.theta >= 0);
        REQUIRE(s.theta <= pi);
        REQUIRE(s.phi >= 0);
        REQUIRE(s.phi < 2 * pi);
        const Vec3<double> back = to_cartesian(s), error = back - w;
        REQUIRE(std::sqrt(dot(error, error)) <= 16 * u64);
    }
}

TEST_CASE("(A3) the printed arctan(y/x) fails in two quadrants, ours does not", "[eq]") {
    const Vec3<double> w = unit_direction(Vec3<double>{-1, 0.5, 0.2});
    const Vec3<double> wrong =
        to_cartesian(Spherical<double>{printed::polar_angle(w), printed::azimuth(w)});
    CHECK(std::abs(wrong.x - w.x) > 1);
    CHECK(std::abs(to_cartesian(to_spherical(w)).x - w.x) < 1e-15);
}

TEST_CASE("(A3) near a pole the printed arccos loses the angle, ours keeps it", "[eq]") {
    const float theta = 1e-4f;
    const Vec3<float> w = {std::sin(theta), 0.0f, std::cos(theta)};
    CHECK(std::abs(to_spherical(w).theta - theta) <= 4 * 0x1p-24f * theta);
    CHECK(std::abs(printed::polar_angle(w) - theta) > 0.01f * theta);
}

TEST_CASE("(A3) a tiny negative azimuth stays below 2 pi", "[eq]") {
    const Spherical<float> s = to_spherical(Vec3<float>{1.0f, -1e-30f, 0.0f});
    CHECK(s.phi >= 0);
    CHECK(s.phi < float(2 * pi));
}

TEST_CASE("(A5) (A6) the solid angles of a sphere's parts sum to 4 pi", "[eq]") {
    constexpr int n = 400;
    double by_angles = 0, by_areas = 0;
    const double r = 3, step = pi / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const double theta = (i + 0.5) * step;
            by_angles += solid_angle_of_angles(theta, step, step);
            const double area = r * r * std::sin(theta) * step * step;
            by_areas += solid_angle_of_area(area, 1.0, r);
        }
    CHECK(by_angles == Approx(4 * pi).epsilon(1e-5));
    CHECK(by_areas == Approx(4 * pi).epsilon(1e-5));
    CHECK(solid_angle_of_area(2.0, 0.5, 10.0) == Approx(0.01));
}

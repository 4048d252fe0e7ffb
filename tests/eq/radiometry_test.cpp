#include "scanshade/eq/radiometry.hpp"

#include <cmath>

#include "scanshade/eq/directions.hpp"
#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("(A7) (A8) (A9) (A10) the definitions are quotients", "[eq]") {
    CHECK(flux(6.0, 2.0) == 3.0);
    CHECK(flux_density(6.0, 4.0) == 1.5);
    CHECK(intensity(6.0, 0.5) == 12.0);
    CHECK(radiance(6.0, 2.0, 0.5, 0.25) == 24.0);
}

TEST_CASE("(A11) (A13) constant radiance gives irradiance pi L and flux pi A L", "[eq]") {
    constexpr int n = 500;
    const double L = 2, step = pi / 2 / n;
    double E = 0, phi = 0;
    for (int i = 0; i < n; ++i) {
        const double theta = (i + 0.5) * step;
        const double ring = solid_angle_of_angles(theta, step, 2 * pi);
        E += irradiance_term(L, std::cos(theta), ring);
        phi += flux_term(L, std::cos(theta), ring, 3.0);
    }
    CHECK(E == Approx(pi * L).epsilon(1e-5));
    CHECK(phi == Approx(pi * L * 3).epsilon(1e-5));
    // The term is undone by the definition of radiance.
    CHECK(radiance(flux_term(L, 0.3, 0.01, 0.02), 0.02, 0.01, 0.3) == Approx(L));
}

TEST_CASE("(A12) a sphere of constant radiance has intensity pi r r L", "[eq]") {
    constexpr int n = 500;
    const double L = 2, r = 1.5, step = pi / 2 / n;
    double I = 0;
    for (int i = 0; i < n; ++i) {
        const double theta = (i + 0.5) * step;  // between the normal and the direction
        const double area = r * r * std::sin(theta) * step * 2 * pi;
        I += intensity_term(L, std::cos(theta), area);
    }
    CHECK(I == Approx(pi * r * r * L).epsilon(1e-5));
}

TEST_CASE("(A14) a cosine light falls off with the cosine and is dark behind", "[eq]") {
    const Vec3<double> d = {0, 0, 1};
    CHECK(cosine_light(Vec3<double>{0, 0, 1}, d) == 1);
    CHECK(cosine_light(Vec3<double>{std::sqrt(0.75), 0, 0.5}, d) == 0.5);
    CHECK(cosine_light(Vec3<double>{0, 0, -1}, d) == 0);
}

TEST_CASE("(A15) a spot light has a hard rim at its half angle", "[eq]") {
    const Vec3<double> d = {0, 0, 1};
    const double cutoff = 20 * pi / 180;
    const auto at = [&](double degrees) {
        const double a = degrees * pi / 180;
        return spot_light(Vec3<double>{std::sin(a), 0, std::cos(a)}, d, std::cos(cutoff), 0.0);
    };
    CHECK(at(0) == 1);
    CHECK(at(19.999) == 1);
    CHECK(at(20.001) == 0);  // 20 is half of the cone, not all of it
    CHECK(at(180) == 0);
}

TEST_CASE("(A15) a penumbra goes from 1 to 0 inside the cone without a step", "[eq]") {
    const Vec3<double> d = {0, 0, 1};
    const double cos_cutoff = std::cos(0.4), cos_inner = std::cos(0.3);
    double before = 1;
    for (double a = 0.25; a < 0.45; a += 1e-4) {
        const double now = spot_light(Vec3<double>{std::sin(a), 0, std::cos(a)}, d, cos_cutoff,
                                      1 / (cos_inner - cos_cutoff));
        CHECK(now <= before);
        CHECK(before - now < 3e-3);
        if (a < 0.3) CHECK(now == 1);
        if (a > 0.4) CHECK(now == 0);
        before = now;
    }
    const double middle = (cos_cutoff + cos_inner) / 2;
    CHECK(spot_light(Vec3<double>{std::sqrt(1 - middle * middle), 0, middle}, d, cos_cutoff,
                     1 / (cos_inner - cos_cutoff)) == Approx(0.5));
}

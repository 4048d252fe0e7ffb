#include "scanshade/eq/shading.hpp"

#include <cmath>

#include "report/printed_forms.hpp"
#include "support/catch.hpp"

using namespace scanshade;

using V = Vec3<double>;
constexpr double u64 = 0x1p-53;

constexpr double noise = 8 * u64;

TEST_CASE("(C1) the vertex normal of a cube's corner is its diagonal", "[eq]") {
    const V n = vertex_normal(V{1, 0, 0} + V{0, 1, 0} + V{0, 0, 1}, 3.0, noise);
    CHECK(n.x == Approx(1 / std::sqrt(3)));
    CHECK(n.y == n.x);
    CHECK(n.z == n.x);
}

TEST_CASE("(C1) opposite normals cancel to 0, also when rounding leaves a rest", "[eq]") {
    const V none = vertex_normal(V{0, 0, 1} + V{0, 0, -1}, 2.0, noise);
    CHECK(dot(none, none) == 0);
    const double c = std::cos(0.3), s = std::sin(0.3);
    const V rest = vertex_normal(V{c, s, 0} + V{-c, -s + 1e-16, 0}, 2.0, noise);
    CHECK(dot(rest, rest) == 0);
    CHECK(vertex_normal(V{c, s, 0} + V{-c, -s + 1e-6, 0}, 2.0, noise).y == Approx(1));
}

TEST_CASE("(C2) bilinear interpolation by hand", "[eq]") {
    CHECK(bilinear(1.0, 2.0, 3.0, 5.0, 0.0, 0.0) == 1);
    CHECK(bilinear(1.0, 2.0, 3.0, 5.0, 1.0, 0.0) == 2);
    CHECK(bilinear(1.0, 2.0, 3.0, 5.0, 0.0, 1.0) == 3);
    CHECK(bilinear(1.0, 2.0, 3.0, 5.0, 1.0, 1.0) == 5);
    // 0.25·(0.5·1 + 0.5·2)… : (1−v)[(1−u)·1 + u·2] + v[(1−u)·3 + u·5] at u = 0.5, v = 0.25
    CHECK(bilinear(1.0, 2.0, 3.0, 5.0, 0.5, 0.25) == 0.75 * 1.5 + 0.25 * 4);
}

TEST_CASE("(C3) edges and spans by hand", "[eq]") {
    // A at y = 0 with 10, B at y = 400 with 30: at y = 100 a quarter of the way.
    CHECK(along_edge(10.0, 30.0, 0.0, 400.0, 100.0) == 15);
    CHECK(along_edge(30.0, 10.0, 400.0, 0.0, 100.0) == 15);
    CHECK(along_edge(10.0, 30.0, 0.0, 400.0, 0.0) == 10);
    CHECK(along_edge(10.0, 30.0, 0.0, 400.0, 400.0) == 30);
    CHECK(along_span(15.0, 25.0, 100.0, 200.0, 120.0) == Approx(17));
    // The origin of x plays no part.
    CHECK(along_span(15.0, 25.0, -20.0, 80.0, 0.0) == Approx(17));
}

TEST_CASE("(C3) a horizontal edge and an empty span give their first end", "[eq]") {
    CHECK(along_edge(10.0, 30.0, 7.0, 7.0, 7.0) == 10);
    CHECK(along_span(15.0, 25.0, 9.0, 9.0, 9.0) == 15);
    CHECK(std::isnan(printed::along_edge(10.0, 30.0, 7.0, 7.0, 7.0)));
    CHECK(std::isnan(printed::along_span(15.0, 25.0, 9.0, 9.0, 9.0)));
}

TEST_CASE("(C4) (C5) interpolated normals are made unit vectors", "[eq]") {
    const V a = {1, 0, 0}, b = {0, 1, 0};
    const V patch = bilinear_normal(a, b, a, b, 0.5, 0.3);
    CHECK(patch.x == Approx(std::sqrt(0.5)));
    CHECK(patch.y == Approx(std::sqrt(0.5)));
    const V span = span_normal(a, b, 0.0, 4.0, 1.0);  // 3/4 a + 1/4 b
    CHECK(span.x == Approx(3 / std::sqrt(10.0)));
    CHECK(span.y == Approx(1 / std::sqrt(10.0)));
}

TEST_CASE("(C4) (C5) between opposite normals the middle has none", "[eq]") {
    const V a = {0, 0, 1}, b = {0, 0, -1};
    const V middle = span_normal(a, b, 0.0, 2.0, 1.0);
    CHECK(dot(middle, middle) == 0);
    const V patch = bilinear_normal(a, b, a, b, 0.5, 0.5);
    CHECK(dot(patch, patch) == 0);
}

TEST_CASE("(C6) channels never mix", "[eq]") {
    const Rgb<double> a = {1, 2, 3}, b = {10, 100, 1000};
    const Rgb<double> sum = a + b, product = a * b, scaled = a * 2.0;
    CHECK((sum.r == 11 && sum.g == 102 && sum.b == 1003));
    CHECK((product.r == 10 && product.g == 200 && product.b == 3000));
    CHECK((scaled.r == 2 && scaled.g == 4 && scaled.b == 6));
}

TEST_CASE("(C7) attenuation by hand", "[eq]") {
    CHECK(attenuation(2.0, 1.0, 0.5, 0.25) == 1 / 3.0);
    CHECK(attenuation(4.0, 0.0, 0.0, 1.0) == 1 / 16.0);
    CHECK(attenuation(1e30f, 1.0f, 1.0f, 1.0f) == 0);  // no overflow to NaN on the way
    // Printed, d² overflows first.
    CHECK(attenuation(1e20f, 1.0f, 0.0f, 0x1p-33f) == Approx(0x1p33 / 1e40));
    CHECK(printed::attenuation(1e20f, 1.0f, 0.0f, 0x1p-33f) == 0);
}

TEST_CASE("(C7) ambient and light terms by hand", "[eq]") {
    const Rgb<double> ambient = ambient_term(Rgb<double>{0.1, 0.2, 0.3}, Rgb<double>{1, 0.5, 0});
    CHECK((ambient.r == 0.1 && ambient.g == 0.1 && ambient.b == 0));
    const Rgb<double> bracket = phong_reflection(Rgb<double>{0.5, 0.5, 0.5}, Rgb<double>{1, 1, 1},
                                                 make_exponent(1), 0.5, 0.25);
    const Rgb<double> light = light_term(0.5, Rgb<double>{2, 4, 8}, bracket);
    CHECK(light.r == 0.5 * 2 * 0.5);
    CHECK(light.g == 1.0);
    CHECK(light.b == 2.0);
}

TEST_CASE("(C7) with Blinn's half vector four times the exponent matches Phong", "[eq]") {
    // In the mirror plane θ_r is twice θ_h.
    for (const double theta_h : {0.01, 0.03, 0.06}) {
        const double phong = pow_shininess(std::cos(2 * theta_h), make_exponent(20));
        const double same = pow_shininess(std::cos(theta_h), make_exponent(20));
        const double four = pow_shininess(std::cos(theta_h), make_exponent(80));
        CHECK(std::abs(four - phong) < 0.01 * (1 - phong));
        CHECK(std::abs(same - phong) > 0.5 * (1 - phong));
    }
}

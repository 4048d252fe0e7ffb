#include "scanshade/eq/microfacet.hpp"

#include <cmath>
#include <string_view>

#include "brdf/cosines.hpp"
#include "scanshade/eq/fresnel.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace scanshade;

namespace {

struct Distribution {
    std::string_view name;
    double (*D)(double n_h, double sin2_h, double m);
};

double normalised_gaussian(double n_h, double sin2_h, double m) {
    return D_gaussian(n_h, sin2_h, m, gaussian_norm(m));
}

const Distribution distributions[] = {{"gaussian", normalised_gaussian},
                                      {"blinn", D_blinn<double>},
                                      {"beckmann", D_beckmann<double>},
                                      {"ggx", D_ggx<double>}};

/// ∫ D cosθ dω = 2π ∫ D cosθ sinθ dθ, with θ = π/2 t⁶ for peaks of any width.
template <class D>
double projected_area(D distribution) {
    constexpr int steps = 40000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps, theta = pi / 2 * std::pow(t, 6);
        const double c = std::cos(theta), s = std::sin(theta);
        sum += distribution(c, s * s) * c * s * 3 * pi * std::pow(t, 5) / steps;
    }
    return 2 * pi * sum;
}

}  // namespace

TEST_CASE("(B17a) (B17b) (B17c) (B17d) the facets' projected areas sum to 1", "[eq]") {
    for (const Distribution& d : distributions)
        for (const double m : {1e-4, 0.001, 0.01, 0.1, 0.3, 0.7, 1.0}) {
            CAPTURE(d.name, m);
            const double area = projected_area([&](double c, double s2) { return d.D(c, s2, m); });
            CHECK(area == Approx(1).epsilon(2e-6));
        }
}

TEST_CASE("(B17a) the printed Gaussian is not normalised", "[eq]") {
    const auto printed = [](double m) {
        return projected_area([&](double c, double s2) { return D_gaussian(c, s2, m, 1.0); });
    };
    CHECK(printed(0.1) == Approx(0.0312).epsilon(1e-2));
    CHECK(printed(0.3) == Approx(0.27).epsilon(2e-2));
    CHECK(printed(1.0) == Approx(1.72).epsilon(1e-2));
}

TEST_CASE("(B17a) for small m the Gaussian's normalisation is Dawson's function", "[eq]") {
    for (const double m : {1e-4, 0.01, 0.1, 0.2}) {
        // F(m) = Σ (−1)^k 2^k m^(2k+1)/(2k+1)!!
        double term = m, dawson = 0;
        for (int k = 0; k < 40; ++k) {
            dawson += term;
            term *= -2 * m * m / (2 * k + 3);
        }
        CHECK(gaussian_norm(m) == Approx(1 / (pi * m * dawson)).epsilon(1e-13));
    }
}

TEST_CASE("(B17b) (B17d) at m = 1 facets point everywhere alike", "[eq]") {
    for (const double c : {0.0, 0.1, 0.7, 1.0}) {
        CHECK(D_blinn(c, 1 - c * c, 1.0) == Approx(1 / pi));
        CHECK(D_ggx(c, 1 - c * c, 1.0) == Approx(1 / pi));
    }
}

TEST_CASE("(B17b) (B17c) away from limits the computed forms are the printed ones", "[eq]") {
    for (const double m : {0.2, 0.5, 0.9})
        for (const double c : {0.3, 0.6, 0.8, 0.99}) {
            CHECK(D_blinn(c, 1 - c * c, m) ==
                  Approx(std::pow(c, 2 / (m * m) - 2) / (pi * m * m)).epsilon(1e-10));
            CHECK(D_beckmann(c, 1 - c * c, m) ==
                  Approx(std::exp((c * c - 1) / (m * m * c * c)) / (pi * m * m * std::pow(c, 4)))
                      .epsilon(1e-10));
        }
}

TEST_CASE("(B17c) Beckmann at grazing half vectors is 0, where the printed form is no number",
          "[eq]") {
    const float c = 0, m = 0.5f;
    const float printed = std::exp((c * c - 1) / (m * m * c * c)) / (c * c * c * c);
    CHECK(std::isnan(printed));
    CHECK(D_beckmann(c, 1.0f, m) == 0);
}

TEST_CASE("(B17d) in the highlight of a smooth surface the printed GGX loses its digits", "[eq]") {
    double worst_printed = 0, worst = 0;
    for (float theta = 2e-4f; theta < 4e-3f; theta *= 1.1f) {
        const float m = 0.001f, c = std::cos(theta), s = std::sin(theta);
        const float below = c * c * (m * m - 1) + 1;
        const float printed = m * m / (float(pi) * below * below);
        const double exact =
            D_ggx(std::cos(double(theta)), std::pow(std::sin(double(theta)), 2), double(m));
        worst_printed = std::max(worst_printed, std::abs(double(printed) / exact - 1));
        worst = std::max(worst, std::abs(double(D_ggx(c, s * s, m)) / exact - 1));
    }
    CHECK(worst_printed > 0.1);
    CHECK(worst < 1e-6);
}

TEST_CASE("(B18a) V-cavities by hand, symmetric and bounded", "[eq]") {
    CHECK(G_v_cavity(1.0, 1.0, 1.0, 1.0) == 1);
    CHECK(G_v_cavity(0.2, 0.9, 0.5, 0.8) == Approx(2 * 0.5 * 0.2 / 0.8));
    CHECK(G_v_cavity(0.9, 0.2, 0.5, 0.8) == G_v_cavity(0.2, 0.9, 0.5, 0.8));
    CHECK(G_v_cavity(-0.1, 0.9, 0.5, 0.8) == 0);
    CHECK(G_v_cavity(0.3, 0.3, 0.0, 0.0) == 0);  // ω_i = −ω_o
    CHECK(v_cavity_over_4_cos_o(0.2, 0.9, 0.5, 0.8) == Approx(0.25 / 3.6));
    CHECK(std::isfinite(v_cavity_over_4_cos_o(1e-12f, 1e-12f, 0.5f, 1e-12f)));
}

TEST_CASE("(B18b) Smith's factor is the printed one, and finite at grazing angles", "[eq]") {
    const auto G1 = [](double c, double m) {
        return 2 * c / (c + std::sqrt(m * m + (1 - m * m) * c * c));
    };
    for (const double m : {0.01, 0.3, 1.0})
        for (const double i : {0.05, 0.5, 1.0})
            for (const double o : {0.1, 0.9}) {
                CHECK(G1_smith_over_cos(i, m) * i == Approx(G1(i, m)));
                CHECK(smith_over_4_cos_o(i, o, m) == Approx(G1(i, m) * G1(o, m) / (4 * o)));
            }
    CHECK(G1_smith_over_cos(1.0, 0.2) == 1);
    CHECK(smith_over_4_cos_o(0.5, 0.0, 0.1) == Approx(G1(0.5, 0.1) / 0.2));  // no 0/0
    CHECK(smith_over_4_cos_o(-0.5, 0.3, 0.1) == 0);
}

TEST_CASE("(B16) with F at the half vector the model is reciprocal; as printed it is not", "[eq]") {
    const Vec3<double> n = {0, 0, 1};
    const auto f_r = [&](const Vec3<double>& wi, const Vec3<double>& wo, bool printed) {
        const Cosines<double> c = cosines(n, wi, wo);
        const double F = fresnel_schlick(Rgb<double>{0.04, 0.04, 0.04}, printed ? c.n_i : c.i_h).r;
        const double G = smith_over_4_cos_o(c.n_i, c.n_o, 0.3);
        return torrance_sparrow_f_cos(Rgb<double>{F, F, F}, G, D_ggx(c.n_h, c.sin2_h, 0.3)).r /
               c.n_i;
    };
    Rng rng(71);
    double asymmetry = 0;
    for (int k = 0; k < 200; ++k) {
        const Vec3<double> wi = random_direction(rng, 0.02), wo = random_direction(rng, 0.02);
        CHECK(f_r(wi, wo, false) == Approx(f_r(wo, wi, false)).epsilon(1e-10));
        const double one = f_r(wi, wo, true), other = f_r(wo, wi, true);
        asymmetry = std::max(asymmetry, std::abs(one - other) / std::max(one, other));
    }
    CHECK(asymmetry > 0.5);
}

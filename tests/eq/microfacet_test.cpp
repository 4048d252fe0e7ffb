#include "scanshade/eq/microfacet.hpp"

#include <cmath>
#include <string_view>

#include "brdf/cosines.hpp"
#include "report/printed_forms.hpp"
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
    const auto as_printed = [](double m) {
        return projected_area([&](double c, double) { return printed::D_gaussian(c, m); });
    };
    CHECK(as_printed(0.1) == Approx(0.0312).epsilon(1e-2));
    CHECK(as_printed(0.3) == Approx(0.27).epsilon(2e-2));
    CHECK(as_printed(1.0) == Approx(1.72).epsilon(1e-2));
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

TEST_CASE("(B17b) (B17c) (B17d) away from limits the computed forms are the printed ones", "[eq]") {
    for (const double m : {0.2, 0.5, 0.9})
        for (const double c : {0.3, 0.6, 0.8, 0.99}) {
            CHECK(D_blinn(c, 1 - c * c, m) == Approx(printed::D_blinn(c, m)).epsilon(1e-10));
            CHECK(D_beckmann(c, 1 - c * c, m) == Approx(printed::D_beckmann(c, m)).epsilon(1e-10));
            CHECK(D_ggx(c, 1 - c * c, m) == Approx(printed::D_ggx(c, m)).epsilon(1e-10));
        }
}

TEST_CASE("(B17c) Beckmann at grazing half vectors is 0, where the printed form is no number",
          "[eq]") {
    const float c = 0, m = 0.5f;
    CHECK(std::isnan(printed::D_beckmann(c, m)));
    CHECK(D_beckmann(c, 1.0f, m) == 0);
}

TEST_CASE("(B17d) in the highlight of a smooth surface the printed GGX loses its digits", "[eq]") {
    double worst_printed = 0, worst = 0;
    for (float theta = 2e-4f; theta < 4e-3f; theta *= 1.1f) {
        const float m = 0.001f, c = std::cos(theta), s = std::sin(theta);
        const double exact =
            D_ggx(std::cos(double(theta)), std::pow(std::sin(double(theta)), 2), double(m));
        worst_printed = std::max(worst_printed, std::abs(double(printed::D_ggx(c, m)) / exact - 1));
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
    for (const double m : {0.01, 0.3, 1.0})
        for (const double i : {0.05, 0.5, 1.0})
            for (const double o : {0.1, 0.9}) {
                CHECK(G1_smith_over_cos(i, m) * i == Approx(printed::G1_smith(i, m)));
                CHECK(smith_over_4_cos_o(i, o, m) ==
                      Approx(printed::G1_smith(i, m) * printed::G1_smith(o, m) / (4 * o)));
            }
    CHECK(G1_smith_over_cos(1.0, 0.2) == 1);
    CHECK(smith_over_4_cos_o(0.5, 0.0, 0.1) ==
          Approx(printed::G1_smith(0.5, 0.1) / 0.2));  // no 0/0
    CHECK(smith_over_4_cos_o(-0.5, 0.3, 0.1) == 0);
}

TEST_CASE("(B16) with F at the half vector the model is reciprocal; as printed it is not", "[eq]") {
    const Vec3<double> n = {0, 0, 1};
    const auto f_r = [&](const Vec3<double>& wi, const Vec3<double>& wo) {
        const Cosines<double> c = cosines(n, wi, wo);
        const Rgb<double> F = fresnel_schlick(Rgb<double>{0.04, 0.04, 0.04}, c.i_h);
        const double G = smith_over_4_cos_o(c.n_i, c.n_o, 0.3);
        return torrance_sparrow_f_cos(F, G, D_ggx(c.n_h, c.sin2_h, 0.3)).r / c.n_i;
    };
    const auto as_printed = [&](const Vec3<double>& wi, const Vec3<double>& wo) {
        const Cosines<double> c = cosines(n, wi, wo);
        const double G = printed::G1_smith(c.n_i, 0.3) * printed::G1_smith(c.n_o, 0.3);
        return printed::torrance_sparrow_brdf(printed::fresnel_schlick(0.04, c.n_i), G,
                                              printed::D_ggx(c.n_h, 0.3), c.n_i, c.n_o);
    };
    Rng rng(71);
    double asymmetry = 0;
    for (int k = 0; k < 200; ++k) {
        const Vec3<double> wi = random_direction(rng, 0.02), wo = random_direction(rng, 0.02);
        CHECK(f_r(wi, wo) == Approx(f_r(wo, wi)).epsilon(1e-10));
        const double one = as_printed(wi, wo), other = as_printed(wo, wi);
        asymmetry = std::max(asymmetry, std::abs(one - other) / std::max(one, other));
    }
    CHECK(asymmetry > 0.5);
}

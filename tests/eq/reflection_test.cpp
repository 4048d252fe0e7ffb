#include "scanshade/eq/reflection.hpp"

#include <algorithm>
#include <cmath>

#include "report/printed_forms.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace scanshade;

namespace {

Vec3<double> upper_direction(Rng& rng) { return random_direction(rng, 0.05); }

}  // namespace

TEST_CASE("(B6) Lambert's albedo by quadrature is rho_d", "[eq]") {
    constexpr int n = 400;
    const Rgb<double> f = lambert_brdf(Rgb<double>{0.2, 0.5, 1.0});
    Rgb<double> albedo{0, 0, 0};
    for (int i = 0; i < n; ++i) {
        const double theta = (i + 0.5) * pi / 2 / n;
        albedo = albedo + f * (std::cos(theta) * std::sin(theta) * pi / 2 / n * 2 * pi);
    }
    CHECK(albedo.r == Approx(0.2).epsilon(1e-5));
    CHECK(albedo.g == Approx(0.5).epsilon(1e-5));
    CHECK(albedo.b == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("(B7) the mirror direction keeps the angle, the plane and the length", "[eq]") {
    Rng rng(21);
    for (int k = 0; k < 500; ++k) {
        const Vec3<double> n = upper_direction(rng), wi = upper_direction(rng);
        const Vec3<double> wr = mirror_direction(wi, n);
        CHECK(dot(wr, n) == Approx(dot(wi, n)).margin(1e-14));
        CHECK(dot(wr, wr) == Approx(1));
        CHECK(std::abs(dot(cross(wi, n), wr)) < 1e-14);
        const Vec3<double> again = mirror_direction(wr, n) - wi;
        CHECK(dot(again, again) < 1e-28);
    }
}

TEST_CASE("(B12) the power holds its error bound for every exponent", "[eq]") {
    Rng rng(22);
    for (const double s : {0.0, 1.0, 2.0, 3.0, 7.0, 10.0, 40.0, 63.0, 100.0, 1000.0, 65535.0, 1e6,
                           0.25, 0.5, 2.5, 30.75, 1000.125})
        for (int k = 0; k < 200; ++k) {
            const Exponent exponent = make_exponent(s);
            const float x = float(std::pow(rng.real(0.001, 1), 1 / (s + 1)));
            const long double exact = std::pow((long double)x, (long double)s);
            if (exact < 1e-30L) continue;
            const double bound = power_error_u(exponent) * 0x1p-24 * double(exact);
            CAPTURE(s, x);
            CHECK(std::abs(double((long double)pow_shininess(x, exponent) - exact)) <=
                  bound * 1.0001);
        }
}

TEST_CASE("(B12) powers at 0, at 1 and of negative cosines are defined", "[eq]") {
    const Exponent zero = make_exponent(0), half = make_exponent(0.5), ten = make_exponent(10);
    CHECK(pow_shininess(0.0, zero) == 1);
    CHECK(pow_shininess(-0.5, zero) == 1);
    CHECK(pow_shininess(0.0, half) == 0);
    CHECK(pow_shininess(-0.5, half) == 0);
    CHECK(pow_shininess(-0.5, ten) == 0);  // an even power would light the wrong side
    CHECK(pow_shininess(1.0, ten) == 1);
    CHECK(pow_shininess(1.0f, make_exponent(1e6)) == 1);
}

TEST_CASE("(B12) diffuse and specular parts add up, channel by channel", "[eq]") {
    const Rgb<double> k_d = {0.1, 0.2, 0.3}, k_s = {0.5, 0.0, 1.0};
    const Rgb<double> L = phong_reflection(k_d, k_s, make_exponent(2), 0.5, 0.8);
    CHECK(L.r == Approx(0.1 * 0.5 + 0.5 * 0.64));
    CHECK(L.g == Approx(0.1));
    CHECK(L.b == Approx(0.15 + 0.64));
    const Rgb<double> flat = phong_reflection(k_d, k_s, make_exponent(0), 0.5, 0.0);
    CHECK(flat.r == Approx(0.55));  // n = 0: the specular part is constant
}

TEST_CASE("(B15) the half vector lies in the middle; opposite directions have none", "[eq]") {
    Rng rng(23);
    for (int k = 0; k < 500; ++k) {
        const Vec3<double> wi = upper_direction(rng), wo = upper_direction(rng);
        const Vec3<double> h = half_vector(wi, wo);
        CHECK(dot(h, h) == Approx(1));
        CHECK(dot(h, wi) == Approx(dot(h, wo)));
        CHECK(std::abs(dot(cross(wi, wo), h)) < 1e-14);
        const Vec3<double> n = upper_direction(rng);
        CHECK(cos_half(dot(n, wi), dot(n, wo), wi, wo) ==
              Approx(std::max(0.0, dot(n, h))).margin(1e-14));
    }
    const Vec3<float> w = {0, 0.6f, 0.8f};
    const Vec3<float> none = half_vector(w, -w);
    CHECK(dot(none, none) == 0);
    CHECK(cos_half(0.8f, -0.8f, w, -w) == 0);
}

TEST_CASE("(B13) f_r cosθ_i is finite where the printed BRDF is not", "[eq]") {
    const Rgb<float> k = {0.5f, 0.5f, 0.5f};
    const float grazing = 1e-42f, r_o = 0.9f;
    CHECK(std::isinf(printed::phong_brdf(k.r, k.r, 10.0f, grazing, r_o)));
    CHECK(phong_f_cos(k, k, make_exponent(10), grazing, r_o).r < 1);
    // With L_i = 1 and k in C7's units, π f_r cosθ_i is B12.
    const Rgb<double> d = {0.1, 0.2, 0.3}, s = {0.3, 0.2, 0.1};
    CHECK(phong_f_cos(d, s, make_exponent(7), 0.4, 0.8).g * pi ==
          Approx(phong_reflection(d, s, make_exponent(7), 0.4, 0.8).g));
}

TEST_CASE("(B14) the modified lobe's albedo at normal incidence is rho_d + rho_s", "[eq]") {
    const Vec3<double> n = {0, 0, 1};
    for (const double s : {0.0, 1.0, 10.0, 100.0, 1e4, 1e6}) {
        CAPTURE(s);
        const double albedo = hemisphere_integral(n, [&](const Vec3<double>& wi) {
            return modified_phong_brdf(Rgb<double>{0.3, 0, 0}, Rgb<double>{0.5, 0, 0},
                                       make_exponent(s), s + 2, wi.z)
                       .r *
                   wi.z;
        });
        CHECK(albedo == Approx(0.8).epsilon(2e-3));
    }
}

TEST_CASE("(B20) Oren-Nayar with sigma 0 is Lambert; its azimuths matter", "[eq]") {
    const OrenNayarCoefficients<double> smooth = oren_nayar_coefficients(0.0);
    CHECK((smooth.A == 1 && smooth.B == 0));
    const Rgb<double> rho = {0.8, 0.5, 0.2};
    CHECK(oren_nayar_f_cos(rho, smooth, 0.3, 0.6, 0.4).r == Approx(0.8 / pi * 0.3));

    const double sigma = 0.5, theta_i = 0.9, theta_o = 0.6;
    const OrenNayarCoefficients<double> k = oren_nayar_coefficients(sigma);
    const auto ours = [&](double dphi) {
        const double s = std::sin(theta_i) * std::sin(theta_o) * std::cos(dphi);
        return oren_nayar_f_cos(rho, k, std::cos(theta_i), std::cos(theta_o), s).r;
    };
    const auto formula = [&](double cosine) {
        return printed::oren_nayar_brdf(0.8, sigma, theta_i, theta_o, cosine) * std::cos(theta_i);
    };
    for (const double dphi : {0.0, 1.0, 2.0, pi})
        CHECK(ours(dphi) == Approx(formula(std::cos(dphi))));
    // The printed cos(θ_i − θ_o) gives the same in every azimuth: no brighter towards the light.
    CHECK(ours(0) > 1.1 * ours(pi));
    CHECK(formula(std::cos(theta_i - theta_o)) > 1.1 * ours(pi));
}

TEST_CASE("(B20) Oren-Nayar is defined at the pole and bounded at grazing angles", "[eq]") {
    const OrenNayarCoefficients<float> k = oren_nayar_coefficients(1.5f);
    const Rgb<float> white = {1, 1, 1};
    CHECK(oren_nayar_f_cos(white, k, 1.0f, 1.0f, 0.0f).r == Approx(k.A / float(pi)));
    for (const float c : {1e-3f, 1e-8f, 1e-30f})
        CHECK(oren_nayar_f_cos(white, k, c, c, 1.0f).r <= 0.35f);  // f_r itself is tan 90°
}

TEST_CASE("(B20) white facets give back at most 1.52 % more than they get", "[eq]") {
    // ∫ f_r cosθ_i dω_i for ρ = 1; grazing views gain most, up to A + B/2.
    const auto albedo = [](double sigma, double theta_o) {
        constexpr int n = 500;
        const OrenNayarCoefficients<double> k = oren_nayar_coefficients(sigma);
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double theta_i = (i + 0.5) * pi / 2 / n, dphi = (j + 0.5) * pi / n;
                const double s = std::sin(theta_i) * std::sin(theta_o) * std::cos(dphi);
                sum += oren_nayar_f_cos(Rgb<double>{1, 1, 1}, k, std::cos(theta_i),
                                        std::cos(theta_o), s)
                           .r *
                       std::sin(theta_i);
            }
        return sum * 2 * (pi / 2 / n) * (pi / n);
    };
    double largest = 0;
    for (const double sigma : {0.1, 0.1985, 0.3, 1.5})
        for (const double theta_o : {0.0, 0.8, 1.2, 1.5, 1.57}) {
            const OrenNayarCoefficients<double> k = oren_nayar_coefficients(sigma);
            CHECK(albedo(sigma, theta_o) <= k.A + k.B / 2 + 1e-5);
            largest = std::max(largest, albedo(sigma, theta_o));
        }
    CHECK(largest == Approx(1.0152).epsilon(1e-4));
    for (double sigma = 0; sigma <= 1.57; sigma += 1e-4) {
        const OrenNayarCoefficients<double> k = oren_nayar_coefficients(sigma);
        CHECK(k.A + k.B / 2 < 1.01518);
    }
}

TEST_CASE("a power by exp and log alone keeps to its bound", "[eq]") {
    for (const double s : {1.0, 12.5, 40.0, 1000.0}) {
        const Exponent form = by_exp_log(make_exponent(s));
        CHECK(form.whole == 0);
        const double bound = power_error_u(form) * 0x1p-24;
        for (const double x : {0.3, 0.9, 0.99, 0.9999, 1.0}) {
            const double exact = double(std::pow(static_cast<long double>(static_cast<float>(x)),
                                                 static_cast<long double>(s)));
            CAPTURE(s, x);
            if (exact < 1e-29) continue;  // below 2^-100 it is 0
            CHECK(std::abs(double(pow_shininess(static_cast<float>(x), form)) - exact) <=
                  bound * exact);
        }
    }
}

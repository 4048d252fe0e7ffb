#include "scanshade/eq/fresnel.hpp"

#include <cmath>

#include "report/printed_forms.hpp"
#include "scanshade/eq/directions.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace scanshade;

namespace {

const Vec3<double> n = {0, 0, 1};

double sin_to_n(const Vec3<double>& w) {
    const Vec3<double> c = cross(w, n);
    return std::sqrt(dot(c, c));
}

}  // namespace

TEST_CASE("(B8) a mirror shows what is at the same angle on the other side", "[eq]") {
    Rng rng(61);
    for (int k = 0; k < 200; ++k) {
        const Vec3<double> wo = random_direction(rng, 0.05);
        if (wo.z > 0.999) continue;
        const DeltaLobe<double> lobe = ideal_mirror(wo, n, 0.3);
        const Spherical<double> o = to_spherical(wo), i = to_spherical(lobe.wi);
        CHECK(lobe.weight == 0.3);
        CHECK(i.theta == Approx(o.theta));
        CHECK(std::cos(i.phi - o.phi) == Approx(-1));  // φ_i − φ_o ± π, as the second form says
        // The printed first form, δ(ω_i − ω_o), selects ω_i = ω_o, whose azimuth is the same.
        CHECK(std::cos(to_spherical(printed::delta_direction(wo)).phi - o.phi) == Approx(1));
    }
}

TEST_CASE("(B9) refraction keeps Snell's law, the plane and the length", "[eq]") {
    Rng rng(62);
    for (int k = 0; k < 500; ++k) {
        const Vec3<double> wi = random_direction(rng, 0.01);
        const double eta = rng.real(0.3, 3);
        const Vec3<double> wt = refracted_direction(wi, n, eta);
        if (dot(wt, wt) == 0) {
            CHECK(eta * sin_to_n(wi) > 1);  // total internal reflection
            continue;
        }
        CHECK(eta * sin_to_n(wi) <= 1);
        CHECK(dot(wt, wt) == Approx(1));
        CHECK(sin_to_n(wt) == Approx(eta * sin_to_n(wi)));
        CHECK(wt.z < 0);
        CHECK(std::abs(dot(cross(wi, n), wt)) < 1e-14);
        CHECK(snell_cos2(wi.z, eta) == Approx(wt.z * wt.z).margin(1e-14));
        // As printed it is no unit vector.
        const Vec3<double> wrong = printed::refracted_direction(wi, n, eta);
        CHECK(std::abs(dot(wrong, wrong) - 1) > 1e-3);
    }
    const Vec3<double> straight = refracted_direction(direction_at(0, 1.0), n, 1.0);
    CHECK(straight.x == Approx(-std::cos(1.0)));  // η = 1 at grazing: no 0/0
}

TEST_CASE("(B9) at grazing angles the usual cosine loses its digits, ours does not", "[eq]") {
    const float cos_i = 1e-4f, eta = 1;
    CHECK(snell_cos2(cos_i, eta) == Approx(1e-8).epsilon(1e-6));
    CHECK(std::abs(printed::snell_cos2(cos_i, eta) - 1e-8f) > 1e-9f);
}

TEST_CASE("(B10) beyond the critical angle all is reflected, before it is not", "[eq]") {
    for (const double eta : {1.1, 1.33, 1.5, 2.4}) {
        const double critical = critical_angle(1 / eta);
        CHECK(fresnel_dielectric(std::cos(critical + 1e-6), eta) == 1);
        CHECK(fresnel_dielectric(std::cos(critical - 1e-6), eta) < 1);
        CHECK(dot(refracted_direction(direction_at(std::cos(critical + 1e-6), 0), n, eta), n) == 0);
        CHECK(critical_angle(eta) == Approx(pi / 2));  // none towards the denser medium
    }
}

TEST_CASE("(B10) radiance times the refracted cone's solid angle keeps the flux", "[eq]") {
    const double eta_oi = 1.5, theta = 0.6, step = 1e-5;
    const auto theta_o = [&](double t) { return std::asin(std::sin(t) / eta_oi); };
    const double domega_i = std::sin(theta) * step;
    const double domega_o = std::sin(theta_o(theta)) * (theta_o(theta + step) - theta_o(theta));
    const double flux_i = 2 * std::cos(theta) * domega_i;
    const double flux_o = refracted_radiance(2.0, eta_oi) * std::cos(theta_o(theta)) * domega_o;
    CHECK(flux_o == Approx(flux_i).epsilon(1e-4));
}

TEST_CASE("(B10) a refractor shows what is refracted to the viewer", "[eq]") {
    Rng rng(63);
    for (int k = 0; k < 200; ++k) {
        const Vec3<double> wo = random_direction(rng, 0.05);
        const double eta_oi = rng.real(0.7, 1.5);
        const DeltaLobe<double> lobe = ideal_refractor(wo, n, eta_oi);
        if (dot(lobe.wi, lobe.wi) == 0) {
            CHECK(lobe.weight == 0);
            continue;
        }
        const Vec3<double> back = refracted_direction(lobe.wi, -n, 1 / eta_oi);
        CHECK(dot(back, wo) == Approx(1));
        CHECK(lobe.weight ==
              Approx(eta_oi * eta_oi * (1 - fresnel_dielectric(-lobe.wi.z, 1 / eta_oi))));
        // The printed δ(ω_i − ω_o) would take light from the viewer's own side.
        CHECK(lobe.wi.z < 0);
        CHECK(printed::delta_direction(wo).z > 0);
    }
}

TEST_CASE("(B11) reflected and transmitted light sum to what arrives", "[eq]") {
    Rng rng(64);
    for (int k = 0; k < 500; ++k) {
        const double eta = rng.real(0.3, 3), cos_i = rng.real(0.01, 1);
        const double cos2 = snell_cos2(cos_i, eta);
        if (cos2 <= 0) {
            CHECK(fresnel_dielectric(cos_i, eta) == 1);
            continue;
        }
        // Transmitted amplitudes, which have formulas of their own.
        const double cos_o = std::sqrt(cos2), flux = cos_o / (eta * cos_i);
        const double t_s = 2 * eta * cos_i / (eta * cos_i + cos_o);
        const double t_p = 2 * eta * cos_i / (eta * cos_o + cos_i);
        CHECK(fresnel_s(cos_i, eta) + flux * t_s * t_s == Approx(1));
        CHECK(fresnel_p(cos_i, eta) + flux * t_p * t_p == Approx(1));
        CHECK(fresnel_dielectric(cos_i, eta) ==
              Approx(fresnel_dielectric(cos_o, 1 / eta)).epsilon(1e-9));
    }
}

TEST_CASE("(B11) there is no reflection of p at Brewster's angle, and all at grazing", "[eq]") {
    for (const double eta : {0.4, 1 / 1.5, 0.9, 1.2}) {
        const double brewster = std::atan(1 / eta);
        CHECK(fresnel_p(std::cos(brewster), eta) < 1e-30);
        CHECK(fresnel_s(std::cos(brewster), eta) > 1e-4);
        CHECK(fresnel_dielectric(0.0, eta) == Approx(1));
    }
    CHECK(fresnel_dielectric(0.0, 1.0) == 0);  // no surface: no 0/0
    CHECK(fresnel_dielectric(1.0, 1.0) == 0);
}

TEST_CASE("(B11) near equal indices the printed form loses its digits, ours does not", "[eq]") {
    const float eta = 1 - 0x1p-20f;
    double worst_printed = 0;
    for (float cos_i = 0.1f; cos_i < 1; cos_i += 0.05f) {
        const double exact = double(fresnel_s((long double)cos_i, (long double)eta));
        CHECK(std::abs(double(fresnel_s(cos_i, eta)) - exact) <= 24 * 0x1p-24 * exact);
        worst_printed =
            std::max(worst_printed, std::abs(double(printed::fresnel_s(cos_i, eta)) / exact - 1));
    }
    CHECK(worst_printed > 0.1);
}

TEST_CASE("(B19) Schlick's approximation has the right ends and stays near", "[eq]") {
    CHECK(normal_reflectance(1.5) == Approx(0.04));
    double worst = 0;
    for (const double eta : {1.33, 1.5, 2.0}) {
        const double F0 = normal_reflectance(eta);
        CHECK(F0 == Approx(fresnel_dielectric(1.0, 1 / eta)));
        CHECK(fresnel_schlick(Rgb<double>{F0, F0, F0}, 1.0).g == F0);
        CHECK(fresnel_schlick(Rgb<double>{F0, F0, F0}, 0.0).b == 1);
        for (double c = 0; c <= 1; c += 1e-3)
            worst = std::max(worst, std::abs(fresnel_schlick(Rgb<double>{F0, F0, F0}, c).r -
                                             fresnel_dielectric(c, 1 / eta)));
    }
    CHECK(worst < 0.061);
    CHECK(worst > 0.05);  // it is an approximation
}

#include "scanshade/eq/reflectance.hpp"

#include <cmath>

#include "brdf/cosines.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace scanshade;

namespace {

/// f_r cosθ_i of a model with its default parameters, about a normal along z.
double default_f_cos(const BrdfInfo& brdf, const Vec3<double>& wi, const Vec3<double>& wo) {
    Material material;
    material.brdf = brdf.name;
    const auto params = resolve_material(material, "", {}).params;
    return brdf.f_cos_f64(cosines(Vec3<double>{0, 0, 1}, wi, wo), params)[0];
}

}  // namespace

TEST_CASE("(B1) (B3) the definition undoes the reflection equation", "[eq]") {
    const double f = 0.2, cos_i = 0.6, L = 3, domega = 0.01;
    CHECK(brdf_by_definition(reflected_term(f * cos_i, L, domega), L, cos_i, domega) == Approx(f));
}

TEST_CASE("(B2) turning both directions about the normal changes no model", "[eq][brdf]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(51);
            for (int k = 0; k < 100; ++k) {
                const Vec3<double> wi = random_direction(rng, 0.05),
                                   wo = random_direction(rng, 0.05);
                const double turn = rng.real(0, 2 * pi);
                const auto turned = [turn](const Vec3<double>& w) {
                    Spherical<double> s = to_spherical(w);
                    s.phi += turn;
                    return to_cartesian(s);
                };
                const auto before = isotropic_angles(to_spherical(wi), to_spherical(wo));
                const auto after =
                    isotropic_angles(to_spherical(turned(wi)), to_spherical(turned(wo)));
                CHECK(std::cos(before.dphi - after.dphi) == Approx(1));
                CHECK((after.dphi >= 0 && after.dphi < 2 * pi));
                CHECK(before.theta_i == Approx(after.theta_i));
                CHECK(default_f_cos(*brdf, turned(wi), turned(wo)) ==
                      Approx(default_f_cos(*brdf, wi, wo)).epsilon(1e-10));
            }
        }
}

TEST_CASE("(B3) (B4) (B5) Lambert in constant light: radiance, albedo and energy are rho", "[eq]") {
    const Vec3<double> z = {0, 0, 1};
    const double rho = 0.7, L = 2;
    const auto f_cos = [&](const Vec3<double>& w) { return rho / pi * w.z; };
    const double albedo =
        hemisphere_integral(z, [&](const Vec3<double>& w) { return albedo_term(f_cos(w), 1.0); });
    const double L_o = hemisphere_integral(
        z, [&](const Vec3<double>& w) { return reflected_term(f_cos(w), L, 1.0); });
    CHECK(albedo == Approx(rho).epsilon(1e-3));
    CHECK(L_o == Approx(rho * L).epsilon(1e-3));
    // What leaves, by its own integral over ω_o, to what arrives.
    const double B = hemisphere_integral(z, [&](const Vec3<double>& w) { return L_o * w.z; });
    const double E = hemisphere_integral(z, [&](const Vec3<double>& w) { return L * w.z; });
    CHECK(energy_ratio(B, E) == Approx(rho).epsilon(1e-3));
}

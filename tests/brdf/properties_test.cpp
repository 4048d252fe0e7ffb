// What each model of the registry says of itself, and what all must keep.
#include <algorithm>
#include <cmath>
#include <utility>

#include "brdf/cosines.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/materials.hpp"

using namespace scanshade;

namespace {

const Vec3<double> up = {0, 0, 1};

/// Pairs of directions above the surface, light and view near grazing at times, and at times the
/// same or mirrored.
std::pair<Vec3<double>, Vec3<double>> random_pair(Rng& rng) {
    const auto one = [&] {
        const std::int64_t pick = rng.integer(0, 7);
        return pick == 0 ? direction_at(rng.real(1e-8, 1e-3), rng.real(0, 2 * pi))
                         : random_direction(rng, 1e-3);
    };
    const Vec3<double> wi = one();
    const std::int64_t pick = rng.integer(0, 15);
    if (pick == 0) return {wi, wi};
    if (pick == 1) return {wi, mirror_direction(wi, up)};
    return {wi, one()};
}

Cosines<double> cosines_of(const Vec3<double>& wi, const Vec3<double>& wo) {
    return cosines(up, wi, wo);
}

/// ∫ f_r cosθ_i dω_i of a channel, for a viewer in direction wo.
double albedo(const BrdfInfo& brdf, const MaterialParams<double>& p, const Vec3<double>& wo,
              std::size_t channel) {
    return hemisphere_integral(mirror_direction(wo, up), [&](const Vec3<double>& wi) {
        return brdf.f_cos_f64(cosines_of(wi, wo), p)[channel];
    });
}

/// Scales diffuse and specular parameters so that they sum to at most 1 in each channel.
void limit_sum_to_one(const BrdfInfo& brdf, MaterialParams<double>& p) {
    for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        const auto reflects = [&](std::size_t i) {
            return brdf.params[i].role == ParamRole::diffuse ||
                   brdf.params[i].role == ParamRole::specular;
        };
        for (std::size_t i = 0; i < brdf.params.size(); ++i)
            if (reflects(i)) sum += p.value[i][c];
        for (std::size_t i = 0; i < brdf.params.size(); ++i)
            if (reflects(i) && sum > 1) p.value[i][c] /= sum;
    }
}

}  // namespace

TEST_CASE("cosines keep the half vector's sine where its cosine is 1, and have none for opposites",
          "[brdf]") {
    const Vec3<float> n = {0, 0, 1};
    for (const float theta : {1e-2f, 1e-3f, 1e-4f}) {
        // Light and viewer lean to the same side by θ and 3 θ, so the half vector by 2 θ.
        const Vec3<float> wi = {std::sin(theta), 0, std::cos(theta)};
        const Vec3<float> wo = {std::sin(3 * theta), 0, std::cos(3 * theta)};
        const Cosines<float> c = cosines(n, wi, wo);
        CHECK(c.sin2_h == Approx(std::pow(std::sin(2 * double(theta)), 2)).epsilon(1e-5));
        CHECK(c.s_io == Approx(double(wi.x) * double(wo.x)).epsilon(1e-5));
        CHECK(c.i_h == Approx(std::cos(double(theta))));
    }
    const Cosines<float> none =
        cosines(n, Vec3<float>{0.6f, 0, 0.8f}, Vec3<float>{-0.6f, 0, -0.8f});
    CHECK((none.n_h == 0 && none.i_h == 0 && none.sin2_h == 1));
    CHECK(none.n_o == 1e-12f);
}

TEST_CASE("each model is finite, not negative, and exact to its bound in float",
          "[brdf][property]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(31);
            for (int k = 0; k < 4000; ++k) {
                // float's own parameters and cosines, so that only the arithmetic differs.
                const MaterialParams<double> p =
                    params_as<double>(to_float(random_params(*brdf, rng)));
                const auto [wi, wo] = random_pair(rng);
                const Cosines<float> narrow = cosines_as<float>(cosines_of(wi, wo));
                CAPTURE(k);
                const auto f32 = brdf->f_cos_f32(narrow, to_float(p));
                const auto f64 = brdf->f_cos_f64(cosines_as<double>(narrow), p);
                const auto f80 =
                    brdf->f_cos_f80(cosines_as<long double>(narrow), params_as<long double>(p));
                const double error_u = brdf->promises.error_u(p);
                for (std::size_t ch = 0; ch < 3; ++ch) {
                    REQUIRE(std::isfinite(f32[ch]));
                    REQUIRE(f32[ch] >= 0);
                    REQUIRE(std::abs(double(f32[ch]) - f64[ch]) <=
                            error_u * 0x1p-24 * f64[ch] + 1e-30);
                    REQUIRE(std::abs(double((long double)f64[ch] - f80[ch])) <=
                            error_u * 0x1p-53 * f64[ch] + 1e-200);
                }
            }
        }
}

TEST_CASE("each model in intervals encloses float and double, closely",
          "[brdf][property][interval]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(35);
            for (int k = 0; k < 2000; ++k) {
                const MaterialParams<float> p = to_float(random_params(*brdf, rng));
                const auto [wi, wo] = random_pair(rng);
                const Cosines<float> c = cosines_as<float>(cosines_of(wi, wo));
                const auto point = [](float x) { return PlainInterval{x, x}; };
                const Cosines<PlainInterval> points = {point(c.n_i), point(c.n_o), point(c.n_h),
                                                       point(c.r_o), point(c.i_h), point(c.sin2_h),
                                                       point(c.s_io)};
                const auto enclosure = brdf->f_cos_interval(points, p);
                const auto f32 = brdf->f_cos_f32(c, p);
                const auto f64 = brdf->f_cos_f64(cosines_as<double>(c), params_as<double>(p));
                const double error_u = brdf->promises.error_u(params_as<double>(p));
                for (std::size_t ch = 0; ch < 3; ++ch) {
                    const auto [low, high] = enclosure[ch];
                    CAPTURE(k, low, high, f32[ch], f64[ch]);
                    REQUIRE((low <= f32[ch] && f32[ch] <= high));
                    REQUIRE((double(low) <= f64[ch] && f64[ch] <= double(high)));
                    REQUIRE(double(high) - double(low) <= 4 * error_u * 0x1p-24 * f64[ch] + 1e-30);
                }
            }
        }
}

TEST_CASE("each model in duals has double's value and its slope", "[brdf][property][dual]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(36);
            int compared = 0;
            for (int k = 0; k < 1000; ++k) {
                const MaterialParams<double> p = random_params(*brdf, rng);
                const auto [wi, wo] = random_pair(rng);
                const Cosines<double> c = cosines_of(wi, wo);
                // Along n_i, with all other cosines fixed.
                const auto fixed = [](double x) { return PlainDual{x, 0}; };
                Cosines<PlainDual> x = {fixed(c.n_i), fixed(c.n_o),    fixed(c.n_h), fixed(c.r_o),
                                        fixed(c.i_h), fixed(c.sin2_h), fixed(c.s_io)};
                x.n_i.derivative = 1;
                const auto slope_at = [&](long double step) {
                    Cosines<long double> moved = cosines_as<long double>(c);
                    moved.n_i += step;
                    return (brdf->f_cos_f80(moved, params_as<long double>(p))[1] -
                            brdf->f_cos_f80(cosines_as<long double>(c),
                                            params_as<long double>(p))[1]) /
                           step;
                };
                const PlainDual f = brdf->f_cos_dual(x, p)[1];
                REQUIRE(f.value == brdf->f_cos_f64(c, p)[1]);
                REQUIRE(std::isfinite(f.derivative));
                REQUIRE(condition_number(c.n_i, f) >= 0);
                const long double h = 1e-6L * (long double)c.n_i;
                const double left = double(slope_at(-h)), right = double(slope_at(h));
                if (!(std::abs(left - right) <= 1e-4 * (std::abs(left) + 1e-6))) continue;
                ++compared;
                REQUIRE(f.derivative == Approx((left + right) / 2).epsilon(1e-3).margin(1e-8));
            }
            CHECK(compared > 500);
        }
}

TEST_CASE("each model is finite at the extremes of everything, in float", "[brdf][property]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(37);
            const double ends[] = {1e-12, 1e-8, 1e-4, 0.5, 1 - 1e-7, 1};
            for (int k = 0; k < 3000; ++k) {
                const MaterialParams<double> p = params_by(*brdf, [&](const ParamInfo& param) {
                    if (param.kind == ParamKind::choice) return random_value(param, rng);
                    return rng.integer(0, 1) == 0 ? param.min : param.max;
                });
                const auto end = [&] { return ends[rng.integer(0, 5)]; };
                const Vec3<double> wi = direction_at(end(), 0);
                const Vec3<double> wo = direction_at(end(), double(rng.integer(0, 2)) * pi / 2);
                const auto f = brdf->f_cos_f32(cosines_as<float>(cosines_of(wi, wo)), to_float(p));
                CAPTURE(k, wi.z, wo.z, wo.x);
                for (const float channel : f) REQUIRE((std::isfinite(channel) && channel >= 0));
            }
        }
}

TEST_CASE("models are reciprocal as they promise; the others show a witness", "[brdf][property]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(38);
            double asymmetry = 0;
            for (int k = 0; k < 3000; ++k) {
                const MaterialParams<double> p = random_params(*brdf, rng);
                const auto [wi, wo] = random_pair(rng);
                const auto f = brdf->f_cos_f64(cosines_of(wi, wo), p);
                const auto swapped = brdf->f_cos_f64(cosines_of(wo, wi), p);
                for (std::size_t ch = 0; ch < 3; ++ch) {
                    const double one = f[ch] / wi.z, other = swapped[ch] / wo.z;
                    if (one + other > 1e-100)
                        asymmetry =
                            std::max(asymmetry, std::abs(one - other) / std::max(one, other));
                }
            }
            if (brdf->promises.reciprocal)
                CHECK(asymmetry < 1e-9);
            else
                CHECK(asymmetry > 0.1);
        }
}

TEST_CASE("in a white furnace models reflect what they promise; the others show a witness",
          "[brdf][property]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(32);
            double largest = 0, largest_limited = 0;
            for (int k = 0; k < 200; ++k) {
                // Half of the materials reflect as much as their colours allow.
                MaterialParams<double> p = params_by(*brdf, [&](const ParamInfo& param) {
                    return k % 2 == 0 && param.kind == ParamKind::rgb ? param.max
                                                                      : random_value(param, rng);
                });
                const Vec3<double> wo = random_direction(rng, 0.02);
                largest = std::max(largest, albedo(*brdf, p, wo, 0));
                limit_sum_to_one(*brdf, p);
                largest_limited = std::max(largest_limited, albedo(*brdf, p, wo, 0));
            }
            const Energy energy = brdf->promises.energy;
            if (energy == Energy::conserving)
                CHECK(largest <= 1.002);
            else
                CHECK(largest > 1.003);
            if (energy == Energy::conserving_to_sum_one) CHECK(largest_limited <= 1.002);
        }
}

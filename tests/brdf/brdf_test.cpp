// Loops over the registry: a model added tomorrow is tested tomorrow.
#include "scanshade/brdf/brdf.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "brdf/cosines.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace scanshade;

namespace {

const Vec3<double> up = {0, 0, 1};

/// A value of a parameter: every fourth time an end of its range. Exponents are kept where a power
/// does not yet amount to a cliff; extremes have a test of their own.
double random_value(const ParamInfo& param, Rng& rng) {
    const double high = param.kind == ParamKind::exponent ? 300 : param.max;
    const std::int64_t pick = rng.integer(0, 7);
    if (param.kind == ParamKind::choice) return double(rng.integer(0, std::int64_t(param.max)));
    const double v = pick == 0 ? param.min : pick == 1 ? high : rng.real(param.min, high);
    return param.kind == ParamKind::exponent && pick % 2 == 0 ? std::floor(v) : v;
}

/// Parameters of a model, each channel by `value(param)`.
template <class Value>
MaterialParams<double> params_by(const BrdfInfo& brdf, Value value) {
    Material material;
    material.brdf = brdf.name;
    for (const ParamInfo& param : brdf.params) {
        if (param.kind == ParamKind::choice)
            material.set_word(param.name, std::string(param.names[std::size_t(value(param))]));
        else if (param.kind == ParamKind::rgb)
            material.set(param.name, {value(param), value(param), value(param)});
        else
            material.set(param.name, {value(param)});
    }
    return resolve_material(material, "", {}).params;
}

MaterialParams<double> random_params(const BrdfInfo& brdf, Rng& rng) {
    return params_by(brdf, [&](const ParamInfo& param) { return random_value(param, rng); });
}

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

TEST_CASE("each model is found by its name and describes its parameters", "[brdf]") {
    REQUIRE(all_brdfs().size() >= 3);
    for (const BrdfInfo* brdf : all_brdfs()) {
        CAPTURE(brdf->name);
        CHECK(find_brdf(brdf->name) == brdf);
        CHECK_FALSE(brdf->equation.empty());
        CHECK_FALSE(brdf->source.empty());
        REQUIRE(brdf->params.size() <= max_params);
        for (const ParamInfo& param : brdf->params) {
            CHECK(param.min < param.max);
            CHECK((param.kind == ParamKind::choice) == !param.names.empty());
            if (!param.names.empty()) CHECK(param.max == double(param.names.size() - 1));
            CHECK((param.standard >= param.min && param.standard <= param.max));
            CHECK_FALSE(param.meaning.empty());
        }
    }
    CHECK(find_brdf("no-such-model") == nullptr);
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
                    REQUIRE(std::abs(double(f64[ch] - f80[ch])) <=
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
                const auto slope_at = [&](double step) {
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
                const double h = 1e-6 * c.n_i;
                const double left = double(slope_at(-h)), right = double(slope_at(h));
                if (!(std::abs(left - right) <= 1e-4 * (std::abs(left) + 1e-6))) continue;
                ++compared;
                REQUIRE(f.derivative == Approx((left + right) / 2).epsilon(1e-3).margin(1e-8));
            }
            CHECK(compared > 500);
        }
}

TEST_CASE("each model is finite at the extremes of everything, in float and in vectors",
          "[brdf][property]") {
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

namespace {

/// Random points, two point lights, a spot and a directional light.
struct SpanCase {
    std::vector<float> position[3], normal[3], albedo[3];
    Lighting<double> lighting{};
    std::size_t count;

    SpanCase(std::size_t points, Rng& rng) : count(points) {
        for (std::size_t i = 0; i < padded(points); ++i) {
            const Vec3<double> n = random_direction(rng, -0.2);
            const double components[] = {n.x, n.y, n.z};
            for (int c = 0; c < 3; ++c) {
                position[c].push_back(float(rng.real(-1, 1)));
                normal[c].push_back(
                    float(components[c] * 0.9));  // not a unit vector: (C5) makes it one
                albedo[c].push_back(float(rng.real(0, 1)));
            }
        }
        const double eye[3] = {0.5, 1, 6};
        std::copy(eye, eye + 3, lighting.eye);
        lighting.eye_scale = 1;
        for (int k = 0; k < 4; ++k) {
            LightTerm<double> light{};
            for (int c = 0; c < 3; ++c) {
                light.position[c] = rng.real(-4, 4) + (c == 2 ? 5 : 0);
                light.irradiance[c] = rng.real(0.1, 3);
            }
            light.point_scale = k == 3 ? 0 : 1;
            light.attenuation[0] = 1;
            light.attenuation[2] = k == 3 ? 0 : 0.05;
            light.radius = k == 3 ? 0 : 1e-4;
            if (k == 2) {
                light.emission = LightEmission::spot;
                light.axis[2] = -1;
                light.cos_cutoff = 0.6;
                light.inv_penumbra = 5;
            }
            lighting.lights.push_back(light);
        }
    }

    template <class T>
    std::vector<T> run(IlluminateFn<T> illuminate, const Lighting<T>& lights,
                       const MaterialParams<T>& params) const {
        std::vector<T> in[9], out[3];
        SurfaceSpan<T> span{};
        for (int c = 0; c < 3; ++c) {
            in[c].assign(position[c].begin(), position[c].end());
            in[3 + c].assign(normal[c].begin(), normal[c].end());
            in[6 + c].assign(albedo[c].begin(), albedo[c].end());
            out[c].resize(padded(count));
            span.position[c] = in[c].data();
            span.normal[c] = in[3 + c].data();
            span.albedo[c] = in[6 + c].data();
            span.radiance[c] = out[c].data();
        }
        span.count = count;
        illuminate(span, lights, params);
        std::vector<T> all;
        for (const auto& channel : out)
            all.insert(all.end(), channel.begin(), channel.begin() + long(count));
        return all;
    }
};

Lighting<float> narrow(const Lighting<double>& from) {
    Lighting<float> to{};
    const auto copy = [](const double(&a)[3], float(&b)[3]) {
        for (int c = 0; c < 3; ++c) b[c] = float(a[c]);
    };
    copy(from.eye, to.eye);
    to.eye_scale = float(from.eye_scale);
    for (const LightTerm<double>& l : from.lights) {
        LightTerm<float> t{};
        copy(l.position, t.position);
        copy(l.irradiance, t.irradiance);
        copy(l.attenuation, t.attenuation);
        copy(l.axis, t.axis);
        t.point_scale = float(l.point_scale);
        t.radius = float(l.radius);
        t.cos_cutoff = float(l.cos_cutoff);
        t.inv_penumbra = float(l.inv_penumbra);
        t.emission = l.emission;
        to.lights.push_back(t);
    }
    return to;
}

}  // namespace

TEST_CASE("every instruction set lights a span as double does", "[brdf][kernels][isa]") {
    REQUIRE_FALSE(instruction_sets().empty());
    for (const BrdfInfo* brdf : all_brdfs())
        for (const std::string& isa : instruction_sets())
            DYNAMIC_SECTION(brdf->name << " on " << isa) {
                use_instruction_set(isa);
                Rng rng(33);
                for (const std::size_t count : {1u, 5u, 16u, 250u}) {
                    const SpanCase span(count, rng);
                    const MaterialParams<double> p = random_params(*brdf, rng);
                    const auto f64 = span.run(brdf->illuminate_f64, span.lighting, p);
                    const Lighting<float> lights = narrow(span.lighting);
                    const auto f32 = span.run(brdf->illuminate_f32, lights, to_float(p));
                    const auto simd = span.run(brdf->illuminate_simd, lights, to_float(p));
                    // A cosine is good to 12 u; a power multiplies that by its exponent.
                    const double bound = (20 * brdf->promises.error_u(p) + 200) * 0x1p-24;
                    for (std::size_t i = 0; i < f64.size(); ++i) {
                        REQUIRE(std::isfinite(simd[i]));
                        REQUIRE(std::abs(double(simd[i]) - f64[i]) <= bound * (f64[i] + 0.1));
                        REQUIRE(std::abs(double(f32[i]) - f64[i]) <= bound * (f64[i] + 0.1));
                    }
                }
                use_instruction_set("");
            }
}

TEST_CASE("without a fraction in the exponent every instruction set has the bits of float",
          "[brdf][kernels][isa]") {
    const BrdfInfo* brdf = find_brdf("blinn-phong");
    Material material;
    material.set("shininess", {37});
    const auto params = to_float(resolve_material(material, "", {}).params);
    Rng rng(34);
    const SpanCase span(333, rng);
    const Lighting<float> lights = narrow(span.lighting);
    const auto f32 = span.run(brdf->illuminate_f32, lights, params);
    for (const std::string& isa : instruction_sets()) {
        use_instruction_set(isa);
        CAPTURE(isa);
        CHECK(span.run(brdf->illuminate_simd, lights, params) == f32);
        use_instruction_set("");
    }
}

TEST_CASE("a material's parameters are checked and mapped to other models by their role",
          "[brdf][resolve]") {
    Material material;
    material.set("kd", {0.1, 0.2, 0.3});
    material.set("ks", {0.4});
    const ResolvedMaterial own = resolve_material(material, "", {});
    CHECK(own.brdf->name == "blinn-phong");
    CHECK(own.params.value[0][2] == 0.3);
    CHECK(own.params.ka[1] == 0.2);  // k_a is the diffuse colour unless it is given
    const ResolvedMaterial lambert = resolve_material(material, "lambert", {});
    CHECK(lambert.params.value[0][0] == 0.1);
    CHECK(lambert.mapped.size() == 1);  // ks was left out, and that is said
    CHECK(resolve_material(material, "unlit", {}).unlit);
    CHECK(resolve_material(material, "", {{"ka", {0.5}, "--set ka"}}).params.ka[0] == 0.5);

    const auto code = [&](const std::string& brdf, std::vector<ParamSetting> set) {
        try {
            resolve_material(material, brdf, set);
        } catch (const Error& e) {
            return e.code();
        }
        return Errc{};
    };
    CHECK(code("fong", {}) == Errc::usage);
    CHECK(code("", {{"shinines", {3}, "--set shinines"}}) == Errc::usage);
    CHECK(code("", {{"kd", {1.5}, "--set kd"}}) == Errc::usage);
    CHECK(code("", {{"kd", {0.5, 0.5}, "--set kd"}}) == Errc::usage);
    CHECK(code("", {{"shininess", {1, 2, 3}, "--set shininess"}}) == Errc::usage);
    CHECK(code("", {{"kd", {}, "--set kd", "ggx"}}) == Errc::usage);
    material.brdf = "no-such";
    CHECK(code("", {}) == Errc::scene);
}

TEST_CASE("a choice is a word of its list", "[brdf][resolve]") {
    for (const BrdfInfo* brdf : all_brdfs())
        for (const ParamInfo& param : brdf->params) {
            if (param.kind != ParamKind::choice) continue;
            CAPTURE(brdf->name, param.name);
            const auto index = std::size_t(&param - brdf->params.data());
            Material material;
            material.brdf = brdf->name;
            for (std::size_t i = 0; i < param.names.size(); ++i) {
                material.set_word(param.name, std::string(param.names[i]));
                const auto params = resolve_material(material, "", {}).params;
                CHECK(params.value[index][0] == double(i));
                CHECK(value_text(param, params.value[index][0]) == param.names[i]);
            }
            material.set_word(param.name, std::string(param.names[0]) + "x");
            CHECK_THROWS_WITH(resolve_material(material, "", {}),
                              Catch::Contains("did you mean '" + std::string(param.names[0])));
            material.set(param.name, {1});
            CHECK_THROWS_WITH(resolve_material(material, "", {}), Catch::Contains("takes one of"));
        }
}

TEST_CASE("a shininess becomes a roughness and back, and that is said", "[brdf][resolve]") {
    const auto find = [](const ResolvedMaterial& m, ParamRole role) {
        for (std::size_t i = 0; i < m.brdf->params.size(); ++i)
            if (m.brdf->params[i].role == role) return m.params.value[i][0];
        return -1.0;
    };
    Material shiny;
    shiny.set("shininess", {98});
    const ResolvedMaterial rough = resolve_material(shiny, "torrance-sparrow", {});
    CHECK(find(rough, ParamRole::roughness) == Approx(std::sqrt(0.02)));
    REQUIRE(rough.mapped.size() == 1);
    CHECK(rough.mapped[0] == "shininess 98 became m 0.141421 = √(2/(s + 2))");

    Material facets;
    facets.brdf = "torrance-sparrow";
    facets.set("m", {std::sqrt(0.02)});
    CHECK(find(resolve_material(facets, "phong", {}), ParamRole::exponent) == Approx(98));
    facets.set("m", {1e-4});
    const ResolvedMaterial limited = resolve_material(facets, "phong", {});
    CHECK(find(limited, ParamRole::exponent) == 1e6);
    CHECK(limited.mapped[0].find("limited to its range") != std::string::npos);
}

TEST_CASE("a material that reflects more than arrives is said to", "[brdf][resolve]") {
    Material material;
    material.brdf = "modified-phong";
    material.set("rho_d", {0.8});
    material.set("rho_s", {0.2});
    CHECK(resolve_material(material, "", {}).mapped.empty());
    material.set("rho_s", {0.1, 0.3, 0.1});
    const auto mapped = resolve_material(material, "", {}).mapped;
    REQUIRE(mapped.size() == 1);
    CHECK(mapped[0].find("rho_d + rho_s is 1.1") == 0);
}

// Loops over the registry: a model added tomorrow is tested tomorrow.
#include "scanshade/brdf/brdf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scanshade/base/error.hpp"
#include "scanshade/kernels/isa.hpp"
#include "scanshade/num/target.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

glm::dvec3 direction(Rng& rng, double lowest_cosine) {
    const double z = rng.real(lowest_cosine, 1), phi = rng.real(0, 2 * pi);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Cosines about n = z, in double.
Cosines<double> cosines_of(const glm::dvec3& wi, const glm::dvec3& wo) {
    const glm::dvec3 h = glm::normalize(wi + wo), mirror = {-wi.x, -wi.y, wi.z};
    return {wi.z, wo.z, std::clamp(h.z, 0.0, 1.0), std::clamp(glm::dot(mirror, wo), 0.0, 1.0)};
}

/// Parameters of a model: every fourth time at an end of its range.
MaterialParams<double> random_params(const BrdfInfo& brdf, Rng& rng) {
    Material material;
    material.brdf = brdf.name;
    for (const ParamInfo& param : brdf.params) {
        const double high = param.kind == ParamKind::exponent ? 300 : param.max;
        const auto value = [&] {
            const std::int64_t pick = rng.integer(0, 7);
            const double v = pick == 0 ? param.min : pick == 1 ? high : rng.real(param.min, high);
            return param.kind == ParamKind::exponent && pick % 2 == 0 ? std::floor(v) : v;
        };
        material.set(param.name, param.kind == ParamKind::rgb
                                     ? std::vector<double>{value(), value(), value()}
                                     : std::vector<double>{value()});
    }
    return resolve_material(material, "", {}).params;
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
            CHECK((param.standard >= param.min && param.standard <= param.max));
            CHECK_FALSE(param.meaning.empty());
        }
    }
    CHECK(find_brdf("no-such-model") == nullptr);
}

TEST_CASE("each model keeps the promises of its own row", "[brdf][property]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(31);
            for (int k = 0; k < 3000; ++k) {
                const MaterialParams<double> p = random_params(*brdf, rng);
                const glm::dvec3 wi = direction(rng, 1e-3), wo = direction(rng, 1e-3);
                const Cosines<double> c = cosines_of(wi, wo);
                CAPTURE(k);
                const auto f = brdf->f_cos_f64(c, p);
                const Cosines<float> narrow = {float(c.n_i), float(c.n_o), float(c.n_h),
                                               float(c.r_o)};
                const Cosines<double> same = {double(narrow.n_i), double(narrow.n_o),
                                              double(narrow.n_h), double(narrow.r_o)};
                const auto f32 = brdf->f_cos_f32(narrow, to_float(p));
                const auto f64 = brdf->f_cos_f64(same, p);
                for (std::size_t ch = 0; ch < 3; ++ch) {
                    REQUIRE(std::isfinite(f[ch]));
                    REQUIRE(f[ch] >= 0);
                    // Parameters and exponents' results are rounded to float: two u more.
                    const double bound = (brdf->promises.error_u(p) + 2) * 0x1p-24 * f64[ch];
                    REQUIRE(std::abs(double(f32[ch]) - f64[ch]) <= bound + 1e-37);
                }
                if (!brdf->promises.reciprocal) continue;
                const auto swapped = brdf->f_cos_f64(cosines_of(wo, wi), p);
                for (std::size_t ch = 0; ch < 3; ++ch)
                    REQUIRE(f[ch] / wi.z == Approx(swapped[ch] / wo.z).epsilon(1e-12));
            }
        }
}

TEST_CASE("models that promise it reflect no more than arrives; the others show a witness",
          "[brdf][property]") {
    for (const BrdfInfo* brdf : all_brdfs()) DYNAMIC_SECTION(brdf->name) {
            Rng rng(32);
            double largest = 0;
            for (int k = 0; k < 60; ++k) {
                const MaterialParams<double> p = random_params(*brdf, rng);
                const glm::dvec3 wo = direction(rng, 0.02);
                constexpr int n = 64;
                double albedo = 0;
                for (int i = 0; i < n; ++i)
                    for (int j = 0; j < 2 * n; ++j) {
                        const double theta = (i + 0.5) * pi / 2 / n, phi = (j + 0.5) * pi / n;
                        const glm::dvec3 wi = {std::sin(theta) * std::cos(phi),
                                               std::sin(theta) * std::sin(phi), std::cos(theta)};
                        albedo += brdf->f_cos_f64(cosines_of(wi, wo), p)[0] * std::sin(theta) *
                                  (pi / 2 / n) * (pi / n);
                    }
                largest = std::max(largest, albedo);
            }
            if (brdf->promises.energy == Energy::conserving)
                CHECK(largest <= 1.001);
            else
                CHECK(largest > 1);
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
            const glm::dvec3 n = direction(rng, -0.2);
            for (int c = 0; c < 3; ++c) {
                position[c].push_back(float(rng.real(-1, 1)));
                normal[c].push_back(float(n[c] * 0.9));  // not a unit vector: (C5) makes it one
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
    material.brdf = "no-such";
    CHECK(code("", {}) == Errc::scene);
}

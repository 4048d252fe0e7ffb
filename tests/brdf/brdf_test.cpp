// Loops over the registry: a model added tomorrow is tested tomorrow.
#include "scanshade/brdf/brdf.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/materials.hpp"

using namespace scanshade;

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

namespace {

/// Random points, two point lights, a spot and a directional light.
struct SpanCase {
    std::vector<float> position[3], normal[3], albedo[3];
    static constexpr double untouched = -7;  // in the places behind the padding
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
            out[c].resize(padded(count) + span_padding, T(untouched));
            span.position[c] = in[c].data();
            span.normal[c] = in[3 + c].data();
            span.albedo[c] = in[6 + c].data();
            span.radiance[c] = out[c].data();
        }
        span.count = count;
        illuminate(span, lights, params);
        std::vector<T> all;
        for (const auto& channel : out) {
            all.insert(all.end(), channel.begin(), channel.begin() + long(count));
            CHECK(std::count(channel.begin() + long(padded(count)), channel.end(), T(untouched)) ==
                  long(span_padding));
        }
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
                for (const std::size_t count : {1u, 5u, 16u, 48u, 250u}) {
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

TEST_CASE("every instruction set is finite where parameters and angles are extreme",
          "[brdf][kernels][isa]") {
    for (const BrdfInfo* brdf : all_brdfs())
        for (const std::string& isa : instruction_sets())
            DYNAMIC_SECTION(brdf->name << " on " << isa) {
                use_instruction_set(isa);
                Rng rng(39);
                for (int k = 0; k < 40; ++k) {
                    SpanCase span(64, rng);
                    for (std::size_t i = 0; i < 64; i += 2)  // seen and lit at grazing angles
                        span.normal[2][i] = float(rng.real(-1e-6, 1e-6));
                    const MaterialParams<double> p = params_by(*brdf, [&](const ParamInfo& param) {
                        if (param.kind == ParamKind::choice) return random_value(param, rng);
                        return rng.integer(0, 1) == 0 ? param.min : param.max;
                    });
                    for (const float L :
                         span.run(brdf->illuminate_simd, narrow(span.lighting), to_float(p)))
                        REQUIRE((std::isfinite(L) && L >= 0));
                }
                use_instruction_set("");
            }
}

// Every equation in every type of number. The table is tests/eq/equation_rows.hpp; an equation that
// is added there is tested here.
#define SCANSHADE_SIMD

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "eq/equation_row.hpp"
#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eq/number_types_test.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "eq/equation_calls.hpp"
#include "scanshade/num/dual.hpp"
#include "scanshade/num/interval.hpp"
#include "scanshade/num/lanes.hpp"
#include "scanshade/num/lanes_functions.hpp"
#include "scanshade/num/wide.hpp"

SCANSHADE_TARGET_BEGIN;

/// Arrays of `padding` floats for each input and output.
inline constexpr std::size_t padding = 16;

template <void (*call)(const Lanes*, Lanes*)>
void in_lanes(const EquationInfo& info, const float* in, float* out) {
    for (std::size_t i = 0; i < padding; i += RealTraits<Lanes>::width) {
        Lanes x[max_equation_inputs], y[max_equation_outputs];
        for (int k = 0; k < info.inputs; ++k)
            x[k] = RealTraits<Lanes>::load(in + std::size_t(k) * padding + i);
        call(x, y);
        for (int k = 0; k < info.outputs; ++k)
            RealTraits<Lanes>::store(y[k], out + std::size_t(k) * padding + i);
    }
}

using LanesFn = void (*)(const EquationInfo&, const float*, float*);
inline constexpr LanesFn lanes_calls[] = {
#define EQUATION(name, ...) in_lanes<name##_call<Lanes>>,
#include "eq/equation_rows.hpp"
};

void run_lanes(std::size_t equation, const EquationInfo& info, const float* in, float* out) {
    lanes_calls[equation](info, in, out);
}

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {
namespace {

HWY_EXPORT(run_lanes);

using namespace HWY_NAMESPACE;

struct EquationRow {
    EquationInfo info;
    void (*f32)(const float*, float*);
    void (*f64)(const double*, double*);
    void (*f80)(const long double*, long double*);
    void (*wide)(const Wide*, Wide*);
    void (*interval)(const Interval*, Interval*);
    void (*dual)(const Dual*, Dual*);
};

const EquationRow equations[] = {
#define EQUATION(name, inputs, outputs, error_u, scale, call, ...) \
    {{#name, inputs, outputs, error_u, scale, __VA_ARGS__},        \
     name##_call<float>,                                           \
     name##_call<double>,                                          \
     name##_call<long double>,                                     \
     name##_call<Wide>,                                            \
     name##_call<Interval>,                                        \
     name##_call<Dual>},
#include "eq/equation_rows.hpp"
};

/// Random inputs in range, floats so that every type starts from the same numbers; at times an end
/// of the range.
std::vector<float> random_inputs(const EquationInfo& info, Rng& rng) {
    std::vector<float> x;
    for (int k = 0; k < info.inputs; ++k) {
        const auto [low, high] = info.range[k];
        const std::int64_t pick = rng.integer(0, 15);
        x.push_back(float(pick == 0 ? low : pick == 1 ? high : rng.real(low, high)));
    }
    return x;
}

template <class R>
std::array<R, max_equation_outputs> evaluate(void (*call)(const R*, R*),
                                             const std::vector<float>& in) {
    R x[max_equation_inputs];
    std::array<R, max_equation_outputs> y;
    for (std::size_t k = 0; k < in.size(); ++k) x[k] = R(in[k]);
    call(x, y.data());
    return y;
}

template <class Check>
void for_each_case(std::uint64_t seed, int cases, Check check) {
    for (std::size_t e = 0; e < std::size(equations); ++e) DYNAMIC_SECTION(equations[e].info.name) {
            Rng rng(seed);
            for (int k = 0; k < cases; ++k) {
                const std::vector<float> x = random_inputs(equations[e].info, rng);
                CAPTURE(k, x);
                check(equations[e], e, x);
            }
        }
}

}  // namespace

TEST_CASE("every equation keeps its error bound in float and in double", "[eq][numbers]") {
    for_each_case(41, 400, [](const EquationRow& row, std::size_t, const std::vector<float>& x) {
        const auto f32 = evaluate(row.f32, x);
        const auto f64 = evaluate(row.f64, x);
        const auto f80 = evaluate(row.f80, x);
        for (std::size_t k = 0; k < std::size_t(row.info.outputs); ++k) {
            const double exact = double(f80[k]), size = std::abs(exact) + row.info.scale;
            CAPTURE(k, exact, f32[k]);
            REQUIRE(std::isfinite(exact));
            CHECK(std::abs(double(f32[k]) - exact) <= row.info.error_u * 0x1p-24 * size + 1e-37);
            CHECK(std::abs(double((long double)f64[k] - f80[k])) <=
                  (row.info.error_u + 1) * 0x1p-53 * size + 1e-300);
        }
    });
}

TEST_CASE("every equation in 113 bits agrees with long double to its bound", "[eq][numbers]") {
    for_each_case(45, 200, [](const EquationRow& row, std::size_t, const std::vector<float>& in) {
        const auto f80 = evaluate(row.f80, in);
        Wide x[max_equation_inputs], y[max_equation_outputs];
        for (std::size_t k = 0; k < in.size(); ++k) x[k] = Wide(double(in[k]));
        row.wide(x, y);
        for (std::size_t k = 0; k < std::size_t(row.info.outputs); ++k) {
            const Wide error = y[k] - Wide(Quad(f80[k]));
            const double size = std::abs(double(y[k])) + row.info.scale;
            CAPTURE(k, double(y[k]), double(error));
            CHECK(std::abs(double(error)) <= (row.info.error_u + 1) * 0x1p-64 * size + 1e-300);
        }
    });
}

TEST_CASE("every equation in intervals encloses float and the exact value, closely",
          "[eq][numbers][interval]") {
    for_each_case(42, 400, [](const EquationRow& row, std::size_t, const std::vector<float>& x) {
        const auto enclosure = evaluate(row.interval, x);
        const auto f32 = evaluate(row.f32, x);
        const auto f80 = evaluate(row.f80, x);
        for (std::size_t k = 0; k < std::size_t(row.info.outputs); ++k) {
            const double size = std::abs(double(f80[k])) + row.info.scale;
            CAPTURE(k, f32[k], enclosure[k].low, enclosure[k].high);
            CHECK(enclosure[k].contains(f32[k]));
            CHECK(enclosure[k].contains(f80[k]));
            // Wider than the error, as intervals do not know that numbers depend on each other.
            CHECK(double(enclosure[k].high) - double(enclosure[k].low) <=
                  6 * row.info.error_u * 0x1p-24 * size + 1e-36);
        }
    });
}

TEST_CASE("every equation in duals has double's value and the slope of its neighbours",
          "[eq][numbers][dual]") {
    for_each_case(43, 200, [](const EquationRow& row, std::size_t, const std::vector<float>& in) {
        for (std::size_t variable = 0; variable < in.size(); ++variable) {
            Dual x[max_equation_inputs], y[max_equation_outputs];
            long double before[max_equation_inputs], after[max_equation_inputs];
            constexpr long double h = 1e-7L;
            for (std::size_t k = 0; k < in.size(); ++k) {
                x[k] = Dual(double(in[k]), k == variable ? 1 : 0);
                before[k] = (long double)in[k] - (k == variable ? h : 0);
                after[k] = (long double)in[k] + (k == variable ? h : 0);
            }
            row.dual(x, y);
            long double low[max_equation_outputs], high[max_equation_outputs];
            row.f80(before, low);
            row.f80(after, high);
            const auto f64 = evaluate(row.f64, in);
            const auto f80 = evaluate(row.f80, in);
            for (std::size_t k = 0; k < std::size_t(row.info.outputs); ++k) {
                CAPTURE(variable, k);
                CHECK(y[k].value == f64[k]);
                REQUIRE(std::isfinite(y[k].derivative));
                const double left = double((f80[k] - low[k]) / h);
                const double right = double((high[k] - f80[k]) / h);
                // Outside of its domain, at a kink or where it is steep there is no such slope.
                if (!(std::abs(left - right) <= 1e-4 * (1 + std::abs(left)))) continue;
                CHECK(y[k].derivative == Approx((left + right) / 2).epsilon(1e-4).margin(1e-4));
            }
        }
    });
}

TEST_CASE("every equation in vectors stays in its interval, on every instruction set",
          "[eq][numbers][isa]") {
    for (const std::string& isa : instruction_sets()) {
        use_instruction_set(isa);
        for (std::size_t e = 0; e < std::size(equations); ++e)
            DYNAMIC_SECTION(equations[e].info.name << " on " << isa) {
                const EquationRow& row = equations[e];
                Rng rng(44);
                for (int k = 0; k < 40; ++k) {
                    float in[max_equation_inputs * padding], out[max_equation_outputs * padding];
                    std::vector<std::vector<float>> cases;
                    for (std::size_t i = 0; i < padding; ++i) {
                        cases.push_back(random_inputs(row.info, rng));
                        for (std::size_t v = 0; v < cases[i].size(); ++v)
                            in[v * padding + i] = cases[i][v];
                    }
                    HWY_DYNAMIC_DISPATCH(run_lanes)(e, row.info, in, out);
                    for (std::size_t i = 0; i < padding; ++i) {
                        const auto enclosure = evaluate(row.interval, cases[i]);
                        for (std::size_t y = 0; y < std::size_t(row.info.outputs); ++y) {
                            CAPTURE(k, cases[i], y, out[y * padding + i], enclosure[y].low,
                                    enclosure[y].high);
                            CHECK(enclosure[y].contains(out[y * padding + i]));
                        }
                    }
                }
            }
        use_instruction_set("");
    }
}

}  // namespace scanshade
#endif

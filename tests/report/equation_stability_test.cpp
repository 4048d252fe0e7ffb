// The equations' part of the stability report: every mark of the formula sheet has its sweep, and
// errors are counted as they are.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "report/sweep_errors.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/report/equation_stability.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

const EquationStability& measured() {
    static const EquationStability result = measure_equation_stability({});
    return result;
}

/// Numbers of docs/equations.md whose note has the word.
std::set<std::string> marked(const std::string& word) {
    std::ifstream file("docs/equations.md");
    std::set<std::string> numbers;
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("| ") && line.find(word) != std::string::npos)
            numbers.insert(line.substr(2, line.find(' ', 2) - 2));
    return numbers;
}

bool has_sweep(const std::string& number, bool misprint) {
    const auto& sweeps = measured().equations;
    return std::any_of(sweeps.begin(), sweeps.end(), [&](const SweepResult& sweep) {
        return sweep.number == number && (sweep.misprint || !misprint);
    });
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

}  // namespace

TEST_CASE("every equation with a mark is measured, and every misprint fails", "[stability][eq]") {
    const std::set<std::string> care = marked("Care: "), corrected = marked("Corrected: ");
    REQUIRE(care.size() > 15);
    REQUIRE(corrected.size() > 7);
    for (const std::string& number : care) {
        CAPTURE(number);
        CHECK(has_sweep(number, false));
    }
    for (const std::string& number : corrected) {
        CAPTURE(number);
        CHECK(has_sweep(number, true));
    }
}

TEST_CASE("a misprint is wrong by more than arithmetic could be, our form is not",
          "[stability][eq]") {
    for (const SweepResult& sweep : measured().equations) {
        CAPTURE(sweep.number, sweep.title);
        CHECK(sweep.kept());
        if (!sweep.misprint) continue;
        CHECK(sweep.printed_f64->worst_ulp > 0.01 * 0x1p52);  // 1 % in double
        CHECK(sweep.ours_f64.worst_ulp < 20);
    }
}

TEST_CASE("all bounds are kept, and none is so wide that it says nothing", "[stability][eq]") {
    CHECK(measured().faults().empty());
    for (const auto* part : {&measured().equations, &measured().models})
        for (const SweepResult& sweep : *part) {
            CAPTURE(sweep.number, sweep.title);
            REQUIRE(sweep.bound.size() == sweep.x.size());
            REQUIRE(sweep.ours_f32.ulp.size() == sweep.x.size());
            // At the tame end of a sweep some digits are always left.
            CHECK(*std::min_element(sweep.bound.begin(), sweep.bound.end()) < 2000);
            CHECK(sweep.ours_f32.nan + sweep.ours_f32.inf == 0);
            CHECK(sweep.ours_f64.nan + sweep.ours_f64.inf == 0);
        }
}

TEST_CASE("the printed forms fail where the page says so", "[stability][eq]") {
    std::size_t nan = 0, inf = 0, fail = 0;
    for (const SweepResult& sweep : measured().equations) {
        nan += sweep.printed_f32->nan;
        inf += sweep.printed_f32->inf;
        fail += sweep.printed_fails();
        if (sweep.title == "GGX at θ_h = m") {
            // Each tenth of the roughness costs two digits, until there are none.
            CHECK(sweep.printed_f64->worst_ulp > 1e11);
            CHECK(sweep.printed_f32->inf > 80);
            CHECK(sweep.ours_f64.worst_ulp < 8);
        }
        if (sweep.number == "B12") {
            // Not everything printed is bad: an exact power of a rounded cosine is as wrong.
            CHECK(!sweep.printed_fails());
            CHECK(sweep.ours_f32.worst_ulp < 4 * sweep.printed_f32->worst_ulp);
            CHECK(sweep.x.front() == 0);
            CHECK(sweep.x.back() == 1e6);
        }
    }
    CHECK(nan > 300);
    CHECK(inf > 100);
    CHECK(fail > 30);
    CHECK(fail < measured().equations.size());
}

TEST_CASE("every model and every choice of it is measured along its whole range",
          "[stability][brdf]") {
    for (const BrdfInfo* brdf : all_brdfs()) {
        CAPTURE(brdf->name);
        std::size_t expected = 3;  // light, viewer, both
        const ParamInfo* roughness = nullptr;
        for (const ParamInfo& param : brdf->params)
            if (param.role == ParamRole::exponent || param.role == ParamRole::roughness)
                roughness = &param;
        if (roughness) ++expected;
        std::size_t variants = 1;
        for (const ParamInfo& param : brdf->params)
            if (!param.names.empty()) variants += param.names.size() - 1;
        std::size_t found = 0;
        for (const SweepResult& sweep : measured().models) {
            if (sweep.number != brdf->name) continue;
            ++found;
            CHECK(sweep.printed_f32.has_value());
            if (roughness && sweep.variable == roughness->symbol) {
                CHECK(sweep.x.front() == double(float(roughness->min)));
                CHECK(sweep.x.back() == double(float(roughness->max)));
            }
        }
        CHECK(found == expected * variants);
    }
}

TEST_CASE("the error is counted in neighbours of the exact result", "[stability]") {
    const Precision f32 = precision_of<float>();
    const auto errors_of = [&](double value, double exact, double bound, bool may_be_zero = false) {
        SweepErrors errors;
        const Component component{value, value - exact, exact};
        add_error({&component, 1}, f32, 7, bound, may_be_zero, errors);
        return errors;
    };
    CHECK(errors_of(1 + 0x1p-23, 1, 1).worst_ulp == 1);
    CHECK(errors_of(1 + 0x1p-23, 1, 1).worst_at == 7);
    CHECK(errors_of(1 + 0x1p-23, 1, 1).over == 0);
    CHECK(errors_of(1 + 0x1p-22, 1, 1).over == 1);
    CHECK(errors_of(2 + 0x1p-23, 2, 1).worst_ulp == 0.5);  // neighbours of 2 are farther apart
    CHECK(errors_of(0x1p-149, 0, 1).worst_ulp == 1);       // and do not get closer below 2^-126
    CHECK(errors_of(0, 1, 1).over == 1);
    CHECK(errors_of(0, 1, 1, true).over == 0);
    CHECK(errors_of(0, 1, 1, true).zero == 1);
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
    CHECK(errors_of(nan, 1, 1).nan == 1);
    CHECK(errors_of(nan, 1, inf).over == 1);  // no bound allows what is no number
    CHECK(errors_of(inf, 1, inf).inf == 1);
    CHECK(errors_of(inf, 1, inf).over == 1);
    CHECK(errors_of(3, nan, 0).over == 0);  // without an exact result any number will do
    CHECK(errors_of(nan, nan, 0).over == 1);
}

TEST_CASE("a vector's error is its length, not that of its worst component", "[stability]") {
    SweepErrors errors;
    const Component parts[] = {{0.6, 0, 0.6}, {0.8, 0, 0.8}, {0x1p-24, 0x1p-24, 0}};
    add_error(parts, precision_of<float>(), 1, 1, false, errors);
    CHECK(errors.worst_ulp == Approx(1).epsilon(0.51));
    CHECK(errors.worst_ulp >= 0.5);
}

TEST_CASE("a broken bound is a fault with its equation, type and place", "[stability]") {
    EquationStability stability;
    SweepResult sweep{};
    sweep.number = "C3";
    sweep.title = "an edge";
    sweep.variable = "height";
    sweep.x = {1, 2};
    sweep.bound = {1, 1};
    sweep.ours_f32.over = 1;
    sweep.ours_f32.worst_ulp = 12;
    sweep.ours_f32.worst_at = 2;
    stability.equations.push_back(sweep);
    REQUIRE(stability.faults().size() == 1);
    CHECK(stability.faults()[0] ==
          "C3 an edge: 1 of 2 results in float break their bound; the largest error is 12 ulp at "
          "height = 2, and 0 are no finite numbers");
}

TEST_CASE("measuring twice gives the same numbers, and stops when it is told to", "[stability]") {
    const auto rows = [](const EquationStability& s) { return equation_scenes_json(s).dump(); };
    CHECK(rows(measure_equation_stability({})) == rows(measured()));
    Watch watch;
    std::size_t told = 0;
    watch.tell = [&](const std::string&, std::size_t done, std::size_t all) {
        CHECK(done < all);
        ++told;
    };
    watch.stopped = [&] { return told == 3; };
    const EquationStability some = measure_equation_stability(watch);
    CHECK(some.partial);
    CHECK(some.equations.size() == 3);
    CHECK(some.models.empty());
    CHECK(!measured().partial);
}

TEST_CASE("an equation is as ill-conditioned as its derivative says", "[stability]") {
    for (const SweepResult& sweep : measured().equations) {
        if (sweep.title == "the same picture at any scale") CHECK(sweep.condition == Approx(1));
        if (sweep.title == "attenuation 1/(1 + q d²), q = 2⁻³³")
            CHECK(sweep.condition == Approx(2).epsilon(1e-4));  // the inverse square
    }
    // A power magnifies the error of its cosine by the exponent.
    for (const SweepResult& sweep : measured().models)
        if (sweep.number == "modified-phong" && sweep.title == "side of the highlight")
            CHECK(sweep.condition == Approx(1e6).epsilon(0.01));
    CHECK(largest(measured().equations.front().bound) == 6);
}

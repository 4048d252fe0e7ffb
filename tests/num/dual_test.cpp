#include "scanshade/num/dual.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// f at x, with the derivative.
template <class F>
Dual at(double x, F f) {
    return f(Dual(x, 1));
}

}  // namespace

TEST_CASE("derivatives of operations and functions by hand", "[num][dual]") {
    const double x = 0.6;
    CHECK(at(x, [](Dual d) { return d * d * d; }).derivative == Approx(3 * x * x));
    CHECK(at(x, [](Dual d) { return Dual(1) / d; }).derivative == Approx(-1 / (x * x)));
    CHECK(at(x, [](Dual d) { return Dual(2) - d; }).derivative == -1);
    CHECK(at(x, [](Dual d) { return sqrt(d); }).derivative == Approx(0.5 / std::sqrt(x)));
    CHECK(at(x, [](Dual d) { return mul_add(d, d, Dual(1)); }).derivative == Approx(2 * x));
    CHECK(at(x, [](Dual d) { return reciprocal(d); }).derivative == Approx(-1 / (x * x)));
    CHECK(at(x, [](Dual d) { return inverse_sqrt(d); }).derivative ==
          Approx(-0.5 / (x * std::sqrt(x))));
    CHECK(at(x, [](Dual d) { return exp(d + d); }).derivative == Approx(2 * std::exp(2 * x)));
    CHECK(at(x, [](Dual d) { return log(d); }).derivative == Approx(1 / x));
    CHECK(at(x, [](Dual d) { return log1p(d); }).derivative == Approx(1 / (1 + x)));
    CHECK(at(x, [](Dual d) { return sin(d); }).derivative == Approx(std::cos(x)));
    CHECK(at(x, [](Dual d) { return cos(d); }).derivative == Approx(-std::sin(x)));
    CHECK(at(x, [](Dual d) { return asin(d); }).derivative == Approx(1 / std::sqrt(1 - x * x)));
    CHECK(at(x, [](Dual d) { return acos(d); }).derivative == Approx(-1 / std::sqrt(1 - x * x)));
    CHECK(at(x, [](Dual d) { return atan2(d, Dual(1)); }).derivative == Approx(1 / (1 + x * x)));
    CHECK(at(-x, [](Dual d) { return abs(d); }).derivative == -1);
    CHECK(at(x, [](Dual d) { return max(d, Dual(0.5)); }).derivative == 1);
    CHECK(at(x, [](Dual d) { return min(d, Dual(0.5)); }).derivative == 0);
    CHECK(at(x, [](Dual d) { return select(d > Dual(0), d, Dual(0)); }).derivative == 1);
}

TEST_CASE("where a slope is infinite it is large, and 0 times it is 0", "[num][dual]") {
    const Dual root = sqrt(Dual(0.0, 1));
    CHECK(root.value == 0);
    CHECK(root.derivative == steepest);
    CHECK(sqrt(Dual(0.0, 0)).derivative == 0);
    CHECK((root * root).derivative == 0);
    CHECK(acos(Dual(1.0, 1)).derivative == -steepest);
    CHECK(acos(Dual(1.0, 0)).derivative == 0);
    CHECK(asin(Dual(-1.0, 1)).derivative == steepest);
    CHECK(acos(Dual(0.0, 1)).derivative == -1);
    CHECK(atan2(Dual(0.0, 1), Dual(0.0, 1)).derivative == 0);
}

TEST_CASE("the condition number tells how a relative error grows", "[num][dual]") {
    // A power of n magnifies by n; a difference of near numbers by much.
    CHECK(condition_number(0.9, plain(at(0.9, [](Dual d) { return d * d * d; }))) == Approx(3));
    CHECK(condition_number(1.001, plain(at(1.001, [](Dual d) { return d - Dual(1); }))) ==
          Approx(1001));
    CHECK(condition_number(2, {0, 0}) == 0);
}

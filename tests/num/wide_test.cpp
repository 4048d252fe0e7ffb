#include "scanshade/num/wide.hpp"

#include "support/catch.hpp"

using namespace scanshade;

namespace {

double relative(const Wide& value, const Wide& exact) { return double((value - exact) / exact); }
constexpr double few_ulp = 0x1p-110;

}  // namespace

TEST_CASE("wide numbers have 113 bits", "[num]") {
    const Wide one(1), ulp = Wide(0x1p-112);
    CHECK(one + ulp > one);
    CHECK(!(one + ulp * Wide(0.25) > one));
    CHECK(relative(wide_pi() * inv_pi_as<Wide>(), one) == Approx(0).margin(few_ulp));
    // π as a double and the next 53 bits of it.
    CHECK(double(wide_pi() - Wide(pi)) == Approx(1.2246467991473532e-16).epsilon(1e-14));
}

TEST_CASE("functions of wide numbers are exact to their last bits", "[num]") {
    for (const double at : {0.03, 0.4, 0.9}) {
        CAPTURE(at);
        const Wide x(at), s = sin(x), c = cos(x);
        CHECK(relative(s * s + c * c, Wide(1)) == Approx(0).margin(few_ulp));
        CHECK(relative(atan2(s, c), x) == Approx(0).margin(few_ulp));
        CHECK(relative(asin(s), x) == Approx(0).margin(few_ulp));
        CHECK(relative(acos(x) + asin(x), wide_pi() * Wide(0.5)) == Approx(0).margin(few_ulp));
        CHECK(relative(exp(log(x)), x) == Approx(0).margin(few_ulp));
        CHECK(relative(log1p(x), log(Wide(1) + x)) == Approx(0).margin(few_ulp));
        CHECK(relative(sqrt(x) * sqrt(x), x) == Approx(0).margin(few_ulp));
        CHECK(relative(pow(x, Wide(3)), x * x * x) == Approx(0).margin(few_ulp));
        CHECK(relative(inverse_sqrt(x) * sqrt(x), Wide(1)) == Approx(0).margin(few_ulp));
    }
    CHECK(max(Wide(1), Wide(2)) > Wide(1.5));
    CHECK(min(Wide(1), Wide(2)) < Wide(1.5));
    CHECK(abs(Wide(-2)) > Wide(1.5));
}

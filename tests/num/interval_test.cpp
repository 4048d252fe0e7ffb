// Soundness (the exact result is inside) and use (the ends are near) of interval arithmetic.
#include "scanshade/num/interval.hpp"

#include <cmath>
#include <cstring>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

/// Any finite float, of any exponent and sign.
float any_float(Rng& rng) {
    while (true) {
        const auto bits = static_cast<std::uint32_t>(rng.bits());
        float x;
        std::memcpy(&x, &bits, sizeof x);
        if (std::isfinite(x)) return x;
    }
}

float near_one(Rng& rng) {
    return float(rng.real(0.5, 2)) * (rng.integer(0, 1) == 0 ? 1.0f : -1.0f);
}

/// Some reals of an interval: its ends, its middle and others between.
template <class Use>
void for_members(const Interval& x, Rng& rng, Use use) {
    use((long double)x.low);
    use((long double)x.high);
    for (int k = 0; k < 4; ++k)
        use((long double)x.low +
            ((long double)x.high - (long double)x.low) * (long double)rng.real(0, 1));
}

}  // namespace

TEST_CASE("one operation on floats is enclosed by neighbours, and exact ones by a point",
          "[num][interval]") {
    Rng rng(91);
    for (int k = 0; k < 20000; ++k) {
        const bool wild = k % 2 == 0;
        const float a = wild ? any_float(rng) : near_one(rng);
        const float b = wild ? any_float(rng) : near_one(rng);
        CAPTURE(k, a, b);
        const auto check = [](const Interval& x, long double exact, float rounded) {
            REQUIRE(x.contains(exact));
            REQUIRE((x.low <= rounded && rounded <= x.high));
            // No float lies strictly between the ends.
            REQUIRE(std::nextafter(x.low, interval_infinity) >= x.high);
            if ((long double)rounded == exact) REQUIRE(x.low == x.high);
        };
        const long double wide_a = (long double)a, wide_b = (long double)b;
        check(Interval(a) * Interval(b), wide_a * wide_b, a * b);
        if (b != 0) check(Interval(a) / Interval(b), wide_a / wide_b, a / b);
        check(sqrt(Interval(std::abs(a))), std::sqrt(std::abs(wide_a)), std::sqrt(std::abs(a)));
        const int exponents = std::abs(std::ilogb(a) - std::ilogb(b));
        if (a == 0 || b == 0 || exponents < 38)  // the sum fits a long double
            check(Interval(a) + Interval(b), wide_a + wide_b, a + b);
    }
    // A sum whose rest is far below a double's last place.
    const Interval sum = Interval(1.0f) + Interval(1e-30f);
    CHECK((sum.low == 1 && sum.high == std::nextafter(1.0f, 2.0f)));
    const Interval less = Interval(1.0f) - Interval(1e-30f);
    CHECK((less.low < 1 && less.high == 1));
}

TEST_CASE("operations on wide intervals enclose those on their members", "[num][interval]") {
    Rng rng(92);
    for (int k = 0; k < 3000; ++k) {
        const auto random = [&] {
            const float a = near_one(rng), b = near_one(rng);
            return Interval{std::min(a, b), std::max(a, b)};
        };
        const Interval a = random(), b = random();
        const Interval positive = abs(a) + Interval(0.001f);
        for_members(a, rng, [&](long double x) {
            for_members(b, rng, [&](long double y) {
                REQUIRE((a + b).contains(x + y));
                REQUIRE((a - b).contains(x - y));
                REQUIRE((a * b).contains(x * y));
                if (y != 0) REQUIRE((a / b).contains(x / y));
                REQUIRE(mul_add(a, b, a).contains(x * y + x));
                REQUIRE(min(a, b).contains(std::min(x, y)));
                REQUIRE(max(a, b).contains(std::max(x, y)));
                REQUIRE(atan2(a, b).contains(std::atan2(x, y)));
            });
            REQUIRE(abs(a).contains(std::abs(x)));
            REQUIRE(exp(a).contains(std::exp(x)));
            REQUIRE(sin(a * Interval(4.0f)).contains(std::sin(4 * x)));
            REQUIRE(cos(a * Interval(4.0f)).contains(std::cos(4 * x)));
            REQUIRE(asin(a * Interval(0.5f)).contains(std::asin(x / 2)));
            REQUIRE(acos(a * Interval(0.5f)).contains(std::acos(x / 2)));
            REQUIRE(log1p(a * Interval(0.25f)).contains(std::log1p(x / 4)));
        });
        for_members(positive, rng, [&](long double x) {
            REQUIRE(log(positive).contains(std::log(x)));
            REQUIRE(sqrt(positive).contains(std::sqrt(x)));
            REQUIRE(inverse_sqrt(positive).contains(1 / std::sqrt(x)));
            REQUIRE(reciprocal(positive).contains(1 / x));
        });
    }
}

TEST_CASE("functions of a point are as close as their documented error", "[num][interval]") {
    Rng rng(93);
    for (int k = 0; k < 2000; ++k) {
        const Interval x(float(rng.real(0.1, 0.9)));
        const auto width_ulps = [](const Interval& y) {
            return double(y.high - y.low) / (0x1p-23 * std::abs(double(y.high)));
        };
        CHECK(width_ulps(exp(x)) <= 2 * exp_ulps + 2);
        CHECK(width_ulps(inverse_sqrt(x)) <= 2 * estimate_ulps + 2);
        CHECK(width_ulps(reciprocal(x)) <= 2 * estimate_ulps + 2);
        CHECK(width_ulps(log(x)) <= 2 * log_ulps + 2);
        CHECK(width_ulps(log1p(x)) <= 2 * log1p_ulps + 2);
        CHECK(width_ulps(sin(x)) <= 2 * sine_ulps + 2);
        CHECK(width_ulps(asin(x)) <= 2 * arc_ulps + 2);
        CHECK(width_ulps(acos(x)) <= 2 * arc_ulps + 2);
        CHECK(width_ulps(atan2(x, Interval(1.0f))) <= 2 * atan2_ulps + 2);
    }
}

TEST_CASE("a select that is undecided returns the hull of both", "[num][interval]") {
    const Interval one(1), two(2), three(3), wide{0.5f, 2.5f};
    CHECK(select(one > two, one, three).low == 3);
    CHECK(select(two > one, one, three).high == 1);
    const Interval both = select(wide > two, one, three);
    CHECK((both.low == 1 && both.high == 3));
    const IntervalMask unsure = wide < two, sure = one < two;
    CHECK((mask_and(unsure, sure).may_hold && mask_and(unsure, sure).may_fail));
    CHECK_FALSE(mask_and(two < one, unsure).may_hold);
    // Touching ends: 2 > 2 fails for sure, 2 < 3 holds.
    CHECK_FALSE((two > two).may_hold);
}

TEST_CASE("divisors that may be 0 open the result, and nothing becomes a NaN", "[num][interval]") {
    const Interval zero(0), one(1), around{-1, 1}, upper{0, 2};
    CHECK((one / upper).low == 0.5f);
    CHECK((one / upper).high == interval_infinity);
    CHECK((one / around).low == -interval_infinity);
    CHECK((one / zero).high == interval_infinity);
    const Interval product = zero * (one / upper);
    CHECK((product.low == 0 && product.high == 0));
    CHECK((one / (one / upper)).low == 0);
    CHECK(sqrt(around).low == 0);
    CHECK((reciprocal(zero).low <= 0x1p100f && reciprocal(zero).high == interval_infinity));
    CHECK(inverse_sqrt(upper).high == interval_infinity);
    CHECK(log(upper).low == -interval_infinity);
    const Interval jump = atan2(around, Interval{-2, -1});
    CHECK((jump.contains(3.14159L) && jump.contains(-3.14159L)));
    CHECK(Interval(pi).contains(3.14159265358979323846264338327950288L));
}

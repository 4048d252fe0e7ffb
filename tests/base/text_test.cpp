#include "scanshade/base/text.hpp"

#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("numbers must fill their text and be finite", "[base]") {
    CHECK(parse_real("1.5") == 1.5);
    CHECK(parse_real("+2") == 2.0);
    CHECK(parse_real("-1e-3") == -1e-3);
    for (const char* text : {"", "+", "+-1", "1.5x", " 1", "nan", "inf", "1e999", "1,5"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_real(text).has_value());
    }
    CHECK(parse_integer("42") == 42);
    CHECK_FALSE(parse_integer("4.2").has_value());
    CHECK_FALSE(parse_integer("99999999999999999999").has_value());
}

TEST_CASE("a slip of the hand finds the name that was meant", "[base]") {
    const std::string_view names[] = {"shininess", "kd", "ks"};
    CHECK(nearest_name("shinyness", names) == "shininess");
    CHECK(nearest_name("kD", names) == "kd");
    CHECK(nearest_name("roughness", names).empty());
    CHECK(suggestion("shinines", names) == ", did you mean 'shininess'?");
    CHECK(suggestion("roughness", names) == "; known are shininess, kd, ks");
    CHECK(nearest_name(std::string(1'000'000, 'x'), names).empty());
}

TEST_CASE("split keeps empty parts", "[base]") {
    CHECK(split("a,,b", ',').size() == 3);
    CHECK(split("", ',').size() == 1);
    CHECK(split("1:2:", ':').back().empty());
}

TEST_CASE("long texts lose their middle, and no part of a character", "[text]") {
    CHECK(shortened("short") == "short");
    CHECK(shortened(std::string(1000, 'x')).size() == 1000);
    const std::string cut = shortened("begin" + std::string(1 << 20, 'x') + "end");
    CHECK(cut.size() < 1010);
    CHECK(cut.starts_with("begin"));
    CHECK(cut.ends_with("end"));
    std::string text;
    for (int i = 0; i < 500; ++i) text += "∫";
    for (std::size_t most = 4; most < 40; ++most) {
        const std::string few = shortened(text, most);
        CAPTURE(most, few);
        CHECK((few.size() - std::string(" … ").size()) % 3 == 0);
    }
}

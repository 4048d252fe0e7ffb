#include <fmt/format.h>

#include <set>

#include "scanshade/base/error.hpp"
#include "scanshade/scene/settings.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

Settings with(std::string_view option, std::string_view value) {
    Settings settings;
    const OptionInfo* info = find_option(option);
    REQUIRE(info != nullptr);
    info->apply(settings, value);
    return settings;
}

std::string refusal(std::string_view option, std::string_view value) {
    try {
        with(option, value);
    } catch (const Error& error) {
        CHECK(error.code() == Errc::usage);
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST_CASE("the table of options has each name once, with a form and a meaning", "[options]") {
    std::set<std::string_view> names;
    for (const OptionInfo& info : shared_options()) {
        CAPTURE(info.name);
        CHECK(names.insert(info.name).second);
        CHECK_FALSE(info.meaning.empty());
        CHECK(info.values.empty() == info.is_flag);
        CHECK(find_option(info.name) == &info);
    }
    CHECK(find_option("shadin") == nullptr);
}

TEST_CASE("each option stores its value", "[options]") {
    CHECK(with("resolution", "16384,1").width == 16384);
    CHECK(with("resolution", "640,480").height == 480);
    CHECK(with("shading", "gouraud").shading == Shading::gouraud);
    CHECK(with("brdf", "lambert").brdf == "lambert");
    CHECK(with("interpolation", "patch").interpolation == Interpolation::patch);
    CHECK(with("renderer", "scalar-f64").renderer == RendererKind::scalar_f64);
    CHECK(with("samples", "1024").samples == 1024);
    CHECK(with("transfer", "linear").transfer == Transfer::linear);
    CHECK(with("power", "exp-log").power == PowerForm::exp_log);
    CHECK(with("exposure", "-1.5").exposure_ev == -1.5);
    CHECK(with("background", "0,1,2.5").background == glm::dvec3(0, 1, 2.5));
    CHECK(with("camera-position", "1,-2,3").camera_position == glm::dvec3(1, -2, 3));
    CHECK(with("camera-focal-point", "1,2,3").camera_focal_point == glm::dvec3(1, 2, 3));
    CHECK(with("camera-view-up", "0,0,1").camera_view_up == glm::dvec3(0, 0, 1));
    CHECK(with("camera-view-angle", "45").camera_view_angle_deg == 45);
    CHECK(with("projection", "orthographic").projection == Projection::orthographic);
    CHECK(with("light", "directional:0,-1,0").lights.size() == 1);
    CHECK(with("normals", "file").normals.source == NormalSource::automatic);
    CHECK(with("normals", "angle").normals.source == NormalSource::angle);
    CHECK(with("crease", "180").normals.crease_deg == 180);
    CHECK(with("cull", "back").cull == Cull::back);
    CHECK(with("mtl-ambient", "true").mtl_ambient);
    CHECK_FALSE(with("mtl-ambient", "false").mtl_ambient);
    CHECK(with("up", "z").up == UpAxis::z);
    const Settings set = with("set", "kd=0.1,0.2,0.3");
    REQUIRE(set.set.size() == 1);
    CHECK(set.set[0].name == "kd");
    CHECK(set.set[0].values == std::vector<double>{0.1, 0.2, 0.3});
    CHECK(set.set[0].place == "--set kd");
    const Settings word = with("set", "shadowing=v-cavity");
    CHECK(word.set[0].word == "v-cavity");
    CHECK(word.set[0].values.empty());
}

TEST_CASE("a refused value names the option, the value and what would be right", "[options]") {
    struct Case {
        std::string_view option, value, right;
    };
    const Case cases[] = {
        {"resolution", "0,10", "16384"},
        {"resolution", "16385,10", "16384"},
        {"resolution", "640", "width,height"},
        {"resolution", "640,480,3", "width,height"},
        {"resolution", "640.5,480", "width,height"},
        {"resolution", "99999999999999999999,1", "16384"},
        {"shading", "gourad", "did you mean 'gouraud'"},
        {"shading", "", "flat, gouraud, phong"},
        {"interpolation", "edge", "did you mean 'edges'"},
        {"renderer", "double", "scalar-f64"},
        {"set", "kd", "NAME=V"},
        {"set", "=1", "NAME=V"},
        {"set", "kd=", "NAME=V"},
        {"set", "kd=1,2", "NAME=V"},
        {"set", "kd=1,2,3,4", "NAME=V"},
        {"set", "kd=0x", "NAME=V"},
        {"set", "distribution=ggx,blinn", "NAME=WORD"},
        {"set", "distribution=-ggx", "NAME=WORD"},
        {"samples", "5", "--samples takes a square number from 1 to 1024"},
        {"samples", "0", "square"},
        {"samples", "-4", "square"},
        {"samples", "1089", "1024"},
        {"samples", "4x", "square"},
        {"transfer", "rgb", "did you mean 'srgb'"},
        {"power", "squarring", "did you mean 'squaring'"},
        {"exposure", "101", "-100 to 100"},
        {"exposure", "inf", "-100 to 100"},
        {"background", "1,1", "three numbers"},
        {"background", "-1,0,0", "from 0"},
        {"background", "1e300,0,0", "1e30"},
        {"camera-position", "1,2", "three numbers"},
        {"camera-position", "1e300,0,0", "1e100"},
        {"camera-focal-point", "nan,0,0", "three numbers"},
        {"camera-view-up", "up", "three numbers"},
        {"camera-view-angle", "0", "0.001"},
        {"camera-view-angle", "180", "179.9"},
        {"projection", "ortho", "orthographic"},
        {"normals", "automatic", "file"},
        {"crease", "181", "0 to 180"},
        {"crease", "-1", "0 to 180"},
        {"cull", "front", "none"},
        {"mtl-ambient", "yes", "true"},
        {"up", "x", "y"},
    };
    for (const Case& row : cases) {
        CAPTURE(row.option, row.value);
        const std::string sentence = refusal(row.option, row.value);
        CAPTURE(sentence);
        CHECK(sentence.starts_with(fmt::format("--{} ", row.option)));
        CHECK(sentence.find(row.right) != std::string::npos);
        CHECK(sentence.find(fmt::format("'{}'", row.value)) != std::string::npos);
    }
}

TEST_CASE("a refused resolution leaves the old one alone", "[options]") {
    Settings settings;
    CHECK_THROWS_AS(find_option("resolution")->apply(settings, "7,0"), Error);
    CHECK(settings.width == 960);
}

TEST_CASE("lights are read in each of their forms", "[options][light]") {
    const Light point = parse_light("point:1,2,3:4,5,6:7,8,9");
    CHECK(point.kind == LightKind::point);
    CHECK(point.position == glm::dvec3(1, 2, 3));
    CHECK(point.intensity == glm::dvec3(4, 5, 6));
    CHECK(point.attenuation == glm::dvec3(7, 8, 9));

    const Light plain = parse_light("point:1,2,3");
    CHECK(plain.intensity == glm::dvec3(1));
    CHECK(plain.attenuation == glm::dvec3(1, 0, 0));

    const Light sun = parse_light("directional:0,-2,0:0.5,0.5,0.4");
    CHECK(sun.kind == LightKind::directional);
    CHECK(sun.direction == glm::dvec3(0, -2, 0));
    CHECK(sun.intensity == glm::dvec3(0.5, 0.5, 0.4));

    const Light spot = parse_light("spot:1,2,3:0,-1,0:25:4,5,6:0,0,1");
    CHECK(spot.kind == LightKind::spot);
    CHECK(spot.direction == glm::dvec3(0, -1, 0));
    CHECK(spot.cutoff_deg == 25);
    CHECK(spot.attenuation == glm::dvec3(0, 0, 1));

    const Light cosine = parse_light("cosine:1,2,3:0,-1,0:4,5,6:1,0,1");
    CHECK(cosine.kind == LightKind::cosine);
    CHECK(cosine.position == glm::dvec3(1, 2, 3));
    CHECK(cosine.attenuation == glm::dvec3(1, 0, 1));
}

TEST_CASE("a light that is not right is refused with its form", "[options][light]") {
    for (const char* text : {"point",
                             "point:",
                             "point:1,2",
                             "point:1,2,3,4",
                             "point:1,2,x",
                             "point:1,2,3:",
                             "point:1,2,3:1,1",
                             "point:1,2,3:-1,0,0",
                             "point:1,2,3:1e31,0,0",
                             "point:1,2,3:1,1,1:0,0,0",
                             "point:1,2,3:1,1,1:-1,0,2",
                             "point:1,2,3:1,1,1:1,0,0:9",
                             "point:1e101,0,0",
                             "point:inf,0,0",
                             "directional:0,0,0",
                             "directional:0,1,0:1,1,1:1,0,0",
                             "spot:1,2,3:0,1,0",
                             "spot:1,2,3:0,0,0:30",
                             "spot:1,2,3:0,1,0:0",
                             "spot:1,2,3:0,1,0:181",
                             "spot:1,2,3:0,1,0:30,30",
                             "cosine:1,2,3",
                             "cosine:1,2,3:0,0,0"}) {
        const std::string_view whole = text;
        const std::string name(whole.substr(0, whole.find(':')));
        const std::string sentence = refusal("light", text);
        CAPTURE(text, sentence);
        CHECK(sentence.starts_with(fmt::format("--light '{}' has no proper ", text)));
        CHECK(sentence.find("write it as " + name + ":") != std::string::npos);
    }
    CHECK(refusal("light", "pont:1,2,3").find("did you mean 'point'") != std::string::npos);
    CHECK(refusal("light", "").find("directional") != std::string::npos);
}

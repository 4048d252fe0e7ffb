#include "report/brdf_page.hpp"

#include <cmath>
#include <string>

#include "report/brdf_values.hpp"
#include "report/svg_plot.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/report/page.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

std::size_t count(const std::string& text, std::string_view part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
    return n;
}

}  // namespace

TEST_CASE("each model's page has its equation, parameters, plots and spheres", "[report]") {
    for (const BrdfInfo* brdf : all_brdfs()) {
        CAPTURE(brdf->name);
        const std::string page = brdf_page(*brdf, {});
        CHECK(page.find(escaped(brdf->equation)) != std::string::npos);
        for (const ParamInfo& p : brdf->params)
            CHECK(page.find(escaped(p.meaning)) != std::string::npos);
        CHECK(count(page, "<svg") == 2);
        CHECK(count(page, "<polyline") == 6);  // four lobes, the albedo and its limit
        CHECK(count(page, "data:image/png;base64,iVBOR") == 6);
        CHECK(count(page, "http") == 2);  // the name space of SVG, and no file from elsewhere
        CHECK(page.find("nan") == std::string::npos);
        CHECK(page.find("inf") == std::string::npos);
    }
    CHECK_THROWS_AS(brdf_page(*all_brdfs().front(), {{"no-such", {1}, "--set no-such", {}}}),
                    Error);
}

TEST_CASE("the albedo of Lambert is its own at every angle; the mirror direction is where it is",
          "[report]") {
    const BrdfInfo& lambert = *find_brdf("lambert");
    const auto params = resolve_material({}, "lambert", {}).params;
    for (const double theta : {0.0, 0.5, 1.0, 1.5})
        CHECK(albedo(lambert, params, theta) == Approx(0.8).epsilon(1e-3));
    const BrdfInfo& phong = *find_brdf("phong");
    const auto shiny = resolve_material({}, "phong", {}).params;
    const double pi = std::acos(-1.0);
    CHECK(f_cos_at(phong, shiny, {0.6, 0.6, pi}) > 1.2 * f_cos_at(phong, shiny, {0.6, 0.6, 0}));
}

TEST_CASE("plots end at round numbers above their curves, and texts are escaped", "[report]") {
    const std::string plot = line_plot({"a<b", "y", 0, 10}, {{"c&d", {{0, 0.1}, {10, 0.83}}}});
    CHECK(plot.find("a&lt;b") != std::string::npos);
    CHECK(plot.find("c&amp;d") != std::string::npos);
    CHECK(plot.find(">0.8<") != std::string::npos);
    CHECK(plot.find(">1<") != std::string::npos);
    CHECK(plot.find(">1.2<") == std::string::npos);
    // The vertical is the curve's middle: straight up from the centre.
    const std::string polar = polar_plot({{"up", {{0, 1}}}});
    CHECK(count(polar, "<polyline") == 1);
}

// Materials bound to models: checks, and what becomes of another model's parameters.
#include <cmath>
#include <string>
#include <vector>

#include "scanshade/base/error.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "support/catch.hpp"

using namespace scanshade;

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

    const auto code = [&](const std::string& brdf, const std::vector<ParamSetting>& set) {
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
    CHECK(code("", {{"kd", {}, "--set kd", "ggx"}}) == Errc::usage);
    material.brdf = "no-such";
    CHECK(code("", {}) == Errc::scene);
}

TEST_CASE("a choice is a word of its list", "[brdf][resolve]") {
    for (const BrdfInfo* brdf : all_brdfs())
        for (const ParamInfo& param : brdf->params) {
            if (param.kind != ParamKind::choice) continue;
            CAPTURE(brdf->name, param.name);
            const auto index = std::size_t(&param - brdf->params.data());
            Material material;
            material.brdf = brdf->name;
            for (std::size_t i = 0; i < param.names.size(); ++i) {
                material.set_word(param.name, std::string(param.names[i]));
                const auto params = resolve_material(material, "", {}).params;
                CHECK(params.value[index][0] == double(i));
                CHECK(value_text(param, params.value[index][0]) == param.names[i]);
            }
            material.set_word(param.name, std::string(param.names[0]) + "x");
            CHECK_THROWS_WITH(resolve_material(material, "", {}),
                              Catch::Contains("did you mean '" + std::string(param.names[0])));
            material.set(param.name, {1});
            CHECK_THROWS_WITH(resolve_material(material, "", {}), Catch::Contains("takes one of"));
        }
}

TEST_CASE("a shininess becomes a roughness and back, and that is said", "[brdf][resolve]") {
    const auto find = [](const ResolvedMaterial& m, ParamRole role) {
        for (std::size_t i = 0; i < m.brdf->params.size(); ++i)
            if (m.brdf->params[i].role == role) return m.params.value[i][0];
        return -1.0;
    };
    Material shiny;
    shiny.set("shininess", {98});
    const ResolvedMaterial rough = resolve_material(shiny, "torrance-sparrow", {});
    CHECK(find(rough, ParamRole::roughness) == Approx(std::sqrt(0.02)));
    REQUIRE(rough.mapped.size() == 1);
    CHECK(rough.mapped[0] == "shininess 98 became m 0.141421 = √(2/(s + 2))");

    Material facets;
    facets.brdf = "torrance-sparrow";
    facets.set("m", {std::sqrt(0.02)});
    CHECK(find(resolve_material(facets, "phong", {}), ParamRole::exponent) == Approx(98));
    facets.set("m", {1e-4});
    const ResolvedMaterial limited = resolve_material(facets, "phong", {});
    CHECK(find(limited, ParamRole::exponent) == 1e6);
    CHECK(limited.mapped[0].find("limited to its range") != std::string::npos);
}

TEST_CASE("a material that reflects more than arrives is said to", "[brdf][resolve]") {
    Material material;
    material.brdf = "modified-phong";
    material.set("rho_d", {0.8});
    material.set("rho_s", {0.2});
    CHECK(resolve_material(material, "", {}).mapped.empty());
    material.set("rho_s", {0.1, 0.3, 0.1});
    const auto mapped = resolve_material(material, "", {}).mapped;
    REQUIRE(mapped.size() == 1);
    CHECK(mapped[0].find("rho_d + rho_s is 1.1") == 0);
}

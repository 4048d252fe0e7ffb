// --tolerance: lights are left out of a tile, and no level moves by more than was allowed.
#include <algorithm>
#include <cmath>

#include "scanshade/image/image.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

/// A sphere under lights from strong to so weak that nobody sees them.
Scene many_lights(const char* brdf) {
    const PolygonSoup soup = find_shape("sphere")->make(12);
    Material material;
    material.brdf = brdf;
    Scene scene = single_object_scene(std::make_shared<Mesh>(build_mesh(soup, {})), material);
    scene.lights.clear();
    scene.ambient = glm::dvec3(0.01);
    Rng rng(77);
    for (int i = 0; i < 48; ++i) {
        Light light;
        light.kind = i % 3 == 0 ? LightKind::directional : LightKind::point;
        light.position = glm::dvec3(rng.real(-1, 1), rng.real(-1, 1), rng.real(0.5, 1)) * 4.0;
        light.direction = -light.position;
        light.intensity = glm::dvec3(0.6 * std::pow(0.8, i));
        light.attenuation = {1, 0, 0.1};
        scene.lights.push_back(light);
    }
    return scene;
}

struct Tolerated {
    double levels;  // largest difference, before rounding to bytes
    std::uint64_t lights;
};

Tolerated compare(const Scene& scene, double tolerance, Transfer transfer) {
    Settings settings;
    settings.width = 160, settings.height = 120;
    settings.transfer = transfer;
    Framebuffer all, fewer;
    Renderer(scene, settings).draw(all);
    settings.tolerance = tolerance;
    Tolerated out{0, Renderer(scene, settings).draw(fewer).tolerated_lights};
    CHECK(all.id == fewer.id);
    const auto level = [&](float L) {
        const double x = std::clamp(double(L), 0.0, 1.0);
        return 255 * (transfer == Transfer::srgb ? srgb_encode(x) : x);
    };
    for (std::size_t i = 0; i < all.r.size(); ++i)
        for (const auto& [a, b] :
             {std::pair{all.r[i], fewer.r[i]}, {all.g[i], fewer.g[i]}, {all.b[i], fewer.b[i]}})
            out.levels = std::max(out.levels, std::abs(level(a) - level(b)));
    return out;
}

}  // namespace

TEST_CASE("a tolerance leaves lights out and keeps its bound", "[engine][tolerance]") {
    for (const char* brdf : {"lambert", "phong", "blinn-phong"})
        for (const Transfer transfer : {Transfer::srgb, Transfer::linear}) {
            const Scene scene = many_lights(brdf);
            std::uint64_t lights = 0;
            for (const double tolerance : {0.1, 1.0, 8.0}) {
                const Tolerated found = compare(scene, tolerance, transfer);
                CAPTURE(brdf, int(transfer), tolerance, found.levels);
                CHECK(found.lights > lights);  // the more, the more is allowed
                CHECK(found.levels > 0);
                CHECK(found.levels <= tolerance);
                lights = found.lights;
            }
            CHECK(compare(scene, 0, transfer).lights == 0);
        }
}

TEST_CASE("a model without a bound keeps all of its lights", "[engine][tolerance]") {
    CHECK(compare(many_lights("torrance-sparrow"), 8, Transfer::srgb).lights == 0);
}

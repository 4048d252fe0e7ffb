// A light that is said not to reach what a tile shows adds exactly nothing there.
#include "render/light_reach.hpp"

#include <glm/glm.hpp>

#include "render/lighting.hpp"
#include "render/surface.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

glm::dvec3 in_cube(Rng& rng, double side) {
    return glm::dvec3{rng.real(-side, side), rng.real(-side, side), rng.real(-side, side)};
}

/// One spot or cosine light at a place of its own, with nothing else that shines.
Scene lit_by_one(Rng& rng) {
    Light light;
    light.kind = rng.chance(0.5) ? LightKind::spot : LightKind::cosine;
    light.position = in_cube(rng, rng.chance(0.2) ? 1000 : 3);
    light.direction = in_cube(rng, 1) + 1e-3;
    light.cutoff_deg = rng.chance(0.2) ? rng.real(90, 180) : rng.real(0.01, 90);
    light.penumbra_deg = rng.chance(0.5) ? 0 : light.cutoff_deg * rng.real(0, 1);
    light.radius = 1e-4;
    Scene scene;
    scene.lights = {light};
    return scene;
}

/// A hundred points of the sphere, most of them on its surface, with normals of any direction.
Batch<float> points_in(const TileSphere& sphere, Rng& rng) {
    Batch<float> points;
    for (std::size_t i = 0; i < 100; ++i) {
        const double share = rng.chance(0.7) ? 0.9999 : rng.real(0, 1);
        const glm::dvec3 p = glm::dvec3(sphere.centre[0], sphere.centre[1], sphere.centre[2]) +
                             glm::normalize(in_cube(rng, 1) + 1e-6) * sphere.radius * share;
        points.push(to_vec3<float>(p), to_vec3<float>(in_cube(rng, 1)), i);
    }
    return points;
}

bool all_zero(const Batch<float>& points) {
    for (const auto& channel : points.radiance)
        for (std::size_t i = 0; i < points.size(); ++i)
            if (channel[i] != 0) return false;
    return true;
}

}  // namespace

TEST_CASE("a light that does not reach a sphere adds exactly 0 in all of it", "[engine][light]") {
    Rng rng(9);
    Material matt;
    matt.brdf = "lambert";
    const ResolvedMaterial material = resolve_material(matt, "", {});
    View view{};
    view.rotation = glm::dmat3(1);
    view.eye = {0, 0, 5};
    int spared = 0, lit = 0;
    for (int k = 0; k < 20000; ++k) {
        const Scene scene = lit_by_one(rng);
        const Lighting<float> lighting = to_float(make_lighting(scene, view));
        const glm::dvec3 centre = in_cube(rng, 2);
        const TileSphere sphere = {{centre.x, centre.y, centre.z}, std::exp2(rng.real(-12, 1))};
        const bool reached = reaches(lighting.lights[0], sphere);
        for (const bool vectors : {false, true}) {
            Batch<float> points = points_in(sphere, rng);
            points.vectors = vectors;
            EventCounts events;
            points.illuminate(material, lighting, events);
            const bool dark = all_zero(points);
            spared += !reached, lit += !dark;
            CAPTURE(k, vectors);
            if (!reached) CHECK(dark);
        }
    }
    CHECK(spared > 2000);
    CHECK(lit > 2000);
}

// What set-up leaves to the driver: needles, large triangles, what is clipped, polygons drawn whole.
// All of it in every shading and interpolation shows what the scalar renderer shows.
#include <cmath>

#include "support/catch.hpp"
#include "support/level_check.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

const PixelCamera camera(96, 64, 0.5, 100);

glm::dvec3 anywhere(Rng& rng, double margin, double w) {
    const double x = rng.real(-margin, 96 + margin), y = rng.real(-margin, 64 + margin);
    return camera.point(x, y, w);
}

PolygonSoup triangles(const std::vector<glm::dvec3>& corners) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) faces.push_back({i, i + 1, i + 2});
    return make_soup(corners, faces);
}

PolygonSoup needles(Rng& rng) {
    std::vector<glm::dvec3> p;
    for (int k = 0; k < 12; ++k) {
        const glm::dvec3 a = anywhere(rng, 0, rng.real(1, 20)),
                         b = anywhere(rng, 0, rng.real(1, 20));
        const double width = std::exp2(rng.real(-9, -4));
        p.insert(p.end(), {a, b, a + (b - a) * 0.7 + glm::dvec3(width, -width, width)});
    }
    return triangles(p);
}

PolygonSoup large(Rng& rng) {
    std::vector<glm::dvec3> p;
    for (int k = 0; k < 12; ++k) p.push_back(anywhere(rng, 3000, rng.real(1, 30)));
    return triangles(p);
}

PolygonSoup near_and_far_cut(Rng& rng) {
    std::vector<glm::dvec3> p;
    for (int k = 0; k < 18; ++k)
        p.push_back(anywhere(rng, 60, rng.chance(0.5) ? rng.real(-2, 3) : rng.real(1, 200)));
    return triangles(p);
}

PolygonSoup beyond_the_guard_band(Rng& rng) {
    std::vector<glm::dvec3> p;
    for (int k = 0; k < 18; ++k)
        p.push_back(anywhere(rng, rng.chance(0.5) ? 1e5 : 50, rng.real(0.6, 5)));
    return triangles(p);
}

PolygonSoup polygons(Rng& rng) {
    std::vector<glm::dvec3> p;
    std::vector<std::vector<std::uint32_t>> faces;
    for (int k = 0; k < 8; ++k) {
        const double x = rng.real(0, 96), y = rng.real(0, 64), radius = rng.real(5, 60);
        faces.emplace_back();
        for (int i = 0; i < 5; ++i) {
            const double angle = -1.2566 * i + rng.real(-0.5, 0.5);
            faces.back().push_back(std::uint32_t(p.size()));
            p.push_back(camera.point(x + radius * std::cos(angle), y + radius * std::sin(angle),
                                     rng.real(1, 4)));
        }
    }
    return make_soup(p, faces);
}

/// Convex, larger than batches take, some seen from behind.
PolygonSoup large_quads(Rng& rng) {
    std::vector<glm::dvec3> p;
    std::vector<std::vector<std::uint32_t>> faces;
    for (int k = 0; k < 6; ++k) {
        const double radius = rng.real(100, 2000), w = rng.real(1, 4), start = rng.real(0, 6);
        const double x = rng.real(0, 96), y = rng.real(0, 64), turn = rng.chance(0.5) ? 1 : -1;
        faces.emplace_back();
        for (int i = 0; i < 4; ++i) {
            const double angle = start + turn * (1.5708 * i + rng.real(-0.4, 0.4));
            faces.back().push_back(std::uint32_t(p.size()));
            p.push_back(camera.point(x + radius * std::cos(angle), y + radius * std::sin(angle),
                                     w * rng.real(1, 2)));
        }
    }
    return make_soup(p, faces);
}

struct Kind {
    const char* name;
    PolygonSoup (*make)(Rng&);
};
constexpr Kind kinds[] = {{"needles", needles},
                          {"large", large},
                          {"near and far", near_and_far_cut},
                          {"guard band", beyond_the_guard_band},
                          {"polygons", polygons},
                          {"large quads", large_quads}};

std::uint64_t records_of(const Drawn& drawn) {
    for (const StageStats& stage : drawn.stats.stages)
        if (stage.name == "records") return stage.items;
    return 0;
}

}  // namespace

TEST_CASE("records show what the scalar renderer shows", "[engine][records]") {
    LevelCounts counts;
    for (const Kind& kind : kinds) {
        std::uint64_t records = 0;
        for (std::uint64_t seed = 1; seed <= 6; ++seed)
            for (int variant = 0; variant < 18; ++variant) {
                Rng rng(seed);
                Settings settings = camera.settings();
                settings.shading = Shading(variant % 3);
                settings.interpolation = Interpolation(variant / 3 % 3);
                const Scene scene =
                    textured_scene(kind.make(rng), camera.camera, variant >= 9, rng);
                CAPTURE(kind.name, seed, variant);
                Drawn drawn;
                CHECK(scalar_difference(scene, settings, RendererKind::scalar_f32, drawn, counts) ==
                      "");
                records += records_of(drawn);
            }
        CAPTURE(kind.name);
        CHECK(records > 100);
    }
    CHECK(counts.exempt <= counts.pixels / 2000);
}

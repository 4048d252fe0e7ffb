// Quadrilaterals that `edges` draws whole, in vectors: they show what the scalar renderer shows.
#include <cmath>

#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/level_check.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

const PixelCamera camera(160, 96, 0.5, 100);

/// A wavy sheet of about `side` × `side` pixels a face: small ones, some of more than one tile, some
/// not convex on the picture.
PolygonSoup sheet(Rng& rng, double side) {
    const int columns = int(170 / side) + 2, rows = int(106 / side) + 2;
    std::vector<glm::dvec3> p;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c)
            p.push_back(camera.point(c * side - 5 + rng.real(-0.3, 0.3) * side,
                                     r * side - 5 + rng.real(-0.3, 0.3) * side,
                                     3 + std::sin(0.7 * c) + std::cos(0.5 * r)));
    std::vector<std::vector<std::uint32_t>> faces;
    const auto at = [&](int r, int c) { return std::uint32_t(r * (columns + 1) + c); };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            faces.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)});
            if (rng.chance(0.3)) std::reverse(faces.back().begin(), faces.back().end());
            if (rng.chance(0.1)) faces.back().pop_back();  // triangles among them
        }
    return make_soup(p, faces);
}

/// Faces that went through records, of all.
double share_of_records(const Drawn& drawn, const Scene& scene) {
    for (const StageStats& stage : drawn.stats.stages)
        if (stage.name == "records")
            return double(stage.items) / double(scene.objects[0].mesh->face_count());
    return 0;
}

Settings settings_of(int variant) {
    Settings settings = camera.settings();
    settings.interpolation = Interpolation::edges;
    settings.shading = Shading(variant % 3);
    settings.cull = variant / 3 % 2 == 0 ? Cull::none : Cull::back;
    settings.samples = variant / 6 % 2 == 0 ? 1 : 4;
    return settings;
}

}  // namespace

TEST_CASE("quadrilaterals drawn whole show what the scalar renderer shows", "[engine][quads]") {
    LevelCounts counts;
    for (const std::string& isa : instruction_sets())
        for (const double side : {1.5, 7.0, 40.0})
            for (int variant = 0; variant < 24; ++variant) {
                Rng rng(std::uint64_t(variant + 1));
                Settings settings = settings_of(variant);
                settings.isa = isa;
                const Scene scene =
                    textured_scene(sheet(rng, side), camera.camera, variant >= 12, rng);
                CAPTURE(isa, side, variant);
                Drawn drawn;
                CHECK(scalar_difference(scene, settings, RendererKind::scalar_f32, drawn, counts) ==
                      "");
                CHECK(share_of_records(drawn, scene) < 0.6 * settings.samples);
            }
    use_instruction_set("");
    CHECK(counts.exempt <= counts.pixels / 2000);
}

TEST_CASE(
    "of quadrilaterals in one place the first in the file is seen, whichever corner it names first",
    "[engine][quads]") {
    Rng rng(3);
    const PolygonSoup once = sheet(rng, 9);
    for (const RendererKind renderer : {RendererKind::simd, RendererKind::scalar_f32}) {
        PolygonSoup twice = once;
        for (std::size_t f = 0; f < once.face_count(); ++f) {
            const std::size_t begin = once.face_begin[f], n = once.face_begin[f + 1] - begin;
            for (std::size_t k = 0; k < n; ++k)
                twice.corners.push_back(once.corners[begin + (k + 1 + f % 3) % n]);
            twice.face_begin.push_back(std::uint32_t(twice.corners.size()));
            twice.face_material.push_back(0);
        }
        Settings settings = settings_of(0);
        settings.renderer = renderer;
        const Drawn one = draw(make_scene(once, camera.camera), settings);
        const Drawn two = draw(make_scene(twice, camera.camera), settings);
        CHECK(one.frame.id == two.frame.id);
        CHECK(one.frame.depth == two.frame.depth);
    }
}

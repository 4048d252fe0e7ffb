// Which clusters a view does not show: never a lie, by exact coverage of their triangles.
#include "render/cluster_cull.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

/// What each triangle of a scene shows: bits.
enum Shown : std::uint8_t { front = 1, back = 2, clipped = 4 };

std::vector<std::uint8_t> shown(TestFrame& test) {
    std::vector<std::uint8_t> seen(test.plan.triangles);
    visit_coverage(test.frame, [&](const DrawnFace& face, int, int, int) {
        seen[face.id] = std::uint8_t(seen[face.id] | (face.back ? back : front));
    });
    for (std::size_t i = 0; i < test.scene.objects.size(); ++i) {
        const Mesh& mesh = *test.scene.objects[i].mesh;
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
            for (const std::uint32_t v : mesh.triangle[t])
                if (test.frame.vertices[i][v].outcode != 0)
                    seen[test.plan.objects[i].first_triangle + t] |= clipped;
    }
    return seen;
}

struct Answers {
    int outside = 0, away = 0, unclipped = 0, none = 0;
    std::string lie;
};

void ask(TestFrame& test, const EngineScene& engine, Answers& answers) {
    const ClusterCull cull(test.frame.view);
    const std::vector<std::uint8_t> seen = shown(test);
    for (std::size_t i = 0; i < engine.objects.size(); ++i) {
        const EngineObject& object = engine.objects[i];
        for (std::size_t c = 0; c < object.bounds.size(); ++c) {
            const Cluster& cluster = object.mesh->clusters[c];
            std::uint8_t any = 0;
            for (std::uint32_t f = 0; f < cluster.face_count; ++f) {
                // Of a quadrilateral drawn whole both triangles, of which the first is seen.
                const std::uint32_t first = test.plan.objects[i].first_triangle +
                                            object.mesh->triangle[cluster.first_face + f];
                for (std::uint32_t t = 0; t < cluster.corners - 2; ++t) any |= seen[first + t];
            }
            const bool outside = cull.outside(object.bounds[c]);
            const bool away = cull.facing_away(object.bounds[c]);
            const bool unclipped = cull.unclipped(object.bounds[c]);
            answers.outside += outside, answers.away += away, answers.unclipped += unclipped;
            answers.none += !outside && !away && !unclipped;
            if (outside && (any & (front | back)) != 0) answers.lie = "outside";
            if (away && (any & front) != 0) answers.lie = "facing away";
            if (unclipped && (any & clipped) != 0) answers.lie = "unclipped";
        }
    }
}

}  // namespace

TEST_CASE("what is said of clusters holds for the samples of their triangles",
          "[engine][clusters]") {
    Answers answers;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
        RandomScene random = make_random_scene(seed);
        random.settings.renderer = RendererKind::scalar_f32;
        TestFrame test(random.scene, random.settings);
        ask(test, EngineScene(test.scene, test.plan.interpolation), answers);
        CAPTURE(seed, describe(random));
        CHECK(answers.lie == "");
        answers.lie.clear();
    }
    CHECK(answers.outside > 500);
    CHECK(answers.away > 200);
    CHECK(answers.unclipped > 1000);
    CHECK(answers.none > 200);
}

namespace {

/// A triangle of any size around the middle of a pixel, in a plane that nearly contains the direction
/// of view: its foreshortening is that of an angle whose cosine is 1 to float, and where it is small,
/// snapping may turn it.
Scene edge_on_triangle(Rng& rng) {
    PixelCamera camera(160, 120, 0.01, 1000);
    camera.camera.projection = Projection::orthographic;  // one direction of view for all of it
    camera.camera.view_angle_deg = 2 * std::atan(60 / 240.0) * 180 / pi;  // 240 pixels a unit
    const double turn = (rng.chance(0.5) ? 1 : -1) * std::exp2(rng.real(-20, -1));
    const double size = std::exp2(rng.real(-16, 0));
    const glm::dvec3 across = glm::normalize(glm::dvec3{rng.real(-1, 1), rng.real(-1, 1), 0});
    const glm::dvec3 along = {-across.y * turn, across.x * turn, -1};
    std::vector<glm::dvec3> p;
    for (int i = 0; i < 3; ++i) {
        const double a = rng.real(-size, size), b = rng.real(-size, size);
        p.push_back(glm::dvec3(0.5 / 240, -0.5 / 240, -3) + across * a + along * b);
    }
    return make_scene(make_soup(p, {{0, 1, 2}}), camera.camera);
}

}  // namespace

TEST_CASE("a triangle seen edge-on is said to face away only where no sample shows its front",
          "[engine][clusters]") {
    Rng rng(8);
    int front_seen = 0, away = 0;
    for (int k = 0; k < 20000; ++k) {
        Settings settings;
        settings.width = 160, settings.height = 120;
        settings.renderer = RendererKind::scalar_f32;
        TestFrame test(edge_on_triangle(rng), settings);
        if (test.plan.triangles == 0) continue;
        const EngineScene engine(test.scene, Interpolation::perspective);
        const std::uint8_t seen = shown(test)[0];
        const bool said = ClusterCull(test.frame.view).facing_away(engine.objects[0].bounds[0]);
        front_seen += (seen & front) != 0, away += said;
        CAPTURE(k);
        CHECK(!(said && (seen & front) != 0));
    }
    CHECK(front_seen > 1000);
    CHECK(away > 1000);
}

// Which clusters a view does not show: never a lie, by exact coverage of their triangles.
#include "render/cluster_cull.hpp"

#include <algorithm>

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
            for (std::uint32_t t = 0; t < cluster.triangle_count; ++t)
                any |= seen[test.plan.objects[i].first_triangle +
                            object.mesh->triangle[cluster.first_triangle + t]];
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
        // Whole polygons are not cut along clusters.
        random.settings.interpolation = Interpolation::perspective;
        random.settings.renderer = RendererKind::scalar_f32;
        TestFrame test(random.scene, random.settings);
        ask(test, EngineScene(test.scene), answers);
        CAPTURE(seed, describe(random));
        CHECK(answers.lie == "");
        answers.lie.clear();
    }
    CHECK(answers.outside > 500);
    CHECK(answers.away > 200);
    CHECK(answers.unclipped > 1000);
    CHECK(answers.none > 200);
}

TEST_CASE("a cluster of one large triangle seen edge-on is not said to face away",
          "[engine][clusters]") {
    // Its foreshortening is that of an angle whose cosine is 1 to float.
    Rng rng(8);
    int front_seen = 0, away = 0;
    for (int k = 0; k < 3000; ++k) {
        PixelCamera camera(640, 480, 0.01, 1000);
        camera.camera.projection = Projection::orthographic;  // one direction of view for all of it
        const double turn = (rng.chance(0.5) ? 1 : -1) * std::exp2(rng.real(-20, -3));
        // In a plane that nearly contains the direction of view.
        const glm::dvec3 across = glm::normalize(glm::dvec3(rng.real(-1, 1), rng.real(-1, 1), 0));
        const glm::dvec3 along = {-across.y * turn, across.x * turn, -1};
        std::vector<glm::dvec3> p;
        for (int i = 0; i < 3; ++i)
            p.push_back(glm::dvec3(0, 0, -3) + across * rng.real(-1, 1) + along * rng.real(-1, 1));
        TestFrame test(make_scene(make_soup(p, {{0, 1, 2}}), camera.camera), camera.settings());
        if (test.plan.triangles == 0) continue;
        const EngineScene engine(test.scene);
        const std::uint8_t seen = shown(test)[0];
        const bool said = ClusterCull(test.frame.view).facing_away(engine.objects[0].bounds[0]);
        front_seen += (seen & front) != 0, away += said;
        CAPTURE(k, turn);
        CHECK(!(said && (seen & front) != 0));
    }
    CHECK(front_seen > 300);
    CHECK(away > 300);
}

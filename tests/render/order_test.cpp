// What the picture must not depend on: the number of threads, the size of tiles, the order in which
// triangles are drawn.
#include <algorithm>
#include <numeric>

#include "scanshade/scene/clusters.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"
#include "support/random_scene.hpp"
#include "support/same_picture.hpp"

using namespace scanshade;

namespace {

template <class T>
void shuffle(std::vector<T>& values, Rng& rng) {
    for (std::size_t i = values.size(); i > 1; --i)
        std::swap(values[i - 1], values[std::size_t(rng.integer(0, std::int64_t(i) - 1))]);
}

/// Triangles of a cluster in another order.
void shuffle_triangles(ClusteredMesh& mesh, const Cluster& cluster, Rng& rng) {
    std::vector<std::uint32_t> order(cluster.face_count);
    std::iota(order.begin(), order.end(), 0u);
    shuffle(order, rng);
    const auto first = [&](LargeVector<std::uint32_t>& of) { return &of[cluster.first_face]; };
    std::uint32_t *const corners = first(mesh.corners), *const triangle = first(mesh.triangle);
    const std::vector<std::uint32_t> old_corners(corners, corners + order.size());
    const std::vector<std::uint32_t> old_triangle(triangle, triangle + order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        corners[i] = old_corners[order[i]] % number_bit + i * number_bit;
        triangle[i] = old_triangle[order[i]];
    }
}

/// The scene with clusters, and the triangles in them, in another order.
Scene reordered(const Scene& scene, std::uint64_t seed) {
    Rng rng(seed);
    Scene out = scene;
    for (Object& object : out.objects) {
        auto mesh = std::make_shared<Mesh>(*object.mesh);
        mesh->cluster_cache = std::make_shared<ClusterCache>();
        clusters_of(*mesh);
        ClusteredMesh& clusters = mesh->cluster_cache->clusters;
        for (const Cluster& cluster : clusters.clusters) shuffle_triangles(clusters, cluster, rng);
        shuffle(clusters.clusters, rng);
        object.mesh = mesh;
    }
    return out;
}

/// Scenes that take every way through the renderer: golden ones and random ones.
std::vector<RandomScene> all_scenes() {
    std::vector<RandomScene> scenes;
    for (const GoldenPicture& picture : load_golden_list().pictures)
        scenes.push_back({picture.scene, picture.settings});
    for (std::uint64_t seed = 1; seed <= 60; ++seed) scenes.push_back(make_random_scene(seed));
    return scenes;
}

}  // namespace

TEST_CASE("the picture does not depend on the number of threads", "[engine][threads]") {
    for (RandomScene& random : all_scenes()) {
        random.settings.threads = 1;
        random.settings.tile = 16;  // many tiles, also of small pictures
        const Framebuffer one = draw(random.scene, random.settings).frame;
        for (const int threads : {2, 3, 7}) {
            random.settings.threads = threads;
            CAPTURE(random.scene.name, describe(random));
            CHECK(difference(draw(random.scene, random.settings).frame, one) == "");
        }
    }
}

TEST_CASE("a renderer draws the same frame again", "[engine][threads]") {
    for (RandomScene& random : all_scenes()) {
        random.settings.threads = 3;
        Renderer renderer(random.scene, random.settings);
        Framebuffer first, again;
        const EventCounts events = renderer.draw(first).events;
        CAPTURE(random.scene.name, describe(random));
        CHECK(renderer.draw(again).events == events);
        CHECK(difference(again, first) == "");
    }
}

TEST_CASE("the picture does not depend on the size of tiles", "[engine][tiles]") {
    for (RandomScene& random : all_scenes()) {
        random.settings.tile = 64;
        const Framebuffer large = draw(random.scene, random.settings).frame;
        for (const int tile : {16, 32}) {
            random.settings.tile = tile;
            CAPTURE(random.scene.name, describe(random));
            CHECK(difference(draw(random.scene, random.settings).frame, large) == "");
        }
    }
}

TEST_CASE("the picture does not depend on the order of clusters and triangles", "[engine][order]") {
    for (const RandomScene& random : all_scenes()) {
        const Framebuffer given = draw(random.scene, random.settings).frame;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            CAPTURE(random.scene.name, describe(random), seed);
            const Scene other = reordered(random.scene, seed);
            CHECK(difference(draw(other, random.settings).frame, given) == "");
        }
    }
}

TEST_CASE("of coincident triangles the first in the file is seen, at the same depth",
          "[engine][order]") {
    Rng rng(7);
    for (int k = 0; k < 50; ++k) {
        const PixelCamera camera(48, 32, 0.1, 100);
        const double w = rng.real(0.5, 5);
        std::vector<glm::dvec3> p;
        for (int i = 0; i < 3; ++i)
            p.push_back(camera.point(rng.real(-20, 70), rng.real(-20, 50), w * rng.real(0.3, 3)));
        // The same triangle with another first corner in each object.
        Scene scene = make_scene(make_soup(p, {{0, 1, 2}}), camera.camera);
        for (const std::vector<std::uint32_t>& corners :
             {std::vector<std::uint32_t>{1, 2, 0}, {2, 0, 1}}) {
            scene.objects.push_back(scene.objects[0]);
            scene.objects.back().mesh =
                std::make_shared<Mesh>(build_mesh(make_soup(p, {corners}), {}));
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            scene.materials.resize(3, scene.materials[0]);
            scene.materials[i].set("kd", {0.3 * (i + 1)});
            scene.objects[i].materials = {i};
        }
        const Framebuffer given = draw(scene, camera.settings()).frame;
        std::vector<Object> objects = scene.objects;
        std::vector<std::size_t> order = {0, 1, 2};
        do {
            for (std::size_t i = 0; i < 3; ++i) scene.objects[i] = objects[order[i]];
            const Framebuffer other = draw(scene, camera.settings()).frame;
            CAPTURE(k, order);
            // Objects have one triangle each, so the first object's id is 0 in any order.
            CHECK(visibility_difference(other, given) == "");
            CHECK(seen(other) == std::size_t(std::count(other.id.begin(), other.id.end(), 0u)));
        } while (std::next_permutation(order.begin(), order.end()));
    }
}

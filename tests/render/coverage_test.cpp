// Surfaces made of many faces: every sample of the interior is covered exactly once, whatever clips
// them. After the fill-rule cases of the dEQP conformance tests.
#include <algorithm>

#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"
#include "support/winding.hpp"

using namespace scanshade;

namespace {

/// Samples inside the closed polygon through these vertices as they were snapped, in exact
/// integers: the winding number with the top-left rule.
std::vector<int> inside_outline(const TestFrame& test, const std::vector<glm::dvec3>& outline) {
    const Mesh& mesh = *test.scene.objects[0].mesh;
    std::vector<SnappedPoint> polygon;
    for (const glm::dvec3& p : outline) {
        // The mesh's vertex that stands there.
        std::size_t best = 0;
        double best_distance = double(INFINITY);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            const glm::dvec3 q =
                mesh.origin + mesh.unit * glm::dvec3(mesh.x[v], mesh.y[v], mesh.z[v]);
            const double distance = glm::dot(q - p, q - p);
            if (distance < best_distance) best = v, best_distance = distance;
        }
        REQUIRE(test.frame.vertices[0][best].outcode == 0);
        polygon.push_back(test.frame.vertices[0][best].point);
    }
    std::vector<int> inside(test.target.depth.size());
    for (int y = 0; y < test.target.height; ++y)
        for (int x = 0; x < test.target.width; ++x) {
            const SnappedPoint p = {x * 256 + 128, y * 256 + 128};
            inside[test.target.index(x, y)] = std::abs(winding_number(polygon, p));
        }
    return inside;
}

std::size_t differences(const std::vector<int>& a, const std::vector<int>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
}

std::size_t covered(const std::vector<int>& count) {
    return static_cast<std::size_t>(
        std::count_if(count.begin(), count.end(), [](int n) { return n > 0; }));
}

/// n × n quads over a square about the middle of the picture, turned, its inner corners jittered,
/// each corner at a depth of its own; as triangles.
struct Grid {
    std::vector<glm::dvec3> positions, outline;
    std::vector<std::vector<std::uint32_t>> faces;

    Grid(const PixelCamera& camera, int n, double side, double angle, bool any_depth, Rng& rng) {
        const auto at = [n](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const bool inner = i > 0 && j > 0 && i < n && j < n;
                const double jitter = inner ? 0.2 : 0;
                const double x = ((i + rng.real(-jitter, jitter)) / n - 0.5) * side;
                const double y = ((j + rng.real(-jitter, jitter)) / n - 0.5) * side;
                positions.push_back(
                    camera.point(camera.width / 2.0 + x * std::cos(angle) - y * std::sin(angle),
                                 camera.height / 2.0 + x * std::sin(angle) + y * std::cos(angle),
                                 any_depth ? rng.real(0.1, 4) : 2));
            }
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
                // Either sense of winding draws the same.
                if ((i + j) % 2 == 1) std::reverse(faces.back().begin(), faces.back().end());
            }
        for (int i = 0; i < n; ++i) outline.push_back(positions[at(i, 0)]);
        for (int j = 0; j < n; ++j) outline.push_back(positions[at(n, j)]);
        for (int i = n; i > 0; --i) outline.push_back(positions[at(i, n)]);
        for (int j = n; j > 0; --j) outline.push_back(positions[at(0, j)]);
    }
};

}  // namespace

TEST_CASE("jittered grids in 15 rotations, at one depth and at depths from 0.1 to 4",
          "[render][coverage]") {
    // 4 x 4 quads on 256 x 256 pixels are dEQP's size; smaller cells meet more corners in a pixel.
    struct Size {
        int picture, cells, side;
    };
    for (const Size& size : {Size{256, 4, 170}, Size{64, 8, 40}})
        for (int rotation = 0; rotation < 15; ++rotation)
            for (const bool any_depth : {false, true}) {
                const PixelCamera camera(size.picture, size.picture);
                Rng rng(100 + std::uint64_t(rotation));
                CAPTURE(size.picture, rotation, any_depth);
                const Grid grid(camera, size.cells, size.side, rotation * pi / 2 / 14, any_depth,
                                rng);
                TestFrame test(make_scene(make_soup(grid.positions, grid.faces), camera.camera),
                               camera.settings());
                const auto got = test.coverage();
                CHECK(double(covered(got)) == Approx(size.side * size.side).epsilon(0.02));
                CHECK(differences(got, inside_outline(test, grid.outline)) == 0);
            }
}

TEST_CASE("fans and strips leave no gap and cover nothing twice, in either order of vertices",
          "[render][coverage]") {
    // A tolerance in the weights, or edges that belong to both sides, draw shared edges twice
    // (zauonlok/renderer; a reference rasterizer of WebGL's tests had it, too).
    using Faces = std::vector<std::vector<std::uint32_t>>;
    const auto require_exact = [](const PixelCamera& camera, const std::vector<glm::dvec3>& points,
                                  Faces faces, const std::vector<glm::dvec3>& outline) {
        for (const bool reversed : {false, true}) {
            CAPTURE(reversed);
            if (reversed)
                for (auto& face : faces) std::reverse(face.begin(), face.end());
            TestFrame test(make_scene(make_soup(points, faces), camera.camera), camera.settings());
            CHECK(differences(test.coverage(), inside_outline(test, outline)) == 0);
        }
    };
    const PixelCamera camera(96, 80);
    Rng rng(7);
    for (int k = 0; k < 30; ++k) {
        std::vector<glm::dvec3> ring, all;
        Faces fan;
        constexpr std::uint32_t n = 17;
        for (std::uint32_t i = 0; i < n; ++i) {
            const double angle = (i + rng.real(0, 0.8)) * 2 * pi / n, r = rng.real(10, 38);
            ring.push_back(
                camera.point(48 + r * std::cos(angle), 40 + r * std::sin(angle), rng.real(0.1, 4)));
            fan.push_back({n, i, (i + 1) % n});
        }
        all = ring;
        all.push_back(camera.point(48 + rng.real(-3, 3), 40 + rng.real(-3, 3), 1));
        CAPTURE(k);
        require_exact(camera, all, fan, ring);

        std::vector<glm::dvec3> strip, upper, lower;
        Faces faces;
        for (std::uint32_t i = 0; i < 12; ++i) {
            upper.push_back(camera.point(5 + 7 * i, rng.real(5, 30), rng.real(0.1, 4)));
            lower.push_back(camera.point(6 + 7 * i, rng.real(45, 75), rng.real(0.1, 4)));
            strip.insert(strip.end(), {upper.back(), lower.back()});
        }
        for (std::uint32_t i = 0; i + 2 < strip.size(); ++i) faces.push_back({i, i + 1, i + 2});
        std::vector<glm::dvec3> outline = upper;
        outline.insert(outline.end(), lower.rbegin(), lower.rend());
        require_exact(camera, strip, faces, outline);
    }
}

TEST_CASE("pictures of 16384 x 16 and 16 x 16384 are covered exactly", "[render][coverage]") {
    for (const auto& [w, h] : {std::pair{16384, 16}, std::pair{16, 16384}}) {
        const PixelCamera camera(w, h);
        const std::vector<glm::dvec3> corners = {
            camera.point(1.3, 1.7, 1), camera.point(w - 1.2, 2.1, 2),
            camera.point(w - 2.6, h - 1.4, 0.7), camera.point(2.2, h - 1.9, 1.5)};
        TestFrame test(make_scene(make_soup(corners, {{0, 1, 2}, {0, 2, 3}}), camera.camera),
                       camera.settings());
        CAPTURE(w, h);
        const auto got = test.coverage();
        CHECK(covered(got) > 190000);
        CHECK(differences(got, inside_outline(test, corners)) == 0);
    }
}

TEST_CASE("a surface that every guard plane clips covers the whole picture once",
          "[render][coverage]") {
    const PixelCamera camera(64, 48);
    for (int rotation = 0; rotation < 15; ++rotation) {
        Rng rng(200 + std::uint64_t(rotation));
        CAPTURE(rotation);
        // Corners a million pixels away, and depths that differ.
        const Grid grid(camera, 5, 2e6, rotation * pi / 2 / 14, true, rng);
        TestFrame test(make_scene(make_soup(grid.positions, grid.faces), camera.camera),
                       camera.settings());
        const auto got = test.coverage();
        CHECK(std::all_of(got.begin(), got.end(), [](int n) { return n == 1; }));
        CHECK(test.frame.events[Event::guard_clipped] > 0);
    }
}

TEST_CASE("a surface across the near and the far plane is cut without a crack",
          "[render][coverage]") {
    // A slope from behind the eye to beyond far, in jittered triangles.
    const PixelCamera camera(80, 60, 0.05, 50);
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        Rng rng(300 + seed);
        constexpr int n = 14;
        std::vector<glm::dvec3> positions;
        std::vector<std::vector<std::uint32_t>> faces;
        const double turn = rng.real(0, 2 * pi);
        const int half = n / 2;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const double x = (double(i - half) + rng.real(-0.3, 0.3)) * 20;
                const double z = (double(j - half) + rng.real(-0.3, 0.3)) * 20;
                positions.push_back({x * std::cos(turn) - z * std::sin(turn), -1,
                                     x * std::sin(turn) + z * std::cos(turn)});
            }
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t v = j * (n + 1) + i;
                faces.push_back({v, v + 1, v + n + 2});
                faces.push_back({v, v + n + 2, v + n + 1});
            }
        TestFrame test(make_scene(make_soup(positions, faces), camera.camera), camera.settings());
        const auto got = test.coverage();
        CHECK(test.frame.events[Event::near_clipped] > 0);
        CAPTURE(seed);
        // w of the floor at row y is 30/(y + 0.5 − 30): far at 0.6 pixel below the horizon.
        std::size_t wrong = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x) {
                const int expected = y >= 31 ? 1 : 0;
                if (y == 30) continue;  // the cut itself
                wrong += got[test.target.index(x, y)] != expected;
            }
        CHECK(wrong == 0);
    }
}

TEST_CASE("a floor from under the camera to the horizon has the right depth everywhere",
          "[render][depth]") {
    const double near = 0.01, far = 1e4;
    const PixelCamera camera(200, 150, near, far);
    const auto floor = [](double x, double z) { return glm::dvec3(x, -1, z); };
    for (const double reach : {9e3, 50.0}) {
        TestFrame test(make_scene(make_soup({floor(-reach, 5), floor(reach, 5),
                                             floor(reach, -reach), floor(-reach, -reach)},
                                            {{0, 1, 2}, {0, 2, 3}}),
                                  camera.camera),
                       camera.settings());
        find_visible(test.frame);
        const double scale = double(test.frame.view.near) / near;  // normalised units
        std::size_t seen = 0;
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 200; ++x) {
                const float z = test.frame.depth[test.target.index(x, y)];
                if (z == 0) continue;
                ++seen;
                const double rows = y + 0.5 - 75;  // below the horizon; 75 pixels a unit at w = 1
                const double expected = near * rows / 75;
                REQUIRE(std::abs(double(z) - expected) <= 3e-6 * expected);
            }
        CHECK(scale > 0);
        CHECK(seen > (reach > 100 ? 14700u : 10000u));
    }
}

TEST_CASE("the order of corners and of faces changes neither coverage nor what is seen",
          "[render][order]") {
    const PixelCamera camera(64, 64);
    Rng rng(9);
    std::vector<glm::dvec3> positions;
    std::vector<std::vector<std::uint32_t>> faces, turned, backwards;
    for (std::uint32_t t = 0; t < 60; ++t) {
        for (int i = 0; i < 3; ++i)
            positions.push_back(
                camera.point(rng.real(-10, 74), rng.real(-10, 74), rng.real(0.5, 4)));
        faces.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        turned.push_back({3 * t + 1, 3 * t + 2, 3 * t});
    }
    backwards.assign(faces.rbegin(), faces.rend());
    const auto draw = [&](const auto& list) {
        TestFrame test(make_scene(make_soup(positions, list), camera.camera), camera.settings());
        find_visible(test.frame);
        return std::pair(test.frame.id, test.frame.depth);
    };
    const auto [id, depth] = draw(faces);
    const auto [turned_id, turned_depth] = draw(turned);
    const auto [backwards_id, backwards_depth] = draw(backwards);
    CHECK(turned_id == id);
    CHECK(backwards_depth == depth);
    for (std::size_t i = 0; i < id.size(); ++i) {
        const std::uint32_t none = Framebuffer::no_triangle;
        REQUIRE(backwards_id[i] == (id[i] == none ? none : 59 - id[i]));
        REQUIRE(turned_depth[i] == depth[i]);
    }
}

TEST_CASE("of two faces at the same depth the first in the file is seen", "[render][order]") {
    // With a depth test that lets equal ones pass, the drawing order decides (zauonlok/renderer).
    const PixelCamera camera(32, 32);
    const std::vector<glm::dvec3> p = {camera.point(4, 4, 2), camera.point(28, 5, 2),
                                       camera.point(16, 28, 2)};
    TestFrame test(make_scene(make_soup(p, {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}}), camera.camera),
                   camera.settings());
    find_visible(test.frame);
    for (const std::uint32_t id : test.frame.id) CHECK((id == 0 || id == Framebuffer::no_triangle));
    CHECK(test.frame.id[test.target.index(16, 12)] == 0);
}

TEST_CASE("a mesh of triangles smaller than a pixel loses no sample", "[render][coverage]") {
    // Dropping triangles of less than a pixel, as tinyrenderer does, empties such a surface.
    const PixelCamera camera(64, 64);
    Rng rng(10);
    const Grid grid(camera, 150, 50, 0.3, false, rng);
    TestFrame test(make_scene(make_soup(grid.positions, grid.faces), camera.camera),
                   camera.settings());
    CHECK(differences(test.coverage(), inside_outline(test, grid.outline)) == 0);
}

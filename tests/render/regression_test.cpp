// Defects of geometry and visibility that other renderers had or have, and hard cases of numbers:
// each stays fixed here. Those of light are in regression_light_test.cpp; fills that cover twice or
// not at all, sub-pixel triangles and equal depth in coverage_test.cpp.
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "render/clip.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"

using namespace scanshade;

TEST_CASE("slivers that clipping makes do not end the drawing of the rest", "[regression]") {
    // zauonlok/renderer leaves the fan of a clipped polygon at its first triangle of no area.
    const PixelCamera camera(64, 64, 0.1, 100);
    Rng rng(41);
    for (int k = 0; k < 200; ++k) {
        // One corner behind the eye, one exactly on the near plane, one in view: the clipped
        // polygon has two corners in nearly the same place.
        const std::vector<glm::dvec3> p = {
            {rng.real(-1, 1), rng.real(-1, 1), rng.real(0.1, 2)},
            camera.point(rng.real(0, 64), rng.real(0, 64), 0.1 * (1 + rng.real(-1e-7, 1e-7))),
            camera.point(rng.real(20, 44), rng.real(20, 44), 3)};
        TestFrame test(make_scene(make_soup(p, {{0, 1, 2}}), camera.camera), camera.settings());
        if (test.plan.triangles == 0) continue;
        std::vector<ClipVertex> polygon;
        for (std::size_t i = 0; i < 3; ++i) polygon.push_back(test.frame.vertices[0][i].clip);
        clip_polygon(polygon, out_near, test.frame.view);
        std::vector<SnappedPoint> points;
        for (const ClipVertex& v : polygon) points.push_back(test.frame.view.snap(v));
        std::vector<int> whole(test.target.depth.size());
        PolygonWalker walker;
        if (points.size() >= 3 && twice_area(points) != 0)
            walker.walk(points, twice_area(points) > 0, {}, 64, 64, [&](int y, int b, int e) {
                for (int x = b; x < e; ++x) ++whole[test.target.index(x, y)];
            });
        REQUIRE(test.coverage() == whole);
    }
}

TEST_CASE("a camera inside a mesh sees its inside, front of near and behind it cut off",
          "[regression]") {
    // tinyrenderer and its descendants do not clip against the near plane.
    Scene scene = lit_sphere();
    scene.camera->position = {0.2, 0.1, 0.3};
    scene.camera->focal_point = {0, 0, -1};
    scene.camera->view_angle_deg = 100;
    const Drawn d = draw(scene, small_picture());
    CHECK(seen(d.frame) == d.frame.id.size());
    CHECK(d.stats.events[Event::near_clipped] > 0);
    CHECK(d.stats.events[Event::not_finite] == 0);
}

TEST_CASE("what is small on the picture is drawn at any scale of the scene", "[regression]") {
    // A floating-point area threshold depends on the units of the scene and on the resolution.
    for (const double scale : {1e-9, 1.0, 1e9}) {
        Scene scene = lit_sphere();
        scene.lights.clear();
        scene.objects[0].to_world = glm::scale(glm::dmat4(1), glm::dvec3(scale));
        scene.camera->position = {0, 0, 50 * scale};
        CAPTURE(scale);
        CHECK(seen(draw(scene, small_picture()).frame) > 10);
    }
}

TEST_CASE("the faces at an edge get the same corner where a plane cuts the edge", "[regression]") {
    // Where a cut is computed in the order of the corners, the two faces round it differently, and
    // the surface cracks at the near plane.
    const PixelCamera camera(64, 64, 0.1, 100);
    const TestFrame test(
        make_scene(make_soup({{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}, {{0, 1, 2}}), camera.camera),
        camera.settings());
    Rng rng(42);
    const auto vertex = [&](double low, double high) {
        const float d = float(rng.real(low, high));
        return ClipVertex{float(rng.real(-50, 50)), float(rng.real(-50, 50)), d, d};
    };
    const auto cut_corners = [&](std::vector<ClipVertex> polygon) {
        clip_polygon(polygon, out_near, test.frame.view);
        std::set<std::array<float, 4>> corners;
        for (const ClipVertex& v : polygon) corners.insert({v.x, v.y, v.d, v.w});
        return corners;
    };
    for (int k = 0; k < 1000; ++k) {
        const ClipVertex a = vertex(0.2, 3), b = vertex(-3, 0), c = vertex(0.2, 3),
                         d = vertex(0.2, 3);
        const auto one = cut_corners({a, b, c}), other = cut_corners({b, a, d});
        // The corner a and the cut of the edge from a to b.
        int shared = 0;
        for (const auto& corner : one) shared += other.count(corner) == 1;
        REQUIRE(shared == 2);
    }
}

TEST_CASE("a face that reaches behind the eye keeps its side", "[regression]") {
    // Dividing by a negative w mirrors a corner; a side decided from that is the wrong one.
    const PixelCamera camera(40, 40, 0.1, 100);
    for (const double height : {-1.0, 1.0}) {
        const PolygonSoup floor =
            make_soup({{-9, height, 5}, {9, height, 5}, {0, height, -60}}, {{0, 1, 2}});
        Settings culled = camera.settings();
        culled.cull = Cull::back;
        CAPTURE(height);
        // Counter-clockwise from above: seen from there only.
        const std::size_t front = seen(draw(make_scene(floor, camera.camera), culled).frame);
        CHECK((height < 0 ? front > 400 : front == 0));
        CHECK(seen(draw(make_scene(floor, camera.camera), camera.settings()).frame) > 400);
    }
}

TEST_CASE("edges without length or height change nothing", "[regression]") {
    // Stepping along an edge by a division through its length or height divides by 0 here.
    Rng rng(43);
    const auto walked = [](const std::vector<SnappedPoint>& polygon) {
        std::vector<std::array<int, 3>> spans;
        PolygonWalker walker;
        walker.walk(polygon, twice_area(polygon) > 0, {}, 32, 32, [&](int y, int begin, int end) {
            spans.push_back({y, begin, end});
        });
        return spans;
    };
    for (int k = 0; k < 300; ++k) {
        const std::int32_t top = int(rng.integer(0, 4000)), bottom = int(rng.integer(4001, 8000));
        const SnappedPoint a = {int(rng.integer(0, 3000)), top}, b = {a.x + 4000, top};
        const SnappedPoint c = {int(rng.integer(0, 8000)), bottom};
        const SnappedPoint middle = {a.x + 2000, top};
        CHECK(walked({a, a, middle, b, b, b, c, c}) == walked({a, b, c}));
        CHECK(walked({c, c, b, middle, a, a}) == walked({c, b, a}));
    }
}

TEST_CASE("fractions of a pixel move the coverage: on the mean it is the area", "[regression]") {
    // Corners rounded to whole pixels make moving pictures stutter.
    const double width = 3.3125, height = 2.6875;  // whole numbers of 1/16 pixel
    const PixelCamera camera(16, 16);
    double sum = 0;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j) {
            const double x = 4 + i / 16.0 + 1.0 / 32, y = 5 + j / 16.0 + 1.0 / 32;
            TestFrame test(
                make_scene(make_soup({camera.point(x, y, 2), camera.point(x + width, y, 2),
                                      camera.point(x + width, y + height, 2),
                                      camera.point(x, y + height, 2)},
                                     {{0, 1, 2, 3}}),
                           camera.camera),
                camera.settings());
            for (const int n : test.coverage()) sum += n;
        }
    CHECK(sum / 256 == Approx(width * height).epsilon(1e-12));
}

TEST_CASE("only an edge with a corner of others in its middle can crack", "[regression]") {
    // A T-junction is a fault of the mesh: its corner is snapped, the long edge is not bent to it.
    // What is lost or drawn twice lies within a pixel of that edge.
    const PixelCamera camera(64, 64);
    Rng rng(44);
    for (int k = 0; k < 100; ++k) {
        const double slope = rng.real(-0.3, 0.3), t = rng.real(0.2, 0.8);
        const auto edge_y = [&](double x) { return 32 + slope * (x - 32); };
        const auto on_edge = [&](double x) { return camera.point(x, edge_y(x), 2); };
        TestFrame test(make_scene(make_soup({camera.point(4, 4, 2), camera.point(60, 4, 2),
                                             on_edge(60), on_edge(4), on_edge(4 + t * 56),
                                             camera.point(60, 60, 2), camera.point(4, 60, 2)},
                                            {{0, 1, 2, 3}, {3, 4, 5, 6}, {4, 2, 5}}),
                                  camera.camera),
                       camera.settings());
        const auto got = test.coverage();
        for (int y = 5; y < 59; ++y)
            for (int x = 5; x < 59; ++x)
                if (std::abs(y + 0.5 - edge_y(x + 0.5)) > 1)
                    REQUIRE(got[test.target.index(x, y)] == 1);
    }
}

TEST_CASE("an offset of a million units does not move a vertex on the picture", "[regression]") {
    Scene here = lit_sphere(), there = lit_sphere();
    here.lights.clear();
    there.lights.clear();
    const glm::dvec3 offset = {0x1p20, -0x1p21, 0x1p20};
    there.objects[0].to_world = glm::translate(glm::dmat4(1), offset);
    there.camera->position += offset;
    there.camera->focal_point += offset;
    const Drawn a = draw(here, small_picture()), b = draw(there, small_picture());
    CHECK(a.frame.id == b.frame.id);
    CHECK(a.frame.r == b.frame.r);
}

TEST_CASE("a mirrored object keeps its front and its light", "[regression]") {
    Scene plain = lit_sphere(), mirrored = lit_sphere();
    mirrored.objects[0].to_world = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    Settings culled = small_picture();
    culled.cull = Cull::back;
    const Drawn a = draw(plain, culled), b = draw(mirrored, culled);
    CHECK(seen(a.frame) == Approx(double(seen(b.frame))).epsilon(0.02));
    double light_a = 0, light_b = 0;
    for (std::size_t i = 0; i < a.frame.r.size(); ++i) {
        light_a += double(a.frame.r[i]);
        light_b += double(b.frame.r[i]);
    }
    CHECK(light_b == Approx(light_a).epsilon(0.02));
}

TEST_CASE("drawing twice gives the same bits", "[regression]") {
    Renderer renderer(lit_sphere(), small_picture());
    Framebuffer first, second;
    renderer.draw(first);
    renderer.draw(second);
    CHECK(first.r == second.r);
    CHECK(first.depth == second.depth);
    CHECK(first.id == second.id);
}

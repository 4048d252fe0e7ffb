// Defects that other renderers had or have, and hard cases of numbers: each stays fixed here.
#include <glm/gtc/matrix_transform.hpp>

#include "render/clip.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

struct Drawn {
    Framebuffer frame;
    FrameStats stats;
};

Drawn draw(const Scene& scene, const Settings& settings) {
    Drawn d;
    d.stats = Renderer(scene, settings).draw(d.frame);
    return d;
}

std::size_t seen(const Framebuffer& frame) {
    std::size_t count = 0;
    for (const std::uint32_t id : frame.id) count += id != Framebuffer::no_triangle;
    return count;
}

Scene lit_sphere() {
    Scene scene = single_object_scene(
        std::make_shared<Mesh>(build_mesh(find_shape("sphere")->make(16), {})), Material{});
    scene.camera = Camera{};
    return scene;
}

Settings small() {
    Settings s;
    s.width = 80;
    s.height = 60;
    return s;
}

}  // namespace

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
        for (int i = 0; i < 3; ++i) polygon.push_back(test.frame.vertices[0][i].clip);
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
    const Drawn d = draw(scene, small());
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
        CHECK(seen(draw(scene, small()).frame) > 10);
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
    const Drawn a = draw(here, small()), b = draw(there, small());
    CHECK(a.frame.id == b.frame.id);
    CHECK(a.frame.r == b.frame.r);
}

TEST_CASE("normals follow an uneven scale by the inverse transpose", "[regression]") {
    // A flattened sphere, lit from above: its top must be as bright as a plane's.
    Scene scene = lit_sphere();
    scene.ambient = {0, 0, 0};
    scene.objects[0].to_world = glm::scale(glm::dmat4(1), glm::dvec3(1, 0.1, 1));
    Light light;
    light.kind = LightKind::directional;
    light.direction = {0, -1, 0};
    scene.lights = {light};
    scene.materials[0] = Material{};
    scene.materials[0].brdf = "lambert";
    scene.camera->position = {0, 5, 0.01};
    const Drawn d = draw(scene, small());
    // Half way to the rim the ellipsoid's normal leans by atan(0.1·tan 30°) only.
    const double half_way = std::cos(std::atan(0.1 * std::tan(pi / 6)));
    const std::size_t at = d.frame.index(40 + 11, 30);
    CHECK(d.frame.r[at] == Approx(0.8 * half_way).epsilon(0.005));
}

TEST_CASE("a mirrored object keeps its front and its light", "[regression]") {
    Scene plain = lit_sphere(), mirrored = lit_sphere();
    mirrored.objects[0].to_world = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    Settings culled = small();
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

TEST_CASE("a light on the surface is counted and gives no NaN", "[regression]") {
    Scene scene = lit_sphere();
    const Mesh& mesh = *scene.objects[0].mesh;
    Light light;
    light.position = mesh.origin + mesh.unit * glm::dvec3(mesh.x[100], mesh.y[100], mesh.z[100]);
    light.attenuation = {0, 0, 1};
    light.radius = 0.05;
    scene.lights = {light};
    scene.camera->position = light.position * 4.0;
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Settings settings = small();
        settings.shading = shading;
        const Drawn d = draw(scene, settings);
        CHECK(d.stats.events[Event::not_finite] == 0);
        if (shading != Shading::flat) CHECK(d.stats.events[Event::light_at_surface] > 0);
    }
}

TEST_CASE("a light 1e25 scenes away lights like a directional one", "[regression]") {
    Scene scene = lit_sphere(), directional = lit_sphere();
    Light far;
    far.position = {3e25, 4e25, 0};
    scene.lights = {far};
    far.kind = LightKind::directional;
    far.direction = {-3, -4, 0};
    directional.lights = {far};
    const Drawn a = draw(scene, small()), b = draw(directional, small());
    for (std::size_t i = 0; i < a.frame.r.size(); ++i)
        REQUIRE(a.frame.r[i] == Approx(double(b.frame.r[i])).margin(1e-5));
}

TEST_CASE("interpolated normals that cancel are replaced by the face's and counted",
          "[regression]") {
    // The middle row of samples lies half way between opposite normals.
    const PixelCamera camera(33, 33);
    PolygonSoup soup = make_soup({camera.point(4.5, 4.5, 2), camera.point(28.5, 4.5, 2),
                                  camera.point(28.5, 28.5, 2), camera.point(4.5, 28.5, 2)},
                                 {{3, 2, 1, 0}});
    soup.normals = {{0, 1, 0}, {0, -1, 0}};
    for (int i = 0; i < 4; ++i) soup.corners[std::size_t(i)].normal = i < 2 ? 0 : 1;
    Settings settings = camera.settings();
    settings.interpolation = Interpolation::patch;
    const Drawn d = draw(make_scene(soup, camera.camera), settings);
    CHECK(d.stats.events[Event::zero_normal] > 10);
    CHECK(d.stats.events[Event::not_finite] == 0);
}

TEST_CASE("shininess 0 and a light behind the surface: no NaN, nothing lit from behind",
          "[regression]") {
    // pow(0, 0) and powers of negative cosines are the classic black or white patches.
    for (const char* brdf : {"phong", "blinn-phong"}) {
        Scene scene = lit_sphere();
        scene.ambient = {0, 0, 0};
        Light light;
        light.kind = LightKind::directional;
        light.direction = {0, 0, 1};  // from behind the sphere, towards the camera
        scene.lights = {light};
        scene.materials[0].brdf = brdf;
        scene.materials[0].set("ks", {1});
        scene.materials[0].set("shininess", {0});
        const Drawn d = draw(scene, small());
        CHECK(d.stats.events[Event::not_finite] == 0);
        CHECK(d.frame.r[d.frame.index(40, 30)] == 0);
    }
}

TEST_CASE("drawing twice gives the same bits", "[regression]") {
    Renderer renderer(lit_sphere(), small());
    Framebuffer first, second;
    renderer.draw(first);
    renderer.draw(second);
    CHECK(first.r == second.r);
    CHECK(first.depth == second.depth);
    CHECK(first.id == second.id);
}

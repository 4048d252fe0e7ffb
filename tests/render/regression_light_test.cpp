// Defects of light that other renderers and shaders had or have, and hard cases of numbers: each
// stays fixed here.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

/// A square in the plane z = −2 that fills the picture of an eye at the origin; the middle pixel
/// shows its middle.
const PixelCamera plate_camera(33, 33);
constexpr glm::dvec3 plate_middle{0, 0, -2};

Scene plate(const Light& light, const glm::dvec3& normal = {0, 0, 1}) {
    PolygonSoup soup = make_soup({plate_camera.point(-5, -5, 2), plate_camera.point(-5, 40, 2),
                                  plate_camera.point(40, 40, 2), plate_camera.point(40, -5, 2)},
                                 {{0, 1, 2, 3}});
    soup.normals = {normal};
    for (PolygonSoup::Corner& corner : soup.corners) corner.normal = 0;
    Scene scene = make_scene(soup, plate_camera.camera);
    scene.ambient = {0, 0, 0};
    scene.lights = {light};
    return scene;
}

void set_material(Scene& scene, const std::string& brdf, double kd, double ks, double shininess) {
    Material& material = scene.materials[0];
    material.brdf = brdf;
    material.set("kd", {kd});
    material.set("ks", {ks});
    material.set("shininess", {shininess});
}

double middle_of(const Scene& scene, RendererKind renderer = RendererKind::scalar_f64) {
    Settings settings = plate_camera.settings();
    settings.renderer = renderer;
    const Framebuffer frame = draw(scene, settings).frame;
    return double(frame.r[frame.index(16, 16)]);
}

Light from_the_eye() {
    Light light;
    light.kind = LightKind::directional;
    light.direction = {0, 0, -1};
    return light;
}

/// x to y, y to z, z to x.
glm::dvec3 turned(const glm::dvec3& v) { return {v.z, v.x, v.y}; }

}  // namespace

TEST_CASE("exchanging the axes of a scene leaves its highlights where they are", "[regression]") {
    // C-Chads/tinygl takes one component of the vertex for all three of the half vector; such a
    // highlight depends on which axis is called x.
    for (const char* brdf : {"phong", "blinn-phong"}) {
        Light light;
        light.position = {0.7, 0.4, -0.6};
        Scene scene = plate(light, {0.2, -0.1, 1});
        set_material(scene, brdf, 0.1, 0.8, 30);
        Scene other = scene;
        other.objects[0].to_world = {{0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}};
        other.lights[0].position = turned(light.position);
        other.camera->position = turned(scene.camera->position);
        other.camera->focal_point = turned(scene.camera->focal_point);
        other.camera->view_up = turned(scene.camera->view_up);
        const Drawn a = draw(scene, plate_camera.settings());
        const Drawn b = draw(other, plate_camera.settings());
        double largest = 0, worst = 0;
        for (std::size_t i = 0; i < a.frame.r.size(); ++i) {
            largest = std::max(largest, double(a.frame.r[i]));
            worst = std::max(worst, std::abs(double(a.frame.r[i]) - double(b.frame.r[i])));
        }
        CAPTURE(brdf);
        CHECK(largest > 0.5);
        CHECK(worst < 1e-5);
    }
}

TEST_CASE("under a far viewer the highlight stands half way between light and viewer",
          "[regression]") {
    // C-Chads/tinygl subtracts the direction to a viewer at infinity instead of adding it.
    Scene scene = lit_sphere();
    scene.ambient = {0, 0, 0};
    scene.camera->projection = Projection::orthographic;
    Light light;
    light.kind = LightKind::directional;
    light.direction = {-0.8, -0.4, -0.5};
    scene.lights = {light};
    set_material(scene, "blinn-phong", 0, 1, 200);
    const Framebuffer frame = draw(scene, small_picture()).frame;
    const auto brightest =
        std::size_t(std::max_element(frame.r.begin(), frame.r.end()) - frame.r.begin());
    const glm::dvec3 h = glm::normalize(glm::normalize(-light.direction) + glm::dvec3(0, 0, 1));
    const double pixels = 30 / (5 * std::tan(pi / 12));  // a unit
    const auto column = brightest % 80, row = brightest / 80;
    CHECK(std::abs(double(column) + 0.5 - (40 + h.x * pixels)) < 1.5);
    CHECK(std::abs(double(row) + 0.5 - (30 - h.y * pixels)) < 1.5);
}

TEST_CASE("a highlight's peak is k_s at any exponent, any length of the normal and any scale",
          "[regression]") {
    // C-Chads/tinygl limits the cosine before it divides by the length of the half vector: a peak
    // of 2⁻ⁿ instead of 1.
    for (const char* brdf : {"phong", "blinn-phong"})
        for (const double shininess : {1.0, 10.0, 100.0, 1000.5})
            for (const double length : {1e-20, 0.5, 1.0, 2.0, 1e20})
                for (const double scale : {1e-3, 1.0, 1e3}) {
                    Scene scene = plate(from_the_eye(), {0, 0, length});
                    set_material(scene, brdf, 0, 0.7, shininess);
                    scene.objects[0].to_world = glm::scale(glm::dmat4(1), glm::dvec3(scale));
                    scene.camera->near.reset();
                    scene.camera->far.reset();
                    CAPTURE(brdf, shininess, length, scale);
                    CHECK(middle_of(scene) == Approx(0.7).epsilon(1e-6));
                }
}

TEST_CASE("no highlight is brighter than k_s, however its cosine rounds", "[regression]") {
    // A cosine of 1 + 2⁻²³ is 1.13 to the millionth power, and no number under an arccos.
    Rng rng(51);
    for (const char* brdf : {"phong", "blinn-phong"})
        for (int k = 0; k < 100; ++k) {
            const glm::dvec3 n =
                glm::normalize(glm::dvec3(rng.real(-0.9, 0.9), rng.real(-0.9, 0.9), 1));
            // Towards where the eye's ray is mirrored.
            Light light = from_the_eye();
            light.direction = -(2 * n.z * n - glm::dvec3(0, 0, 1));
            if (light.direction.z > -0.05) continue;
            Scene scene = plate(light, n);
            set_material(scene, brdf, 0, 1, 1e6);
            CAPTURE(brdf, k);
            CHECK(middle_of(scene, RendererKind::scalar_f32) <= 1.000001);
            CHECK(middle_of(scene) == Approx(1).epsilon(1e-6));
        }
}

TEST_CASE("light falls off with the distance by each coefficient of its attenuation",
          "[regression]") {
    // In one build of C-Chads/tinygl the distance stays 0, so attenuation does nothing.
    const double c = 0.5, l = 0.25, q = 2;
    for (const RendererKind renderer : {RendererKind::scalar_f32, RendererKind::scalar_f64})
        for (const glm::dvec3& attenuation :
             {glm::dvec3(c, 0, 0), glm::dvec3(0, l, 0), glm::dvec3(0, 0, q), glm::dvec3(c, l, q)})
            for (const double d : {0.25, 1.0, 7.0}) {
                Light light;
                light.position = plate_middle + glm::dvec3(0, 0, d);
                light.attenuation = attenuation;
                Scene scene = plate(light);
                set_material(scene, "blinn-phong", 0.8, 0, 1);
                const double f_att =
                    1 / (attenuation.x + attenuation.y * d + attenuation.z * d * d);
                CAPTURE(renderer_names()[std::size_t(renderer)], d);
                CHECK(middle_of(scene, renderer) == Approx(0.8 * f_att).epsilon(1e-5));
            }
}

TEST_CASE("where nothing varies, flat, Gouraud and Phong shading show the same light",
          "[regression]") {
    // In some renderers the switch for flat faces changes their colour, too.
    Light light = from_the_eye();
    light.direction = {-0.3, 0.4, -1};
    Scene scene = plate(light);
    scene.camera->projection = Projection::orthographic;
    scene.ambient = {0.1, 0.1, 0.1};
    set_material(scene, "blinn-phong", 0.6, 0.3, 5);
    Settings settings = plate_camera.settings();
    std::set<float> radiances;
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        settings.shading = shading;
        const Framebuffer frame = draw(scene, settings).frame;
        for (const float r : frame.r) CHECK(r == Approx(double(frame.r[0])).epsilon(1e-6));
        radiances.insert(frame.r[0]);
    }
    CHECK(*radiances.rbegin() == Approx(double(*radiances.begin())).epsilon(1e-6));
    CHECK(*radiances.begin() > 0.3f);
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
    const Drawn d = draw(scene, small_picture());
    // Half way to the rim the ellipsoid's normal leans by atan(0.1·tan 30°) only.
    const double half_way = std::cos(std::atan(0.1 * std::tan(pi / 6)));
    const std::size_t at = d.frame.index(40 + 11, 30);
    CHECK(d.frame.r[at] == Approx(0.8 * half_way).epsilon(0.005));
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
        Settings settings = small_picture();
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
    const Drawn a = draw(scene, small_picture()), b = draw(directional, small_picture());
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
    const Scene scene = make_scene(soup, camera.camera);
    Settings settings = camera.settings();
    for (const Interpolation interpolation :
         {Interpolation::perspective, Interpolation::edges, Interpolation::patch})
        for (const RendererKind renderer :
             {RendererKind::simd, RendererKind::scalar_f32, RendererKind::scalar_f64}) {
            settings.interpolation = interpolation;
            settings.renderer = renderer;
            const Drawn d = draw(scene, settings);
            CAPTURE(int(interpolation), int(renderer));
            CHECK(d.stats.events[Event::zero_normal] == 24);
            CHECK(d.stats.events[Event::not_finite] == 0);
        }
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
        const Drawn d = draw(scene, small_picture());
        CHECK(d.stats.events[Event::not_finite] == 0);
        CHECK(d.frame.r[d.frame.index(40, 30)] == 0);
    }
}

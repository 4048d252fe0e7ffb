// Smooth surfaces of shapes, and the picture of them.
#include "scanshade/render/smooth.hpp"

#include <glm/glm.hpp>

#include "scanshade/eq/raycast.hpp"
#include "scanshade/image/texture.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

glm::dvec3 object_point(const Mesh& mesh, std::uint32_t v) {
    return mesh.origin + mesh.unit * glm::dvec3(mesh.x[v], mesh.y[v], mesh.z[v]);
}

/// A shape alone, lit from one direction.
Scene matt_shape(const char* name, int tessellation) {
    Material matt;
    matt.brdf = "lambert";
    matt.set("kd", {1});
    Scene scene = single_object_scene(make_shape_mesh(*find_shape(name), tessellation), matt);
    Light light;
    light.kind = LightKind::directional;
    light.direction = {-0.6, 0, -0.8};
    scene.lights = {light};
    scene.ambient = glm::dvec3(0);
    scene.camera = Camera{};
    return scene;
}

}  // namespace

TEST_CASE("the vertices of a shape lie on its smooth surface, with its normals", "[scene]") {
    for (const ShapeInfo& shape : all_shapes()) {
        if (shape.smooth == nullptr) continue;
        for (const int n : {1, 2, 5}) {
            const auto mesh = make_shape_mesh(shape, n);
            CAPTURE(shape.name, n);
            CHECK(mesh->shape == &shape);
            CHECK(mesh->tessellation == n);
            const std::size_t patches = std::size_t(shape.patches);
            REQUIRE(mesh->face_count() % patches == 0);
            double apart = 0, turned = 0;
            for (std::size_t f = 0; f < mesh->face_count(); ++f) {
                const int patch = int(f / (mesh->face_count() / patches));
                for (std::uint32_t c = mesh->face_begin[f]; c < mesh->face_begin[f + 1]; ++c) {
                    const std::uint32_t v = mesh->corner[c];
                    const SmoothPoint p =
                        shape.smooth(patch, double(mesh->u[v]), double(mesh->v[v]));
                    apart = std::max(apart, glm::distance(p.position, object_point(*mesh, v)));
                    const glm::dvec3 normal(mesh->nx[v], mesh->ny[v], mesh->nz[v]);
                    turned = std::max(turned, glm::distance(p.normal, normal));
                }
            }
            CHECK(apart < 1e-6);
            CHECK(turned < 2e-5);
        }
    }
}

TEST_CASE("derivatives of smooth surfaces are what differences say, and normals stand on them",
          "[scene]") {
    Rng random(7);
    for (const ShapeInfo& shape : all_shapes()) {
        if (shape.smooth == nullptr) continue;
        for (int trial = 0; trial < 200; ++trial) {
            const int patch = int(random.integer(0, shape.patches - 1));
            const double u = random.real(0.02, 0.98), v = random.real(0.02, 0.98);
            constexpr double h = 1e-5;
            const SmoothPoint p = shape.smooth(patch, u, v);
            const auto at = [&](double du, double dv) {
                return shape.smooth(patch, u + du, v + dv).position;
            };
            CAPTURE(shape.name, patch, u, v);
            const glm::dvec3 du = (at(h, 0) - at(-h, 0)) / (2 * h);
            const glm::dvec3 dv = (at(0, h) - at(0, -h)) / (2 * h);
            CHECK(glm::distance(p.du, du) < 1e-6 * (1 + glm::length(du)));
            CHECK(glm::distance(p.dv, dv) < 1e-6 * (1 + glm::length(dv)));
            CHECK(glm::dot(glm::cross(p.du, p.dv), p.normal) ==
                  Approx(glm::length(glm::cross(p.du, p.dv))));
        }
    }
}

TEST_CASE("a smooth sphere is shaded as the closed form says", "[render]") {
    Settings settings = small_picture();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Scene scene = matt_shape("sphere", 32);
        scene.camera->projection = projection;
        scene.objects[0].to_world[3] = glm::dvec4(0.1, -0.2, 0.3, 1);
        Framebuffer frame;
        const SmoothCounts counts = draw_smooth(scene, settings, frame);
        CHECK(counts.exact == seen(frame));
        CHECK(counts.exact > 500);
        CHECK(counts.unrefined + counts.meshes == 0);
        const double per_pixel = 2 * std::tan(glm::radians(15.0)) / settings.height;
        double worst = 0;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x) {
                const std::size_t at = frame.index(x, y);
                if (frame.id[at] == Framebuffer::no_triangle) continue;
                const double px = (x + 0.5 - settings.width / 2.0) * per_pixel;
                const double py = (settings.height / 2.0 - y - 0.5) * per_pixel;
                const bool flat = projection == Projection::orthographic;
                const Vec3<double> from{flat ? 5 * px : 0, flat ? 5 * py : 0, 5};
                const Vec3<double> to{flat ? 0 : px, flat ? 0 : py, -1};
                const Vec3<double> centre{0.1, -0.2, 0.3};
                const auto hit = ray_sphere(from, to, centre, 1.0);
                REQUIRE(hit.hit == 1);
                const Vec3<double> n = from + to * hit.t_near - centre;
                worst = std::max(
                    worst, std::abs(std::max(0.6 * n.x + 0.8 * n.z, 0.0) - double(frame.g[at])));
            }
        CHECK(worst < 1e-6);
    }
}

TEST_CASE("a smooth picture does not depend on the polygons, but at silhouettes", "[render]") {
    const Settings settings = small_picture();
    for (const char* name : {"sphere", "torus", "teapot", "cylinder", "terrain"}) {
        const int n = name == std::string_view("terrain") ? 128 : 12;  // its hills are small
        Scene coarse = matt_shape(name, n), fine = matt_shape(name, 3 * n);
        for (Scene* scene : {&coarse, &fine}) {
            scene->camera->position = {2, 2, 4};
            scene->objects[0].to_world =
                glm::dmat4{{-0.8, 0.1, 0, 0}, {0, 1.2, 0.3, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
        }
        Framebuffer a, b;
        const SmoothCounts counts = draw_smooth(coarse, settings, a);
        draw_smooth(fine, settings, b);
        std::size_t both = 0, other = 0;
        for (std::size_t i = 0; i < a.r.size(); ++i) {
            if (a.id[i] == Framebuffer::no_triangle || b.id[i] == Framebuffer::no_triangle)
                continue;
            ++both;
            other += std::abs(a.g[i] - b.g[i]) > 1e-5f;
        }
        CAPTURE(name, both, other, counts.unrefined);
        CHECK(both > 300);
        CHECK(other < both / 40);
        CHECK(counts.unrefined < both / 40);
    }
}

TEST_CASE("textures stand where the smooth surface has its coordinates", "[render]") {
    // A ramp along u, on a sphere that shows its texture alone: colour is u itself.
    MipLevel ramp{256, 1, {}};
    for (int i = 0; i < 256; ++i)
        ramp.texels.insert(ramp.texels.end(), 3, (static_cast<float>(i) + 0.5f) / 256);
    Scene scene = matt_shape("sphere", 8);
    scene.materials[0].brdf = "unlit";
    scene.materials[0].map_kd = std::make_shared<Texture>(make_texture(ramp, "ramp"));
    const Settings settings = small_picture();
    Framebuffer frame;
    draw_smooth(scene, settings, frame);
    const double per_pixel = 2 * std::tan(glm::radians(15.0)) / settings.height;
    for (int x = settings.width / 2 - 15; x < settings.width / 2 + 15; ++x) {
        const int y = settings.height / 2;
        const Vec3<double> from{0, 0, 5};
        const Vec3<double> to{(x + 0.5 - settings.width / 2.0) * per_pixel, -0.5 * per_pixel, -1};
        const auto hit = ray_sphere(from, to, Vec3<double>{0, 0, 0}, 1.0);
        const Vec3<double> p = from + to * hit.t_near;
        const double u = 0.5 + std::atan2(p.x, p.z) / (2 * std::acos(-1.0));
        CAPTURE(x, u);
        CHECK(std::abs(double(frame.r[frame.index(x, y)]) - u) < 1e-4);
    }
}

TEST_CASE("meshes from files are smooth only as their normals say", "[render]") {
    const Scene scene = lit_sphere();  // a mesh that does not know what it was made from
    Settings settings = small_picture();
    Framebuffer frame;
    const SmoothCounts counts = draw_smooth(scene, settings, frame);
    CHECK(counts.exact == 0);
    CHECK(counts.meshes == seen(frame));
    settings.renderer = RendererKind::scalar_f64;
    const Drawn phong = draw(scene, settings);
    double worst = 0;
    for (std::size_t i = 0; i < frame.r.size(); ++i)
        worst = std::max(worst, std::abs(double(frame.r[i]) - double(phong.frame.r[i])));
    CHECK(worst < 2e-3);  // corners are snapped to 1/256 pixel in the one and not in the other
    CHECK(worst > 0);
}

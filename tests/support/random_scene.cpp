#include "support/random_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "support/pictures.hpp"
#include "support/random_mesh.hpp"

namespace scanshade {
namespace {

class SceneMaker {
public:
    explicit SceneMaker(const Rng& rng) : rng_(rng) {}

    RandomScene make() {
        Scene& scene = out_.scene;
        scene.name = "random";
        for (auto n = rng_.integer(1, 4); n > 0; --n) scene.materials.push_back(material());
        for (auto n = rng_.integer(1, 4); n > 0; --n) scene.objects.push_back(object());
        for (auto n = rng_.chance(0.1) ? 0 : rng_.integer(0, 5); n > 0; --n)
            scene.lights.push_back(light());
        if (rng_.chance(0.7)) scene.ambient = colour(0.3);
        scene.camera = camera();
        set_picture(out_.settings);
        set_methods(out_.settings);
        return std::move(out_);
    }

private:
    double log_real(double low, double high) {
        return std::exp2(rng_.real(std::log2(low), std::log2(high)));
    }
    glm::dvec3 vector(double side) {
        return glm::dvec3{rng_.real(-side, side), rng_.real(-side, side), rng_.real(-side, side)};
    }
    glm::dvec3 colour(double most) {
        return glm::dvec3{rng_.real(0, most), rng_.real(0, most), rng_.real(0, most)};
    }
    /// All choices are drawn, in the order in which they stand.
    template <class T>
    T pick(std::initializer_list<T> values) {
        return values.begin()[rng_.integer(0, std::int64_t(values.size()) - 1)];
    }

    // ---- what is there
    Material material() {
        Material m;
        m.brdf = pick({"lambert", "phong", "blinn-phong", "unlit"});
        const glm::dvec3 kd = colour(1);
        m.set("kd", {kd.x, kd.y, kd.z});
        if (m.brdf != "lambert") {
            m.set("ks", {pick({0.0, 0.0, rng_.real(0, 1)})});
            m.set("shininess",
                  {pick({0.0, 1.0, 7.0, 32.0, rng_.real(0, 300), log_real(300, 20000)})});
        }
        if (rng_.chance(0.2)) m.set("ka", {rng_.real(0, 1)});
        if (rng_.chance(0.2)) m.set("emission", {rng_.real(0, 0.2)});
        if (rng_.chance(0.35)) m.map_kd = make_random_texture(rng_);
        return m;
    }

    Object object() {
        const auto materials = std::uint32_t(rng_.integer(1, 3));
        Object o;
        // Now and then a mesh stands in the scene twice.
        const bool again = !out_.scene.objects.empty() && rng_.chance(0.2);
        o.mesh = again ? out_.scene.objects.back().mesh : make_random_mesh(rng_, materials);
        for (int i = 0; i < 3; ++i)
            o.materials.push_back(
                std::uint32_t(rng_.integer(0, std::int64_t(out_.scene.materials.size()) - 1)));
        o.to_world = placement();
        if (rng_.chance(0.5)) o.shading = Shading(rng_.integer(0, 2));
        return o;
    }

    glm::dmat4 placement() {
        glm::dmat4 m(1);
        if (rng_.chance(0.2)) return m;
        m = glm::translate(m, vector(1));
        const double angle = rng_.real(0, 6.3);
        m = glm::rotate(m, angle, glm::normalize(vector(1) + 1e-3));
        const double size = rng_.chance(0.8) ? rng_.real(0.3, 1.5) : log_real(1e-4, 30);
        glm::dvec3 scale(size);
        if (rng_.chance(0.3)) scale *= glm::dvec3{1, rng_.real(0.05, 1), rng_.real(0.05, 1)};
        if (rng_.chance(0.3)) scale.x = -scale.x;
        m = glm::scale(m, scale);
        if (rng_.chance(0.15)) m[1][0] += rng_.real(-1, 1) * size;  // a shear
        return m;
    }

    /// Some vertex of some object, if there is one.
    glm::dvec3 on_surface() {
        const auto last = std::int64_t(out_.scene.objects.size()) - 1;
        const Object& o = out_.scene.objects[std::size_t(rng_.integer(0, last))];
        const Mesh& mesh = *o.mesh;
        if (mesh.vertex_count() == 0) return {0, 0, 0};
        const auto v = std::size_t(rng_.integer(0, std::int64_t(mesh.vertex_count()) - 1));
        const glm::dvec3 local(mesh.x[v], mesh.y[v], mesh.z[v]);
        return glm::dvec3(o.to_world * glm::dvec4(mesh.origin + mesh.unit * local, 1));
    }

    // ---- light
    Light light() {
        Light l;
        l.kind = LightKind(rng_.integer(0, 3));
        const glm::dvec3 touching = on_surface();
        l.position = pick({vector(1), vector(5), vector(5), vector(5), vector(1000), touching,
                           touching + vector(0.01)});
        l.direction = rng_.chance(0.5) ? -l.position + vector(0.7) : vector(1);
        if (!(glm::length(l.direction) > 1e-3)) l.direction = {0, -1, 0};
        l.intensity = rng_.chance(0.2) ? glm::dvec3(0) : colour(1);
        if (rng_.chance(0.2)) l.intensity.y = 0;
        l.attenuation = pick({glm::dvec3{1, 0, 0}, glm::dvec3{rng_.real(0.5, 2), 0, 0},
                              glm::dvec3{rng_.real(0.1, 1), rng_.real(0, 1), rng_.real(0, 1)},
                              glm::dvec3{0.01, 0, rng_.real(0.1, 1)}});
        l.cutoff_deg = pick({rng_.real(1, 40), rng_.real(1, 40), rng_.real(40, 180), 90.0, 180.0});
        l.penumbra_deg = rng_.chance(0.5) ? 0 : rng_.real(0.01, 1) * l.cutoff_deg;
        if (rng_.chance(0.3)) l.radius = log_real(1e-6, 1);
        return l;
    }

    // ---- camera
    Camera camera() {
        Camera c;
        const double distance = pick({rng_.real(0, 0.5), rng_.real(0.5, 3), rng_.real(3, 8),
                                      rng_.real(3, 8), log_real(8, 2000)});
        c.position = glm::normalize(vector(1) + 1e-3) * distance;
        c.focal_point = rng_.chance(0.15) ? vector(10) : vector(0.5);
        c.view_up = vector(1);
        c.view_angle_deg = pick({30.0, 30.0, rng_.real(5, 60), rng_.real(60, 170), 2.0});
        if (rng_.chance(0.25)) c.projection = Projection::orthographic;
        if (rng_.chance(0.4)) {
            c.near = pick({distance * rng_.real(0.3, 1.1) + 1e-3, log_real(1e-5, 1)});
            c.far = *c.near * pick({1 + rng_.real(0.05, 3), log_real(1e2, 1e6)});
        }
        return c;
    }

    void set_picture(Settings& s) {
        s.width = int(rng_.chance(0.7) ? 48 : rng_.integer(1, 96));
        s.height = int(rng_.chance(0.7) ? 32 : rng_.integer(1, 96));
        s.samples = rng_.chance(0.15) ? 4 : 1;
        s.transfer = rng_.chance(0.8) ? Transfer::srgb : Transfer::linear;
        if (rng_.chance(0.3)) s.exposure_ev = rng_.real(-2, 2);
        s.background = colour(0.5);
        s.tile = pick({16, 32, 64, 64});
        s.threads = rng_.chance(0.1) ? int(rng_.integer(2, 3)) : 1;
    }

    void set_methods(Settings& s) {
        s.shading = Shading(rng_.integer(0, 2));
        if (rng_.chance(0.5)) s.given.insert("shading");
        s.interpolation = Interpolation(rng_.integer(0, 2));
        if (rng_.chance(0.2)) s.brdf = pick({"lambert", "phong", "blinn-phong", "unlit"});
        if (rng_.chance(0.4)) s.cull = Cull::back;
    }

    Rng rng_;
    RandomScene out_;
};

}  // namespace

RandomScene make_random_scene(Rng rng) { return SceneMaker(rng).make(); }

Scene textured_scene(PolygonSoup soup, const Camera& camera, bool textured, Rng& rng) {
    for (PolygonSoup::Corner& corner : soup.corners) {
        corner.texcoord = std::uint32_t(soup.texcoords.size());
        soup.texcoords.push_back({rng.real(0, 3), rng.real(0, 3)});
    }
    Scene scene = make_scene(soup, camera);
    scene.ambient = {0.1, 0.1, 0.1};
    if (textured) scene.materials[0].map_kd = make_random_texture(rng);
    return scene;
}

std::string describe(const RandomScene& random) {
    const Settings& s = random.settings;
    std::string text =
        fmt::format("{}x{} samples {} {} {} cull {} tile {} threads {} ortho {}, {} lights;",
                    s.width, s.height, s.samples, shading_names()[std::size_t(s.shading)],
                    interpolation_names()[std::size_t(s.interpolation)], s.cull == Cull::back,
                    s.tile, s.threads, random.scene.camera->projection == Projection::orthographic,
                    random.scene.lights.size());
    for (const Object& o : random.scene.objects)
        text += fmt::format(" {} ({} triangles, {})", o.mesh->name, o.mesh->triangle_count(),
                            o.shading ? shading_names()[std::size_t(*o.shading)] : "default");
    return text;
}

}  // namespace scanshade

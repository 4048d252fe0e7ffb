// What the inspector shows of a pixel is what the renderers put there.
#include "scanshade/render/inspect.hpp"

#include <cmath>
#include <limits>

#include "scanshade/base/error.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/eq/shading.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

struct Pictures {
    Framebuffer frame[2];
    Image bytes[2];  // float, double

    Pictures(const Scene& scene, Settings settings) {
        for (int i = 0; i < 2; ++i) {
            settings.renderer = i == 0 ? RendererKind::scalar_f32 : RendererKind::scalar_f64;
            Renderer(scene, settings).draw(frame[i]);
            bytes[i] = encode(frame[i], settings.transfer, settings.exposure_ev);
        }
    }
    std::array<float, 3> radiance(int i, int x, int y) const {
        const std::size_t at = frame[i].index(x, y);
        return {frame[i].r[at], frame[i].g[at], frame[i].b[at]};
    }
    std::array<std::uint8_t, 3> byte(int i, int x, int y) const {
        const std::uint8_t* p = bytes[i].pixel(x, y);
        return {p[0], p[1], p[2]};
    }
};

template <class T>
bool nearly(T a, T b, T scale, T ulps) {
    return std::abs(a - b) <= ulps * std::numeric_limits<T>::epsilon() * std::abs(scale);
}

/// Parts add up to the bracket, the bracket times light to the term, terms to the radiance.
template <class T>
void check_sums(const PointReport<T>& point) {
    for (std::size_t c = 0; c < 3; ++c) {
        T sum = point.ambient[c] + point.emission[c];
        for (const LightAtPoint<T>& light : point.lights) {
            sum += light.term[c];
            if (!(light.cosines.n_i > 0)) {
                CHECK(light.term[c] == 0);
                continue;
            }
            CHECK(light.factor == light.f_att * light.emission);
            CHECK(light.term[c] == light.irradiance[c] * light.factor * light.f_cos[c]);
            T bracket = 0;
            for (const NamedTerm<T>& part : light.bracket.parts) bracket += part.value[c];
            CHECK(nearly(bracket, T(pi) * light.f_cos[c], bracket, T(10)));
        }
        CHECK(nearly(sum, point.radiance[c], sum, T(2) + T(point.lights.size())));
    }
}

/// (C3), (C5) across the span lead from the crossings to the sample.
template <class T>
void check_scanline(const SampleNumbers<T>& n, double x) {
    if (!n.scanline || n.travel != Travel::scanline) return;
    for (std::size_t c = 0; c < 3; ++c) {
        const T between = along_span(n.scanline->ab[c], n.scanline->cd[c], n.scanline->ab_x - T(x),
                                     n.scanline->cd_x - T(x), T(0));
        // Crossings are shown from the picture's corner, and lose the digits of that number.
        const T bound = sizeof(T) == sizeof(float) ? T(1e-3) : T(1e-10);
        CHECK(std::abs(between - n.carried[c]) <= bound);
    }
}

template <class T>
void check_numbers(const SampleNumbers<T>& n, const InspectedSample& sample) {
    for (const PointReport<T>& point : n.lit) check_sums(point);
    check_scanline(n, sample.x);
    if (sample.shading == Shading::phong)
        for (std::size_t c = 0; c < 3; ++c) CHECK(n.radiance[c] == n.lit[0].radiance[c]);
}

/// Whether something was seen there.
bool check_pixel(const Scene& scene, const Settings& settings, const Pictures& drawn, int x,
                 int y) {
    const Inspection at = inspect_pixel(scene, settings, x, y);
    CHECK(at.radiance32 == drawn.radiance(0, x, y));
    CHECK(at.radiance64 == drawn.radiance(1, x, y));
    CHECK(at.byte32 == drawn.byte(0, x, y));
    CHECK(at.byte64 == drawn.byte(1, x, y));
    REQUIRE(at.samples.size() == std::size_t(settings.samples));
    CHECK(at.samples[0].triangle == drawn.frame[0].id[drawn.frame[0].index(x, y)]);
    bool covered = false;
    for (const InspectedSample& sample : at.samples) {
        if (!sample.covered) continue;
        covered = true;
        check_numbers(sample.f32, sample);
        check_numbers(sample.f64, sample);
    }
    return covered;
}

Scene scene_with(std::string_view shape, const std::string& brdf) {
    Material material;
    material.brdf = brdf;
    Scene scene = single_object_scene(
        std::make_shared<Mesh>(build_mesh(find_shape(shape)->make(5), {})), material);
    scene.ambient = glm::dvec3(0.1, 0.05, 0.02);
    Light spot = scene.lights.front();
    spot.kind = LightKind::spot;
    spot.direction = -spot.position;
    spot.attenuation = {0.5, 0.1, 0.2};
    spot.penumbra_deg = 10;
    scene.lights.push_back(spot);
    return scene;
}

}  // namespace

TEST_CASE("the inspector's pixel is the picture's, for every shading, model and interpolation",
          "[inspect]") {
    std::vector<std::string> models{"unlit"};
    for (const BrdfInfo* brdf : all_brdfs()) models.emplace_back(brdf->name);
    for (const std::string& model : models)
        for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong})
            for (const Interpolation interpolation :
                 {Interpolation::perspective, Interpolation::edges, Interpolation::patch}) {
                CAPTURE(model, int(shading), int(interpolation));
                const Scene scene = scene_with("sphere", model);
                Settings settings;
                settings.width = 40, settings.height = 30;
                settings.shading = shading;
                settings.interpolation = interpolation;
                const Pictures drawn(scene, settings);
                CHECK(check_pixel(scene, settings, drawn, 20, 15));
                CHECK(check_pixel(scene, settings, drawn, 14, 10));
                CHECK_FALSE(check_pixel(scene, settings, drawn, 0, 0));
            }
}

TEST_CASE("the inspector's pixel is the picture's, in random scenes", "[inspect][random]") {
    int seen = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const RandomScene random = make_random_scene(seed);
        CAPTURE(describe(random));
        const Pictures drawn(random.scene, random.settings);
        const int w = random.settings.width, h = random.settings.height;
        for (const auto& [x, y] : {std::pair{w / 2, h / 2}, {w / 3, h / 2}, {w - 1, h / 4}})
            seen += check_pixel(random.scene, random.settings, drawn, x, y);
    }
    CHECK(seen > 60);
}

TEST_CASE("on a quadrilateral the inspector shows C5 as printed", "[inspect]") {
    // Corners at pixels (10, 10), (30, 12), (32, 30), (8, 28): row 20 crosses the left and the
    // right edge.
    const PixelCamera camera(40, 40);
    const PolygonSoup soup = make_soup({camera.point(10, 10, 2), camera.point(8, 28, 2),
                                        camera.point(32, 30, 2), camera.point(30, 12, 2)},
                                       {{0, 1, 2, 3}});
    const Scene scene = make_scene(soup, camera.camera);
    Settings settings = camera.settings();
    settings.interpolation = Interpolation::edges;
    const Inspection at = inspect_pixel(scene, settings, 20, 20);
    const InspectedSample& sample = at.samples.at(0);
    REQUIRE(sample.covered);
    REQUIRE(sample.corners.size() == 4);
    REQUIRE(sample.f64.scanline.has_value());
    const Scanline<double>& row = *sample.f64.scanline;
    // Corners are snapped to 1/256 pixel, so crossings are good to about that.
    CHECK(row.ab_x == Approx(10 - 2 * (20.5 - 10) / 18).margin(0.01));
    CHECK(row.cd_x == Approx(30 + 2 * (20.5 - 12) / 18).margin(0.01));
    CHECK(sample.corners[row.a].x < 11);
    CHECK(sample.corners[row.c].x > 29);
}

TEST_CASE("the inspector refuses pixels outside the picture", "[inspect]") {
    const Settings settings = small_picture();
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {80, 0}, {0, 60}})
        CHECK_THROWS_AS(inspect_pixel(lit_sphere(), settings, x, y), Error);
}

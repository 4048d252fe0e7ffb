// Gouraud and Phong interpolation of polygons that are parallel to the picture, against C2 and C3
// evaluated by hand from where the corners stand in pixels.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scanshade/render/renderer.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"

using namespace scanshade;

namespace {

constexpr int side = 65;  // odd: the picture's centre is a sample
constexpr glm::dvec3 kd{0.8, 0.5, 0.3}, intensity{1.1, 0.9, 0.7}, ambient{0.05, 0.06, 0.08};
constexpr glm::dvec3 towards_light{0.6, 0, 0.8};

/// A corner in pixels from the upper left of the picture, y down, and its normal.
struct Corner {
    glm::dvec2 at;
    glm::dvec3 normal;
};
using Polygon = std::vector<Corner>;  // counter-clockwise as seen

/// A unit normal that faces the viewer.
glm::dvec3 normal(double x, double y) { return glm::normalize(glm::dvec3(x, y, 1)); }

// Positions are multiples of 1/256 pixel, so that snapping moves nothing.
const Polygon square = {{{10, 50}, normal(-1.2, 0.3)},
                        {{50, 50}, normal(1, 0)},
                        {{50, 10}, normal(0.1, 2)},
                        {{10, 10}, normal(0.7, -0.4)}};
const Polygon slanted_quad = {{{4.25, 40.5}, normal(2, 0)},
                              {{30.125, 61.75}, normal(-0.9, 0.2)},
                              {{58.5, 30.0625}, normal(0.4, 1.5)},
                              {{22, 5.375}, normal(-0.2, -1)}};
const Polygon pentagon = {{{12.5, 20.25}, normal(1.5, 0)},
                          {{18.75, 55.125}, normal(-1, 0.5)},
                          {{47, 60.5}, normal(0, 2)},
                          {{60.375, 33.25}, normal(0.8, 0.1)},
                          {{38.25, 4.5}, normal(-0.5, -0.6)}};
// The upper edge goes through samples, which it owns.
const Polygon horizontal_edges = {{{6, 52}, normal(0.9, 0)},
                                  {{57.25, 52}, normal(-1.1, 0.3)},
                                  {{40, 8.5}, normal(0.2, 1)},
                                  {{20.5, 8.5}, normal(1.8, -0.2)}};
const Polygon pixel_wide = {{{30.25, 60}, normal(1.2, 0)},
                            {{31.25, 60}, normal(-0.8, 0)},
                            {{34.75, 5}, normal(0, 1)},
                            {{33.75, 5}, normal(0.5, 0.5)}};

struct Case {
    const char* name;
    const Polygon& polygon;
    int least_pixels;
};
const Case cases[] = {{"square", square, 1600},
                      {"slanted quad", slanted_quad, 1200},
                      {"pentagon", pentagon, 1500},
                      {"horizontal edges", horizontal_edges, 1400},
                      {"a pixel wide", pixel_wide, 50}};

/// A camera for which one unit of the plane z = 0 is a pixel, y up, 0 in the picture's centre.
Camera picture_camera() {
    Camera camera;
    camera.position = {0, 0, 100};
    camera.projection = Projection::orthographic;
    camera.view_angle_deg = glm::degrees(2 * std::atan(side / 2.0 / 100));
    return camera;
}

Framebuffer draw(const Polygon& polygon, Interpolation interpolation, Shading shading) {
    PolygonSoup soup;
    for (const Corner& corner : polygon) {
        const auto i = std::uint32_t(soup.positions.size());
        soup.positions.push_back({corner.at.x - side / 2.0, side / 2.0 - corner.at.y, 0});
        soup.normals.push_back(corner.normal);
        soup.corners.push_back({i, no_index, i});
    }
    soup.face_begin.push_back(std::uint32_t(polygon.size()));
    soup.face_material.push_back(0);

    Material material;
    material.brdf = "lambert";
    material.set("kd", {kd.x, kd.y, kd.z});
    Scene scene = single_object_scene(std::make_shared<const Mesh>(build_mesh(soup, {})), material);
    scene.camera = picture_camera();
    scene.ambient = ambient;
    Light light;
    light.kind = LightKind::directional;
    light.direction = -towards_light;
    light.intensity = intensity;
    scene.lights = {light};

    Settings settings;
    settings.width = settings.height = side;
    settings.interpolation = interpolation;
    settings.shading = shading;
    settings.renderer = RendererKind::scalar_f64;
    Framebuffer frame;
    Renderer(scene, settings).draw(frame);
    return frame;
}

/// I_a k_d + I k_d max(N·L, 0)
glm::dvec3 lambert(const glm::dvec3& N) {
    return kd * (ambient + intensity * std::max(glm::dot(glm::normalize(N), towards_light), 0.0));
}

/// What travels: colours (Gouraud) or normals (Phong).
glm::dvec3 carried(const Corner& corner, Shading shading) {
    return shading == Shading::gouraud ? lambert(corner.normal) : corner.normal;
}

glm::dvec3 shown(const glm::dvec3& value, Shading shading) {
    return shading == Shading::gouraud ? value : lambert(value);
}

/// C3 and C5: along the two edges that the scanline crosses, then across.
glm::dvec3 by_edges(const Polygon& polygon, const glm::dvec2& p, Shading shading) {
    struct Crossing {
        double x;
        glm::dvec3 value;
    };
    std::vector<Crossing> crossing;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner *A = &polygon[i], *B = &polygon[(i + 1) % polygon.size()];
        if (A->at.y > B->at.y) std::swap(A, B);
        if (!(A->at.y <= p.y && p.y < B->at.y)) continue;  // a horizontal edge is never crossed
        const double t = (p.y - A->at.y) / (B->at.y - A->at.y);
        crossing.push_back({A->at.x * (1 - t) + B->at.x * t,
                            carried(*A, shading) * (1 - t) + carried(*B, shading) * t});
    }
    REQUIRE(crossing.size() == 2);
    if (crossing[1].x < crossing[0].x) std::swap(crossing[0], crossing[1]);
    const double t = (p.x - crossing[0].x) / (crossing[1].x - crossing[0].x);
    return shown(crossing[0].value * (1 - t) + crossing[1].value * t, shading);
}

/// C2 and C4 on a quadrilateral: (u, v) by Newton's method from the middle, then bilinear.
glm::dvec3 by_patch(const Polygon& quad, const glm::dvec2& p, Shading shading) {
    const Corner &A = quad[0], &B = quad[1], &C = quad[3], &D = quad[2];  // D is opposite to A
    const auto bilinear = [](auto a, auto b, auto c, auto d, const glm::dvec2& uv) {
        return (a * (1 - uv.x) + b * uv.x) * (1 - uv.y) + (c * (1 - uv.x) + d * uv.x) * uv.y;
    };
    glm::dvec2 uv(0.5);
    for (int step = 0; step < 30; ++step) {
        const glm::dvec2 du = (B.at - A.at) * (1 - uv.y) + (D.at - C.at) * uv.y;
        const glm::dvec2 dv = (C.at - A.at) * (1 - uv.x) + (D.at - B.at) * uv.x;
        const glm::dvec2 miss = p - bilinear(A.at, B.at, C.at, D.at, uv);
        uv += glm::inverse(glm::dmat2(du, dv)) * miss;
    }
    REQUIRE(glm::distance(p, bilinear(A.at, B.at, C.at, D.at, uv)) < 1e-9);
    return shown(bilinear(carried(A, shading), carried(B, shading), carried(C, shading),
                          carried(D, shading), uv),
                 shading);
}

/// Barycentric in the fan of triangles from the first corner.
glm::dvec3 by_fan(const Polygon& polygon, const glm::dvec2& p, Shading shading) {
    const Corner& A = polygon[0];
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Corner &B = polygon[i], &C = polygon[i + 1];
        const glm::dvec2 weight = glm::inverse(glm::dmat2(B.at - A.at, C.at - A.at)) * (p - A.at);
        if (std::min({weight.x, weight.y, 1 - weight.x - weight.y}) < -1e-12) continue;
        return shown(carried(A, shading) * (1 - weight.x - weight.y) +
                         carried(B, shading) * weight.x + carried(C, shading) * weight.y,
                     shading);
    }
    FAIL("a covered sample lies outside of the polygon");
    return {};
}

using ByHand = glm::dvec3 (*)(const Polygon&, const glm::dvec2&, Shading);

/// Compares every covered sample; says how many there are and the largest difference.
struct Comparison {
    int pixels = 0;
    double worst = 0;
};
Comparison compare(const Framebuffer& frame, const Polygon& polygon, Shading shading,
                   ByHand by_hand) {
    Comparison result;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t i = frame.index(x, y);
            if (frame.id[i] == Framebuffer::no_triangle) continue;
            ++result.pixels;
            const glm::dvec3 expected = by_hand(polygon, {x + 0.5, y + 0.5}, shading);
            const glm::dvec3 got(frame.r[i], frame.g[i], frame.b[i]);
            for (int c = 0; c < 3; ++c)
                result.worst = std::max(result.worst, std::abs(got[c] - expected[c]));
        }
    return result;
}

void require_by_hand(Interpolation interpolation, ByHand for_quads, ByHand for_others) {
    for (const Shading shading : {Shading::gouraud, Shading::phong})
        for (const Case& c : cases) {
            const Comparison result =
                compare(draw(c.polygon, interpolation, shading), c.polygon, shading,
                        c.polygon.size() == 4 ? for_quads : for_others);
            CAPTURE(c.name, shading_names()[std::size_t(shading)]);
            CHECK(result.pixels >= c.least_pixels);
            CHECK(result.worst < 2e-6);  // of normals and colours kept in float
        }
}

/// A square about the centre sample, turned, with bright and dark corners in alternation.
Polygon turned_square(double degrees) {
    Polygon polygon;
    for (int corner = 0; corner < 4; ++corner) {
        const double angle = glm::radians(degrees + 45 - 90.0 * corner);
        const glm::dvec2 arm(std::cos(angle), std::sin(angle));
        polygon.push_back(
            {glm::dvec2(side / 2.0) + 25.0 * arm, corner % 2 == 0 ? towards_light : normal(-2, 0)});
    }
    return polygon;
}

double centre_of_turned_square(double degrees, Interpolation interpolation) {
    const Framebuffer frame = draw(turned_square(degrees), interpolation, Shading::gouraud);
    const std::size_t i = frame.index(side / 2, side / 2);
    REQUIRE(frame.id[i] != Framebuffer::no_triangle);
    return double(frame.r[i]);
}

}  // namespace

TEST_CASE("along edges and spans, colours and normals are C3 and C5 by hand",
          "[render][interpolation]") {
    require_by_hand(Interpolation::edges, by_edges, by_edges);
}

TEST_CASE("in a patch, colours and normals are C2 and C4 by hand; other polygons are a fan",
          "[render][interpolation]") {
    require_by_hand(Interpolation::patch, by_patch, by_fan);
}

TEST_CASE("a polygon that faces the picture is a fan of triangles in perspective",
          "[render][interpolation]") {
    require_by_hand(Interpolation::perspective, by_fan, by_fan);
}

TEST_CASE("the three interpolations of a quadrilateral are three different pictures",
          "[render][interpolation]") {
    const Framebuffer frame = draw(slanted_quad, Interpolation::edges, Shading::gouraud);
    CHECK(compare(frame, slanted_quad, Shading::gouraud, by_patch).worst > 0.05);
    CHECK(compare(frame, slanted_quad, Shading::gouraud, by_fan).worst > 0.05);
}

TEST_CASE("what edges show in the middle of a square depends on how it is turned, a patch does not",
          "[render][interpolation]") {
    const double bright = lambert(towards_light).x, dark = lambert(normal(-2, 0)).x;
    const double mean = (bright + dark) / 2;
    constexpr double snapped = 0.01;  // corners of a turned square move by up to 1/512 pixel
    CHECK(bright - dark > 0.5);
    CHECK(std::abs(centre_of_turned_square(0, Interpolation::edges) - mean) < snapped);
    // At 45° the scanline runs from one corner to the opposite one, at 135° between the others.
    const double at_45 = centre_of_turned_square(45, Interpolation::edges);
    const double at_135 = centre_of_turned_square(135, Interpolation::edges);
    CHECK(std::abs(std::max(at_45, at_135) - bright) < snapped);
    CHECK(std::abs(std::min(at_45, at_135) - dark) < snapped);
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 135.0}) {
        CAPTURE(degrees);
        CHECK(std::abs(centre_of_turned_square(degrees, Interpolation::patch) - mean) < snapped);
    }
}

TEST_CASE("each seen face that edges or patch cannot carry is counted once, in every renderer",
          "[patch]") {
    const PixelCamera camera(96, 64, 0.1);
    std::vector<glm::dvec3> positions;
    const auto add = [&](std::initializer_list<glm::dvec3> corners) {
        for (const glm::dvec3& p : corners) positions.push_back(camera.point(p.x, p.y, p.z));
    };
    // x and y in pixels, then the distance.
    add({{5, 25, 2}, {25, 28, 2}, {26, 4, 2}, {4, 3, 2}});            // convex: a patch
    add({{35, 25, 2}, {60, 20, 2}, {42, 15, 2}, {38, 3, 2}});         // a dart
    add({{68, 25, 2}, {90, 20, 2}, {68, 3, 2}, {80, 10, 2}});         // a bow tie
    add({{36, 58, 2}, {54, 36, 2}, {54, 58, 2}, {36, 36, 2}});        // one whose halves cancel
    add({{30, 60, 2}, {30, 32, 2}, {4, 32, 0.05}, {4, 60, 0.05}});    // cut by near
    add({{60, 60, 2}, {40000, 60, 2}, {40000, 34, 2}, {60, 34, 2}});  // cut by the guard band
    add({{10, 20, 3}, {20, 20, 3}, {12, 17, 3}, {10, 10, 3}});        // a dart behind the patch
    add({{110, 25, 2}, {130, 20, 2}, {115, 15, 2}, {112, 3, 2}});     // a dart beside the picture
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t v = 0; v < positions.size(); v += 4)
        faces.push_back({v, v + 1, v + 2, v + 3});
    const Scene scene = make_scene(make_soup(positions, faces), camera.camera);
    struct {
        Interpolation interpolation;
        Event event;
        std::uint64_t count;
    } constexpr rows[] = {{Interpolation::perspective, Event::patch_fallback, 0},
                          {Interpolation::perspective, Event::edges_fallback, 0},
                          {Interpolation::patch, Event::patch_fallback, 5},
                          {Interpolation::patch, Event::edges_fallback, 0},
                          // The guard band clips the coverage of a polygon only.
                          {Interpolation::edges, Event::edges_fallback, 4},
                          {Interpolation::edges, Event::patch_fallback, 0}};

    Settings settings = camera.settings();
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong})
        for (const int samples : {1, 4}) {
            settings.shading = shading;
            settings.samples = samples;
            for (const auto& row : rows) {
                settings.interpolation = row.interpolation;
                const auto counted = [&](RendererKind renderer, int tile) {
                    settings.renderer = renderer;
                    settings.tile = tile;
                    return draw(scene, settings).stats.events[row.event];
                };
                CAPTURE(int(shading), samples, int(row.interpolation), int(row.event));
                CHECK(counted(RendererKind::scalar_f64, 64) == row.count);
                CHECK(counted(RendererKind::scalar_f32, 64) == row.count);
                CHECK(counted(RendererKind::simd, 64) == row.count);
                // Several tiles, and threads, see the same face.
                CHECK(counted(RendererKind::simd, 16) == row.count);
            }
        }
}

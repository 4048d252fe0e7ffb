// Depth along the spans of a quadrilateral in float: only where it is as good as it says, and (C3) with
// differences in double elsewhere.
#include <algorithm>
#include <cmath>

#include "render/carry.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

constexpr double u = 0x1p-24;

/// A convex quadrilateral of any form, from tiny to far larger than the picture, seen from either
/// side, with depths that vary little or by a thousand.
Scene random_quad(Rng& rng, const PixelCamera& camera) {
    const double size = std::exp2(rng.real(-2, 10)), vary = std::exp2(rng.real(-8, 10));
    const double flat = rng.chance(0.3) ? std::exp2(rng.real(-8, 0)) : 1, turned = rng.real(0, 6.3);
    const double px = rng.real(0, camera.width), py = rng.real(0, camera.height);
    double angle[4];
    for (double& a : angle) a = rng.real(0, 6.283);
    std::sort(angle, angle + 4);
    if (rng.chance(0.5)) std::reverse(angle, angle + 4);
    std::vector<glm::dvec3> p;
    for (const double a : angle) {
        const double x = size * std::cos(a), y = size * flat * std::sin(a);
        p.push_back(camera.point(px + x * std::cos(turned) - y * std::sin(turned),
                                 py + x * std::sin(turned) + y * std::cos(turned),
                                 1 + rng.real(0, vary)));
    }
    return make_scene(make_soup(p, {{0, 1, 2, 3}}), camera.camera);
}

/// (C3) of the snapped corners' depths, in long double.
long double exact_depth(const DrawnFace& face, SnappedPoint p) {
    const Place<long double> at = polygon_place<long double>(face.corner, p);
    const auto depth = [&](std::uint32_t corner) {
        return (long double)(face.state[corner].depth);
    };
    return along_span(along_edge(depth(at.a), depth(at.b), at.a_y, at.b_y, at.y),
                      along_edge(depth(at.c), depth(at.d), at.c_y, at.d_y, at.y), at.ab_x, at.cd_x,
                      0.0L);
}

struct Worst {
    double served = 0, other = 0;  // in u of the smallest corner, and of the value
    int spans = 0, sums = 0;       // samples
};

void measure(TestFrame& test, Worst& worst) {
    visit_coverage(test.frame, [&](const DrawnFace& face, int y, int begin, int end) {
        if (face.carrier != Carrier::polygon) return;
        double least = 1;
        for (const VertexState& vertex : face.state) least = std::min(least, double(vertex.depth));
        for (int x = begin; x < end; ++x) {
            const SnappedPoint p = sample_point(x, y, test.frame.sample);
            const double exact = double(exact_depth(face, p));
            const double error = std::abs(double(depth_at(face, test.frame, p)) - exact) / u;
            ++(face.quad_serves ? worst.spans : worst.sums);
            double& bound = face.quad_serves ? worst.served : worst.other;
            bound = std::max(bound, error / (face.quad_serves ? least : exact));
        }
    });
}

}  // namespace

TEST_CASE("depth along spans is good to 64 u of the nearest-to-far corner, (C3) in double to 8 u",
          "[engine][numbers]") {
    const PixelCamera camera(96, 64, 0.5, 1e5);
    Rng rng(15);
    Worst worst;
    for (int k = 0; k < 6000; ++k) {
        Settings settings = camera.settings();
        settings.interpolation = Interpolation::edges;
        TestFrame test(random_quad(rng, camera), settings);
        if (test.plan.triangles > 0) measure(test, worst);
    }
    CAPTURE(worst.served, worst.other, worst.spans, worst.sums);
    CHECK(worst.spans > 10000);
    CHECK(worst.sums > 10000);
    CHECK(worst.served <= 64);
    CHECK(worst.other <= 8);
    CHECK(worst.served > 2);  // it rounds; a bound that nothing comes near says nothing
}

// Depth as a plane in float: only where it is as good as it says, and the scalar sum elsewhere.
#include <cmath>

#include "render/carry.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

constexpr double u = 0x1p-24;

/// A triangle of any form, from tiny to far larger than the picture, with depths that vary little or
/// by a thousand.
Scene random_triangle(Rng& rng, const PixelCamera& camera) {
    const double size = std::exp2(rng.real(-2, 10)), vary = std::exp2(rng.real(-8, 10));
    const double px = rng.real(0, camera.width), py = rng.real(0, camera.height);
    std::vector<glm::dvec3> p;
    for (int i = 0; i < 3; ++i) {
        const double x = px + rng.real(-size, size), y = py + rng.real(-size, size);
        p.push_back(camera.point(x, y, 1 + rng.real(0, vary)));
    }
    if (rng.chance(0.3)) p[2] = p[0] + (p[1] - p[0]) * rng.real(0, 1) + (p[2] - p[0]) * 1e-3;
    return make_scene(make_soup(p, {{0, 1, 2}}), camera.camera);
}

/// near/w at a sample from snapped corners, in long double: 2^-64 of each term.
long double exact_depth(const DrawnFace& face, SnappedPoint p) {
    long double sum = 0, area = 0;
    for (int i = 0; i < 3; ++i) {
        const auto e =
            (long double)(edge_function(face.point[(i + 1) % 3], face.point[(i + 2) % 3], p));
        sum += e * (long double)(face.state[std::size_t(i)].depth);
        area += e;
    }
    return sum / area;
}

struct Worst {
    double plane = 0, weights = 0;  // in u of the smallest corner, and of the value
    int planes = 0, sums = 0;       // samples
};

void measure(TestFrame& test, Worst& worst) {
    visit_coverage(test.frame, [&](const DrawnFace& face, int y, int begin, int end) {
        if (face.carrier != Carrier::triangle) return;
        const auto depth = [&](std::size_t i) { return double(face.state[i].depth); };
        const double least = std::min({depth(0), depth(1), depth(2)});
        for (int x = begin; x < end; ++x) {
            const SnappedPoint p = sample_point(x, y, test.frame.sample);
            const double exact = double(exact_depth(face, p));
            const double error = std::abs(double(depth_at(face, test.frame, p)) - exact) / u;
            ++(face.planar ? worst.planes : worst.sums);
            double& bound = face.planar ? worst.plane : worst.weights;
            bound = std::max(bound, error / (face.planar ? least : exact));
        }
    });
}

}  // namespace

TEST_CASE("plane depth is good to 20 u of the nearest-to-far corner, Σ λ z to 8 u of itself",
          "[engine][numbers]") {
    const PixelCamera camera(96, 64, 0.5, 1e5);
    Rng rng(5);
    Worst worst;
    for (int k = 0; k < 4000; ++k) {
        TestFrame test(random_triangle(rng, camera), camera.settings());
        if (test.plan.triangles > 0) measure(test, worst);
    }
    CHECK(worst.planes > 10000);
    CHECK(worst.sums > 10000);
    CHECK(worst.plane <= 20);
    CHECK(worst.weights <= 8);
    CAPTURE(worst.plane, worst.weights);
    CHECK(worst.plane > 1);  // it rounds; a bound that nothing comes near says nothing
}

TEST_CASE("the value of a plane is monotone along rows and columns", "[engine][numbers]") {
    // That is what the bounds of a box of samples rest on.
    Rng rng(6);
    int falls = 0;
    for (int k = 0; k < 20000; ++k) {
        const ScreenPlane<float> plane = {float(rng.real(0.1, 1)), float(rng.real(0, 1e-3)),
                                          float(rng.real(-1e-3, 1e-3))};
        const float Y = float(rng.integer(0, 100));
        for (int x = 0; x < 20; ++x)
            falls += plane_value(plane, float(x + 1), Y) < plane_value(plane, float(x), Y);
    }
    CHECK(falls == 0);
}

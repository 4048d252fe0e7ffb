#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "scanshade/scene/shapes.hpp"
#include "scene/teapot_data.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

PolygonSoup teapot(int n) { return find_shape("teapot")->make(n); }

using Patch = std::array<std::array<double, 3>, 16>;

/// Control points of a patch mirrored in the plane y = 0 of Newell's frame, rows reversed or not.
Patch patch(std::size_t number, double y_sign, bool reversed) {
    Patch points;
    for (std::size_t k = 0; k < 16; ++k) {
        const std::size_t from = reversed ? k / 4 * 4 + 3 - k % 4 : k;
        const double* p = teapot_points[teapot_patches[number][from]];
        points[k] = {p[0], y_sign * p[1] + 0.0, p[2]};
    }
    return points;
}

}  // namespace

TEST_CASE("the teapot's figures: 32 patches over 302 of 306 points", "[teapot]") {
    CHECK(std::size(teapot_points) == 306);
    CHECK(std::size(teapot_patches) == 32);
    std::set<std::uint16_t> used;
    for (const auto& points : teapot_patches) used.insert(std::begin(points), std::end(points));
    CHECK(used.size() == 302);
    CHECK(*used.rbegin() == 305);
    double x[2] = {0, 0}, y = 0, z[2] = {9, 0};
    for (const auto& p : teapot_points) {
        x[0] = std::min(x[0], p[0]);
        x[1] = std::max(x[1], p[0]);
        y = std::max(y, std::abs(p[1]));
        z[0] = std::min(z[0], p[2]);
        z[1] = std::max(z[1], p[2]);
    }
    CHECK((x[0] == -3 && x[1] == 3.525 && y == 2 && z[0] == 0 && z[1] == 3.15));
}

TEST_CASE("the teapot's figures are symmetrical from left to right", "[teapot]") {
    std::set<Patch> patches;
    for (std::size_t k = 0; k < 32; ++k) patches.insert(patch(k, 1, false));
    REQUIRE(patches.size() == 32);
    for (std::size_t k = 0; k < 32; ++k) {
        INFO("patch " << k);
        CHECK(patches.count(patch(k, -1, true)) == 1);
    }
}

TEST_CASE("the teapot stands on its bottom, with the spout along +x", "[teapot]") {
    const PolygonSoup soup = teapot(20);
    glm::dvec3 low(9), high(-9);
    for (const glm::dvec3& p : soup.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    CHECK(low.x == Approx(-1).margin(1e-3));       // the handle
    CHECK(high.x == Approx(1.1447).margin(1e-3));  // the tip of the spout
    CHECK(low.y == Approx(-0.525));
    CHECK(high.y == Approx(0.525));
    CHECK(high.z == Approx(2.0 / 3).margin(1e-3));
    CHECK(low.z == -high.z);
}

TEST_CASE("the teapot's poles look up and down", "[teapot]") {
    const PolygonSoup soup = teapot(6);
    int top = 0, bottom = 0;
    for (const PolygonSoup::Corner& c : soup.corners) {
        const glm::dvec3& p = soup.positions[c.position];
        if (p.x != 0 || p.z != 0 || std::abs(std::abs(p.y) - 0.525) > 1e-12) continue;
        const double up = p.y > 0 ? 1 : -1;
        (p.y > 0 ? top : bottom)++;
        CHECK(glm::length(soup.normals[c.normal] - glm::dvec3(0, up, 0)) < 1e-12);
    }
    CHECK(top == 4 * 6);
    CHECK(bottom == 4 * 6);
}

TEST_CASE("patches of the teapot's body meet with one tangent plane", "[teapot]") {
    const PolygonSoup soup = teapot(6);
    std::map<std::uint32_t, std::vector<glm::dvec3>> normals;
    for (const PolygonSoup::Corner& c : soup.corners)
        normals[c.position].push_back(soup.normals[c.normal]);
    double smallest = 1;
    int positions = 0;
    for (const auto& [number, at] : normals) {
        const glm::dvec3& p = soup.positions[number];
        // The barrel between foot and rim, handle and spout left out.
        if (p.y < -0.45 || p.y > 0.27 || std::abs(p.z) < 0.25) continue;
        ++positions;
        for (const glm::dvec3& n : at) smallest = std::min(smallest, glm::dot(n, at[0]));
    }
    CHECK(positions > 50);
    CHECK(smallest > 1 - 1e-12);
}

TEST_CASE("finer teapots pass through the points of coarser ones", "[teapot]") {
    const auto key = [](const glm::dvec3& p) {
        return std::array{std::llround(p.x * 1e12), std::llround(p.y * 1e12),
                          std::llround(p.z * 1e12)};
    };
    std::set<std::array<long long, 3>> fine;
    for (const glm::dvec3& p : teapot(8).positions) fine.insert(key(p));
    const PolygonSoup coarse = teapot(4);
    CHECK(std::all_of(coarse.positions.begin(), coarse.positions.end(),
                      [&](const glm::dvec3& p) { return fine.count(key(p)) == 1; }));
}

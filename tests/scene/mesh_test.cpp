#include "scanshade/scene/mesh.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "scanshade/base/timer.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

using Corner = PolygonSoup::Corner;

/// Positions with faces given as lists of position numbers.
PolygonSoup soup_of(std::vector<glm::dvec3> positions,
                    std::initializer_list<std::initializer_list<std::uint32_t>> faces) {
    PolygonSoup soup;
    soup.positions = std::move(positions);
    for (const auto& face : faces) {
        for (const std::uint32_t p : face) soup.corners.push_back({p, no_index, no_index});
        soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
        soup.face_material.push_back(0);
    }
    return soup;
}

PolygonSoup cube() {
    std::vector<glm::dvec3> positions;
    for (int i = 0; i < 8; ++i) positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    return soup_of(
        positions,
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// Two unit squares that share the y axis; the right one is turned up by `fold`.
PolygonSoup hinge(double fold_deg) {
    const double a = fold_deg * 3.141592653589793 / 180;
    return soup_of({{-1, 0, 0},
                    {0, 0, 0},
                    {0, 1, 0},
                    {-1, 1, 0},
                    {std::cos(a), 0, std::sin(a)},
                    {std::cos(a), 1, std::sin(a)}},
                   {{0, 1, 2, 3}, {1, 4, 5, 2}});
}

glm::dvec3 normal(const Mesh& mesh, std::size_t corner) {
    const std::uint32_t v = mesh.corner[corner];
    return {mesh.nx[v], mesh.ny[v], mesh.nz[v]};
}

glm::dvec3 face_normal(const Mesh& mesh, std::size_t face) {
    const auto& n = mesh.face_normal[face];
    return {n[0], n[1], n[2]};
}

glm::dvec3 position(const Mesh& mesh, std::size_t corner) {
    const std::uint32_t v = mesh.corner[corner];
    return mesh.origin + mesh.unit * glm::dvec3(mesh.x[v], mesh.y[v], mesh.z[v]);
}

void check_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-7) {
    CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
    CHECK(glm::length(a - b) <= tolerance);
}

}  // namespace

TEST_CASE("a mesh keeps polygons, their order and their triangles", "[mesh]") {
    PolygonSoup soup =
        soup_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
    soup.face_material = {3, 1};
    soup.name = "two";
    const Mesh mesh = build_mesh(soup, {});
    CHECK(mesh.name == "two");
    CHECK(mesh.face_begin == std::vector<std::uint32_t>{0, 4, 7});
    CHECK(mesh.corner == std::vector<std::uint32_t>{0, 1, 2, 3, 1, 4, 2});  // order of first use
    CHECK(mesh.face_material == std::vector<std::uint32_t>{3, 1});
    CHECK(mesh.triangle_face == std::vector<std::uint32_t>{0, 0, 1});
    CHECK(mesh.face_first_triangle == std::vector<std::uint32_t>{0, 2, 3});
    CHECK(mesh.triangle[2] == std::array<std::uint32_t, 3>{1, 4, 2});
    CHECK(mesh.vertex_count() == 5);
    CHECK_FALSE(mesh.has_texcoords);
    check_near(face_normal(mesh, 0), {0, 0, 1}, 0);
    CHECK(mesh.origin == glm::dvec3(1, 0.5, 0));
    CHECK(mesh.unit == 1);
    CHECK(mesh.face_centre[0] == std::array<float, 3>{-0.5f, 0, 0});
    for (std::size_t c = 0; c < 7; ++c)
        check_near(position(mesh, c), soup.positions[soup.corners[c].position], 0);
}

TEST_CASE("scaling the input by a power of two changes nothing but the unit", "[mesh]") {
    PolygonSoup soup = hinge(35);
    for (glm::dvec3& p : soup.positions) p = p * 0.7 + glm::dvec3(12.3, -4.56, 0.789);
    for (const auto source : {NormalSource::automatic, NormalSource::area, NormalSource::angle})
        for (const int exponent : {-320, -31, 1, 40, 320}) {
            CAPTURE(int(source), exponent);
            PolygonSoup scaled = soup;
            for (glm::dvec3& p : scaled.positions) p *= std::ldexp(1.0, exponent);
            const Mesh a = build_mesh(soup, {source, 60}), b = build_mesh(scaled, {source, 60});
            CHECK(b.unit == std::ldexp(a.unit, exponent));
            CHECK((a.x == b.x && a.y == b.y && a.z == b.z));
            CHECK((a.nx == b.nx && a.ny == b.ny && a.nz == b.nz));
            CHECK((a.face_normal == b.face_normal && a.face_centre == b.face_centre));
            CHECK((a.corner == b.corner && a.triangle == b.triangle));
        }
}

TEST_CASE("coordinates lie in [-1, 1] and touch its outer half", "[mesh]") {
    for (const double size : {1e-200, 0.3, 1.0, 7.0, 1e39, 1e100}) {
        CAPTURE(size);
        PolygonSoup soup = soup_of({{0, 0, 0}, {size, 0, 0}, {0, size / 3, 0}}, {{0, 1, 2}});
        const Mesh mesh = build_mesh(soup, {});
        REQUIRE(mesh.triangle_count() == 1);
        float largest = 0;
        for (const auto* axis : {&mesh.x, &mesh.y, &mesh.z})
            for (const float x : *axis) largest = std::max(largest, std::abs(x));
        CHECK(largest <= 1);
        CHECK(largest > 0.5f);
        check_near(face_normal(mesh, 0), {0, 0, 1}, 0);
    }
}

TEST_CASE("positions that no face uses do not move the frame", "[mesh]") {
    PolygonSoup soup = soup_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1e9, 0, 0}}, {{0, 1, 2}});
    CHECK(build_mesh(soup, {}).origin == glm::dvec3(1, 1, 0));
}

TEST_CASE("degenerate faces are left out and counted", "[mesh]") {
    const Mesh mesh = build_mesh(
        soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}, {0, 0, 0}},
                {{0, 1}, {}, {0, 1, 0}, {0, 1, 1}, {0, 5, 1}, {0, 3, 4}, {0, 1, 2}}),
        {});
    CHECK(mesh.face_count() == 1);
    CHECK(mesh.events[Event::degenerate_face] == 6);
    CHECK(mesh.face_first_triangle == std::vector<std::uint32_t>{0, 1});
    const Mesh empty = build_mesh(soup_of({{0, 0, 0}}, {{0, 0, 0}}), {});
    CHECK(empty.face_count() == 0);
    CHECK(empty.unit == 1);
}

TEST_CASE("a needle of a face has area and is kept", "[mesh]") {
    const Mesh mesh = build_mesh(soup_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-10, 0}}, {{0, 1, 2}}), {});
    REQUIRE(mesh.face_count() == 1);
    check_near(face_normal(mesh, 0), {0, 0, 1}, 0);
}

TEST_CASE("a cube has sharp edges by default and round ones without a crease", "[mesh][normals]") {
    const Mesh sharp = build_mesh(cube(), {});
    CHECK(sharp.vertex_count() == 24);
    for (std::size_t c = 0; c < sharp.corner.size(); ++c)
        check_near(normal(sharp, c), face_normal(sharp, c / 4), 0);
    const Mesh round = build_mesh(cube(), {NormalSource::automatic, 180});
    CHECK(round.vertex_count() == 8);
    for (std::size_t c = 0; c < round.corner.size(); ++c)
        check_near(normal(round, c), glm::normalize(position(round, c) - 0.5));
}

TEST_CASE("faces share a normal up to the crease angle and not beyond", "[mesh][normals]") {
    for (const double fold : {30.0, 59.9, 60.0, 90.0}) {
        CAPTURE(fold);
        const Mesh shared = build_mesh(hinge(fold), {NormalSource::automatic, fold});
        CHECK(shared.vertex_count() == 6);
        check_near(normal(shared, 1),
                   glm::normalize(face_normal(shared, 0) + face_normal(shared, 1)));
        CHECK(build_mesh(hinge(fold), {NormalSource::automatic, fold - 0.1}).vertex_count() == 8);
    }
}

TEST_CASE("the crease rule does not depend on the order of faces", "[mesh][normals]") {
    // A chain of three faces around an edge, 50 degrees apart: the middle one shares with both,
    // the outer ones with the middle one alone.
    const auto direction = [](double degrees) {
        return glm::dvec3(std::cos(degrees * 0.017453292519943295), 0,
                          std::sin(degrees * 0.017453292519943295));
    };
    std::vector<glm::dvec3> positions{{0, 0, 0}, {0, 1, 0}};
    for (const double angle : {0.0, 50.0, 100.0}) {
        positions.push_back(direction(angle));
        positions.push_back(direction(angle) + glm::dvec3(0, 1, 0));
    }
    const Mesh forward =
        build_mesh(soup_of(positions, {{0, 2, 3, 1}, {0, 4, 5, 1}, {0, 6, 7, 1}}), {});
    const Mesh backward =
        build_mesh(soup_of(positions, {{0, 6, 7, 1}, {0, 4, 5, 1}, {0, 2, 3, 1}}), {});
    for (std::size_t f = 0; f < 3; ++f)
        check_near(normal(forward, 4 * f), normal(backward, 4 * (2 - f)));
    const glm::dvec3 n[3] = {face_normal(forward, 0), face_normal(forward, 1),
                             face_normal(forward, 2)};
    check_near(normal(forward, 0), glm::normalize(n[0] + n[1]));
    check_near(normal(forward, 4), glm::normalize(n[0] + n[1] + n[2]));
    check_near(normal(forward, 8), glm::normalize(n[1] + n[2]));
}

TEST_CASE("(C1) sums over polygons, not over their triangles", "[mesh][normals]") {
    // At the cube's corners each of three quads counts once, although one or two of its triangles
    // meet there; with triangles the sum would lean.
    const Mesh mesh = build_mesh(cube(), {NormalSource::average, 180});
    check_near(normal(mesh, 0), glm::normalize(glm::dvec3(-1)));
}

TEST_CASE("a face that visits a position twice counts once in (C1)", "[mesh][normals]") {
    PolygonSoup soup = hinge(40);
    soup.corners.insert(soup.corners.begin() + 1, soup.corners[1]);  // 0 1 1 2 3
    soup.face_begin = {0, 5, 9};
    const Mesh mesh = build_mesh(soup, {});
    check_near(normal(mesh, 1), glm::normalize(face_normal(mesh, 0) + face_normal(mesh, 1)));
    CHECK(mesh.vertex_count() == 6);
}

TEST_CASE("the three weights differ as they should", "[mesh][normals]") {
    // Around (0,0,0): a large square in z = 0 and a small right triangle in x = 0 with the angle
    // 45 degrees there.
    const PolygonSoup soup =
        soup_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 1, 1}}, {{0, 1, 2, 3}, {0, 3, 4}});
    const glm::dvec3 a(0, 0, 1), b(1, 0, 0);
    const auto at_origin = [&](NormalSource source) {
        return normal(build_mesh(soup, {source, 180}), 0);
    };
    check_near(at_origin(NormalSource::average), glm::normalize(a + b));
    check_near(at_origin(NormalSource::area), glm::normalize(16.0 * a + 2.0 * b));
    check_near(at_origin(NormalSource::angle), glm::normalize(90.0 * a + 45.0 * b));
    // The crease angle applies to weighted sums too.
    check_near(normal(build_mesh(soup, {NormalSource::area, 60}), 0), a, 0);
}

TEST_CASE("a reflex corner weighs by the angle inside", "[mesh][normals]") {
    // An L in z = 0 with 270 degrees at its inner corner, and a square in the plane y = 1 there.
    const PolygonSoup soup = soup_of(
        {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {2, 1, 1}, {1, 1, 1}},
        {{0, 1, 2, 3, 4, 5}, {3, 2, 6, 7}});
    const Mesh mesh = build_mesh(soup, {NormalSource::angle, 180});
    check_near(normal(mesh, 3),
               glm::normalize(270.0 * glm::dvec3(0, 0, 1) + 90.0 * glm::dvec3(0, -1, 0)));
}

TEST_CASE("smoothing groups decide where the file has them", "[mesh][normals]") {
    PolygonSoup soup = cube();
    soup.face_smoothing = {1, 1, 1, 1, 1, 1};
    CHECK(build_mesh(soup, {}).vertex_count() == 8);  // no crease angle with groups
    soup.face_smoothing = {0, 0, 0, 0, 0, 0};
    CHECK(build_mesh(soup, {NormalSource::automatic, 180}).vertex_count() == 24);
    soup.face_smoothing = {1, 2, 1, 2, 0, 0};
    const Mesh mesh = build_mesh(soup, {});
    const glm::dvec3 bottom_front = glm::normalize(glm::dvec3(0, -1, -1));
    check_near(normal(mesh, 0), bottom_front);    // position 0 of face 0, group 1
    check_near(normal(mesh, 8), bottom_front);    // position 0 of face 2, group 1
    check_near(normal(mesh, 16), {-1, 0, 0}, 0);  // position 0 of face 4, off
    check_near(normal(mesh, 1), {0, 0, -1}, 0);   // face 3 has another group there
    // Forced recomputation ignores groups.
    CHECK(build_mesh(soup, {NormalSource::average, 180}).vertex_count() == 8);
}

TEST_CASE("normals of the file come first, whatever their length", "[mesh][normals]") {
    PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    soup.normals = {{1e300, 0, 1e300}, {0, -3e-300, 0}, {0, 0, 0}};
    for (std::uint32_t c = 0; c < 3; ++c) soup.corners[c].normal = c;
    const Mesh mesh = build_mesh(soup, {});
    check_near(normal(mesh, 0), glm::normalize(glm::dvec3(1, 0, 1)));
    check_near(normal(mesh, 1), {0, -1, 0}, 0);
    check_near(normal(mesh, 2), {0, 0, 1}, 0);
    CHECK(mesh.events[Event::repaired_normal] == 1);
    CHECK(mesh.events[Event::cancelled_normal] == 0);
    const Mesh forced = build_mesh(soup, {NormalSource::average, 60});
    for (std::size_t c = 0; c < 3; ++c) check_near(normal(forced, c), {0, 0, 1}, 0);
    CHECK(forced.events[Event::repaired_normal] == 0);
    // A corner without one is computed, the others stay.
    soup.corners[0].normal = no_index;
    check_near(normal(build_mesh(soup, {}), 0), {0, 0, 1}, 0);
    check_near(normal(build_mesh(soup, {}), 1), {0, -1, 0}, 0);
}

TEST_CASE("opposite normals that cancel fall back to the face normal", "[mesh][normals]") {
    // A sheet with a front and a back that share their vertices.
    PolygonSoup sheet = soup_of({{0, 0, 0}, {1, 0.1, 0.3}, {0.2, 1, 0.1}}, {{0, 1, 2}, {2, 1, 0}});
    const Mesh mesh = build_mesh(sheet, {NormalSource::automatic, 180});
    CHECK(mesh.vertex_count() == 6);
    CHECK(mesh.events[Event::cancelled_normal] == 6);
    for (std::size_t c = 0; c < 6; ++c) check_near(normal(mesh, c), face_normal(mesh, c / 3), 0);
    // The default crease angle keeps the sides apart: nothing cancels.
    CHECK(build_mesh(sheet, {}).events[Event::cancelled_normal] == 0);
    // Also where the sum is exactly 0.
    const PolygonSoup flat = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}});
    CHECK(build_mesh(flat, {}).events[Event::cancelled_normal] == 0);
    CHECK(build_mesh(flat, {NormalSource::average, 180}).events[Event::cancelled_normal] == 6);
    sheet.face_smoothing = {5, 5};
    CHECK(build_mesh(sheet, {}).events[Event::cancelled_normal] == 6);
}

TEST_CASE("vertices are joined by position, normal and texture coordinate", "[mesh]") {
    PolygonSoup soup = hinge(0);
    soup.texcoords = {{0, 0}, {0.25, 0.75}, {1e39, -1e39}};
    for (Corner& c : soup.corners) c.texcoord = 0;
    CHECK(build_mesh(soup, {}).vertex_count() == 6);
    soup.corners[4].texcoord = 1;  // position 1 has two texture coordinates now
    soup.corners[5].texcoord = 2;
    const Mesh mesh = build_mesh(soup, {});
    CHECK(mesh.vertex_count() == 7);
    CHECK(mesh.has_texcoords);
    CHECK(mesh.u[mesh.corner[4]] == 0.25f);
    CHECK(mesh.v[mesh.corner[4]] == 0.75f);
    CHECK(std::isfinite(mesh.u[mesh.corner[5]]));
}

TEST_CASE("every number of a mesh is finite and every normal has unit length", "[mesh]") {
    for (const double crease : {0.0, 60.0, 180.0})
        for (const auto source :
             {NormalSource::automatic, NormalSource::area, NormalSource::angle}) {
            const Mesh mesh = build_mesh(hinge(77), {source, crease});
            for (std::size_t c = 0; c < mesh.corner.size(); ++c)
                CHECK(glm::length(normal(mesh, c)) == Approx(1).epsilon(1e-6));
        }
}

TEST_CASE("many faces around one position take no quadratic time", "[mesh][normals]") {
    // A steep cone of 100 000 faces: every pair of them would be 10^10 tests.
    constexpr std::uint32_t n = 100'000;
    PolygonSoup cone;
    cone.positions.emplace_back(0, 0, 10);
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n;
        cone.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        for (const std::uint32_t p : {0u, i + 1, (i + 1) % n + 1})
            cone.corners.push_back({p, no_index, no_index});
        cone.face_begin.push_back(std::uint32_t(cone.corners.size()));
        cone.face_material.push_back(0);
    }
    const Timer timer;
    const Mesh mesh = build_mesh(cone, {});
    CHECK(mesh.triangle_count() == n);
    CHECK(timer.ms() < 5000);
    check_near(normal(mesh, 0), {0, 0, 1}, 1e-6);
}

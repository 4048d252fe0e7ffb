#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "scanshade/scene/mesh.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

using Polygon = std::vector<glm::dvec3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Polygon in_plane(std::initializer_list<glm::dvec2> points) {
    Polygon polygon;
    for (const glm::dvec2& p : points) polygon.emplace_back(p, 0);
    return polygon;
}

/// Signed area along the polygon's normal, and the sum of the triangles' unsigned areas: equal
/// exactly where no triangle is turned over or lies outside.
struct Areas {
    double polygon = 0, triangles = 0;
};

Areas areas(const Polygon& polygon, const Triangles& triangles) {
    Areas a;
    a.polygon = glm::length(newell_normal(polygon)) / 2;
    for (const auto& t : triangles)
        a.triangles +=
            glm::length(glm::cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]])) /
            2;
    return a;
}

/// Every outline edge belongs to one triangle, every other edge to two in opposite directions, so
/// that a closed mesh stays closed.
bool is_closed_up(std::size_t corners, const Triangles& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    for (std::uint32_t i = 0; i < corners; ++i) --edges[{i, std::uint32_t((i + 1) % corners)}];
    for (const auto& [edge, count] : edges)
        if (count != 0 && edges[{edge.second, edge.first}] != count) return false;
    return true;
}

void check_triangulation(const Polygon& polygon, bool concave) {
    EventCounts events;
    const Triangles triangles = triangulate(polygon, events);
    REQUIRE(triangles.size() == polygon.size() - 2);
    std::set<std::uint32_t> used;
    for (const auto& t : triangles) used.insert(t.begin(), t.end());
    CHECK(used.size() == polygon.size());
    CHECK(is_closed_up(polygon.size(), triangles));
    const Areas a = areas(polygon, triangles);
    CHECK(a.triangles == Approx(a.polygon).epsilon(1e-6));
    CHECK(events[Event::concave_face] == (concave ? 1 : 0));
    CHECK(events[Event::self_crossing_face] == 0);
}

/// A star-shaped outline whose corners are far out and far in by turns.
Polygon random_star(std::mt19937& random, int n) {
    std::uniform_real_distribution<double> outer(0.6, 1), inner(0.1, 0.3);
    Polygon polygon;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979 * i / n,
                     r = i % 2 ? inner(random) : outer(random);
        polygon.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    return polygon;
}

}  // namespace

TEST_CASE("a convex polygon gives the fan from its first corner", "[mesh][triangulate]") {
    EventCounts events;
    const Polygon pentagon = in_plane({{0, 0}, {2, 0}, {3, 1}, {1, 3}, {-1, 1}});
    CHECK(triangulate(pentagon, events) == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
    CHECK(events == EventCounts{});
    CHECK(triangulate({}, events).empty());
    CHECK(triangulate(in_plane({{0, 0}, {1, 0}}), events).empty());
    CHECK(triangulate(in_plane({{0, 0}, {1, 0}, {0, 1}}), events) == Triangles{{0, 1, 2}});
}

TEST_CASE("a concave quadrilateral is cut through its reflex corner", "[mesh][triangulate]") {
    // Wherever the outline starts: the fan from corner 0 would be wrong for half of the starts.
    const Polygon arrow = in_plane({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}});
    for (std::size_t start = 0; start < 4; ++start) {
        CAPTURE(start);
        Polygon turned;
        for (std::size_t i = 0; i < 4; ++i) turned.push_back(arrow[(start + i) % 4]);
        check_triangulation(turned, true);
    }
}

TEST_CASE("triangulation does not depend on place, scale or plane", "[mesh][triangulate]") {
    const Polygon comb = in_plane({{0, 0},
                                   {7, 0},
                                   {7, 3},
                                   {6, 3},
                                   {6, 1},
                                   {5, 1},
                                   {5, 3},
                                   {4, 3},
                                   {4, 1},
                                   {3, 1},
                                   {3, 3},
                                   {2, 3},
                                   {2, 1},
                                   {1, 1},
                                   {1, 3},
                                   {0, 3}});
    EventCounts events;
    const Triangles expected = triangulate(comb, events);
    check_triangulation(comb, true);
    for (const double scale : {0x1p-300, 0x1p-40, 0x1p40, 0x1p300})
        for (const double offset : {0.0, 1e9 * scale}) {
            CAPTURE(scale, offset);
            Polygon moved;
            for (const glm::dvec3& p : comb) moved.push_back(p * scale + offset);
            CHECK(triangulate(moved, events) == expected);
        }
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        Polygon turned;
        for (const glm::dvec3& p : comb)
            turned.emplace_back(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
        check_triangulation(turned, true);
        std::reverse(turned.begin(), turned.end());  // the normal points the other way
        check_triangulation(turned, true);
    }
}

TEST_CASE("collinear and repeated corners lose no area", "[mesh][triangulate]") {
    // On an edge of a convex outline: still the fan.
    check_triangulation(in_plane({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), false);
    check_triangulation(in_plane({{0, 0}, {2, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 2}, {0, 0}}), false);
    // On the edges of an L, doubled.
    check_triangulation(in_plane({{0, 0},
                                  {1, 0},
                                  {2, 0},
                                  {2, 0},
                                  {2, 1},
                                  {1.5, 1},
                                  {1, 1},
                                  {1, 1},
                                  {1, 1.5},
                                  {1, 2},
                                  {0.5, 2},
                                  {0, 2},
                                  {0, 2},
                                  {0, 1}}),
                        true);
    // A spike: out and back along the same line.
    EventCounts events;
    const Polygon spiked = in_plane({{0, 0}, {2, 0}, {2, 1}, {4, 1}, {2, 1}, {2, 2}, {0, 2}});
    const Triangles triangles = triangulate(spiked, events);
    CHECK(triangles.size() == 5);
    CHECK(areas(spiked, triangles).triangles == Approx(4.0));
}

TEST_CASE("a hole that a cut joins to the outline stays open", "[mesh][triangulate]") {
    check_triangulation(
        in_plane({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}),
        true);
}

TEST_CASE("an outline that crosses itself is counted and still gives n - 2 triangles",
          "[mesh][triangulate]") {
    EventCounts events;
    const Polygon bow_tie = in_plane({{0, 0}, {4, 3}, {4, 0}, {0, 2}});
    CHECK(triangulate(bow_tie, events).size() == 2);
    CHECK(events[Event::self_crossing_face] == 1);
    Polygon pentagram;
    for (int i = 0; i < 5; ++i)
        pentagram.emplace_back(std::cos(2.513274122871834 * i), std::sin(2.513274122871834 * i), 0);
    CHECK(triangulate(pentagram, events).size() == 3);
    CHECK(events[Event::self_crossing_face] == 2);
    const Polygon line = in_plane({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
    CHECK(triangulate(line, events).size() == 2);
}

TEST_CASE("a rectangle whose corners come in the wrong order is drawn, and counted as what it is",
          "[mesh][triangulate]") {
    // Bow ties whose halves cancel, in several planes: each is as its first three corners face.
    const glm::dvec3 a(1, 2, 3), right(2, 0, 1), up(0, 3, 0.5);
    const Polygon bow_ties[] = {{a, a + right + up, a + right, a + up},
                                {a, a + right, a + up, a + right + up},
                                {a, a + 3.0 * right + up, a + right, a + up}};
    for (const Polygon& polygon : bow_ties) {
        EventCounts events;
        const Triangles triangles = triangulate(polygon, events);
        CHECK(triangles.size() == 2);
        CHECK(is_closed_up(4, triangles));
        CHECK(events[Event::self_crossing_face] == 1);
        const glm::dvec3 first = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
        CHECK(glm::distance(newell_normal(polygon), first) < 1e-12);
    }
    // What goes back the way it came encloses nothing.
    CHECK(newell_normal({a, a + right, a + up, a + right}) == glm::dvec3(0));
    CHECK(newell_normal({a, a + up, a, a + right}) == glm::dvec3(0));
    CHECK(newell_normal({a, a + right, a + 3.0 * right, a + 2.0 * right}) == glm::dvec3(0));
}

TEST_CASE("random concave outlines are covered once", "[mesh][triangulate]") {
    constexpr unsigned seed = 20240611;
    INFO("seed " << seed);
    std::mt19937 random(seed);
    for (int n = 9; n < 300; n += 7) {
        CAPTURE(n);
        Polygon star = random_star(random, n);
        for (glm::dvec3& p : star) p = p * 1e-3 + glm::dvec3(1e4, -2e5, 3e4);  // far away
        check_triangulation(star, true);
    }
}

TEST_CASE("random corners in any order end in n - 2 triangles", "[mesh][triangulate]") {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coordinate(0, 6);  // many coincide or are collinear
    for (int round = 0; round < 2000; ++round) {
        Polygon polygon;
        for (int i = 0; i < 4 + round % 20; ++i)
            polygon.emplace_back(coordinate(random), coordinate(random), coordinate(random) / 6);
        EventCounts events;
        const Triangles triangles = triangulate(polygon, events);
        REQUIRE(triangles.size() == polygon.size() - 2);
        REQUIRE(is_closed_up(polygon.size(), triangles));
    }
}

TEST_CASE("a large hostile outline takes bounded time", "[mesh][triangulate]") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> coordinate(0, 1);
    Polygon tangle;
    for (int i = 0; i < 20000; ++i) tangle.emplace_back(coordinate(random), coordinate(random), 0);
    EventCounts events;
    CHECK(triangulate(tangle, events).size() == 19998);
    CHECK(events[Event::self_crossing_face] == 1);
    check_triangulation(random_star(random, 4001), true);
}

TEST_CASE("Newell's normal is twice the area long", "[mesh][triangulate]") {
    const auto n = newell_normal({{5, 5, 1}, {7, 5, 1}, {7, 8, 1}, {5, 8, 1}});
    CHECK(n == glm::dvec3(0, 0, 12));
    // A polygon that is not planar, far away: the offset has no influence.
    const Polygon saddle{{0, 0, 1}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
    Polygon far;
    for (const glm::dvec3& p : saddle) far.push_back(p + 0x1p40);
    CHECK(newell_normal(far) == newell_normal(saddle));
    CHECK(newell_normal({{0, 0, 0}, {1, 1, 1}}) == glm::dvec3(0));
    // Twice this area is more than a double holds; its direction is still there.
    CHECK(std::isinf(newell_normal({{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}).z));
}

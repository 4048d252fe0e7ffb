#include "scanshade/scene/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "support/catch.hpp"

using namespace scanshade;

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// How often each directed edge, by position number, belongs to a face.
std::map<Edge, int> directed_edges(const PolygonSoup& soup) {
    std::map<Edge, int> count;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const std::uint32_t begin = soup.face_begin[f], end = soup.face_begin[f + 1];
        for (std::uint32_t c = begin; c < end; ++c)
            ++count[{soup.corners[c].position, soup.corners[c + 1 < end ? c + 1 : begin].position}];
    }
    return count;
}

/// Edges of one face alone.
std::size_t border_edges(const PolygonSoup& soup) {
    const std::map<Edge, int> edges = directed_edges(soup);
    return std::size_t(std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
        return edges.count({edge.first.second, edge.first.first}) == 0;
    }));
}

std::vector<glm::dvec3> face_positions(const PolygonSoup& soup, std::size_t face) {
    std::vector<glm::dvec3> points;
    for (std::uint32_t c = soup.face_begin[face]; c < soup.face_begin[face + 1]; ++c)
        points.push_back(soup.positions[soup.corners[c].position]);
    return points;
}

/// By the divergence theorem; positive where faces look outward.
double volume(const PolygonSoup& soup) {
    double sum = 0;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto p = face_positions(soup, f);
        for (std::size_t k = 2; k < p.size(); ++k)
            sum += glm::dot(p[0], glm::cross(p[k - 1], p[k])) / 6;
    }
    return sum;
}

/// What the table does not say: faces at n, edges of the border at n, volume of the limit.
struct Expected {
    std::size_t (*faces)(std::size_t n);
    std::size_t (*border)(std::size_t n);  // 0: closed
    double volume;                         // 0: not closed
    int detail = 1;                        // quads are so much larger than what the shape shows
};

const std::map<std::string, Expected, std::less<>>& expected() {
    constexpr double pi = 3.14159265358979323846;
    static constexpr auto closed = [](std::size_t) { return std::size_t(0); };
    static const std::map<std::string, Expected, std::less<>> table = {
        {"sphere", {[](std::size_t n) { return 8 * n * n; }, closed, 4 * pi / 3}},
        {"torus", {[](std::size_t n) { return 32 * n * n; }, closed, 2 * pi * pi * 0.7 * 0.09}},
        // Open: rim and lid (4n each), two ends of handle and of spout (2n each).
        // One quad a patch would be a flat handle: it has 2 by 2 then.
        {"teapot",
         {[](std::size_t n) { return n > 1 ? 32 * n * n : 128; },
          [](std::size_t n) { return n > 1 ? 16 * n : 32; }, 0}},
        {"cube", {[](std::size_t n) { return 6 * n * n; }, closed, 8}},
        {"cylinder", {[](std::size_t n) { return 12 * n * n; }, closed, 2 * pi}},
        {"plane", {[](std::size_t n) { return n * n; }, [](std::size_t n) { return 4 * n; }, 0}},
        // Hills of the last octave are 1/27 wide.
        {"terrain",
         {[](std::size_t n) { return n * n; }, [](std::size_t n) { return 4 * n; }, 0, 16}},
        // Open: the room's front and the undersides of two blocks.
        {"cornell-box",
         {[](std::size_t n) { return 19 * n * n; }, [](std::size_t n) { return 12 * n; }, 0}},
    };
    return table;
}

constexpr int some_tessellations[] = {1, 2, 3, 7, 16};

}  // namespace

TEST_CASE("each shape is found by its name, and nothing else is", "[shapes]") {
    std::set<std::string_view> names;
    for (const ShapeInfo& shape : all_shapes()) {
        INFO(shape.name);
        CHECK(names.insert(shape.name).second);
        CHECK(find_shape(shape.name) == &shape);
        CHECK(shape.default_tessellation >= 1);
        CHECK(shape.default_tessellation <= shape.max_tessellation);
        CHECK_FALSE(shape.meaning.empty());
        CHECK(expected().count(std::string(shape.name)) == 1);
    }
    CHECK(find_shape("Sphere") == nullptr);
    CHECK(find_shape("") == nullptr);
}

TEST_CASE("tessellation sets the number of faces, and its maximum keeps it below 20 million",
          "[shapes]") {
    for (const ShapeInfo& shape : all_shapes()) {
        const Expected& known = expected().at(std::string(shape.name));
        for (const int n : some_tessellations) {
            INFO(shape.name << " " << n);
            CHECK(shape.make(n).face_count() == known.faces(std::size_t(n)));
        }
        CHECK(known.faces(std::size_t(shape.max_tessellation)) < 20'000'000);
    }
}

TEST_CASE("an edge of a shape has one face on either side, or lies on the known border",
          "[shapes]") {
    for (const ShapeInfo& shape : all_shapes())
        for (const int n : some_tessellations) {
            INFO(shape.name << " " << n);
            const PolygonSoup soup = shape.make(n);
            const auto edges = directed_edges(soup);
            CHECK(std::all_of(edges.begin(), edges.end(),
                              [](const auto& edge) { return edge.second == 1; }));
            CHECK(border_edges(soup) ==
                  expected().at(std::string(shape.name)).border(std::size_t(n)));
        }
}

TEST_CASE("positions of a shape are distinct and all of them are used", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes()) {
        INFO(shape.name);
        const PolygonSoup soup = shape.make(7);
        std::set<std::array<double, 3>> distinct;
        for (const glm::dvec3& p : soup.positions) distinct.insert({p.x, p.y, p.z});
        CHECK(distinct.size() == soup.positions.size());
        std::set<std::uint32_t> used;
        for (const PolygonSoup::Corner& c : soup.corners) used.insert(c.position);
        CHECK(used.size() == soup.positions.size());
    }
}

TEST_CASE("faces of a shape are counter-clockwise about their unit normals", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes())
        for (const int n : {6, 32}) {
            INFO(shape.name << " " << n);
            const PolygonSoup soup = shape.make(n * expected().find(shape.name)->second.detail);
            double smallest = 1, length_error = 0;
            for (std::size_t f = 0; f < soup.face_count(); ++f) {
                const glm::dvec3 face = glm::normalize(newell_normal(face_positions(soup, f)));
                for (std::uint32_t c = soup.face_begin[f]; c < soup.face_begin[f + 1]; ++c) {
                    const glm::dvec3& normal = soup.normals[soup.corners[c].normal];
                    smallest = std::min(smallest, glm::dot(face, normal));
                    length_error = std::max(length_error, std::abs(glm::length(normal) - 1));
                }
            }
            CHECK(smallest > (n == 6 ? 0.3 : 0.9));
            CHECK(length_error < 1e-15);
        }
}

TEST_CASE("closed shapes look outward: their volume comes near that of the body", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes()) {
        const double limit = expected().at(std::string(shape.name)).volume;
        if (limit == 0) continue;
        INFO(shape.name);
        CHECK(volume(shape.make(32)) == Approx(limit).epsilon(0.003));
    }
}

TEST_CASE("normals of the sphere are its positions; those of the torus point from its ring",
          "[shapes]") {
    const PolygonSoup sphere = find_shape("sphere")->make(9), torus = find_shape("torus")->make(5);
    double error = 0;
    for (const PolygonSoup::Corner& c : sphere.corners)
        error =
            std::max(error, glm::length(sphere.positions[c.position] - sphere.normals[c.normal]));
    for (const PolygonSoup::Corner& c : torus.corners) {
        const glm::dvec3 p = torus.positions[c.position];
        const glm::dvec3 ring = 0.7 * glm::normalize(glm::dvec3(p.x, 0, p.z));
        error = std::max(error, glm::length((p - ring) / 0.3 - torus.normals[c.normal]));
    }
    CHECK(error < 1e-14);
}

TEST_CASE("the cylinder has a crease at its rims, the cube flat sides", "[shapes]") {
    for (const std::string_view name : {"cylinder", "cube"}) {
        const PolygonSoup soup = find_shape(name)->make(4);
        for (const PolygonSoup::Corner& c : soup.corners) {
            const glm::dvec3 n = soup.normals[c.normal];
            INFO(name << " normal " << n.x << " " << n.y << " " << n.z);
            const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
            if (name == "cube") CHECK((largest == 1 && glm::dot(n, n) == 1));
            if (name == "cylinder") CHECK((n.y == 0 || std::abs(n.y) == 1));
        }
    }
}

TEST_CASE("texture coordinates of a shape span [0, 1] and stay there", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes())
        for (const int n : some_tessellations) {
            INFO(shape.name << " " << n);
            const PolygonSoup soup = shape.make(n);
            glm::dvec2 low(1), high(0);
            for (const PolygonSoup::Corner& c : soup.corners)
                for (int k = 0; k < 2; ++k) {
                    low[k] = std::min(low[k], soup.texcoords[c.texcoord][k]);
                    high[k] = std::max(high[k], soup.texcoords[c.texcoord][k]);
                }
            CHECK(low == glm::dvec2(0));
            CHECK(high == glm::dvec2(1));
        }
}

TEST_CASE("a shape is about one unit in radius", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes()) {
        INFO(shape.name);
        double largest = 0;
        for (const glm::dvec3& p : shape.make(4).positions)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        CHECK(largest >= 1);
        CHECK(largest < 1.15);
    }
}

TEST_CASE("meshes of shapes have no odd faces", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes())
        for (const int n : {1, 2, shape.default_tessellation}) {
            INFO(shape.name << " " << n);
            const PolygonSoup soup = shape.make(n);
            const Mesh mesh = build_mesh(soup, {});
            CHECK(mesh.face_count() == soup.face_count());
            CHECK(mesh.events[Event::degenerate_face] == 0);
            CHECK(mesh.events[Event::repaired_normal] == 0);
            CHECK(mesh.has_texcoords);
        }
}

TEST_CASE("every face of a shape has one of the shape's materials, and each is used", "[shapes]") {
    for (const ShapeInfo& shape : all_shapes()) {
        INFO(shape.name);
        const PolygonSoup soup = shape.make(2);
        const std::set<std::uint32_t> used(soup.face_material.begin(), soup.face_material.end());
        CHECK(soup.face_material.size() == soup.face_count());
        CHECK(used.size() == shape.materials().size());
        CHECK(*used.rbegin() == shape.materials().size() - 1);
    }
}

TEST_CASE("the Cornell box has its published measures", "[shapes]") {
    const PolygonSoup soup = find_shape("cornell-box")->make(1);
    const std::vector<Material> materials = find_shape("cornell-box")->materials();
    std::map<std::string, double> area;  // mm²
    std::set<double> heights;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        std::vector<glm::dvec3> p = face_positions(soup, f);
        for (glm::dvec3& q : p) q = q * 279.6 + glm::dvec3(278, 274.4, 279.6);
        area[materials[soup.face_material[f]].name] += glm::length(newell_normal(p)) / 2;
        for (const glm::dvec3& q : p) heights.insert(std::round(q.y * 10) / 10);
    }
    CHECK(heights == std::set<double>{0, 165, 330, 548.8});
    CHECK(area.size() == 4);
    CHECK(area["cornell-lamp"] == Approx(130 * 105));
    CHECK(area["cornell-green"] == Approx(559.2 * 548.8));
    CHECK(area["cornell-red"] == Approx(559.2 * 548.8).epsilon(1e-3));
    // Floor, ceiling around the lamp, back wall; of each block the top and the four sides.
    const auto block = [](double a, double b, double height) {
        return a * b + 2 * (a + b) * height;
    };
    const double room =
        (552.8 + 549.6) / 2 * 559.2 + 556 * 559.2 - 130 * 105 + (549.6 + 556) / 2 * 548.8;
    CHECK(area["cornell-white"] ==
          Approx(room + block(165, 165, 165) + block(165, 165, 330)).epsilon(0.005));
}

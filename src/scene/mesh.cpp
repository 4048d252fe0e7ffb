// From polygons with an index for each attribute to one vertex for each combination of them.
#include "scanshade/scene/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <tuple>

#include "scanshade/base/error.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/scene/clusters.hpp"
#include "scene/mesh_parts.hpp"

namespace scanshade {
namespace {

/// Larger texture coordinates have no digits behind the point in float, so they mean nothing.
constexpr double max_texcoord = 0x1p23;

/// Calls visit(polygon) with the corner positions of a face; the buffer is used again.
class FacePolygon {
public:
    explicit FacePolygon(const PolygonSoup& soup) : soup_(soup) {}
    template <class Corners>
    const std::vector<glm::dvec3>& of(const Corners& corners) {
        points_.clear();
        for (const PolygonSoup::Corner& c : corners) points_.push_back(soup_.positions[c.position]);
        return points_;
    }

private:
    const PolygonSoup& soup_;
    std::vector<glm::dvec3> points_;
};

/// Faces, or positions, that one thread looks at at once.
constexpr std::size_t piece = 4096;

DrawnFaces drawn_faces(const PolygonSoup& soup, EventCounts& events) {
    const auto corners_of = [&](std::size_t f) {
        const std::size_t begin = soup.face_begin[f];
        return std::span(soup.corners).subspan(begin, soup.face_begin[f + 1] - begin);
    };
    std::vector<std::optional<glm::dvec3>> normals(soup.face_count());
    parallel_for(normals.size(), piece, 0, [&](std::size_t begin, std::size_t end, int) {
        FacePolygon polygon(soup);
        for (std::size_t f = begin; f < end; ++f)
            normals[f] = unit_newell_normal(polygon.of(corners_of(f)));
    });
    DrawnFaces faces;
    faces.corner.reserve(soup.corners.size());
    faces.face.reserve(soup.corners.size());
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto corners = corners_of(f);
        const std::optional<glm::dvec3>& normal = normals[f];
        if (!normal) {
            events.add(Event::degenerate_face);
            continue;
        }
        faces.face.insert(faces.face.end(), corners.size(), std::uint32_t(faces.size()));
        faces.corner.insert(faces.corner.end(), corners.begin(), corners.end());
        faces.begin.push_back(std::uint32_t(faces.corner.size()));
        faces.number.push_back(std::uint32_t(f));
        faces.normal.push_back(*normal);
    }
    return faces;
}

/// Centre of the box of what is drawn, and the power of two that brings it into [-1, 1].
void fit_frame(const PolygonSoup& soup, const DrawnFaces& faces, Mesh& mesh) {
    if (faces.corner.empty()) return;
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const PolygonSoup::Corner& c : faces.corner) {
        low = glm::min(low, soup.positions[c.position]);
        high = glm::max(high, soup.positions[c.position]);
    }
    mesh.origin = 0.5 * low + 0.5 * high;
    const glm::dvec3 half = glm::max(high - mesh.origin, mesh.origin - low);
    int exponent;
    const double mantissa = std::frexp(std::max({half.x, half.y, half.z}), &exponent);
    mesh.unit = std::ldexp(1.0, mantissa == 0.5 ? exponent - 1 : exponent);
}

std::array<float, 2> to_texcoord(const PolygonSoup& soup, std::uint32_t index) {
    if (index == no_index) return {0, 0};
    const glm::dvec2 t = glm::clamp(soup.texcoords[index], -max_texcoord, max_texcoord);
    return {float(t.x), float(t.y)};
}

/// For each corner the first one, in the order of the file, that looks the same.
std::vector<std::uint32_t> first_equals(const PolygonSoup& soup, const DrawnFaces& faces,
                                        const CornerNormals& normals, CornersByPosition& around) {
    std::vector<std::uint32_t> first(faces.corner.size());
    const auto look = [&](std::uint32_t c) {
        return std::tie(faces.corner[c].texcoord, normals.normal[c]);
    };
    parallel_for(soup.positions.size(), piece, 0, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t p = begin; p < end; ++p) {
            const std::span<std::uint32_t> corners = around.at(p);
            std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::tuple_cat(look(a), std::tie(a)) < std::tuple_cat(look(b), std::tie(b));
            });
            for (std::size_t i = 0; i < corners.size(); ++i)
                first[corners[i]] = i > 0 && look(corners[i]) == look(corners[i - 1])
                                        ? first[corners[i - 1]]
                                        : corners[i];
        }
    });
    return first;
}

/// Numbers vertices in the order in which faces use them first.
void add_vertices(const PolygonSoup& soup, const DrawnFaces& faces, const CornerNormals& normals,
                  CornersByPosition& around, Mesh& mesh) {
    using Origin = CornerNormals::Origin;
    const std::vector<std::uint32_t> first = first_equals(soup, faces, normals, around);
    mesh.corner.resize(first.size());
    for (std::uint32_t c = 0; c < first.size(); ++c) {
        if (first[c] != c) {
            mesh.corner[c] = mesh.corner[first[c]];
            continue;
        }
        mesh.corner[c] = std::uint32_t(mesh.vertex_count());
        const PolygonSoup::Corner& corner = faces.corner[c];
        const glm::dvec3 p = (soup.positions[corner.position] - mesh.origin) / mesh.unit;
        const auto [u, v] = to_texcoord(soup, corner.texcoord);
        mesh.x.push_back(float(p.x));
        mesh.y.push_back(float(p.y));
        mesh.z.push_back(float(p.z));
        mesh.nx.push_back(normals.normal[c][0]);
        mesh.ny.push_back(normals.normal[c][1]);
        mesh.nz.push_back(normals.normal[c][2]);
        mesh.u.push_back(u);
        mesh.v.push_back(v);
        mesh.has_texcoords |= corner.texcoord != no_index;
        if (normals.origin[c] == Origin::cancelled) mesh.events.add(Event::cancelled_normal);
        if (normals.origin[c] == Origin::repaired) mesh.events.add(Event::repaired_normal);
    }
}

/// Faces whose triangles one thread finds, one face after another.
struct FacePiece {
    std::vector<std::array<std::uint32_t, 3>> triangle;
    EventCounts events;
};

/// Faces begin ≤ f < end, whose place in the mesh is there; face_first_triangle gets, one place further,
/// how many triangles each has.
FacePiece add_face_piece(const PolygonSoup& soup, const DrawnFaces& faces, std::size_t begin,
                         std::size_t end, Mesh& mesh) {
    FacePiece out;
    FacePolygon polygon(soup);
    for (std::size_t f = begin; f < end; ++f) {
        const std::uint32_t first = faces.begin[f], count = faces.begin[f + 1] - first;
        const auto& points = polygon.of(std::span(faces.corner).subspan(first, count));
        glm::dvec3 centre(0);
        for (const glm::dvec3& p : points) centre += (p - mesh.origin) / mesh.unit;
        centre /= double(count);
        mesh.face_material[f] = soup.face_material[faces.number[f]];
        mesh.face_centre[f] = {float(centre.x), float(centre.y), float(centre.z)};
        const glm::dvec3& n = faces.normal[f];
        mesh.face_normal[f] = {float(n.x) + 0.0f, float(n.y) + 0.0f, float(n.z) + 0.0f};
        const auto triangles = triangulate(points, out.events);
        for (const auto& t : triangles)
            out.triangle.push_back(
                {mesh.corner[first + t[0]], mesh.corner[first + t[1]], mesh.corner[first + t[2]]});
        mesh.face_first_triangle[f + 1] = std::uint32_t(triangles.size());
    }
    return out;
}

void add_faces(const PolygonSoup& soup, const DrawnFaces& faces, Mesh& mesh) {
    const std::size_t count = faces.size();
    mesh.face_begin = faces.begin;
    mesh.face_material.resize(count);
    mesh.face_centre.resize(count);
    mesh.face_normal.resize(count);
    mesh.face_first_triangle.resize(count + 1);
    std::vector<FacePiece> pieces((count + piece - 1) / piece);
    parallel_for(count, piece, 0, [&](std::size_t begin, std::size_t end, int) {
        pieces[begin / piece] = add_face_piece(soup, faces, begin, end, mesh);
    });
    for (const FacePiece& p : pieces) {
        mesh.triangle.insert(mesh.triangle.end(), p.triangle.begin(), p.triangle.end());
        mesh.events += p.events;
    }
    mesh.triangle_face.reserve(mesh.triangle.size());
    for (std::size_t f = 0; f < count; ++f) {
        const std::uint32_t triangles = mesh.face_first_triangle[f + 1];
        mesh.triangle_face.insert(mesh.triangle_face.end(), triangles, std::uint32_t(f));
        mesh.face_first_triangle[f + 1] += mesh.face_first_triangle[f];
        const std::uint32_t corners = faces.begin[f + 1] - faces.begin[f];
        mesh.has_quads |= corners == 4;
        mesh.has_polygons |= corners > 3;
    }
}

}  // namespace

CornersByPosition::CornersByPosition(const DrawnFaces& faces, std::size_t position_count)
    : begin(position_count + 1), corner(faces.corner.size()) {
    for (const PolygonSoup::Corner& c : faces.corner) ++begin[c.position + 1];
    for (std::size_t p = 0; p < position_count; ++p) begin[p + 1] += begin[p];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t c = 0; c < corner.size(); ++c) corner[next[faces.corner[c].position]++] = c;
}

Mesh build_mesh(const PolygonSoup& soup, const NormalOptions& options) {
    SCANSHADE_CHECK(soup.corners.size() < no_index);
    SCANSHADE_CHECK(soup.face_material.size() == soup.face_count());
    Mesh mesh;
    mesh.name = soup.name;
    const DrawnFaces faces = drawn_faces(soup, mesh.events);
    fit_frame(soup, faces, mesh);
    CornersByPosition around(faces, soup.positions.size());
    const CornerNormals normals = corner_normals(soup, faces, around, options, mesh.unit);
    add_vertices(soup, faces, normals, around, mesh);
    add_faces(soup, faces, mesh);
    mesh.cluster_cache = std::make_shared<ClusterCache>();
    return mesh;
}

}  // namespace scanshade

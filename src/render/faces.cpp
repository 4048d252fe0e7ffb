#include "render/faces.hpp"

#include <algorithm>
#include <cmath>

namespace scanshade {
namespace {

std::span<const std::uint32_t> face_vertices(const Mesh& mesh, std::size_t face) {
    return std::span(mesh.corner).subspan(mesh.face_begin[face], mesh.corner_count(face));
}

struct Outcodes {
    std::uint8_t all = 0xff, any = 0;
};

Outcodes outcodes(const VertexFrame& vertices, std::span<const std::uint32_t> corners) {
    Outcodes codes;
    for (const std::uint32_t v : corners) {
        codes.all &= vertices.outcode[v];
        codes.any |= vertices.outcode[v];
    }
    return codes;
}

/// A corner between near and far, wherever it is on the picture.
PictureCorner picture_corner(const View& view, const VertexFrame& vertices, std::uint32_t v) {
    if (vertices.outcode[v] == 0) return {double(vertices.point[v].x), double(vertices.point[v].y)};
    const ClipVertex& c = vertices.clip[v];
    const auto to_grid = [&](float x, int size) {
        return std::nearbyint(double(x) / double(c.w) * subpixels) + size * (subpixels / 2);
    };
    return {to_grid(c.x, view.width), to_grid(c.y, view.height)};
}

double turn(const PictureCorner& a, const PictureCorner& b, const PictureCorner& c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

/// Every corner turns the same way, and the polygon goes down and up once. Exact where the corners
/// are within the guard band.
bool strictly_convex(const std::vector<PictureCorner>& p) {
    const std::size_t n = p.size();
    int left = 0, right = 0, peaks = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const PictureCorner &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
        const double t = turn(a, b, c);
        if (!(t != 0)) return false;
        ++(t > 0 ? left : right);
        // The lowest in a strict order of (y, x) is a corner once only, unless it winds twice.
        const auto before = [](const PictureCorner& u, const PictureCorner& v) {
            return u.y != v.y ? u.y < v.y : u.x < v.x;
        };
        if (before(b, a) && before(b, c)) ++peaks;
    }
    return (left == 0 || right == 0) && peaks == 1;
}

double polygon_area(const std::vector<PictureCorner>& p) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
        sum +=
            (p[i].x - p[0].x) * (p[i + 1].y - p[0].y) - (p[i + 1].x - p[0].x) * (p[i].y - p[0].y);
    return sum;
}

}  // namespace

/// Cofactors of the matrix whose rows are the corners (x, y, w).
HomogeneousEdges homogeneous_edges(const ClipVertex* const (&v)[3]) {
    HomogeneousEdges e{};
    double determinant = 0;
    for (int i = 0; i < 3; ++i) {
        const ClipVertex &p = *v[(i + 1) % 3], &q = *v[(i + 2) % 3];
        e.a[i] = double(p.y) * double(q.w) - double(p.w) * double(q.y);
        e.b[i] = double(p.w) * double(q.x) - double(p.x) * double(q.w);
        e.c[i] = double(p.x) * double(q.y) - double(p.y) * double(q.x);
        if (i == 0)
            determinant =
                e.a[0] * double(v[0]->x) + e.b[0] * double(v[0]->y) + e.c[0] * double(v[0]->w);
    }
    e.positive = determinant > 0;
    if (!e.positive)
        for (int i = 0; i < 3; ++i) e.a[i] = -e.a[i], e.b[i] = -e.b[i], e.c[i] = -e.c[i];
    // Σ λ_i w_i = |determinant| and Σ λ_i is that over w of the point.
    e.sum_to_inv_w = 1 / std::abs(determinant);
    return e;
}

std::size_t object_of(const RenderPlan& plan, std::uint32_t triangle) {
    const auto after = std::upper_bound(
        plan.objects.begin(), plan.objects.end(), triangle,
        [](std::uint32_t t, const ObjectPlan& object) { return t < object.first_triangle; });
    return static_cast<std::size_t>(after - plan.objects.begin()) - 1;
}

bool drawn_whole(const Frame& frame, std::size_t object, std::size_t face) {
    const VertexFrame& vertices = frame.vertices[object];
    std::vector<PictureCorner> corner;
    for (const std::uint32_t v : face_vertices(*frame.scene.objects[object].mesh, face)) {
        if ((vertices.outcode[v] & out_depth) != 0) return false;
        corner.push_back(picture_corner(frame.view, vertices, v));
    }
    return strictly_convex(corner);
}

void describe_triangle(const Frame& frame, std::size_t object, std::uint32_t triangle,
                       DrawnFace& out) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    const VertexFrame& vertices = frame.vertices[object];
    out.object = object;
    out.face = mesh.triangle_face[triangle];
    out.id = frame.plan.objects[object].first_triangle + triangle;
    out.vertex = mesh.triangle[triangle];
    const Outcodes codes = outcodes(vertices, out.vertex);
    out.outside = codes.any;
    out.empty = codes.all != 0;
    out.carrier = codes.any == 0 ? Carrier::triangle : Carrier::clipped;
    if (out.empty) return;
    bool positive;
    if (out.carrier == Carrier::triangle) {
        for (int i = 0; i < 3; ++i) out.point[i] = vertices.point[out.vertex[i]];
        const std::int64_t area = twice_area(out.point);
        out.empty = area == 0;
        positive = area > 0;
        out.inv_area = 1 / static_cast<double>(area);
        std::sort(std::begin(out.order), std::end(out.order), [&](std::uint8_t a, std::uint8_t b) {
            const SnappedPoint &p = out.point[a], &q = out.point[b];
            return p.y != q.y ? p.y < q.y : p.x < q.x;
        });
    } else {
        const ClipVertex* v[3];
        for (int i = 0; i < 3; ++i) v[i] = &vertices.clip[out.vertex[i]];
        out.edges = homogeneous_edges(v);
        positive = out.edges.positive;
        out.empty = !std::isfinite(out.edges.sum_to_inv_w);
    }
    // Counter-clockwise is front; on the picture, y down, that has a negative area.
    out.back = positive != vertices.mirrored;
}

void describe_whole(const Frame& frame, std::size_t object, std::size_t face, DrawnFace& out) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    const VertexFrame& vertices = frame.vertices[object];
    out.object = object;
    out.face = face;
    out.id = frame.plan.objects[object].first_triangle + mesh.face_first_triangle[face];
    out.vertex = face_vertices(mesh, face);
    const Outcodes codes = outcodes(vertices, out.vertex);
    out.outside = codes.any;
    out.empty = codes.all != 0;
    out.carrier = Carrier::polygon;
    out.corner.clear();
    for (const std::uint32_t v : out.vertex)
        out.corner.push_back(picture_corner(frame.view, vertices, v));
    const bool positive = polygon_area(out.corner) > 0;
    out.back = positive != vertices.mirrored;
}

void describe_drawn(const Frame& frame, std::uint32_t id, DrawnFace& out) {
    const std::size_t object = object_of(frame.plan, id);
    const std::uint32_t triangle = id - frame.plan.objects[object].first_triangle;
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    const std::size_t face = mesh.triangle_face[triangle];
    if (frame.plan.interpolation == Interpolation::edges && mesh.corner_count(face) > 3 &&
        drawn_whole(frame, object, face))
        describe_whole(frame, object, face, out);
    else
        describe_triangle(frame, object, triangle, out);
}

}  // namespace scanshade

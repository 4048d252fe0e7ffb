#include "render/faces.hpp"

#include <algorithm>
#include <cmath>

namespace scanshade {
namespace {

std::span<const std::uint32_t> face_vertices(const Mesh& mesh, std::size_t face) {
    return std::span(mesh.corner).subspan(mesh.face_begin[face], mesh.corner_count(face));
}

void load_corners(const Frame& frame, DrawnFace& face) {
    face.state.clear();
    face.outside = 0;
    std::uint8_t all = 0xff;
    for (const std::uint32_t v : face.vertex) {
        face.state.push_back(frame.vertex(face.object, v));
        face.outside |= face.state.back().outcode;
        all &= face.state.back().outcode;
    }
    face.empty = all != 0;
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

PictureCorner picture_corner(const View& view, const VertexState& vertex) {
    if (vertex.outcode == 0) return {double(vertex.point.x), double(vertex.point.y)};
    const ClipVertex& c = vertex.clip;
    const auto to_grid = [&](float x, int size) {
        return std::nearbyint(double(x) / double(c.w) * subpixels) + size * subpixels * 0.5;
    };
    return {to_grid(c.x, view.width), to_grid(c.y, view.height)};
}

/// Cofactors of the matrix whose rows are the corners (x, y, w).
HomogeneousEdges homogeneous_edges(const ClipVertex* const (&v)[3]) {
    HomogeneousEdges e{};
    for (int i = 0; i < 3; ++i) {
        const ClipVertex &p = *v[(i + 1) % 3], &q = *v[(i + 2) % 3];
        e.a[i] = double(p.y) * double(q.w) - double(p.w) * double(q.y);
        e.b[i] = double(p.w) * double(q.x) - double(p.x) * double(q.w);
        e.c[i] = double(p.x) * double(q.y) - double(p.y) * double(q.x);
    }
    const double determinant =
        e.a[0] * double(v[0]->x) + e.b[0] * double(v[0]->y) + e.c[0] * double(v[0]->w);
    e.positive = determinant > 0;
    if (!e.positive)
        for (int i = 0; i < 3; ++i) e.a[i] = -e.a[i], e.b[i] = -e.b[i], e.c[i] = -e.c[i];
    // Σ λ_i w_i = |determinant| and Σ λ_i is that over w of the point.
    e.sum_to_inv_w = 1 / std::abs(determinant);
    return e;
}

bool drawn_whole(const Frame& frame, std::size_t object, std::size_t face) {
    std::vector<PictureCorner> corner;
    for (const std::uint32_t v : face_vertices(*frame.scene.objects[object].mesh, face)) {
        const VertexState vertex = frame.vertex(object, v);
        if ((vertex.outcode & out_depth) != 0) return false;
        corner.push_back(picture_corner(frame.view, vertex));
    }
    return strictly_convex(corner);
}

SampleBox sample_box(std::span<const SnappedPoint> points, SampleOffset sample, int width,
                     int height) {
    SnappedPoint low = points[0], high = points[0];
    for (const SnappedPoint& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const auto first = [](int x, int s) { return (x - s + subpixels - 1) >> subpixel_bits; };
    const auto last = [](int x, int s) { return (x - s) >> subpixel_bits; };
    return {std::max(first(low.x, sample.x), 0), std::max(first(low.y, sample.y), 0),
            std::min(last(high.x, sample.x), width - 1),
            std::min(last(high.y, sample.y), height - 1)};
}

namespace {

/// Twice the area, the order of corners, and the depth's plane where it serves.
bool measure_triangle(const Frame& frame, DrawnFace& face) {
    for (std::size_t i = 0; i < 3; ++i) face.point[i] = face.state[i].point;
    const std::int64_t area = twice_area(face.point);
    face.empty = area == 0;
    if (face.empty) return false;
    face.inv_area = 1 / static_cast<double>(area);
    std::sort(std::begin(face.order), std::end(face.order), [&](std::uint8_t a, std::uint8_t b) {
        const SnappedPoint &p = face.point[a], &q = face.point[b];
        return p.y != q.y ? p.y < q.y : p.x < q.x;
    });
    face.box = sample_box(face.point, frame.sample, frame.view.width, frame.view.height);
    if (face.box.empty()) return area > 0;

    double px[3], py[3], z[3];
    for (int i = 0; i < 3; ++i) {
        const std::uint8_t corner = face.order[i];
        px[i] = face.point[corner].x, py[i] = face.point[corner].y;
        z[i] = double(face.state[corner].depth);
    }
    const int ox = face.box.origin_x(), oy = face.box.origin_y();
    const ScreenPlane<double> plane =
        plane_through(px, py, z, ox * 256.0 + frame.sample.x, oy * 256.0 + frame.sample.y);
    face.depth = {float(plane.c), float(plane.x), float(plane.y)};
    const auto [left, right] = std::minmax_element(px, px + 3);
    const auto [top, bottom] = std::minmax_element(py, py + 3);
    face.planar =
        planes_serve(face.depth, float(std::min({z[0], z[1], z[2]})), float(std::abs(area)),
                     float(face.box.x1 - ox), float(face.box.y1 - oy), float(*right - *left),
                     float(*bottom - *top), steepest_weight(frame.plan));
    return area > 0;
}

}  // namespace

namespace {

/// The quadrilateral in float, where that serves. All corners are within the guard band.
void measure_quad(const Frame& frame, bool positive, DrawnFace& face) {
    SnappedPoint p[4];
    for (std::uint8_t k = 0; k < 4; ++k) {
        face.clockwise[k] = std::uint8_t(positive ? k : (4 - k) % 4);
        p[k] = face.state[face.clockwise[k]].point;
    }
    face.box = sample_box(p, frame.sample, frame.view.width, frame.view.height);
    if (face.box.empty()) return;
    const int ox = face.box.origin_x(), oy = face.box.origin_y();
    float turn[4], nearest = 0, farthest = INFINITY;
    SnappedPoint low = p[0], high = p[0];
    for (int k = 0; k < 4; ++k) {
        turn[k] = static_cast<float>(edge_function(p[(k + 3) % 4], p[k], p[(k + 1) % 4]));
        low = {std::min(low.x, p[k].x), std::min(low.y, p[k].y)};
        high = {std::max(high.x, p[k].x), std::max(high.y, p[k].y)};
        ScreenQuad<float>& q = face.quad;
        q.x[k] = float(p[k].x - (ox * subpixels + frame.sample.x)) / subpixels;
        q.y[k] = float(p[k].y - (oy * subpixels + frame.sample.y)) / subpixels;
        q.z[k] = face.state[face.clockwise[k]].depth;
        nearest = std::max(nearest, q.z[k]), farthest = std::min(farthest, q.z[k]);
    }
    for (int k = 0; k < 4; ++k)
        face.quad.per_height[k] = per_height(face.quad.y[(k + 1) % 4] - face.quad.y[k]);
    face.quad_serves =
        quads_serve(nearest, farthest, turn, float(face.box.x1 - ox), float(face.box.y1 - oy),
                    float(high.x - low.x), float(high.y - low.y), steepest_weight(frame.plan));
}

}  // namespace

void describe_triangle(const Frame& frame, std::size_t object, std::uint32_t triangle,
                       DrawnFace& out) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    out.object = object;
    out.face = mesh.triangle_face[triangle];
    out.id = frame.plan.objects[object].first_triangle + triangle;
    out.vertex = mesh.triangle[triangle];
    load_corners(frame, out);
    out.carrier = out.outside == 0 ? Carrier::triangle : Carrier::clipped;
    out.planar = out.quad_serves = false;
    if (out.empty) return;
    bool positive;
    if (out.carrier == Carrier::triangle) {
        positive = measure_triangle(frame, out);
    } else {
        const ClipVertex* v[3];
        for (std::size_t i = 0; i < 3; ++i) v[i] = &out.state[i].clip;
        out.edges = homogeneous_edges(v);
        positive = out.edges.positive;
        out.empty = !std::isfinite(out.edges.sum_to_inv_w);
    }
    // Counter-clockwise is front; on the picture, y down, that has a negative area.
    out.back = positive != frame.object_views[object].mirrored;
}

void describe_whole(const Frame& frame, std::size_t object, std::size_t face, DrawnFace& out) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    out.object = object;
    out.face = face;
    out.id = frame.plan.objects[object].first_triangle + mesh.face_first_triangle[face];
    out.vertex = face_vertices(mesh, face);
    load_corners(frame, out);
    out.carrier = Carrier::polygon;
    out.planar = out.quad_serves = false;
    out.corner.clear();
    for (const VertexState& vertex : out.state)
        out.corner.push_back(picture_corner(frame.view, vertex));
    const bool positive = polygon_area(out.corner) > 0;
    out.back = positive != frame.object_views[object].mirrored;
    if (out.corner.size() == 4 && out.outside == 0) measure_quad(frame, positive, out);
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

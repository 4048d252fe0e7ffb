#include "render/records.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "render/shade_common.hpp"
#include "render/visibility.hpp"

namespace scanshade {

void RecordMaker::add_triangle(std::size_t object, std::uint32_t triangle) {
    describe_triangle(frame_, object, triangle, face_);
    add_drawn();
}

void RecordMaker::add(std::size_t object, std::uint32_t triangle) {
    const Mesh& mesh = *frame_.scene.objects[object].mesh;
    const std::uint32_t face = mesh.triangle_face[triangle];
    if (!draws_whole(frame_.plan.interpolation) || mesh.corner_count(face) == 3)
        return add_triangle(object, triangle);
    if (drawn_whole(frame_, object, face)) {
        describe_whole(frame_, object, face, face_);
        return add_drawn();
    }
    falls_back_ = true;
    for (std::uint32_t t = mesh.face_first_triangle[face]; t < mesh.face_first_triangle[face + 1];
         ++t)
        add_triangle(object, t);
    falls_back_ = false;
}

void RecordMaker::add_drawn() {
    if (face_.empty) {
        if (face_.outside == 0) events_.add(Event::zero_area);
        return;
    }
    if (!drawn_corners(face_, frame_, events_, point_)) return;
    if (face_.back && frame_.plan.cull == Cull::back) return;
    const SampleBox box = sample_box(point_, frame_.sample, frame_.view.width, frame_.view.height);
    if (box.empty()) return;

    Record r{};
    r.id = face_.id;
    r.object = static_cast<std::uint32_t>(face_.object);
    r.material = material_of(frame_, face_.object, face_.face);
    r.triangle = face_.id - frame_.plan.objects[face_.object].first_triangle;
    r.back = face_.back;
    r.affine = frame_.view.orthographic || frame_.plan.interpolation == Interpolation::edges;
    r.x0 = box.x0, r.y0 = box.y0, r.x1 = box.x1, r.y1 = box.y1;
    r.origin_x = box.origin_x(), r.origin_y = box.origin_y();
    if (face_.carrier == Carrier::triangle || face_.quad_serves) {
        r.coverage = Record::Coverage::edges;
        describe_edges(r);
    } else {
        r.coverage = Record::Coverage::rows;
        r.first_point = static_cast<std::uint32_t>(into_.points.size());
        r.point_count = static_cast<std::uint32_t>(point_.size());
        into_.points.insert(into_.points.end(), point_.begin(), point_.end());
    }
    describe_depth(r);
    r.scalar = falls_back_ || r.depth == Record::Depth::scalar;
    if (r.depth != Record::Depth::scalar) describe_values(r);
    into_.records.push_back(r);
}

/// Edge functions turned so that they are ≥ 0 inside, with the top-left rule in the constant.
void RecordMaker::describe_edges(Record& r) const {
    // A quadrilateral's corners are clockwise here.
    const bool positive = face_.quad_serves || face_.inv_area > 0;
    const int n = face_.quad_serves ? 4 : 3;
    const auto point = [&](int k) {
        return face_.quad_serves ? face_.state[face_.clockwise[k % 4]].point : face_.point[k % 3];
    };
    r.edge_count = n;
    const SnappedPoint origin = {r.origin_x * subpixels + frame_.sample.x,
                                 r.origin_y * subpixels + frame_.sample.y};
    const SnappedPoint corner = {frame_.sample.x, frame_.sample.y};
    for (int k = 0; k < n; ++k) {
        const SnappedPoint from = point(k), to = point(k + 1);
        const std::int64_t turn = positive ? 1 : -1;
        const std::int64_t A = turn * (from.y - to.y), B = turn * (to.x - from.x);
        const bool top_left = A > 0 || (A == 0 && B > 0);
        r.edge_x[k] = A;
        r.edge_y[k] = B;
        r.edge_c[k] =
            (turn * edge_function(from, to, origin) - (top_left ? 0 : 1)) >> subpixel_bits;
        if (n == 4) continue;
        // λ of the corner opposite to the edge, with the sign that the area takes away again.
        const int opposite = (k + 2) % 3;
        r.weight_x[opposite] = double(std::int64_t(from.y - to.y) * subpixels);
        r.weight_y[opposite] = double(std::int64_t(to.x - from.x) * subpixels);
        r.weight_c[opposite] = double(edge_function(from, to, corner));
    }
    r.inv_area = face_.inv_area;  // of a triangle
}

void RecordMaker::describe_depth(Record& r) const {
    r.nearest = INFINITY;
    r.farthest = 0;
    if (face_.carrier == Carrier::polygon && !face_.quad_serves) {
        r.depth = Record::Depth::scalar;
        return;
    }
    if (face_.quad_serves) return describe_quad(r);
    for (std::size_t i = 0; i < 3; ++i) {
        r.order[i] = face_.order[i];
        r.corner_depth[i] = face_.state[i].depth;
        r.corner_w[i] = frame_.view.orthographic ? face_.state[i].clip.d : face_.state[i].clip.w;
    }
    if (face_.carrier == Carrier::clipped) {
        r.depth = Record::Depth::clipped;
        std::copy(std::begin(face_.edges.a), std::end(face_.edges.a), r.weight_x);
        std::copy(std::begin(face_.edges.b), std::end(face_.edges.b), r.weight_y);
        std::copy(std::begin(face_.edges.c), std::end(face_.edges.c), r.weight_c);
        r.sum_to_inv_w = face_.edges.sum_to_inv_w;
        // What near or far has cut keeps its homogeneous values; orthographic ones need no factor.
        r.affine = r.affine && !frame_.view.orthographic && (face_.outside & out_depth) == 0;
        return;
    }
    // Each of the three terms and the two sums may round once.
    const auto [low, high] = std::minmax_element(r.corner_depth, r.corner_depth + 3);
    r.nearest = *high * (1 + 0x1p-20f);
    r.farthest = *low * (1 - 0x1p-20f);
    r.depth = face_.planar ? Record::Depth::plane : Record::Depth::weights;
    if (face_.planar) describe_planes(r);
}

/// What set-up gives a quadrilateral of a batch.
void RecordMaker::describe_quad(Record& r) const {
    const ScreenQuad<float>& q = face_.quad;
    r.depth = Record::Depth::spans;
    r.rows[row_origin_x] = static_cast<float>(r.origin_x);
    r.rows[row_origin_y] = static_cast<float>(r.origin_y);
    std::copy_n(q.x, 4, r.rows + row_quad_x);
    std::copy_n(q.y, 4, r.rows + row_quad_y);
    std::copy_n(q.per_height, 4, r.rows + row_quad_per_height);
    std::copy_n(q.z, 4, r.rows + row_quad_depth);
    std::copy_n(face_.clockwise, 4, r.order);
    // A span's slope may go on beyond its ends by what the crossings are rounded by.
    const auto [low, high] = std::minmax_element(q.z, q.z + 4);
    const float room = (*high - *low) * 0x1p-6f;
    r.nearest = (*high + room) * (1 + 0x1p-20f);
    r.farthest = (*low - room) * (1 - 0x1p-20f);
}

void set_plane(Record& r, int row, float a0, float a1, float a2) {
    for (int part = 0; part < 3; ++part)
        r.rows[row + part] = a0 * r.weight_plane[0][part] + a1 * r.weight_plane[1][part] +
                             a2 * r.weight_plane[2][part];
}

/// What set-up gives a triangle of a batch.
void RecordMaker::describe_planes(Record& r) const {
    r.rows[row_depth] = face_.depth.c;
    r.rows[row_depth + 1] = face_.depth.x;
    r.rows[row_depth + 2] = face_.depth.y;
    r.rows[row_origin_x] = static_cast<float>(r.origin_x);
    r.rows[row_origin_y] = static_cast<float>(r.origin_y);
    for (int i = 0; i < 3; ++i) {
        const double scale = r.inv_area * (r.affine ? 1.0 : double(r.corner_depth[i]));
        const double at_origin =
            r.weight_c[i] + r.weight_x[i] * r.origin_x + r.weight_y[i] * r.origin_y;
        r.weight_plane[i][0] = static_cast<float>(at_origin * scale);
        r.weight_plane[i][1] = static_cast<float>(r.weight_x[i] * scale);
        r.weight_plane[i][2] = static_cast<float>(r.weight_y[i] * scale);
    }
}

void RecordMaker::describe_values(Record& r) const {
    if (r.depth == Record::Depth::spans) return describe_corners(r);
    const ObjectSurface& surface = surfaces_[face_.object];
    const Mesh& mesh = *frame_.scene.objects[face_.object].mesh;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = face_.vertex[i];
        const glm::dvec3 n = surface.vertex_normal(v) * (face_.back ? -1.0 : 1.0);
        const glm::dvec3 p = surface.vertex_position(v);
        for (int c = 0; c < 3; ++c) {
            r.main[i][c] = static_cast<float>(n[c]);
            r.position[i][c] = static_cast<float>(p[c]);
        }
        r.texcoord[i][0] = mesh.u[v];
        r.texcoord[i][1] = mesh.v[v];
    }
    for (int i = 0; i < 3; ++i) {
        const float *a = r.main[i], *b = r.main[(i + 1) % 3];
        // Not so where something is no number.
        r.normals_disagree |= !(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > 0.1f);
    }
    if (r.depth != Record::Depth::plane) return;
    const auto planes = [&](int row, int count, auto&& value) {
        for (int c = 0; c < count && row >= 0; ++c)
            set_plane(r, row + 3 * c, value(0, c), value(1, c), value(2, c));
    };
    planes(attributes_.main, 3, [&](int i, int c) { return r.main[i][c]; });
    planes(attributes_.texcoord, 2, [&](int i, int c) { return r.texcoord[i][c]; });
    planes(attributes_.position, 3, [&](int i, int c) { return r.position[i][c]; });
}

/// Values at a quadrilateral's corners.
void RecordMaker::describe_corners(Record& r) const {
    const ObjectSurface& surface = surfaces_[face_.object];
    const Mesh& mesh = *frame_.scene.objects[face_.object].mesh;
    glm::vec3 normal[4];
    const auto put = [&](int row, int corner, const glm::vec3& value, int count) {
        for (int c = 0; c < count && row >= 0; ++c) r.rows[row + 4 * c + corner] = value[c];
    };
    for (int k = 0; k < 4; ++k) {
        const std::uint32_t v = face_.vertex[face_.clockwise[k]];
        normal[k] = glm::vec3(surface.vertex_normal(v) * (face_.back ? -1.0 : 1.0));
        put(quad_attributes_.main, k, normal[k], 3);
        put(quad_attributes_.texcoord, k, {mesh.u[v], mesh.v[v], 0}, 2);
        put(quad_attributes_.position, k, glm::vec3(surface.vertex_position(v)), 3);
    }
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < i; ++k) r.normals_disagree |= !(glm::dot(normal[i], normal[k]) > 0.1f);
}

void list_records(int tile, int tiles_x, RecordList& into) {
    // Those that no bound is known of come last.
    const auto key = [&](std::uint32_t number) {
        const float nearest = into.records[number].nearest;
        return std::isinf(nearest) ? 0 : nearest;
    };
    std::vector<std::uint32_t> order(into.records.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater(), key);
    for (const std::uint32_t number : order) {
        const Record& r = into.records[number];
        for (int ty = r.y0 / tile; ty <= r.y1 / tile; ++ty)
            for (int tx = r.x0 / tile; tx <= r.x1 / tile; ++tx)
                into.lists.push(static_cast<std::size_t>(ty * tiles_x + tx), number);
    }
}

}  // namespace scanshade

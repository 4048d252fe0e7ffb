#include "render/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "render/carry.hpp"
#include "render/clip.hpp"
#include "render/faces.hpp"
#include "render/walk.hpp"

namespace scanshade {
namespace {

/// Depth of a triangle at a sample.
float triangle_depth(const DrawnFace& face, SnappedPoint p, SampleOffset sample) {
    if (face.planar) {
        const int X = (p.x - sample.x) / subpixels - face.box.origin_x();
        const int Y = (p.y - sample.y) / subpixels - face.box.origin_y();
        return plane_value(face.depth, float(X), float(Y));
    }
    float lambda[3];
    triangle_weights(face, p, lambda);
    const auto term = [&](int i) {
        const std::uint8_t corner = face.order[i];
        return lambda[corner] * face.state[corner].depth;
    };
    return (term(0) + term(1)) + term(2);
}

/// (C3) of the corners' depths.
float polygon_depth(const DrawnFace& face, SnappedPoint p, SampleOffset sample) {
    if (face.quad_serves) {
        const int X = (p.x - sample.x) / subpixels - face.box.origin_x();
        const int Y = (p.y - sample.y) / subpixels - face.box.origin_y();
        return span_depth(quad_span(face.quad, float(Y)), float(X));
    }
    const Place<float> at = polygon_place<float>(face.corner, p);
    const auto depth = [&](std::uint32_t corner) { return face.state[corner].depth; };
    return along_span(along_edge(depth(at.a), depth(at.b), at.a_y, at.b_y, at.y),
                      along_edge(depth(at.c), depth(at.d), at.c_y, at.d_y, at.y), at.ab_x, at.cd_x,
                      0.0f);
}

float clipped_depth(const DrawnFace& face, const View& view, SnappedPoint p) {
    double lambda[3];
    homogeneous_weights(face, view, p, lambda);
    const double sum = lambda[0] + lambda[1] + lambda[2];
    if (!view.orthographic)
        return static_cast<float>(double(view.near) * (sum * face.edges.sum_to_inv_w));
    double d = 0;
    for (std::size_t i = 0; i < 3; ++i) d += lambda[i] / sum * double(face.state[i].clip.d);
    return view.depth({0, 0, static_cast<float>(d), 1});
}

}  // namespace

float depth_at(const DrawnFace& face, const Frame& frame, SnappedPoint p) {
    switch (face.carrier) {
        case Carrier::triangle:
            return triangle_depth(face, p, frame.sample);
        case Carrier::polygon:
            return polygon_depth(face, p, frame.sample);
        case Carrier::clipped:
            return clipped_depth(face, frame.view, p);
    }
    return 0;
}

bool drawn_corners(const DrawnFace& face, const Frame& frame, EventCounts& events,
                   std::vector<SnappedPoint>& out) {
    out.clear();
    if (face.outside == 0) {
        for (const VertexState& v : face.state) out.push_back(v.point);
    } else {
        const bool depth = (face.outside & out_depth) != 0;
        events.add(depth ? Event::near_clipped : Event::guard_clipped);
        std::vector<ClipVertex> polygon;
        for (const VertexState& v : face.state) polygon.push_back(v.clip);
        clip_polygon(polygon, face.outside, frame.view);
        for (const ClipVertex& v : polygon) out.push_back(frame.view.snap(v));
        if (out.size() < 3) return false;
    }
    if (twice_area(out) != 0) return true;
    events.add(Event::zero_area);
    return false;
}

namespace {

/// One pass over the faces of a frame.
class CoveragePass {
public:
    CoveragePass(Frame& frame, const CoverageVisitor& visit) : frame_(frame), visit_(visit) {}

    void draw_object(std::size_t object) {
        const Mesh& mesh = *frame_.scene.objects[object].mesh;
        const bool edges = frame_.plan.interpolation == Interpolation::edges;
        for (std::size_t face = 0; face < mesh.face_count(); ++face) {
            if (edges && mesh.corner_count(face) > 3 && drawn_whole(frame_, object, face)) {
                describe_whole(frame_, object, face, face_);
                draw();
                continue;
            }
            for (std::uint32_t t = mesh.face_first_triangle[face];
                 t < mesh.face_first_triangle[face + 1]; ++t) {
                describe_triangle(frame_, object, t, face_);
                draw();
            }
        }
    }

private:
    /// Draws face_: coverage from its snapped corners, clipped first where they reach too far.
    void draw() {
        ++frame_.items;
        if (face_.empty) {
            if (face_.outside == 0) frame_.events.add(Event::zero_area);
            return;
        }
        if (!drawn_corners(face_, frame_, frame_.events, point_)) return;
        if (face_.back && frame_.plan.cull == Cull::back) return;
        walker_.walk(point_, twice_area(point_) > 0, frame_.sample, frame_.view.width,
                     frame_.view.height,
                     [this](int y, int begin, int end) { visit_(face_, y, begin, end); });
    }

    Frame& frame_;
    const CoverageVisitor& visit_;
    DrawnFace face_;
    PolygonWalker walker_;
    std::vector<SnappedPoint> point_;
};

}  // namespace

void visit_coverage(Frame& frame, const CoverageVisitor& visit) {
    CoveragePass pass(frame, visit);
    for (std::size_t object = 0; object < frame.scene.objects.size(); ++object)
        pass.draw_object(object);
}

void find_visible(Frame& frame) {
    const std::size_t samples = frame.target.depth.size();
    frame.depth.assign(samples, 0.0f);
    frame.id.assign(samples, Framebuffer::no_triangle);
    visit_coverage(frame, [&frame](const DrawnFace& face, int y, int begin, int end) {
        std::size_t at = frame.target.index(begin, y);
        for (int x = begin; x < end; ++x, ++at) {
            if (frame.only && !frame.only->inside[at]) continue;
            const float z = depth_at(face, frame, sample_point(x, y, frame.sample));
            const bool nearer =
                z > frame.depth[at] || (z == frame.depth[at] && face.id < frame.id[at]);
            if (!nearer) continue;
            frame.depth[at] = z;
            frame.id[at] = face.id;
        }
    });
}

}  // namespace scanshade

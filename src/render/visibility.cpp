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

/// Depth at a sample of one face, in float, by the way its values travel.
float depth_at(const DrawnFace& face, const Frame& frame, SnappedPoint p) {
    const VertexFrame& vertices = frame.vertices[face.object];
    if (face.carrier == Carrier::triangle) {
        float lambda[3];
        triangle_weights(face, p, lambda);
        const auto term = [&](int i) {
            const std::uint8_t corner = face.order[i];
            return lambda[corner] * vertices.depth[face.vertex[corner]];
        };
        return (term(0) + term(1)) + term(2);
    }
    if (face.carrier == Carrier::polygon) {
        const Place<float> at = polygon_place<float>(face, p);
        const auto depth = [&](std::uint32_t corner) {
            return vertices.depth[face.vertex[corner]];
        };
        return along_span(along_edge(depth(at.a), depth(at.b), at.a_y, at.b_y, at.y),
                          along_edge(depth(at.c), depth(at.d), at.c_y, at.d_y, at.y), at.ab_x,
                          at.cd_x, 0.0f);
    }
    double lambda[3];
    homogeneous_weights(face, frame.view, p, lambda);
    const double sum = lambda[0] + lambda[1] + lambda[2];
    if (!frame.view.orthographic)
        return static_cast<float>(double(frame.view.near) * (sum * face.edges.sum_to_inv_w));
    double d = 0;
    for (int i = 0; i < 3; ++i) d += lambda[i] / sum * double(vertices.clip[face.vertex[i]].d);
    return frame.view.depth({0, 0, static_cast<float>(d), 1});
}

/// One pass over the faces of a frame.
class CoveragePass {
public:
    CoveragePass(Frame& frame, const CoverageVisitor& visit) : frame_(frame), visit_(visit) {}

    void draw_object(std::size_t object) {
        const Mesh& mesh = *frame_.scene.objects[object].mesh;
        const bool edges = frame_.plan.interpolation == Interpolation::edges;
        for (std::size_t face = 0; face < mesh.face_count(); ++face) {
            if (edges && mesh.corner_count(face) > 3) {
                if (drawn_whole(frame_, object, face)) {
                    describe_whole(frame_, object, face, face_);
                    draw();
                    continue;
                }
                frame_.events.add(Event::edges_fallback);
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
        const VertexFrame& vertices = frame_.vertices[face_.object];
        point_.clear();
        if (face_.outside == 0) {
            for (const std::uint32_t v : face_.vertex) point_.push_back(vertices.point[v]);
        } else {
            clip(vertices);
            if (point_.size() < 3) return;
        }
        const std::int64_t area = twice_area(point_);
        if (area == 0) {
            frame_.events.add(Event::zero_area);
            return;
        }
        if (face_.back && frame_.plan.cull == Cull::back) return;
        walker_.walk(point_, area > 0, frame_.sample, frame_.view.width, frame_.view.height,
                     [this](int y, int begin, int end) { visit_(face_, y, begin, end); });
    }

    void clip(const VertexFrame& vertices) {
        const bool depth = (face_.outside & out_depth) != 0;
        frame_.events.add(depth ? Event::near_clipped : Event::guard_clipped);
        polygon_.clear();
        for (const std::uint32_t v : face_.vertex) polygon_.push_back(vertices.clip[v]);
        clip_polygon(polygon_, face_.outside, frame_.view);
        for (const ClipVertex& v : polygon_) point_.push_back(frame_.view.snap(v));
    }

    Frame& frame_;
    const CoverageVisitor& visit_;
    DrawnFace face_;
    PolygonWalker walker_;
    std::vector<SnappedPoint> point_;
    std::vector<ClipVertex> polygon_;
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

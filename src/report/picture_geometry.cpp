#include "report/picture_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/frame.hpp"
#include "render/visibility.hpp"
#include "report/picture_reference.hpp"

namespace scanshade {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-24;  // unit roundoff of float

/// How far rounding may move a point of clip space on the picture, in 1/256 pixel.
struct Rounding {
    double x = 0, y = 0, w = 0;           // sums of the magnitudes that are added up
    double picture_x = 0, picture_y = 0;  // pixels from the centre
    double least_w = infinite;

    /// Matrix, three products and three sums, each rounded; then a division; then snapping.
    double bound() const {
        const double error_w = 5 * u * w;
        if (!(least_w > error_w)) return infinite;
        const auto along = [&](double sum, double picture) {
            const double moved = (5 * u * sum + picture * error_w) / (least_w - error_w);
            return subpixels * (moved + u * picture) + 0.5;
        };
        return std::hypot(along(x, picture_x), along(y, picture_y)) * (1 + 1e-6);
    }
};

class GeometryMeasurement {
public:
    explicit GeometryMeasurement(const ReportInput& input)
        : camera_(reference_camera(input.scene, input.settings)),
          given_(input.scene),
          normal_(normalised(input.scene)),
          plan_(make_plan(normal_, plain(input.settings))),
          target_(plan_.width, plan_.height),
          frame_(normal_, plan_, target_) {
        transform_vertices(frame_);
        const std::size_t samples = target_.id.size();
        covered_.resize(samples), reference_covered_.resize(samples), at_edge_.resize(samples);
        moved_.resize(samples);
        nearest_.resize(samples), nearest_id_.resize(samples, Framebuffer::no_triangle);
    }

    GeometryResult measure() {
        collect_spans();
        for (object_ = 0; object_ < given_.objects.size(); ++object_) measure_object();
        count_samples();
        return result_;
    }

private:
    struct Span {
        std::uint32_t id;
        int y, begin, end;
    };

    /// What decides coverage, and nothing else.
    static Settings plain(Settings settings) {
        settings.renderer = RendererKind::scalar_f32;
        settings.interpolation = Interpolation::perspective;
        settings.samples = 1;
        settings.cull = Cull::none;
        return settings;
    }

    void collect_spans() {
        visit_coverage(frame_, [this](const DrawnFace& face, int y, int begin, int end) {
            spans_.push_back({face.id, y, begin, end});
        });
        next_ = spans_.begin();
    }

    void measure_object() {
        const Mesh& mesh = *given_.objects[object_].mesh;
        eye_ = reference_vertices(camera_, given_.objects[object_]);
        rounding_.clear();
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) measure_vertex(v);
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t)
            measure_triangle(mesh.triangle[t], plan_.objects[object_].first_triangle + t);
    }

    void measure_vertex(std::uint32_t v) {
        const Mesh& mesh = *given_.objects[object_].mesh;
        const float xyz1[4] = {mesh.x[v], mesh.y[v], mesh.z[v], 1};
        const auto magnitudes = [&](int row) {
            double sum = 0;
            for (std::size_t i = 0; i < 4; ++i)
                sum += std::abs(double(frame_.object_views[object_].to_clip[std::size_t(row)][i]) *
                                double(xyz1[i]));
            return sum;
        };
        const VertexState& state = frame_.vertices[object_][v];
        Rounding rounding{magnitudes(0), magnitudes(1), camera_.orthographic ? 0 : magnitudes(3)};
        rounding.least_w = double(state.clip.w);
        const glm::dvec2 exact = camera_.to_picture(eye_[v]);
        rounding.picture_x = std::abs(exact.x - camera_.width / 2.0);
        rounding.picture_y = std::abs(exact.y - camera_.height / 2.0);
        rounding_.push_back(rounding);
        if (state.outcode != 0) return;
        ++result_.vertices;
        const glm::dvec2 snapped(state.point.x, state.point.y);
        const double moved = glm::distance(snapped, exact * double(subpixels));
        result_.displacement = std::max(result_.displacement, moved);
        result_.bound_share = std::max(result_.bound_share, moved / rounding.bound());
    }

    /// Of every point of a triangle's outline, also of the corners that clipping makes.
    double triangle_bound(const std::array<std::uint32_t, 3>& triangle) const {
        Rounding all;
        std::uint8_t outside = 0;
        double bound = 0;
        for (const std::uint32_t v : triangle) {
            const Rounding& r = rounding_[v];
            outside |= frame_.vertices[object_][v].outcode;
            bound = std::max(bound, r.bound());
            all.x = std::max(all.x, r.x), all.y = std::max(all.y, r.y);
            all.w = std::max(all.w, r.w), all.least_w = std::min(all.least_w, r.least_w);
        }
        if (outside == 0) return bound;
        // New corners are interpolated in double and rounded to float again, wherever the edge
        // leaves the room between near, far and the guard band.
        all.least_w = std::max(all.least_w, camera_.orthographic ? 1 : double(frame_.view.near));
        all.picture_x = all.picture_y = double(guard_band);
        return all.bound() * 1.2;
    }

    void measure_triangle(const std::array<std::uint32_t, 3>& triangle, std::uint32_t id) {
        const std::array<glm::dvec3, 3> eye = {eye_[triangle[0]], eye_[triangle[1]],
                                               eye_[triangle[2]]};
        const ReferencePolygon polygon = reference_polygon(camera_, eye);
        const auto begin = next_;
        while (next_ != spans_.end() && next_->id == id) ++next_;
        const SampleBox box = box_of(polygon, begin);
        if (box.empty()) return;
        const glm::dvec3 normal = glm::cross(eye[1] - eye[0], eye[2] - eye[0]);
        const double offset = glm::dot(normal, eye[0]), bound = triangle_bound(triangle);
        auto span = begin;
        for (int y = box.y0; y <= box.y1; ++y)
            for (int x = box.x0; x <= box.x1; ++x) {
                while (span != next_ && (span->y < y || (span->y == y && span->end <= x))) ++span;
                const bool covered = span != next_ && span->y == y && span->begin <= x;
                const glm::dvec2 sample(x + 0.5, y + 0.5);
                const double inside = polygon.line_distance(sample);
                if (inside < -undecided && !covered) continue;
                const double distance = polygon.outline_distance(sample);
                compare_sample(target_.index(x, y), covered, inside > 0, distance, bound);
                if (inside > 0) see({x, y}, id, normal, offset);
            }
    }

    /// The samples that either covers.
    SampleBox box_of(const ReferencePolygon& polygon,
                     std::vector<Span>::const_iterator begin) const {
        SampleBox box{camera_.width, camera_.height, -1, -1};
        const auto add = [&](double x0, double y0, double x1, double y1) {
            const auto pixel = [](double x, int size) {
                return int(std::floor(std::clamp(x, -1.0, double(size))));
            };
            box.x0 = std::min(box.x0, std::max(pixel(x0, camera_.width), 0));
            box.y0 = std::min(box.y0, std::max(pixel(y0, camera_.height), 0));
            box.x1 = std::max(box.x1, std::min(pixel(x1, camera_.width), camera_.width - 1));
            box.y1 = std::max(box.y1, std::min(pixel(y1, camera_.height), camera_.height - 1));
        };
        glm::dvec2 low(infinite), high(-infinite);
        for (const glm::dvec2& p : polygon.corners())
            low = glm::min(low, p), high = glm::max(high, p);
        if (!polygon.corners().empty()) add(low.x, low.y, high.x, high.y);
        for (auto s = begin; s != next_; ++s) add(s->begin, s->y, s->end - 1, s->y);
        return box;
    }

    void compare_sample(std::size_t sample, bool covered, bool inside, double distance,
                        double bound) {
        covered_[sample] = covered_[sample] || covered;
        reference_covered_[sample] = reference_covered_[sample] || inside;
        at_edge_[sample] = at_edge_[sample] || distance <= undecided;
        if (covered == inside || distance <= undecided) return;
        moved_[sample] = true;
        const double moved = distance * subpixels;
        result_.edge_distance = std::max(result_.edge_distance, moved);
        result_.bound_share = std::max(result_.bound_share, moved / bound);
    }

    /// The nearest triangle in double; of equal depth the first.
    void see(const glm::ivec2& sample, std::uint32_t id, const glm::dvec3& normal, double offset) {
        const double x = (sample.x + 0.5 - camera_.width / 2.0) / camera_.scale;
        const double y = (sample.y + 0.5 - camera_.height / 2.0) / camera_.scale;
        const double nearness = camera_.orthographic
                                    ? (normal.x * x + normal.y * y - offset) / normal.z
                                    : (normal.x * x + normal.y * y + normal.z) / offset;
        const std::size_t i = target_.index(sample.x, sample.y);
        if (nearest_id_[i] != Framebuffer::no_triangle && !(nearness > nearest_[i])) return;
        nearest_[i] = nearness;
        nearest_id_[i] = id;
    }

    void count_samples() {
        find_visible(frame_);
        for (std::size_t i = 0; i < covered_.size(); ++i) {
            result_.samples += covered_[i];
            result_.moved += moved_[i];
            if (at_edge_[i]) continue;
            result_.opened += covered_[i] != reference_covered_[i];
            result_.mistaken += !moved_[i] && frame_.id[i] != nearest_id_[i];
        }
    }

    const ReferenceCamera camera_;
    const Scene& given_;
    const Scene normal_;
    const RenderPlan plan_;
    Framebuffer target_;
    Frame frame_;
    GeometryResult result_;

    std::vector<Span> spans_;  // by triangle, then from the top
    std::vector<Span>::const_iterator next_;
    std::size_t object_ = 0;
    std::vector<glm::dvec3> eye_;     // [vertex] of the object
    std::vector<Rounding> rounding_;  // [vertex]
    std::vector<std::uint8_t> covered_, reference_covered_, at_edge_, moved_;  // [sample]: bool
    std::vector<double> nearest_;            // [sample] larger is nearer
    std::vector<std::uint32_t> nearest_id_;  // [sample]
};

}  // namespace

GeometryResult measure_geometry(const ReportInput& input) {
    return GeometryMeasurement(input).measure();
}

}  // namespace scanshade

// The reference of the stability report's geometry against exact arithmetic: rational numbers from
// the meshes' floats and the camera's doubles on, and no clipping at all.
#include "report/picture_geometry.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <limits>
#include <set>

#include "report/picture_cases.hpp"
#include "report/picture_reference.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"

using namespace scanshade;
namespace mp = boost::multiprecision;

namespace {

using Integer = mp::number<mp::cpp_int_backend<>, mp::et_off>;
using Rational = mp::number<mp::rational_adaptor<mp::cpp_int_backend<>>, mp::et_off>;
using ExactVec = std::array<Rational, 3>;

Rational exact(double x) { return Rational(x); }
ExactVec exact(const glm::dvec3& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }

Rational dot(const ExactVec& a, const ExactVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// ReferenceCamera on numbers without rounding.
class ExactCamera {
public:
    explicit ExactCamera(const ReferenceCamera& camera) : camera_(camera) {}

    ExactVec eye(const Object& object, std::uint32_t vertex) const {
        const Mesh& m = *object.mesh;
        const float xyz[3] = {m.x[vertex], m.y[vertex], m.z[vertex]};
        ExactVec from;
        for (int row = 0; row < 3; ++row) {
            from[std::size_t(row)] = exact(object.to_world[3][row]) - exact(camera_.position[row]);
            for (int i = 0; i < 3; ++i)
                from[std::size_t(row)] +=
                    exact(object.to_world[i][row]) *
                    (exact(m.origin[i]) + exact(m.unit) * exact(double(xyz[i])));
        }
        return {dot(exact(camera_.right), from), dot(exact(camera_.down), from),
                dot(exact(camera_.forward), from)};
    }

    /// Homogeneous, from the middle of the picture: pixels are [0]/[2] and [1]/[2].
    ExactVec on_picture(const ExactVec& eye) const {
        const Rational scale = exact(camera_.scale);
        return {scale * eye[0], scale * eye[1], camera_.orthographic ? Rational(1) : eye[2]};
    }

private:
    const ReferenceCamera& camera_;
};

/// A linear function of the sample with whole coefficients; only its sign counts.
struct ExactLine {
    Integer x, y, constant;

    int sign(int px, int py) const { return (x * px + y * py + constant).sign(); }
};

/// Which samples see a triangle, by its homogeneous edge functions (Olano and Greer 1997): the ray
/// through a sample meets the triangle's plane in Σ λ_i v_i / Σ λ_i.
class ExactTriangle {
public:
    enum class Side { outside, edge, inside };

    ExactTriangle(const ReferenceCamera& camera, const std::array<ExactVec, 3>& eye) {
        const ExactCamera exact_camera(camera);
        std::array<ExactVec, 3> v, line;
        for (std::size_t i = 0; i < 3; ++i) v[i] = exact_camera.on_picture(eye[i]);
        for (std::size_t i = 0; i < 3; ++i) line[i] = cross(v[(i + 1) % 3], v[(i + 2) % 3]);
        flat_ = dot(line[0], v[0]) == 0;
        ExactVec sum{}, near{}, far{};  // Σλ; Σλ_i (z_i − near); Σλ_i (far − z_i)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += line[i][c];
                near[c] += line[i][c] * (eye[i][2] - exact(camera.near));
                far[c] += line[i][c] * (exact(camera.far) - eye[i][2]);
            }
        sum_ = whole(sum, camera);
        for (const ExactVec& each : {line[0], line[1], line[2], near, far})
            bounds_.push_back(whole(each, camera));
    }

    Side side(int px, int py) const {
        if (flat_) return Side::outside;
        const int sense = sum_.sign(px, py);
        Side result = sense == 0 ? Side::edge : Side::inside;
        for (const ExactLine& bound : bounds_) {
            const int s = sense * bound.sign(px, py);
            if (s < 0) return Side::outside;
            if (s == 0) result = Side::edge;
        }
        return result;
    }

private:
    static ExactVec cross(const ExactVec& a, const ExactVec& b) {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /// In pixels from the upper left corner, at their centres, times whatever makes it whole.
    static ExactLine whole(const ExactVec& line, const ReferenceCamera& camera) {
        const Rational constant = line[2] + line[0] * (Rational(1 - camera.width) / 2) +
                                  line[1] * (Rational(1 - camera.height) / 2);
        // All denominators are powers of two.
        const Integer factor = std::max(
            {mp::denominator(line[0]), mp::denominator(line[1]), mp::denominator(constant)});
        const auto times = [&](const Rational& r) {
            return Integer(mp::numerator(Rational(r * factor)));
        };
        return {times(line[0]), times(line[1]), times(constant)};
    }

    bool flat_ = false;
    ExactLine sum_;
    std::vector<ExactLine> bounds_;
};

/// What the exact geometry of a scene says.
struct ExactComparison {
    double vertex_error = 0;           // pixels, of the reference's vertices
    double displacement = 0;           // 1/256 pixel, of the renderer's
    std::size_t wrong = 0;             // samples that the reference has on the wrong side
    std::vector<char> moved, at_edge;  // [sample] as GeometryResult has it
};

class ExactMeasurement {
public:
    explicit ExactMeasurement(const ReportInput& input)
        : camera_(reference_camera(input.scene, input.settings)),
          given_(input.scene),
          test_(input.scene, plain(input.settings)) {
        out_.moved.resize(test_.target.id.size());
        out_.at_edge.resize(test_.target.id.size());
        covered_.resize(test_.plan.triangles);
        visit_coverage(test_.frame, [this](const DrawnFace& face, int y, int begin, int end) {
            for (int x = begin; x < end; ++x) covered_[face.id].push_back(test_.target.index(x, y));
        });
    }

    ExactComparison measure() {
        for (std::size_t o = 0; o < given_.objects.size(); ++o) {
            const Mesh& mesh = *given_.objects[o].mesh;
            const std::vector<glm::dvec3> rounded = reference_vertices(camera_, given_.objects[o]);
            std::vector<ExactVec> eye;
            for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                eye.push_back(ExactCamera(camera_).eye(given_.objects[o], v));
                measure_vertex(test_.frame.vertices[o][v], eye.back(), rounded[v]);
            }
            const std::uint32_t first = test_.plan.objects[o].first_triangle;
            for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
                const auto& [a, b, c] = mesh.triangle[t];
                measure_triangle({eye[a], eye[b], eye[c]}, {rounded[a], rounded[b], rounded[c]},
                                 covered_[first + t]);
            }
        }
        return out_;
    }

private:
    static Settings plain(Settings settings) {
        settings.renderer = RendererKind::scalar_f32;
        settings.interpolation = Interpolation::perspective;
        return settings;
    }

    void measure_vertex(const VertexState& state, const ExactVec& eye, const glm::dvec3& rounded) {
        if (state.outcode != 0) return;
        const ExactVec h = ExactCamera(camera_).on_picture(eye);
        const auto pixel = [&](std::size_t i, int size) {
            return static_cast<double>(h[i] / h[2] + Rational(size) / 2);
        };
        const glm::dvec2 at(pixel(0, camera_.width), pixel(1, camera_.height));
        out_.vertex_error =
            std::max(out_.vertex_error, glm::distance(camera_.to_picture(rounded), at));
        out_.displacement = std::max(
            out_.displacement, glm::distance(glm::dvec2(state.point.x, state.point.y), at * 256.0));
    }

    void measure_triangle(const std::array<ExactVec, 3>& eye,
                          const std::array<glm::dvec3, 3>& rounded,
                          const std::vector<std::size_t>& covered) {
        const ReferencePolygon polygon = reference_polygon(camera_, rounded);
        const ExactTriangle exact_triangle(camera_, eye);
        auto next = covered.begin();  // ascending
        // A pixel beyond a polygon in floating point, exact arithmetic has nothing to add.
        constexpr double infinity = std::numeric_limits<double>::infinity();
        glm::dvec2 low(infinity), high(-infinity);
        for (const glm::dvec2& p : polygon.corners())
            low = glm::min(low, p - 2.0), high = glm::max(high, p + 1.0);
        const auto clamped = [](double x, int size) {
            return int(std::clamp(x, 0.0, double(size)));
        };
        for (int y = clamped(low.y, camera_.height); y < clamped(high.y, camera_.height); ++y)
            for (int x = clamped(low.x, camera_.width); x < clamped(high.x, camera_.width); ++x) {
                const std::size_t sample = test_.target.index(x, y);
                const bool drawn = next != covered.end() && *next == sample;
                next += drawn;
                const double line = polygon.line_distance({x + 0.5, y + 0.5});
                if (line < -1 && !drawn) continue;
                const ExactTriangle::Side side = exact_triangle.side(x, y);
                const double distance = polygon.outline_distance({x + 0.5, y + 0.5});
                if (side == ExactTriangle::Side::edge || distance <= undecided)
                    out_.at_edge[sample] = 1;
                else if ((line > 0) != (side == ExactTriangle::Side::inside))
                    ++out_.wrong;
                else if (drawn != (line > 0))
                    out_.moved[sample] = 1;
            }
        if (next != covered.end()) ++out_.wrong;
    }

    const ReferenceCamera camera_;
    const Scene& given_;
    TestFrame test_;
    std::vector<std::vector<std::size_t>> covered_;  // [triangle] samples
    ExactComparison out_;
};

std::size_t count(const std::vector<char>& flags) {
    return std::size_t(std::count(flags.begin(), flags.end(), 1));
}

}  // namespace

TEST_CASE("the reference geometry is that of exact arithmetic", "[report][stability][exact]") {
    const std::set<std::string_view> names = {
        "scale-1e-18",      "scale-1e18",      "offset-1e7-file",   "near-through-mesh",
        "near-and-far-cut", "inside-mesh",     "guard-band",        "behind-the-eye",
        "at-the-eye",       "w-ratio-1e6",     "depth-1e-3-to-1e9", "near-coplanar-1e-7",
        "t-junctions",      "zero-area-faces", "light-inside"};
    std::size_t found = 0;
    for (const HardCase& hard : hard_cases()) {
        if (names.count(hard.name) == 0) continue;
        ++found;
        CAPTURE(hard.name);
        const ReportInput input = hard.input();
        const ExactComparison exact = ExactMeasurement(input).measure();
        CHECK(exact.vertex_error <= undecided);
        CHECK(exact.wrong == 0);
        const GeometryResult got = measure_geometry(input);
        CHECK(got.displacement == Approx(exact.displacement).margin(256 * undecided));
        CHECK(std::abs(double(got.moved) - double(count(exact.moved))) <=
              double(count(exact.at_edge)));
    }
    CHECK(found == names.size());
}

TEST_CASE("distances from a polygon of the reference", "[report][stability]") {
    const PixelCamera camera(40, 30);
    Scene scene = make_scene(make_soup({camera.point(5, 5, 1), camera.point(5, 25, 1),
                                        camera.point(35, 25, 1), camera.point(35, 5, 1)},
                                       {{0, 1, 2, 3}}),
                             camera.camera);
    const ReferenceCamera reference = reference_camera(scene, camera.settings());
    const glm::dvec3 corner = reference.to_eye(camera.point(35, 25, 1));
    CHECK(glm::distance(reference.to_picture(corner), {35, 25}) < 1e-12);
    const ReferencePolygon polygon =
        reference_polygon(reference, {reference.to_eye(camera.point(5, 5, 1)),
                                      reference.to_eye(camera.point(5, 25, 1)), corner});
    CHECK(polygon.corners().size() == 3);
    CHECK(polygon.line_distance({6, 20}) == Approx(1));
    CHECK(polygon.line_distance({2, 20}) == Approx(-3));
    CHECK(polygon.outline_distance({1, 2}) == Approx(5));
    CHECK(polygon.outline_distance({20, 29}) == Approx(4));
}

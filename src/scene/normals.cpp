// Vertex normals: from the file, from smoothing groups, or by equation (C1). Faces are adjacent
// where they share a position number: what a file keeps apart stays apart.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scanshade/base/parallel.hpp"
#include "scanshade/eq/shading.hpp"
#include "scene/mesh_parts.hpp"

namespace scanshade {
namespace {

using Origin = CornerNormals::Origin;

/// A sum shorter than this share of its terms' lengths is what opposite normals leave: noise.
constexpr double cancelled_share = 1e-6;

/// Files round to about six digits: faces that meet at the crease angle itself share a normal.
constexpr double crease_tolerance = 1e-6;

/// Around a position with more faces than this the crease angle is not tested in pairs, because
/// the cost is the square. Smooth fans of any size are recognised without pairs.
constexpr std::size_t max_pairwise = 1024;

std::array<float, 3> to_float(const glm::dvec3& n) {
    return {float(n.x) + 0.0f, float(n.y) + 0.0f, float(n.z) + 0.0f};  // no -0: equal means same
}

/// Weights of the face normals in (C1), a corner.
std::vector<double> area_weights(const PolygonSoup& soup, const DrawnFaces& faces, double unit) {
    std::vector<double> weights;
    std::vector<glm::dvec3> polygon;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        polygon.clear();
        for (std::uint32_t c = faces.begin[f]; c < faces.begin[f + 1]; ++c)
            polygon.push_back(soup.positions[faces.corner[c].position] / unit);
        weights.insert(weights.end(), polygon.size(), glm::length(newell_normal(polygon)));
    }
    return weights;
}

/// The angle inside a polygon at p, [0, 2π].
double interior_angle(const glm::dvec3& before, const glm::dvec3& p, const glm::dvec3& after,
                      const glm::dvec3& normal) {
    const glm::dvec3 a = safe_normalize(after - p).value_or(glm::dvec3(0));
    const glm::dvec3 b = safe_normalize(before - p).value_or(glm::dvec3(0));
    const glm::dvec3 cross = glm::cross(a, b);
    const double angle = std::atan2(glm::length(cross), glm::dot(a, b));
    return glm::dot(cross, normal) < 0 ? 2 * std::numbers::pi - angle : angle;
}

std::vector<double> angle_weights(const PolygonSoup& soup, const DrawnFaces& faces) {
    std::vector<double> weights(faces.corner.size(), 0);
    std::vector<std::uint32_t> ring;  // corners, those at the place of the one before left out
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto point = [&](std::uint32_t c) {
            return soup.positions[faces.corner[c].position];
        };
        ring.clear();
        for (std::uint32_t c = faces.begin[f]; c < faces.begin[f + 1]; ++c)
            if (ring.empty() || point(c) != point(ring.back())) ring.push_back(c);
        while (ring.size() > 1 && point(ring.back()) == point(ring.front())) ring.pop_back();
        for (std::size_t i = 0; i < ring.size(); ++i)
            weights[ring[i]] =
                interior_angle(point(ring[(i + ring.size() - 1) % ring.size()]), point(ring[i]),
                               point(ring[(i + 1) % ring.size()]), faces.normal[f]);
    }
    return weights;
}

/// (C1) at one position after the other.
class NormalSum {
public:
    NormalSum(const PolygonSoup& soup, const DrawnFaces& faces, const NormalOptions& options,
              double unit, CornerNormals& out)
        : soup_(soup),
          faces_(faces),
          out_(out),
          by_group_(options.source == NormalSource::automatic && !soup.face_smoothing.empty()),
          by_angle_(options.source == NormalSource::angle),
          never_split_(options.crease_deg >= 180),
          crease_(options.crease_deg * std::numbers::pi / 180) {
        if (options.source == NormalSource::area) weight_ = area_weights(soup, faces, unit);
        if (by_angle_) weight_ = angle_weights(soup, faces);
    }

    /// `corners` are all corners at one position; changes their order.
    void sum_at(std::span<std::uint32_t> corners) const {
        if (by_group_)
            sum_by_group(corners);
        else if (never_split_ || is_smooth(corners) || corners.size() > max_pairwise)
            share(corners);
        else
            sum_pairwise(corners);
    }

private:
    struct Sum {
        glm::dvec3 normals{0};
        double weights = 0;
        std::uint32_t last_face = no_index;
    };

    const glm::dvec3& face_normal(std::uint32_t corner) const {
        return faces_.normal[faces_.face[corner]];
    }
    std::uint32_t group(std::uint32_t corner) const {
        return soup_.face_smoothing[faces_.number[faces_.face[corner]]];
    }

    /// A face that visits the position twice counts once, but for its angles, which add up.
    /// Corners are in the order of their faces, so the two visits follow one another.
    void add(std::uint32_t corner, Sum& sum) const {
        const std::uint32_t face = faces_.face[corner];
        if (face == sum.last_face && !by_angle_) return;
        sum.last_face = face;
        const double weight = weight_.empty() ? 1 : weight_[corner];
        sum.normals += weight * faces_.normal[face];
        sum.weights += weight;
    }

    void store(std::uint32_t corner, const Sum& sum) const {
        if (out_.origin[corner] != Origin::summed) return;  // the file's
        const Vec3<double> n =
            vertex_normal(Vec3<double>{sum.normals.x, sum.normals.y, sum.normals.z}, sum.weights,
                          cancelled_share);
        if (dot(n, n) > 0)
            out_.normal[corner] = to_float({n.x, n.y, n.z});
        else
            out_.origin[corner] = Origin::cancelled;
    }

    /// All faces lie so close to their mean direction that no two differ by the crease angle.
    bool is_smooth(std::span<const std::uint32_t> corners) const {
        glm::dvec3 sum(0);
        for (const std::uint32_t c : corners) sum += face_normal(c);
        const double length = glm::length(sum);
        if (length <= cancelled_share * double(corners.size())) return false;
        const double enough = std::cos(crease_ / 2) * length;
        return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
            return glm::dot(face_normal(c), sum) >= enough;
        });
    }

    /// One normal for all of the corners.
    void share(std::span<const std::uint32_t> corners) const {
        Sum sum;
        for (const std::uint32_t c : corners) add(c, sum);
        for (const std::uint32_t c : corners) store(c, sum);
    }

    /// Each corner sums over the faces within the crease angle of its own face: a rule that does
    /// not depend on the order of faces.
    void sum_pairwise(std::span<const std::uint32_t> corners) const {
        const double cos_crease = std::cos(crease_) - crease_tolerance;
        for (const std::uint32_t c : corners) {
            Sum sum;
            for (const std::uint32_t other : corners)
                if (glm::dot(face_normal(c), face_normal(other)) >= cos_crease) add(other, sum);
            store(c, sum);
        }
    }

    /// Corners of one group share a normal; group 0 is off: the face normal, which is there.
    void sum_by_group(std::span<std::uint32_t> corners) const {
        std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
            return group(a) != group(b) ? group(a) < group(b) : a < b;
        });
        for (std::size_t begin = 0, end; begin < corners.size(); begin = end) {
            end = begin + 1;
            while (end < corners.size() && group(corners[end]) == group(corners[begin])) ++end;
            if (group(corners[begin]) != 0) share(corners.subspan(begin, end - begin));
        }
    }

    const PolygonSoup& soup_;
    const DrawnFaces& faces_;
    CornerNormals& out_;
    bool by_group_, by_angle_, never_split_;
    double crease_;               // rad
    std::vector<double> weight_;  // [corner]; empty: 1
};

/// Takes the file's normals; true where there is one for every corner.
bool take_file_normals(const PolygonSoup& soup, const DrawnFaces& faces, CornerNormals& out) {
    bool all = true;
    for (std::size_t c = 0; c < faces.corner.size(); ++c) {
        const std::uint32_t number = faces.corner[c].normal;
        if (number == no_index) {
            all = false;
            continue;
        }
        const std::optional<glm::dvec3> n = safe_normalize(soup.normals[number]);
        out.origin[c] = n ? Origin::file : Origin::repaired;
        if (n) out.normal[c] = to_float(*n);
    }
    return all;
}

}  // namespace

std::optional<glm::dvec3> safe_normalize(const glm::dvec3& v) {
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(size > 0) || !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        return std::nullopt;
    int exponent;
    std::frexp(size, &exponent);
    const glm::dvec3 scaled(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent),
                            std::ldexp(v.z, -exponent));
    return scaled / glm::length(scaled);
}

CornerNormals corner_normals(const PolygonSoup& soup, const DrawnFaces& faces,
                             CornersByPosition& around, const NormalOptions& options, double unit) {
    CornerNormals out;
    out.origin.assign(faces.corner.size(), Origin::summed);
    out.normal.reserve(faces.corner.size());
    for (const std::uint32_t f : faces.face) out.normal.push_back(to_float(faces.normal[f]));
    if (options.source == NormalSource::automatic && take_file_normals(soup, faces, out))
        return out;
    const NormalSum sum(soup, faces, options, unit, out);
    constexpr std::size_t piece = 4096;  // positions that one thread looks at at once
    parallel_for(soup.positions.size(), piece, 0, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t p = begin; p < end; ++p) sum.sum_at(around.at(p));
    });
    return out;
}

}  // namespace scanshade

// Triangulation of one polygon by ear clipping.
//
// The polygon is projected along the largest component of its Newell normal and snapped to a grid
// of 2^-29 of its own size: finer than the floats that are drawn, and coarse enough that every
// orientation is computed exactly in 64-bit integers. So no decision depends on rounding, and the
// result does not change when the polygon is moved or scaled by a power of two.
#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/mesh_parts.hpp"

namespace scanshade {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Corners relative to the first one, times a power of two, so that the largest is in [1/2, 1).
struct LocalPolygon {
    std::vector<glm::dvec3> corners;
    int exponent;  // original = local · 2^exponent
};

LocalPolygon localised(std::span<const glm::dvec3> polygon) {
    LocalPolygon local{{polygon.begin(), polygon.end()}, 0};
    double size = 0;
    // Halved first: the difference of two corners may exceed the largest double.
    for (glm::dvec3& p : local.corners) {
        p = p * 0.5 - polygon.front() * 0.5;
        size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    if (size == 0) return local;
    int exponent;
    std::frexp(size, &exponent);
    for (glm::dvec3& p : local.corners)
        p = {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
    local.exponent = exponent + 1;
    return local;
}

glm::dvec3 newell_sum(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

/// Newell's sum, or what serves in its place; 0 where no digit of it is sure.
glm::dvec3 facing(std::span<const glm::dvec3> corners) {
    // Each cross product errs by at most a few units of rounding of the product of its lengths,
    // which is below 12 here.
    const double rounding = 0x1p-48 * double(corners.size());
    const glm::dvec3 sum = newell_sum(corners);
    if (glm::length(sum) > rounding) return sum;
    if (corners.size() != 4) return glm::dvec3(0);
    // A quadrilateral's sum is the cross product of its diagonals. Where they are parallel, but on two
    // lines, its corners are those of a trapezoid in another order: halves that cancel.
    const bool folded = glm::distance(corners[0], corners[2]) <= rounding ||
                        glm::distance(corners[1], corners[3]) <= rounding;
    const glm::dvec3 first = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return folded || glm::length(first) <= rounding ? glm::dvec3(0) : first;
}

struct GridPoint {
    std::int64_t x, y;  // at most 2^29
    bool operator==(const GridPoint&) const = default;
};

/// Twice the area of a b c: positive where they turn left. Exact: at most 2^62.
std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<GridPoint> project(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    int first = (dropped + 1) % 3, second = (dropped + 2) % 3;
    if (normal[dropped] < 0) std::swap(first, second);
    std::vector<GridPoint> points;
    points.reserve(corners.size());
    for (const glm::dvec3& p : corners)
        points.push_back(
            {std::llround(std::ldexp(p[first], 29)), std::llround(std::ldexp(p[second], 29))});
    return points;
}

/// How the outline turns. A simple outline turns once around, whatever its shape.
struct Turning {
    int rounds = 0;
    bool right_turn = false;
    bool spike = false;  // goes back the way it came, so that `rounds` says nothing

    bool convex() const { return !right_turn && !spike && rounds == 1; }
    bool crosses_itself() const { return !spike && rounds != 1; }
};

Turning turning(const std::vector<GridPoint>& points) {
    std::vector<GridPoint> directions;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const GridPoint a = points[i], b = points[(i + 1) % points.size()];
        if (a != b) directions.push_back({b.x - a.x, b.y - a.y});
    }
    const auto upper = [](GridPoint d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
    Turning t;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const GridPoint d = directions[i], e = directions[(i + 1) % directions.size()];
        const std::int64_t cross = d.x * e.y - d.y * e.x;
        // Angles in [0, π) are the upper half: a left turn passes 0 from lower to upper.
        if (cross > 0 && !upper(d) && upper(e)) ++t.rounds;
        if (cross < 0 && upper(d) && !upper(e)) --t.rounds;
        t.right_turn |= cross < 0;
        t.spike |= cross == 0 && upper(d) != upper(e);
    }
    return t;
}

class EarClipper {
public:
    explicit EarClipper(const std::vector<GridPoint>& points)
        : points_(points), removed_(points.size()), work_left_(points.size() << 12) {
        const std::uint32_t n = std::uint32_t(points.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            previous_.push_back((i + n - 1) % n);
            next_.push_back((i + 1) % n);
            by_x_.push_back(i);
        }
        std::sort(by_x_.begin(), by_x_.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return points[a].x < points[b].x; });
    }

    std::vector<Triangle> run() {
        Rule rule = Rule::ear;
        refill();
        std::uint32_t last = 0;
        for (std::size_t left = points_.size(); left > 3;) {
            if (queue_.empty()) {
                rule = Rule(std::min(int(rule) + 1, int(Rule::any)));
                refill();
            }
            const std::uint32_t i = queue_.front();
            queue_.pop_front();
            if (removed_[i] || !accepts(rule, i)) continue;
            stuck_ |= rule >= Rule::left_turn;
            last = next_[i];
            clip(i);
            --left;
            if (work_left_ > 0) rule = Rule::ear;
        }
        triangles_.push_back({previous_[last], last, next_[last]});
        return std::move(triangles_);
    }

    /// No triangulation without overlap was found.
    bool stuck() const { return stuck_; }

private:
    /// What may be clipped; the next one applies where no corner satisfies the one before. A
    /// simple outline always has an ear; one that touches itself may be left with corners that
    /// have no area; one that crosses itself needs the others.
    enum class Rule { ear, no_area, left_turn, any };

    bool accepts(Rule rule, std::uint32_t i) {
        switch (rule) {
            case Rule::ear:
                return is_spike(i) || is_ear(i);
            case Rule::no_area:
                return turn(i) == 0;
            case Rule::left_turn:
                return turn(i) > 0;
            case Rule::any:
                break;
        }
        return true;
    }

    /// All corners that are left: every other one first, so that not all triangles share a corner.
    void refill() {
        for (const std::size_t first : {0u, 1u})
            for (std::size_t i = first; i < points_.size(); i += 2)
                if (!removed_[i]) queue_.push_back(std::uint32_t(i));
    }

    std::int64_t turn(std::uint32_t i) const {
        return orientation(points_[previous_[i]], points_[i], points_[next_[i]]);
    }

    /// Goes back the way it came, or stays in place: clipped before any ear leans on it.
    bool is_spike(std::uint32_t i) const {
        const GridPoint p = points_[i], a = points_[previous_[i]], c = points_[next_[i]];
        return turn(i) == 0 && (a.x - p.x) * (c.x - p.x) + (a.y - p.y) * (c.y - p.y) >= 0;
    }

    /// Removes corner i with its triangle; only its neighbours can become ears by that.
    void clip(std::uint32_t i) {
        const std::uint32_t a = previous_[i], c = next_[i];
        triangles_.push_back({a, i, c});
        next_[a] = c;
        previous_[c] = a;
        removed_[i] = true;
        queue_.push_back(a);
        queue_.push_back(c);
        if (2 * ++stale_ > by_x_.size()) {
            std::erase_if(by_x_, [&](std::uint32_t k) { return removed_[k]; });
            stale_ = 0;
        }
    }

    /// Corner i turns left and nothing of the outline reaches into its triangle.
    bool is_ear(std::uint32_t i) {
        if (work_left_ == 0 || turn(i) <= 0) return false;
        const std::array<std::uint32_t, 3> ear{previous_[i], i, next_[i]};
        const GridPoint p = points_[ear[0]], q = points_[i], r = points_[ear[2]];
        const auto [left, right] = std::minmax({p.x, q.x, r.x});
        const auto [low, high] = std::minmax({p.y, q.y, r.y});
        auto k =
            std::lower_bound(by_x_.begin(), by_x_.end(), left,
                             [&](std::uint32_t a, std::int64_t x) { return points_[a].x < x; });
        for (; k != by_x_.end() && points_[*k].x <= right && work_left_ > 0; ++k, --work_left_) {
            if (points_[*k].y < low || points_[*k].y > high || removed_[*k]) continue;
            if (*k != ear[0] && *k != i && *k != ear[2] && blocks(*k, ear)) return false;
        }
        return work_left_ > 0;
    }

    bool blocks(std::uint32_t q, const std::array<std::uint32_t, 3>& ear) const {
        const GridPoint p[3] = {points_[ear[0]], points_[ear[1]], points_[ear[2]]};
        for (int k = 0; k < 3; ++k) {
            if (points_[q] != p[k]) continue;
            // A second corner at the same point, as holes have that are joined to the outline by
            // a cut, only blocks where one of its edges goes into the triangle.
            const auto goes_inside = [&](GridPoint r) {
                return orientation(p[k], p[(k + 1) % 3], r) > 0 &&
                       orientation(p[k], r, p[(k + 2) % 3]) > 0;
            };
            return goes_inside(points_[previous_[q]]) || goes_inside(points_[next_[q]]);
        }
        return orientation(p[0], p[1], points_[q]) >= 0 &&
               orientation(p[1], p[2], points_[q]) >= 0 && orientation(p[2], p[0], points_[q]) >= 0;
    }

    const std::vector<GridPoint>& points_;
    std::vector<std::uint32_t> previous_, next_;  // the outline that is left, a ring
    std::vector<std::uint32_t> by_x_;             // corners by x, to test near ones only
    std::size_t stale_ = 0;                       // removed ones among them
    std::vector<bool> removed_;
    std::deque<std::uint32_t> queue_;  // corners to look at
    std::size_t work_left_;            // tests that a hostile outline may cost
    std::vector<Triangle> triangles_;
    bool stuck_ = false;
};

std::vector<Triangle> fan(std::size_t corners) {
    std::vector<Triangle> triangles;
    triangles.reserve(corners - 2);
    for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
    return triangles;
}

}  // namespace

glm::dvec3 newell_normal(const std::vector<glm::dvec3>& polygon) {
    if (polygon.size() < 3) return glm::dvec3(0);
    const LocalPolygon local = localised(polygon);
    const glm::dvec3 n = facing(local.corners);
    const int exponent = 2 * local.exponent;
    return {std::ldexp(n.x, exponent), std::ldexp(n.y, exponent), std::ldexp(n.z, exponent)};
}

std::optional<glm::dvec3> unit_newell_normal(std::span<const glm::dvec3> polygon) {
    if (polygon.size() < 3) return std::nullopt;
    return safe_normalize(facing(localised(polygon).corners));
}

std::vector<Triangle> triangulate(const std::vector<glm::dvec3>& polygon, EventCounts& events) {
    if (polygon.size() < 3) return {};
    if (polygon.size() == 3) return fan(3);
    const LocalPolygon local = localised(polygon);
    const std::vector<GridPoint> points = project(local.corners, facing(local.corners));
    const Turning turns = turning(points);
    if (turns.convex() || (!turns.right_turn && turns.rounds == 0)) return fan(polygon.size());
    events.add(Event::concave_face);
    EarClipper clipper(points);
    std::vector<Triangle> triangles = clipper.run();
    if (turns.crosses_itself() || clipper.stuck()) events.add(Event::self_crossing_face);
    return triangles;
}

}  // namespace scanshade

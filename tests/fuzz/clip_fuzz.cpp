// Triangles across near, far and the guard band: what is covered once they are clipped, against the
// sign of exact determinants before; and neighbours stay neighbours.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fuzz/fuzz.hpp"
#include "render/clip.hpp"
#include "render/walk.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

constexpr int side = 16;
using Exact =
    __int128;  // coordinates are whole and below 2^26, w below 2^14: products of three fit

View make_fuzz_view() {
    View view{};
    view.near = 2, view.far = 4096;
    view.width = view.height = side;
    return view;
}

/// A corner with whole coordinates: exact in float and in what it is compared with.
ClipVertex corner(Rng& rng) {
    const auto d = float(rng.chance(0.7) ? rng.integer(1, 64) : rng.integer(-6000, 6000));
    const auto reach = std::int64_t(rng.chance(0.6) ? 2 * side * std::abs(d) : (1 << 24) - 1);
    return {float(rng.integer(-reach, reach)), float(rng.integer(-reach, reach)), d, d};
}

std::vector<SnappedPoint> clipped(std::vector<ClipVertex> polygon, const View& view) {
    std::uint8_t outside = 0;
    for (const ClipVertex& v : polygon) outside |= view.outcode(v);
    if (outside != 0) clip_polygon(polygon, outside, view);
    std::vector<SnappedPoint> points;
    if (polygon.size() >= 3)
        for (const ClipVertex& v : polygon) points.push_back(view.snap(v));
    return points;
}

/// How often each sample is covered.
struct Coverage {
    int at[side][side] = {};
    bool operator==(const Coverage&) const = default;
};

Coverage coverage(const std::vector<SnappedPoint>& points) {
    Coverage count;
    if (points.size() < 3 || twice_area(points) == 0) return count;
    PolygonWalker().walk(points, twice_area(points) > 0, {}, side, side,
                         [&](int y, int begin, int end) {
                             for (int x = begin; x < end; ++x) ++count.at[y][x];
                         });
    return count;
}

/// A half plane of the picture: positive inside.
struct HalfPlane {
    double value, slope;  // at a sample; change in a pixel
};

/// The part of a triangle between near and far, as half planes of exact determinants.
class ExactTriangle {
public:
    ExactTriangle(const std::array<ClipVertex, 3>& t, const View& view) : view_(view) {
        const auto minor = [](float p, float q, float r, float s) {
            return Exact(p) * Exact(s) - Exact(q) * Exact(r);
        };
        for (std::size_t i = 0; i < 3; ++i) {
            const ClipVertex &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
            edge_[i] = {minor(a.y, a.w, b.y, b.w), minor(a.w, a.x, b.w, b.x),
                        minor(a.x, a.y, b.x, b.y)};
        }
        volume_ =
            edge_[0][0] * Exact(t[0].x) + edge_[0][1] * Exact(t[0].y) + edge_[0][2] * Exact(t[0].w);
        if (volume_ > 0) return;
        volume_ = -volume_;
        for (auto& e : edge_)
            for (Exact& c : e) c = -c;
    }
    bool flat() const { return volume_ == 0; }

    /// At a sample, in half pixels from the picture's centre: +1 inside, −1 outside, 0 within a
    /// pixel of an edge, as corners are snapped.
    int side_of(int half_x, int half_y) const {
        std::array<HalfPlane, 5> planes;
        double sum = 0, sum_x = 0, sum_y = 0;  // volume/w, its change in a pixel
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& e = edge_[i];
            planes[i] = {0.5 * double(e[0] * half_x + e[1] * half_y + 2 * e[2]),
                         std::hypot(double(e[0]), double(e[1]))};
            sum += planes[i].value, sum_x += double(e[0]), sum_y += double(e[1]);
        }
        const double at_near = double(volume_) / double(view_.near);
        const double at_far = double(volume_) / double(view_.far), slope = std::hypot(sum_x, sum_y);
        planes[3] = {at_near - sum, slope + 1e-6 * at_near};
        planes[4] = {sum - at_far, slope + 1e-6 * at_far};
        int where = 1;
        for (const HalfPlane& p : planes)
            where = std::min(where, p.value < -p.slope ? -1 : p.value > p.slope ? 1 : 0);
        return where;
    }

private:
    const View& view_;
    std::array<std::array<Exact, 3>, 3> edge_{};
    Exact volume_ = 0;
};

void check_against_exact(const std::array<ClipVertex, 3>& t, const View& view) {
    const ExactTriangle exact(t, view);
    if (exact.flat()) return;
    const Coverage got = coverage(clipped({t.begin(), t.end()}, view));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int expected = exact.side_of(2 * x + 1 - side, 2 * y + 1 - side);
            if (got.at[y][x] > 1) broken("a triangle covers a sample once");
            if (expected > 0 && got.at[y][x] == 0) broken("a triangle covers what is inside");
            if (expected < 0 && got.at[y][x] > 0) broken("a triangle covers nothing outside");
        }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const View view = make_fuzz_view();
    Rng rng(std::span(data, size));
    std::array<ClipVertex, 3> t{corner(rng), corner(rng), corner(rng)};
    check_against_exact(t, view);
    // From either end an edge is cut at the same points.
    const auto points = clipped({t[0], t[1], t[2]}, view);
    for (const std::array<int, 3>& order : {std::array{1, 2, 0}, std::array{2, 1, 0}}) {
        const auto other = clipped(
            {t[std::size_t(order[0])], t[std::size_t(order[1])], t[std::size_t(order[2])]}, view);
        if (coverage(points) != coverage(other)) broken("the order of corners changes nothing");
    }
    return 0;
}

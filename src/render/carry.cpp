#include "render/carry.hpp"

#include <algorithm>
#include <cmath>

namespace scanshade {

bool homogeneous_weights(const DrawnFace& face, const View& view, SnappedPoint p,
                         double (&lambda)[3]) {
    const double X = double(p.x) / subpixels - view.width / 2.0;
    const double Y = double(p.y) / subpixels - view.height / 2.0;
    bool clamped = false;
    for (int i = 0; i < 3; ++i) {
        lambda[i] = face.edges.a[i] * X + face.edges.b[i] * Y + face.edges.c[i];
        clamped |= !(lambda[i] >= 0);
        lambda[i] = std::max(lambda[i], 0.0);
    }
    // All three are below zero only for a sample far outside by rounding: take the middle.
    if (!(lambda[0] + lambda[1] + lambda[2] > 0)) lambda[0] = lambda[1] = lambda[2] = 1;
    return clamped;
}

namespace {

double cross2(const PictureCorner& a, const PictureCorner& b) { return a.x * b.y - a.y * b.x; }

/// The root of a v² + b v + c that lies nearest to [0, 1].
std::optional<double> patch_root(double a, double b, double c) {
    const auto outside = [](double t) { return std::max({0.0, -t, t - 1}); };
    if (a == 0) return b == 0 ? std::nullopt : std::optional(-c / b);
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    // b and the root have the same sign, so q does not cancel.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    if (q == 0) return 0.0;
    const double first = q / a, second = c / q;
    return outside(first) <= outside(second) ? first : second;
}

}  // namespace

std::optional<PatchPlace> inverse_bilinear(const PictureCorner& A, const PictureCorner& B,
                                           const PictureCorner& C, const PictureCorner& D,
                                           const PictureCorner& p) {
    // p − A = u e + v f + u v g
    const PictureCorner e = {B.x - A.x, B.y - A.y}, f = {C.x - A.x, C.y - A.y};
    const PictureCorner g = {A.x - B.x - C.x + D.x, A.y - B.y - C.y + D.y};
    const PictureCorner h = {p.x - A.x, p.y - A.y};
    const std::optional<double> v =
        patch_root(cross2(g, f), cross2(e, f) + cross2(h, g), cross2(h, e));
    if (!v) return std::nullopt;
    const double x = e.x + g.x * *v, y = e.y + g.y * *v;
    const double u = std::abs(x) > std::abs(y) ? (h.x - f.x * *v) / x : (h.y - f.y * *v) / y;
    if (!std::isfinite(u)) return std::nullopt;
    return PatchPlace{std::clamp(u, 0.0, 1.0), std::clamp(*v, 0.0, 1.0)};
}

}  // namespace scanshade

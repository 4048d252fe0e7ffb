// The scanline walker: which samples a polygon covers. Integer arithmetic throughout, so the answer
// is exact and the same everywhere.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace scanshade {

inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;  // in one pixel

/// A point on the picture in 1/256 pixel from the picture's upper left corner, y down.
/// |x|, |y| < 2^24: within the guard band.
struct SnappedPoint {
    std::int32_t x, y;
    bool operator==(const SnappedPoint&) const = default;
};

/// Where in each pixel the sample stands, in 1/256 pixel: the centre is {128, 128}.
struct SampleOffset {
    std::int32_t x = subpixels / 2, y = subpixels / 2;
    bool operator==(const SampleOffset&) const = default;
};

/// Twice the signed area of a closed polygon in (1/256 pixel)²; positive where the corners run
/// clockwise on the picture (y down). Exact: |result| < 2^50 · corners.
inline std::int64_t twice_area(std::span<const SnappedPoint> polygon) {
    std::int64_t sum = 0;
    const SnappedPoint o = polygon[0];
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const SnappedPoint a = polygon[i], b = polygon[i + 1];
        sum += std::int64_t(a.x - o.x) * (b.y - o.y) - std::int64_t(b.x - o.x) * (a.y - o.y);
    }
    return sum;
}

/// Value at p of the edge function of a→b: twice the area of (a, b, p), positive to the right of
/// the edge on the picture (y down). Exact: |result| < 2^50.
inline std::int64_t edge_function(SnappedPoint a, SnappedPoint b, SnappedPoint p) {
    return std::int64_t(b.x - a.x) * (p.y - a.y) - std::int64_t(b.y - a.y) * (p.x - a.x);
}

/// ⌈n/d⌉ for d > 0.
inline std::int64_t ceil_div(std::int64_t n, std::int64_t d) {
    return n / d + ((n % d != 0 && n > 0) ? 1 : 0);
}

/// One edge on its way down the picture: in each row the first pixel whose sample is not to the
/// left of the edge. Advances by adding a quotient and a remainder: no rounding, no drift.
class EdgeWalker {
public:
    EdgeWalker() = default;
    EdgeWalker(SnappedPoint a, SnappedPoint b, SampleOffset sample, std::int32_t row_begin,
               std::int32_t row_end) {
        direction_ = a.y < b.y ? 1 : -1;
        if (a.y > b.y) std::swap(a, b);
        // Rows whose sample lies in [a.y, b.y): the upper end belongs to the edge, the lower not.
        first_ = row_of(a.y, sample.y);
        last_ = row_of(b.y, sample.y);
        first_ = std::max(first_, row_begin);
        last_ = std::min(last_, row_end);
        if (first_ >= last_) return;
        // The edge crosses the row at x = a.x + (Y − a.y) dx/dy; the pixel is ⌈(x − sample)/256⌉.
        const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
        const std::int64_t Y = std::int64_t(first_) * subpixels + sample.y;
        const std::int64_t numerator = (a.x - std::int64_t(sample.x)) * dy + (Y - a.y) * dx;
        divisor_ = subpixels * dy;
        pixel_ = ceil_div(numerator, divisor_);
        deficit_ = pixel_ * divisor_ - numerator;
        // dx/dy pixels to the right in each row, as whole pixels and a positive remainder.
        step_ = ceil_div(dx, dy);
        step_deficit_ = (step_ * dy - dx) * subpixels;
    }

    std::int32_t first_row() const { return first_; }
    std::int32_t last_row() const { return last_; }  // one past
    int direction() const { return direction_; }     // +1: down
    std::int64_t pixel() const { return pixel_; }

    void next_row() {
        pixel_ += step_;
        deficit_ += step_deficit_;
        if (deficit_ >= divisor_) {
            deficit_ -= divisor_;
            --pixel_;
        }
    }

private:
    static std::int32_t row_of(std::int32_t y, std::int32_t sample_y) {
        return static_cast<std::int32_t>(ceil_div(std::int64_t(y) - sample_y, subpixels));
    }
    std::int32_t first_ = 0, last_ = 0;
    int direction_ = 0;
    std::int64_t pixel_ = 0;    // ⌈exact crossing⌉
    std::int64_t deficit_ = 0;  // (pixel − exact crossing) · divisor, in [0, divisor)
    std::int64_t divisor_ = 1;
    std::int64_t step_ = 0, step_deficit_ = 0;
};

/// Walks polygons of any number of corners; keeps its lists of edges from one to the next.
class PolygonWalker {
public:
    /// Calls span(y, x_begin, x_end) for the covered samples of each row of a width × height picture,
    /// from the top. A sample is covered where the polygon winds around it in its own sense; samples
    /// on a left or top edge are covered, those on a right or bottom edge are not. Polygons that share
    /// an edge therefore never share a sample and leave none out.
    /// polygon: 3 or more corners; `positive`: its area is positive.
    template <class Span>
    void walk(std::span<const SnappedPoint> polygon, bool positive, SampleOffset sample,
              std::int32_t width, std::int32_t height, Span&& span) {
        edges_.clear();
        std::int32_t row = height, row_end = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const EdgeWalker edge(polygon[i], polygon[(i + 1) % polygon.size()], sample, 0, height);
            if (edge.first_row() >= edge.last_row()) continue;
            row = std::min(row, edge.first_row());
            row_end = std::max(row_end, edge.last_row());
            edges_.push_back(edge);
        }
        for (; row < row_end; ++row) {
            collect_active(row);
            int winding = 0;
            for (std::size_t i = 0; i + 1 < active_.size(); ++i) {
                // A polygon of positive area has its left edges going up.
                winding += positive ? -active_[i]->direction() : active_[i]->direction();
                const std::int64_t begin = std::max<std::int64_t>(active_[i]->pixel(), 0);
                const std::int64_t end = std::min<std::int64_t>(active_[i + 1]->pixel(), width);
                if (winding > 0 && begin < end)
                    span(row, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end));
            }
            for (EdgeWalker* edge : active_) edge->next_row();
        }
    }

private:
    /// The edges that cross a row, from left to right.
    void collect_active(std::int32_t row) {
        active_.clear();
        for (EdgeWalker& edge : edges_) {
            if (row < edge.first_row() || row >= edge.last_row()) continue;
            std::size_t at = active_.size();
            active_.push_back(&edge);
            for (; at > 0 && active_[at - 1]->pixel() > edge.pixel(); --at)
                active_[at] = active_[at - 1];
            active_[at] = &edge;
        }
    }

    std::vector<EdgeWalker> edges_;
    std::vector<EdgeWalker*> active_;
};

}  // namespace scanshade

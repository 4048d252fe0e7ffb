// Rare events: oddities of numbers and geometry that are handled, counted and shown, never thrown.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace scanshade {

/// One row of the table in events.cpp for each; the order is the same.
enum class Event {
    // while loading
    degenerate_face,       // fewer than three distinct corners, or no area
    concave_face,          // triangulated by ear clipping
    self_crossing_face,    // no clean triangulation exists
    cancelled_normal,      // averaged vertex normal of zero length: the face normal was taken
    repaired_normal,       // a normal in the file of zero length or not finite
    missing_material,      // a name that no material library defines
    transparency_ignored,  // d < 1: drawn opaque
    // while drawing
    near_clipped,      // triangle cut by the near or far plane
    guard_clipped,     // triangle cut by the guard band
    zero_area,         // triangle of no area after snapping
    clamped_weight,    // homogeneous weight below 0 by rounding
    edges_fallback,    // seen polygon not strictly convex on screen: triangulated
    patch_fallback,    // seen quad without an inverse bilinear map: barycentric
    zero_normal,       // interpolated normal of zero length: the face normal was taken
    light_at_surface,  // light closer than its radius
    not_finite,        // colour that is Inf or NaN: drawn black
    count_
};

struct EventInfo {
    Event event;
    std::string_view name;     // stable: scripts read it
    std::string_view meaning;  // one sentence for people
    double allowed_rate;       // of the things that it counts among; more is worth a warning
    std::string_view among;    // what the rate refers to: faces, triangles, vertices, samples
};

/// All events in the order of the enum.
std::span<const EventInfo> all_events();

/// How often each event happened; a plain sum, so counts of parts add up.
class EventCounts {
public:
    void add(Event event, std::uint64_t times = 1) { count_[index(event)] += times; }
    std::uint64_t operator[](Event event) const { return count_[index(event)]; }
    EventCounts& operator+=(const EventCounts& other) {
        for (std::size_t i = 0; i < count_.size(); ++i) count_[i] += other.count_[i];
        return *this;
    }
    bool operator==(const EventCounts&) const = default;

private:
    static std::size_t index(Event event) { return static_cast<std::size_t>(event); }
    std::array<std::uint64_t, static_cast<std::size_t>(Event::count_)> count_{};
};

}  // namespace scanshade

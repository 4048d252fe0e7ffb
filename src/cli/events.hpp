// Rare events as people and scripts read them: with the rate that they happened at.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scanshade/base/events.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// How many things there were that events are counted among.
struct EventTotals {
    std::uint64_t faces = 0, triangles = 0, vertices = 0, samples = 0, materials = 0;
};

/// Of a scene; the samples are known only once it has been drawn.
EventTotals event_totals(const Scene& scene, std::uint64_t covered_samples = 0);

/// An event that happened.
struct EventRow {
    const EventInfo* info;
    std::uint64_t count;
    double rate;  // count of all that info->among names

    bool is_allowed() const { return rate <= info->allowed_rate; }
};

/// Those that happened at all, in the order of the table.
std::vector<EventRow> event_rows(const EventCounts& counts, const EventTotals& totals);

/// One sentence with numbers.
std::string sentence(const EventRow& row);

/// Sentences of those that happened more often than is normal.
std::vector<std::string> event_warnings(const std::vector<EventRow>& rows);

}  // namespace scanshade

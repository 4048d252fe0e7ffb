#include "cli/events.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace scanshade {
namespace {

struct Total {
    std::string_view among;
    std::uint64_t EventTotals::*count;
};

constexpr Total totals_by_name[] = {
    {"faces", &EventTotals::faces},         {"triangles", &EventTotals::triangles},
    {"vertices", &EventTotals::vertices},   {"samples", &EventTotals::samples},
    {"materials", &EventTotals::materials},
};

std::uint64_t total_of(std::string_view among, const EventTotals& totals) {
    for (const Total& row : totals_by_name)
        if (row.among == among) return totals.*row.count;
    return 0;
}

}  // namespace

EventTotals event_totals(const Scene& scene, std::uint64_t covered_samples) {
    EventTotals totals;
    // Faces that were left out while loading are counted among all that the files have.
    totals.faces = scene.events[Event::degenerate_face];
    for (const Object& object : scene.objects) {
        totals.faces += object.mesh->face_count();
        totals.triangles += object.mesh->triangle_count();
        totals.vertices += object.mesh->vertex_count();
    }
    totals.samples = covered_samples;
    totals.materials = scene.materials.size();
    return totals;
}

std::vector<EventRow> event_rows(const EventCounts& counts, const EventTotals& totals) {
    std::vector<EventRow> rows;
    for (const EventInfo& info : all_events()) {
        const std::uint64_t count = counts[info.event];
        if (count == 0) continue;
        const std::uint64_t total = std::max(count, total_of(info.among, totals));
        rows.push_back({&info, count, double(count) / double(total)});
    }
    return rows;
}

std::string sentence(const EventRow& row) {
    return fmt::format("{}: {} ({} times, {:.3g} % of {})", row.info->name, row.info->meaning,
                       row.count, 100 * row.rate, row.info->among);
}

std::vector<std::string> event_warnings(const std::vector<EventRow>& rows) {
    std::vector<std::string> sentences;
    for (const EventRow& row : rows)
        if (!row.is_allowed()) sentences.push_back(sentence(row));
    return sentences;
}

}  // namespace scanshade

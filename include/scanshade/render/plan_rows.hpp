// What the vector renderer leaves out because a scene does not need it: one table. Leaving a row's
// work out changes no bit of the picture; tests hold that for each row alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scanshade {

struct RenderPlan;

enum class PlanRow {
    clusters_outside,
    clusters_facing_away,
    clipping,
    normals,
    positions,
    texcoords,
    unseen_points,
    dark_lights,
    attenuation,
    specular,
    material_lookup,
    empty_tiles,
    unchanged_background,
    count_
};

inline constexpr std::size_t plan_row_count = static_cast<std::size_t>(PlanRow::count_);

struct PlanRowInfo {
    PlanRow row;
    std::string_view name;      // stable: scripts read it
    std::string_view left_out;  // what, as a sentence goes on after "left out: "
    std::string_view unit;      // of the count of what it saved in a frame
    bool (*applies)(const RenderPlan&);
    std::string (*reason)(const RenderPlan&);  // why it applies or not, with the counts
};

/// All rows in the order of the enum.
std::span<const PlanRowInfo> all_plan_rows();

/// How much of a row's unit a frame did without, and of how much; with several samples a pixel, all
/// samples together. Both are 0 for a row that is not left out.
struct PlanSaving {
    std::uint64_t saved = 0, of = 0;

    PlanSaving& operator+=(const PlanSaving& other) {
        saved += other.saved;
        of += other.of;
        return *this;
    }
    bool operator==(const PlanSaving&) const = default;
};

/// One for each row, in the order of the enum.
class PlanSavings {
public:
    PlanSaving& operator[](PlanRow row) { return rows_[static_cast<std::size_t>(row)]; }
    const PlanSaving& operator[](PlanRow row) const { return rows_[static_cast<std::size_t>(row)]; }
    PlanSavings& operator+=(const PlanSavings& other) {
        for (std::size_t i = 0; i < plan_row_count; ++i) rows_[i] += other.rows_[i];
        return *this;
    }

private:
    std::array<PlanSaving, plan_row_count> rows_{};
};

}  // namespace scanshade

// A report as programs read it: JSON, and its rows as CSV.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/report/fit.hpp"
#include "scanshade/report/provenance.hpp"
#include "scanshade/report/timing.hpp"

namespace scanshade {

using Json = nlohmann::ordered_json;

Json to_json(const Times& times);
Json to_json(const Estimate& estimate);

/// {"report", "partial", "provenance", "scenes"}; each scene has at least "name" and "rows", each
/// row "axis" and "method". What is not UTF-8 in a name becomes U+FFFD.
std::string report_json(std::string_view kind, const Provenance& provenance, bool partial,
                        const Json& scenes);

/// A line for each row of each scene. Objects inside rows become columns "outer.inner"; the columns
/// are those that any row has. Text that a spreadsheet would take for a formula begins with an
/// apostrophe.
std::string report_csv(const Json& scenes);

/// The text with whatever is not UTF-8 as U+FFFD, and without control characters.
std::string clean_text(std::string_view text);

}  // namespace scanshade

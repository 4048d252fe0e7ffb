// The equation at one pixel as people read it: sections of rows, in float and in double.
#pragma once

#include <string>
#include <vector>

#include "scanshade/render/inspect.hpp"

namespace scanshade {

/// One quantity.
struct InspectionRow {
    std::string symbol;       // "N·L", as the formula sheet spells it
    std::string meaning;      // a few words; empty where the symbol says it
    std::vector<double> f32;  // what the float renderer has: one number, or three
    std::vector<double> f64;  // the same in double
    bool is_rgb = false;      // three channels, not a vector
};

struct InspectionSection {
    std::string title;
    std::vector<InspectionRow> rows;
};

/// Names of a sample's corners: "A", "B", "C" as (C3) has them where a row crosses edges AB and AC,
/// "A" to "D" where it crosses AB and CD; in the order of InspectedSample::corners.
std::vector<std::string> corner_names(const InspectedSample& sample);

/// The sections of an inspection, in the order of the computation. Of several samples only the first
/// that shows something is there with all steps, unless every one is asked for.
std::vector<InspectionSection> inspection_sections(const Inspection& inspection,
                                                   bool every_sample = false);

/// Numbers as a row shows them: nine significant digits in float, twelve in double; channels that
/// are equal are one number.
std::string f32_text(const InspectionRow& row);
std::string f64_text(const InspectionRow& row);

/// Everything with all digits, for programs.
std::string inspection_json(const Inspection& inspection);

}  // namespace scanshade

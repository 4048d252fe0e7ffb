#include <nlohmann/json.hpp>

#include "scanshade/report/document.hpp"
#include "scanshade/report/inspection.hpp"

namespace scanshade {
namespace {

Json to_json(const InspectionRow& row) {
    return {
        {"symbol", row.symbol}, {"meaning", row.meaning}, {"float", row.f32}, {"double", row.f64}};
}

Json to_json(const InspectionSection& section) {
    Json rows = Json::array();
    for (const InspectionRow& row : section.rows) rows.push_back(to_json(row));
    const std::size_t begin = section.title.find_first_not_of(' ');
    return {{"title", clean_text(section.title.substr(begin))}, {"rows", rows}};
}

}  // namespace

std::string inspection_json(const Inspection& inspection) {
    Json sections = Json::array();
    for (const InspectionSection& section : inspection_sections(inspection, true))
        sections.push_back(to_json(section));
    const Json all = {{"pixel", {inspection.x, inspection.y}},
                      {"resolution", {inspection.width, inspection.height}},
                      {"byte", {{"float", inspection.byte32}, {"double", inspection.byte64}}},
                      {"sections", sections}};
    return all.dump(2) + "\n";
}

}  // namespace scanshade

#include "scanshade/report/document.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace scanshade {
namespace {

std::string dump(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json to_json(const Provenance& p) {
    return {{"commit", p.commit}, {"compiler", p.compiler}, {"flags", p.flags}, {"cpu", p.cpu},
            {"isa", p.isa},       {"threads", p.threads},   {"seed", p.seed},   {"date", p.date}};
}

/// A row as columns.
using Flat = std::vector<std::pair<std::string, Json>>;

void flatten(const Json& value, const std::string& name, Flat& into) {
    if (!value.is_object()) return into.emplace_back(name, value), void();
    for (const auto& [key, inner] : value.items())
        flatten(inner, name.empty() ? key : name + "." + key, into);
}

std::string csv_field(const Json& value) {
    if (!value.is_string()) return dump(value, -1);
    std::string text = clean_text(value.get<std::string>());
    if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
        text.insert(0, "'");
    if (text.find_first_of(",\"") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

const Json* find(const Flat& row, const std::string& name) {
    for (const auto& [key, value] : row)
        if (key == name) return &value;
    return nullptr;
}

}  // namespace

Json to_json(const Times& times) {
    return {{"median", times.median}, {"min", times.min}, {"runs", times.runs}};
}

Json to_json(const Estimate& estimate) {
    return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

std::string report_json(std::string_view kind, const Provenance& provenance, bool partial,
                        const Json& scenes) {
    const Json json = {{"report", kind},
                       {"partial", partial},
                       {"provenance", to_json(provenance)},
                       {"scenes", scenes}};
    return dump(json, 2) + "\n";
}

std::string report_csv(const Json& scenes) {
    std::vector<Flat> rows;
    std::vector<std::string> columns;
    for (const Json& scene : scenes)
        for (const Json& row : scene["rows"]) {
            rows.push_back({{"scene", scene["name"]}});
            flatten(row, "", rows.back());
            for (const auto& [name, value] : rows.back())
                if (std::find(columns.begin(), columns.end(), name) == columns.end())
                    columns.push_back(name);
        }
    std::string text;
    const auto add_line = [&](auto field) {
        for (std::size_t c = 0; c < columns.size(); ++c) text += (c ? "," : "") + field(columns[c]);
        text += "\n";
    };
    add_line([](const std::string& column) { return csv_field(column); });
    for (const Flat& row : rows)
        add_line([&](const std::string& column) {
            const Json* value = find(row, column);
            return value ? csv_field(*value) : std::string();
        });
    return text;
}

std::string clean_text(std::string_view text) {
    std::string clean = Json::parse(dump(std::string(text), -1)).get<std::string>();
    std::replace_if(
        clean.begin(), clean.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return clean;
}

}  // namespace scanshade

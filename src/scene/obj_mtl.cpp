// MTL statements are read here and not by the library that reads OBJ files, because there a
// statement that is absent cannot be told from one that says 0 (Kd) or 1 (Ns).
#include "scene/obj_mtl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scene/limits.hpp"
#include "scene/obj_text.hpp"

namespace scanshade {
namespace {

using Colour = std::array<double, 3>;

constexpr double max_shininess = 1e6;
constexpr double max_emission = 1e6;
constexpr Colour absent_kd{0.8, 0.8, 0.8};

bool is_number_keyword(std::string_view keyword) {
    constexpr std::string_view keywords[] = {"Ka", "Kd", "Ks", "Ke", "Ns", "d", "Tr", "illum"};
    return std::find(std::begin(keywords), std::end(keywords), keyword) != std::end(keywords);
}

/// The numbers at the front; "Kd spectral file.rfl" has none.
std::vector<double> leading_numbers(std::string_view arguments) {
    std::vector<double> numbers;
    while (const std::optional<double> number = parse_real(next_word(arguments)))
        numbers.push_back(*number);
    return numbers;
}

/// What follows the options: -s 1 1 1, -clamp on, -type sphere, ...
std::string_view without_options(std::string_view arguments) {
    arguments = trimmed(arguments);
    while (arguments.starts_with('-')) {
        const std::string_view option = next_word(arguments);
        if (option == "-type" || option == "-imfchan") next_word(arguments);
        while (true) {
            std::string_view rest = arguments;
            const std::string_view word = next_word(rest);
            if (!parse_real(word) && word != "on" && word != "off") break;
            arguments = rest;
        }
        arguments = trimmed(arguments);
    }
    return arguments;
}

}  // namespace

struct MaterialLibraries::Subject {
    const std::string& name;
    const MtlEntry& entry;
    std::vector<std::string>& warnings;

    std::string place() const { return fmt::format("{}:{}", entry.file.string(), entry.line); }
    void warn(const std::string& sentence) const {
        warnings.push_back(fmt::format("{}: material '{}': {}", place(), name, sentence));
    }

    std::optional<double> number(std::string_view keyword) const {
        const auto at = entry.numbers.find(keyword);
        return at == entry.numbers.end() ? std::nullopt : std::optional(at->second.front());
    }

    double clamped(std::string_view keyword, double value, double max) const {
        const double inside = std::clamp(value, 0.0, max);
        if (inside != value)
            warn(fmt::format("{} {} is outside 0 to {}; {} is used", keyword, value, max, inside));
        return inside;
    }

    /// Missing components are equal to the first one.
    std::optional<Colour> colour(std::string_view keyword, double max) const {
        const auto at = entry.numbers.find(keyword);
        if (at == entry.numbers.end()) return std::nullopt;
        Colour colour;
        for (std::size_t k = 0; k < 3; ++k)
            colour[k] =
                clamped(keyword, at->second.size() < 3 ? at->second[0] : at->second[k], max);
        return colour;
    }
};

void MaterialLibraries::read(const std::filesystem::path& folder, const std::string& name) {
    if (!read_.insert(folder / name).second) return;
    try {
        const std::filesystem::path file = files_.find(folder, name);
        add(file, read_text(file, max_mtl_bytes));
    } catch (const Error& error) {
        report_.warnings.push_back(fmt::format("{}; its materials are missing", error.what()));
    }
}

void MaterialLibraries::add(const std::filesystem::path& file, const std::string& text) {
    MtlEntry ignored;  // what stands before the first newmtl, or in a second one of a known name
    MtlEntry* entry = &ignored;
    std::set<std::string, std::less<>> other_maps;
    StatementStream(text, [&](const Statement& s) {
        if (s.keyword == "newmtl") {
            const auto [at, is_new] = entries_.try_emplace(std::string(trimmed(s.arguments)));
            entry = is_new ? &at->second : &ignored;
            *entry = MtlEntry{file, s.line, {}, {}};
        } else if (s.keyword == "map_Kd") {
            entry->map_kd = trimmed(s.arguments);
        } else if (s.keyword.starts_with("map_") || s.keyword == "bump" || s.keyword == "norm") {
            other_maps.emplace(s.keyword);
        } else if (is_number_keyword(s.keyword)) {
            std::vector<double> numbers = leading_numbers(s.arguments);
            if (!numbers.empty()) entry->numbers[std::string(s.keyword)] = std::move(numbers);
        }
    }).visit_all();
    if (!other_maps.empty())
        report_.warnings.push_back(
            fmt::format("{}: {} are ignored; of textures only map_Kd is drawn", file.string(),
                        fmt::join(other_maps, ", ")));
}

Material MaterialLibraries::make(const std::string& name) {
    const Subject subject{name, entries_.at(name), report_.warnings};
    Material material;
    material.name = name;
    material.place = subject.place();
    const auto set = [&](std::string_view parameter, const Colour& c) {
        material.set(parameter, {c.begin(), c.end()}, material.place);
    };

    const double illum = subject.number("illum").value_or(2);
    if (illum == 0) material.brdf = "unlit";
    add_texture(subject, material);
    std::optional<Colour> kd = subject.colour("Kd", 1);
    const bool has_colour = kd && *kd != Colour{};
    if (!subject.entry.map_kd.empty() && !has_colour)
        kd = material.map_kd ? Colour{1, 1, 1} : absent_kd;  // exporters leave it black there
    set("kd", kd.value_or(absent_kd));
    if (const auto ka = subject.colour("Ka", 1); ka && mtl_ambient_) set("ka", *ka);
    if (const auto ke = subject.colour("Ke", max_emission)) set("emission", *ke);

    const std::optional<double> ns = subject.number("Ns");
    const bool specular = ns && illum != 1;
    set("ks", specular ? subject.colour("Ks", 1).value_or(Colour{}) : Colour{});
    if (ns) material.set("shininess", {subject.clamped("Ns", *ns, max_shininess)}, material.place);

    if (subject.number("d").value_or(1 - subject.number("Tr").value_or(0)) < 1)
        report_.events.add(Event::transparency_ignored);
    return material;
}

void MaterialLibraries::add_texture(const Subject& subject, Material& material) {
    if (subject.entry.map_kd.empty()) return;
    std::string name(without_options(subject.entry.map_kd));
    if (name != subject.entry.map_kd) subject.warn("the options of map_Kd are ignored");
    std::replace(name.begin(), name.end(), '\\', '/');
    try {
        const std::filesystem::path file = find_texture(subject, name);
        material.map_kd = files_.texture(file);
        material.map_file = file;
    } catch (const Error& error) {
        subject.warn(fmt::format("drawn without its texture: {}", error.what()));
    }
}

std::filesystem::path MaterialLibraries::find_texture(const Subject& subject,
                                                      const std::string& name) const {
    const std::filesystem::path folder = subject.entry.file.parent_path();
    const std::filesystem::path alone = std::filesystem::path(name).filename();
    std::error_code ignored;
    const auto exists = [&](const std::filesystem::path& file) {
        return std::filesystem::exists(folder / file, ignored);
    };
    const bool as_named = exists(name) && files_.allows(folder / name);
    return files_.find(folder, as_named || !exists(alone) ? name : alone.string());
}

}  // namespace scanshade

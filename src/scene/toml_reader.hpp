// Values of a TOML table, with errors that name the place and the nearest known key.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scene/limits.hpp"
#include "scene/toml.hpp"

namespace scanshade {

class TomlReader {
public:
    TomlReader(const toml::table& table, std::string file, std::string what)
        : table_(table), file_(std::move(file)), what_(std::move(what)) {}

    /// Refuses every key that is not in the list.
    void allow_only(std::initializer_list<std::string_view> known) const {
        const std::vector<std::string_view> names(known);
        for (const auto& [key, node] : table_)
            if (std::find(names.begin(), names.end(), key.str()) == names.end())
                throw error(node, fmt::format("{} has no key '{}'{}", what_, key.str(),
                                              suggestion(key.str(), names)));
    }

    bool has(std::string_view key) const { return table_.contains(key); }
    const toml::node* node(std::string_view key) const { return table_.get(key); }
    const toml::table& table() const { return table_; }
    const std::string& file() const { return file_; }

    std::optional<std::string> text(std::string_view key) const {
        const toml::node* value = node(key);
        if (value == nullptr) return std::nullopt;
        if (!value->is_string()) throw wrong(*value, key, "a text in quotes");
        return value->as_string()->get();
    }

    std::optional<double> real(std::string_view key) const {
        const toml::node* value = node(key);
        if (value == nullptr) return std::nullopt;
        return number(*value, key, "a number");
    }

    /// A real number in [low, high].
    std::optional<double> real_between(std::string_view key, double low, double high) const {
        const auto value = real(key);
        if (value && !(*value >= low && *value <= high))
            throw error(*node(key), fmt::format("{} of {} is {}; it lies between {} and {}", key,
                                                what_, *value, low, high));
        return value;
    }

    std::optional<std::vector<double>> reals(std::string_view key, std::size_t count) const {
        const toml::node* value = node(key);
        if (value == nullptr) return std::nullopt;
        const std::string form = fmt::format("an array of {} numbers", count);
        const toml::array* array = value->as_array();
        if (array == nullptr || array->size() != count) throw wrong(*value, key, form);
        std::vector<double> out;
        for (const toml::node& element : *array) out.push_back(number(element, key, form));
        return out;
    }

    std::optional<glm::dvec3> vector(std::string_view key) const {
        const auto v = reals(key, 3);
        if (!v) return std::nullopt;
        return glm::dvec3((*v)[0], (*v)[1], (*v)[2]);
    }

    /// Three numbers, or one that means the same three times.
    std::optional<glm::dvec3> vector_or_number(std::string_view key) const {
        const toml::node* value = node(key);
        if (value != nullptr && value->is_number()) return glm::dvec3(*real(key));
        return vector(key);
    }

    /// A point or a direction.
    std::optional<glm::dvec3> point(std::string_view key) const {
        const auto v = vector(key);
        if (v && max_abs(*v) > max_coordinate)
            throw error(*node(key), fmt::format("{} of {} lies outside -{} to {}", key, what_,
                                                max_coordinate, max_coordinate));
        return v;
    }

    /// Three numbers or one, none negative.
    std::optional<glm::dvec3> radiance(std::string_view key) const {
        const auto v = vector_or_number(key);
        if (v && (v->x < 0 || v->y < 0 || v->z < 0 || max_abs(*v) > max_radiance))
            throw error(*node(key), fmt::format("{} of {} must not be negative or above {}", key,
                                                what_, max_radiance));
        return v;
    }

    /// The number of a name in a table.
    std::optional<std::size_t> choice(std::string_view key,
                                      std::span<const std::string_view> names) const {
        const auto value = text(key);
        if (!value) return std::nullopt;
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == *value) return i;
        throw error(*node(key), fmt::format("{} of {} knows no '{}'{}", key, what_, *value,
                                            suggestion(*value, names)));
    }

    Error error(const toml::node& at, std::string_view sentence) const {
        Error e(Errc::scene, sentence);
        e.at(file_, static_cast<long>(at.source().begin.line));
        return e;
    }
    /// At the table itself, for what is missing.
    Error error(std::string_view sentence) const { return error(table_, sentence); }

    std::string place(const toml::node& at) const {
        return fmt::format("{}:{}", file_, at.source().begin.line);
    }

    double number(const toml::node& value, std::string_view key, std::string_view form) const {
        const auto number = value.value<double>();
        if (!value.is_number() || !number) throw wrong(value, key, form);
        if (!std::isfinite(*number))
            throw error(value, fmt::format("{} of {} must be a finite number", key, what_));
        return *number;
    }

private:
    Error wrong(const toml::node& value, std::string_view key, std::string_view form) const {
        return error(value, fmt::format("{} of {} takes {}", key, what_, form));
    }

    const toml::table& table_;
    std::string file_, what_;
};

}  // namespace scanshade

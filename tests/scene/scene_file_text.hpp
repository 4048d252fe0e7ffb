// Scene files from text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scanshade/base/error.hpp"
#include "scanshade/scene/scene.hpp"
#include "scanshade/scene/settings.hpp"

namespace scanshade {

inline const std::string cube = "[[object]]\nshape = \"cube\"\n";

inline Scene parse(std::string_view text, const std::filesystem::path& folder = ".") {
    Settings settings;
    return parse_scene(text, folder / "s.toml", settings);
}

struct Refusal {
    Errc code{};
    std::string sentence = "taken";
};

/// Why a text is refused.
inline Refusal refusal(std::string_view text) {
    try {
        parse(text);
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
    return {};
}

}  // namespace scanshade

// What all fuzz targets share. A target is one file; `make fuzz-NAME TIME=60` runs it.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "scanshade/base/error.hpp"
#include "scanshade/render/renderer.hpp"
#include "support/temp_folder.hpp"

namespace scanshade {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program: the fuzzer keeps the input that led here.
[[noreturn]] inline void broken(const std::string& promise) {
    std::fprintf(stderr, "broken: %s\n", promise.c_str());
    std::abort();
}

/// An error is one sentence, whatever the input holds.
inline void check_sentence(const Error& error) {
    const std::string_view text = error.what();
    if (text.empty() || text.size() > 4096) broken("an error is a sentence");
}

/// Loads the file and draws it small; what is refused must be refused in a sentence, and all that is
/// drawn be finite.
inline void load_and_draw(const std::filesystem::path& file) {
    constexpr std::size_t most_triangles = 5000;  // more takes long and shows nothing new
    Settings settings;
    settings.width = 24, settings.height = 18, settings.threads = 1;
    settings.given = {"resolution", "samples", "threads", "isa"};
    try {
        const Scene scene = load_scene(file, settings);
        if (scene.triangle_count() > most_triangles) return;
        Framebuffer frame;
        Renderer(scene, settings).draw(frame);
        for (const auto plane : {&Framebuffer::r, &Framebuffer::g, &Framebuffer::b})
            for (const float value : frame.*plane)
                if (!std::isfinite(value)) broken("every colour is finite");
    } catch (const Error& error) {
        check_sentence(error);
    }
}

}  // namespace scanshade

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

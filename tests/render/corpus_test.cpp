// Files that other people made: every OBJ of Debian's assimp-testmodels is drawn, or refused with
// one sentence.
#include <algorithm>
#include <filesystem>

#include "scanshade/base/error.hpp"
#include "scanshade/render/renderer.hpp"
#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("every OBJ file of assimp-testmodels is drawn or refused in one sentence",
          "[render][corpus]") {
    const std::filesystem::path folder = "/usr/share/assimp/models";
    if (!std::filesystem::exists(folder)) {
        WARN("skipped: assimp-testmodels is not installed");
        return;
    }
    std::size_t drawn = 0, refused = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        std::string extension = entry.path().extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(), ::tolower);
        if (extension != ".obj") continue;
        CAPTURE(entry.path().string());
        Settings settings;
        settings.width = 64;
        settings.height = 48;
        try {
            const Scene scene = load_scene(entry.path(), settings);
            for (const Interpolation mode :
                 {Interpolation::perspective, Interpolation::edges, Interpolation::patch}) {
                settings.interpolation = mode;
                Framebuffer frame;
                const FrameStats stats = Renderer(scene, settings).draw(frame);
                CHECK(stats.covered_samples > 0);
                CHECK(stats.events[Event::not_finite] == 0);
            }
            ++drawn;
        } catch (const Error& e) {
            CHECK(e.code() == Errc::format);
            CHECK(std::string(e.what()).find('\n') == std::string::npos);
            ++refused;
        }
    }
    CHECK(drawn >= 18);
    CHECK(drawn > refused);
}

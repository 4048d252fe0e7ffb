// TOML scenes, from their bytes to a picture; and what is read can be written and read again.
#include "fuzz/fuzz.hpp"
#include "scanshade/image/png.hpp"

using namespace scanshade;

namespace {

struct Workshop {
    TempFolder folder;

    Workshop() {
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
        save_png(Image(2, 2), folder.path / "t.png");
    }
};

/// Shapes of a million faces are made in seconds, and are all alike.
bool asks_for_fine_shapes(std::string_view text) {
    constexpr std::string_view key = "tessellation";
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string_view::npos;) {
        at += key.size();
        const std::string_view value = text.substr(at, text.find_first_of("\n[") - at);
        std::size_t digits = 0;
        for (const char c : value.substr(0, 40)) digits += (c >= '0' && c <= '9') || c == 'e';
        if (digits > 2) return true;
    }
    return false;
}

void check_round_trip(const std::filesystem::path& file) {
    Settings settings, again;
    try {
        const Scene scene = load_scene(file, settings);
        const auto folder = file.parent_path();
        const std::string written = scene_text(scene, settings, folder);
        const Scene read = parse_scene(written, folder / "again.toml", again);
        if (read.objects.size() != scene.objects.size() ||
            read.lights.size() != scene.lights.size())
            broken("a scene that was written is read again as it was:\n" + written);
    } catch (const Error& error) {
        check_sentence(error);
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Workshop workshop;
    const std::string text(text_of(data, size));
    if (asks_for_fine_shapes(text)) return -1;  // no seed for others
    const auto file = workshop.folder.write("s.toml", text);
    load_and_draw(file);
    check_round_trip(file);
    return 0;
}

// scanshade-view INPUT [options]: shows a scene in a window.
#include <string>
#include <utility>

#include "cli/console.hpp"
#include "cli/options.hpp"
#include "scanshade/scene/scene.hpp"
#include "viewer/viewer.hpp"

namespace {

using namespace scanshade;

int run(const char* const* args) {
    std::string input;
    Settings settings;
    viewer::ViewerOptions viewing;
    const std::string summary = "look at it from all sides in a window\n\n" + viewer::help_text();
    OptionParser options("scanshade-view", "INPUT [options]", summary);
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.flag("--no-panel", viewing.no_panel, "begin without the panel; P shows it");
    options.text("--record", "FILE", viewing.record, "write down all keys and mouse events");
    options.text("--play", "FILE", viewing.play, "do again what was recorded, then go on");
    options.integer("--turn", 1, 100'000, viewing.turn,
                    "turn the scene by so many frames, say how long they took, and end");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;

    const Settings command_line = settings;
    Scene scene = load_scene(input, settings);
    warn(scene.warnings);
    viewer::Viewer viewer(input, std::move(scene), std::move(settings), command_line, viewing);
    if (viewing.turn > 0)
        print(viewer.turn(viewing.turn) + "\n");
    else
        viewer.run();
    return exit_done;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("scanshade-view", [&] { return run(argv + (argc > 0 ? 1 : 0)); });
}

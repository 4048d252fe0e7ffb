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
    const std::string summary = "look at it from all sides in a window\n\n" + viewer::help_text();
    OptionParser options("scanshade-view", "INPUT [options]", summary);
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;

    Scene scene = load_scene(input, settings);
    warn(scene.warnings);
    viewer::Viewer(std::move(scene), std::move(settings)).run();
    return exit_done;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("scanshade-view", [&] { return run(argv + (argc > 0 ? 1 : 0)); });
}

// What the viewer reads and writes.
#include <fmt/format.h>

#include "cli/console.hpp"
#include "cli/shipped.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/image/png.hpp"
#include "viewer/viewer.hpp"

namespace scanshade::viewer {

void Viewer::open(const std::filesystem::path& file, bool keep_camera) {
    try {
        Settings settings = state_.settings_for_loading(command_line_);
        Scene scene = load_scene(file, settings);
        settings.width = state_.settings().width, settings.height = state_.settings().height;
        warn(scene.warnings);
        state_.replace(std::move(scene), settings, keep_camera);
        if (file != input_file_) ui_.lesson = lesson_of(file);
        input_file_ = file;
        watch_.watch(input_file_, state_.scene());
        ui_.inspection.reset();
        ui_.notice.clear();
    } catch (const Error& error) {
        report(error.what());
    }
}

void Viewer::open_lesson(std::size_t number) {
    const LessonInfo& lesson = *all_lessons()[number];
    attempt(ui_, [&] {
        const auto folder = shipped_folder("lessons", "start it in the project's folder");
        open(folder / fmt::format("{}.toml", lesson.name), false);
        ui_.lesson = lesson_of(input_file_);  // its window again, also where it was closed
    });
}

void Viewer::save_picture() {
    // What is asked for before it in the same batch of events belongs into the picture.
    if (state_.take_change() || !picture_.final()) draw(false);
    try {
        const auto path = next_free_path(".", state_.scene().name, "png");
        save_png(to_image(picture_.pixels()), path);
        say(fmt::format("saved {}", path.filename().string()));
        note("scanshade-view: " + ui_.status);
    } catch (const Error& error) {
        report(error.what());
    }
}

void Viewer::save_scene() {
    try {
        const auto path = next_free_path(".", state_.scene().name, "toml");
        write_file(scene_text(state_.scene(), state_.settings(), "."), path);
        say(fmt::format("saved {}", path.filename().string()));
        note("scanshade-view: " + ui_.status);
    } catch (const Error& error) {
        report(error.what());
    }
}

}  // namespace scanshade::viewer

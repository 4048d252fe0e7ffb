// scanshade lesson: pages that teach shading, with pictures and plots that are made on the spot.
#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/shipped.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/report/lesson.hpp"

namespace scanshade {
namespace {

std::string list() {
    std::vector<std::vector<std::string>> rows;
    for (const LessonInfo* lesson : all_lessons())
        rows.push_back({std::string(lesson->name), std::string(lesson->summary)});
    return table(rows);
}

Watch watch_on(Progress& progress) {
    Watch watch;
    watch.stopped = Interrupt::came;
    watch.tell = [&progress](const std::string& what, std::size_t done, std::size_t all) {
        progress.text(fmt::format("lesson {}, {} of {}", what, done + 1, all));
    };
    return watch;
}

}  // namespace

int run_lesson(OptionParser& options, char** args) {
    std::string name, folder;
    options.positional("NAME", name, "'list' for what there is, a lesson, or 'all'");
    options.text("-o,--output", "DIR", folder,
                 "folder for index.html and its pictures; made where it is not there");
    if (!options.parse(args)) return exit_done;
    if (name == "list") {
        print(list());
        return exit_done;
    }
    std::vector<const LessonInfo*> lessons;
    if (name == "all")
        lessons.assign(all_lessons().begin(), all_lessons().end());
    else
        lessons = {&find_lesson(name)};
    if (folder.empty())
        throw Error(
            Errc::usage,
            fmt::format("'lesson {0}' needs a folder for its page: 'scanshade lesson {0} -o "
                        "DIR'",
                        name));
    const std::filesystem::path scenes =
        shipped_folder("lessons", "start it in the project's folder");
    const Interrupt interrupt;
    make_folder(folder);
    Progress progress("lessons");
    const LessonsWritten written = write_lessons(lessons, scenes, folder, watch_on(progress));
    progress.finish();
    note(fmt::format("wrote {}{}", (std::filesystem::path(folder) / "index.html").string(),
                     written.partial ? ", partial because it was interrupted" : ""));
    return written.partial ? Interrupt::status() : exit_done;
}

}  // namespace scanshade

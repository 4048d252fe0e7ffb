// The command lesson, and that what the lessons tell people to type works.
#include <sstream>

#include "cli/process.hpp"
#include "scanshade/report/lesson.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// The words of a lesson's line, its output going into `folder`, small pictures, and no window.
std::vector<std::string> words_of(const std::string& line, const TempFolder& folder) {
    std::vector<std::string> words;
    std::istringstream text(line);
    for (std::string word; text >> word;) words.push_back(word);
    words.erase(words.begin());
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i - 1] == "-o") words[i] = folder.path / words[i];
    // The viewer checks the shared options in the same way as the others.
    if (words[0] == "view") words[0] = "explain";
    if (words[0] != "inspect") words.insert(words.end(), {"--resolution", "48,36"});
    return words;
}

}  // namespace

TEST_CASE("every command of every lesson works as it stands there", "[cli][lesson]") {
    const TempFolder folder;
    for (const LessonInfo* lesson : all_lessons())
        for (const std::string& line : command_lines(*lesson)) {
            const Finished run = run_scanshade(words_of(line, folder));
            CAPTURE(line, run.err);
            CHECK(line.starts_with("scanshade "));
            CHECK(run.status == 0);
        }
}

TEST_CASE("lesson lists, writes one or all, and says what is missing", "[cli][lesson]") {
    const Finished list = run_scanshade({"lesson", "list"});
    CHECK(list.status == 0);
    for (const LessonInfo* lesson : all_lessons())
        CHECK(list.out.find(std::string(lesson->summary)) != std::string::npos);

    const TempFolder folder;
    const std::string out = folder.path / "deep" / "depth";
    const Finished one = run_scanshade({"lesson", "depth", "-o", out});
    CHECK(one.status == 0);
    CHECK(one.err == "wrote " + out + "/index.html\n");
    CHECK(read_file(out + "/index.html").find("<h2 id=\"depth\">") != std::string::npos);

    const Finished nowhere = run_scanshade({"lesson", "depth"});
    CHECK(nowhere.status == 2);
    CHECK(nowhere.err.find("'scanshade lesson depth -o DIR'") != std::string::npos);
    const Finished unknown = run_scanshade({"lesson", "deph", "-o", out});
    CHECK(unknown.status == 2);
    CHECK(unknown.err.find("did you mean 'depth'?") != std::string::npos);
}

TEST_CASE("lessons are found from any folder; an interruption leaves a whole page",
          "[cli][lesson]") {
    const TempFolder folder;
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    const Finished found = run_scanshade({"lesson", "fill-rule", "-o", "page"});
    const std::string copy = folder.path / "scanshade";
    std::filesystem::copy_file(SCANSHADE_BINARY, copy);
    const Finished lost = run_scanshade({"lesson", "fill-rule", "-o", "other"}, {}, copy);
    std::filesystem::current_path(here);
    CHECK(found.status == 0);
    CHECK(lost.status == 3);
    CHECK(lost.err.find("models/lessons") != std::string::npos);

    const std::string out = folder.path / "all";
    const Finished stopped = run_scanshade_interrupted(
        {"lesson", "all", "-o", out}, out + "/shading-flat.png", std::chrono::milliseconds(1));
    CHECK(stopped.status == 130);
    CHECK(stopped.err.find("partial") != std::string::npos);
    CHECK(read_file(out + "/index.html").find("is partial") != std::string::npos);
}

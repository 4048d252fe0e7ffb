// Lessons: each a scene and a page about it, with pictures, plots and numbers that are made anew
// whenever it is written.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/report/watch.hpp"

namespace scanshade {

class LessonWork;  // report/lessons/work.hpp

/// An equation as docs/equations.md prints it, and the function of eq/ that computes it.
struct LessonEquation {
    std::string_view number, printed, function;
};

/// A command on the lesson's scene: "render" and "--shading flat -o flat.png".
struct LessonCommand {
    std::string_view command, options;
};

struct LessonQuestion {
    std::string_view question, answer;
};

/// One row of the registry. Its scene is models/lessons/<name>.toml.
struct LessonInfo {
    std::string_view name, title;
    std::string_view summary;  // one line
    std::span<const LessonEquation> equations;
    std::span<const LessonCommand> commands;
    std::span<const LessonQuestion> questions;
    void (*fill)(LessonWork&);  // explains, draws, plots, measures
};

/// In the order in which they are taught.
std::span<const LessonInfo* const> all_lessons();

/// Throws Error(usage) that names the nearest one.
const LessonInfo& find_lesson(std::string_view name);

/// The lesson whose scene a file is: lessons/<name>.toml in any folder; null: of none.
const LessonInfo* lesson_of(const std::filesystem::path& scene);

/// The lines to type: first the viewer on the lesson's scene.
std::vector<std::string> command_lines(const LessonInfo& lesson);

/// A number of a lesson's page; tests hold what the lesson says about it.
struct LessonFact {
    std::string_view lesson;
    std::string what;
    double value;
    std::string unit;
};

struct LessonsWritten {
    std::vector<LessonFact> facts;
    bool partial = false;  // stopped before the last lesson; the page has those before
};

/// One page with these lessons, index.html, and their pictures beside it, in a folder that exists.
/// `scenes` has the scene files. Throws Error: file, and what loading and drawing throw.
LessonsWritten write_lessons(std::span<const LessonInfo* const> lessons,
                             const std::filesystem::path& scenes, const std::string& folder,
                             const Watch& watch);

}  // namespace scanshade

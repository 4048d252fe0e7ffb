#include "scanshade/report/lesson.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/lessons/rows.hpp"
#include "report/lessons/work.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/report/page.hpp"

namespace scanshade {
namespace {

std::string fact_text(double value) {
    if (std::isinf(value)) return "∞";
    return value == std::trunc(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

void add_facts(const std::vector<LessonFact>& facts, Page& page) {
    if (facts.empty()) return;
    page.subsection("Measured just now");
    std::vector<std::vector<Cell>> rows;
    for (const LessonFact& fact : facts)
        rows.push_back({{fact.what}, number_cell(fact_text(fact.value)), {fact.unit, "faint"}});
    page.table({"what", "value", "unit"}, rows);
}

void add_equations(const LessonInfo& lesson, Page& page) {
    if (lesson.equations.empty()) return;
    page.subsection("Equations");
    std::vector<std::vector<Cell>> rows;
    for (const LessonEquation& equation : lesson.equations)
        rows.push_back({{std::string(equation.number), "whole"},
                        {std::string(equation.printed)},
                        {std::string(equation.function), "code"}});
    page.table({"number", "as printed", "function"}, rows);
}

std::vector<LessonFact> add_lesson(const LessonInfo& lesson, const std::filesystem::path& scenes,
                                   const std::string& folder, std::string_view heading,
                                   Page& page) {
    page.section(heading, lesson.name);
    page.lead(lesson.summary);
    LessonWork work(lesson, scenes, folder, page);
    lesson.fill(work);
    add_facts(work.facts(), page);
    add_equations(lesson, page);
    page.subsection("Try it");
    page.commands(command_lines(lesson));
    page.subsection("Questions");
    for (const LessonQuestion& q : lesson.questions) page.answer(q.question, q.answer);
    return work.facts();
}

std::string heading(const LessonInfo& lesson) {
    std::size_t number = 1;
    for (const LessonInfo* const other : all_lessons()) {
        if (other == &lesson) break;
        ++number;
    }
    return fmt::format("{}  {}", number, lesson.title);
}

/// What each lesson is about, with the way there.
void add_contents(std::span<const LessonInfo* const> lessons, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const LessonInfo* lesson : lessons)
        rows.push_back({{heading(*lesson), "", fmt::format("#{}", lesson->name)},
                        {std::string(lesson->summary)}});
    page.table({"lesson", "what it shows"}, rows);
}

}  // namespace

std::span<const LessonInfo* const> all_lessons() { return lessons::rows; }

const LessonInfo& find_lesson(std::string_view name) {
    std::vector<std::string_view> names;
    for (const LessonInfo* lesson : all_lessons()) {
        if (lesson->name == name) return *lesson;
        names.push_back(lesson->name);
    }
    throw Error(Errc::usage,
                fmt::format("lesson '{}' is unknown{}", name, suggestion(name, names)));
}

const LessonInfo* lesson_of(const std::filesystem::path& scene) {
    if (scene.extension() != ".toml" || scene.parent_path().filename() != "lessons") return nullptr;
    const std::string name = scene.stem().string();
    for (const LessonInfo* lesson : all_lessons())
        if (lesson->name == name) return lesson;
    return nullptr;
}

std::vector<std::string> command_lines(const LessonInfo& lesson) {
    std::vector<std::string> lines{
        fmt::format("scanshade view models/lessons/{}.toml", lesson.name)};
    for (const LessonCommand& c : lesson.commands)
        lines.push_back(fmt::format("scanshade {} models/lessons/{}.toml {}", c.command,
                                    lesson.name, c.options));
    return lines;
}

LessonsWritten write_lessons(std::span<const LessonInfo* const> lessons,
                             const std::filesystem::path& scenes, const std::string& folder,
                             const Watch& watch) {
    LessonsWritten written;
    Page page(
        "Lessons in shading",
        "Each lesson is a scene to look at, to change and to measure. All pictures, plots and "
        "numbers of this page were made by the program that wrote it. Three choices are kept "
        "apart: the shading (where light is evaluated: flat, gouraud, phong), the brdf (what is "
        "evaluated there) and the interpolation (how values travel inside a polygon).");
    std::vector<const LessonInfo*> done;
    Page body;
    for (const LessonInfo* lesson : lessons) {
        if ((written.partial = watch.stopped())) break;
        watch.tell(std::string(lesson->name), done.size(), lessons.size());
        for (LessonFact& fact : add_lesson(*lesson, scenes, folder, heading(*lesson), body))
            written.facts.push_back(std::move(fact));
        done.push_back(lesson);
    }
    if (written.partial)
        page.notice(fmt::format("This page is partial: it was interrupted after {} of {} lessons.",
                                done.size(), lessons.size()));
    if (lessons.size() > 1) add_contents(done, page);
    page.append(body);
    write_file(page.text(), (std::filesystem::path(folder) / "index.html").string());
    return written;
}

}  // namespace scanshade

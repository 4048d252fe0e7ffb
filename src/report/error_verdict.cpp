// The error report in sentences.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/error_parts.hpp"

namespace scanshade {
namespace {

constexpr double tolerated = 1.05;    // an error that is no larger than this is as good
constexpr double worth_saying = 0.9;  // of the time

double ms(const ErrorRow& row) { return row.time->median; }

/// No pixel differs from the reference by more than a level: nobody can see it.
bool unseen(const ErrorRow& row) { return row.error("over1") == 0; }

/// To the eye and by the numbers, over the whole picture.
bool as_good(const ErrorRow& a, const ErrorRow& b) {
    if (unseen(a)) return true;
    return a.error("rmse") <= tolerated * b.error("rmse") &&
           a.error("flip") <= tolerated * b.error("flip");
}

/// By enough to be worth saying, and not by chance.
bool surely_faster(const ErrorRow& a, const ErrorRow& b) {
    return ms(a) < worth_saying * ms(b) && paired_difference(b.run_ms, a.run_ms).low > 0;
}

/// "3.2 times", "850 times".
std::string factor(double f) {
    return f < 10 ? fmt::format("{:.2g} times", f) : fmt::format("{:.0f} times", f);
}

/// "a third of the time".
std::string share_of_time(double ratio) {
    constexpr std::string_view words[] = {"half",      "a third", "a quarter",
                                          "a fifth",   "a sixth", "a seventh",
                                          "an eighth", "a ninth", "a tenth"};
    const double parts = std::round(1 / ratio);
    if (parts >= 2 && parts <= 10 && std::abs(ratio * parts - 1) < 0.12)
        return fmt::format("{} of the time", words[std::size_t(parts) - 2]);
    if (ratio < 0.1) return fmt::format("1/{:.0f} of the time", 1 / ratio);
    return fmt::format("{:.0f} % of the time", 100 * ratio);
}

std::string times(const ErrorRow& a, const ErrorRow& b) {
    return fmt::format("{} ms instead of {} ms", short_number(ms(a)), short_number(ms(b)));
}

/// The row among those that `is` picks for which `less` is first; null: there is none.
template <class Is, class Less>
const ErrorRow* best_row(const std::vector<ErrorRow>& rows, Is is, Less less) {
    const ErrorRow* best = nullptr;
    for (const ErrorRow& row : rows)
        if (row.time && is(row) && (best == nullptr || less(row, *best))) best = &row;
    return best;
}

bool faster(const ErrorRow& a, const ErrorRow& b) { return ms(a) < ms(b); }
bool nearer(const ErrorRow& a, const ErrorRow& b) { return a.error("rmse") < b.error("rmse"); }

struct Saying {
    enum class Kind { cheaper, best, other } kind = Kind::other;  // the first says the most
    double share = 1;  // of the time of what it is as good as
    std::string text;
};

std::string as_good_as(const ErrorRow& a, const ErrorRow& b) {
    return fmt::format("{} is as good as {} at {} ({}{})", a.method.name, b.method.name,
                       share_of_time(ms(a) / ms(b)), times(a, b),
                       unseen(a) ? "; no pixel is off by more than a level" : "");
}

/// What else there is for those who want less error.
std::string nearer_costs(const std::vector<ErrorRow>& rows, const ErrorRow& given,
                         const ErrorRow* said = nullptr) {
    const ErrorRow* better = best_row(
        rows, [&](const ErrorRow& row) { return 2 * row.error("rmse") <= given.error("rmse"); },
        faster);
    if (better == nullptr || better == said || unseen(given)) return {};
    return fmt::format(" {} has {:.2g} of the error of what it asks for, at {} the time.",
                       better->method.name, better->error("rmse") / given.error("rmse"),
                       factor(ms(*better) / ms(given)));
}

Saying quality_saying(const ErrorAxisResult& result, const ErrorRow& given) {
    const ErrorRow* cheaper = best_row(
        result.rows,
        [&](const ErrorRow& row) { return as_good(row, given) && surely_faster(row, given); },
        faster);
    if (cheaper != nullptr)
        return {Saying::Kind::cheaper, ms(*cheaper) / ms(given),
                as_good_as(*cheaper, given) + "." + nearer_costs(result.rows, given, cheaper)};
    const ErrorRow* dearer = best_row(
        result.rows,
        [&](const ErrorRow& row) { return as_good(given, row) && surely_faster(given, row); },
        nearer);
    const std::string more = nearer_costs(result.rows, given);
    if (dearer == nullptr)
        return {Saying::Kind::other, 1,
                fmt::format("nothing as good as {} is faster.{}", given.method.name, more)};
    return {Saying::Kind::best, ms(given) / ms(*dearer),
            fmt::format("{}. Nothing as good is faster.{}", as_good_as(given, *dearer), more)};
}

/// Models are not good or bad: they are other models.
Saying model_saying(const ErrorAxisResult& result, const ErrorRow& given) {
    const ErrorRow* nearest = best_row(
        result.rows, [](const ErrorRow& row) { return row.error("rmse") > 0; }, nearer);
    if (nearest == nullptr) return {};
    return {Saying::Kind::other, 1,
            fmt::format("of the other models {} is nearest to what it asks for, off by {} (RMSE), "
                        "at {} the time.",
                        nearest->method.name, short_number(nearest->error("rmse")),
                        factor(ms(*nearest) / ms(given)))};
}

/// What half the size of polygons does to the mean error.
Saying convergence_saying(const ErrorAxisResult& result, const ErrorRow&) {
    std::string text;
    for (const ErrorOrder& order : result.orders)
        if (order.metric == "mae" && order.region == ErrorRegion::covered)
            text += fmt::format("{}{:.1f} ({})", text.empty() ? "" : ", ",
                                std::exp2(order.order.value), order.series);
    if (text.empty()) return {};
    return {Saying::Kind::other, 1,
            "polygons half as large divide the mean error of what both pictures cover by " + text +
                "."};
}

/// Axes on which nothing is better than something else.
constexpr struct {
    std::string_view axis;
    Saying (*say)(const ErrorAxisResult& result, const ErrorRow& given);
} other_sayings[] = {{"model", model_saying}, {"convergence", convergence_saying}};

Saying quality_or_other(const ErrorAxisResult& result, const ErrorRow& given) {
    for (const auto& other : other_sayings)
        if (other.axis == result.axis->name) return other.say(result, given);
    return quality_saying(result, given);
}

Saying saying_of(const ErrorAxisResult& result) {
    const ErrorRow* given = best_row(
        result.rows, [](const ErrorRow& row) { return row.method.as_given; }, faster);
    if (given == nullptr) return {};
    Saying saying = quality_or_other(result, *given);
    if (!saying.text.empty())
        saying.text = fmt::format("{}: for this scene, {}", result.axis->name, saying.text);
    return saying;
}

}  // namespace

std::vector<std::string> verdict_of(const ErrorSceneResult& scene) {
    std::vector<Saying> sayings;
    for (const ErrorAxisResult& result : scene.axes) sayings.push_back(saying_of(result));
    std::erase_if(sayings, [](const Saying& saying) { return saying.text.empty(); });
    std::stable_sort(sayings.begin(), sayings.end(), [](const Saying& a, const Saying& b) {
        return std::pair(a.kind, a.share) < std::pair(b.kind, b.share);
    });
    std::vector<std::string> sentences;
    for (Saying& saying : sayings) {
        saying.text[0] = char(saying.text[0] - 'a' + 'A');
        sentences.push_back(std::move(saying.text));
    }
    return sentences;
}

}  // namespace scanshade

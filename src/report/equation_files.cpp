// The equations' part of the stability report: rows for programs, sections of the page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "report/equation_files.hpp"

namespace scanshade {
namespace {

/// The largest share of its bound that an error takes.
double share_of_bound(const SweepErrors& errors, const std::vector<double>& bound) {
    double share = 0;
    for (std::size_t i = 0; i < bound.size(); ++i)
        if (errors.ulp[i] > 0) share = std::max(share, errors.ulp[i] / bound[i]);
    return share;
}
double share_of_bound(const SweepResult& sweep) {
    return std::max(share_of_bound(sweep.ours_f32, sweep.bound),
                    share_of_bound(sweep.ours_f64, sweep.bound));
}

// ---- for programs

Json row_json(std::string_view axis, const SweepResult& sweep, const Column& column) {
    const SweepErrors& e = *column.errors;
    return {{"axis", axis},
            {"method", column.method},
            {"parameters",
             {{"of", sweep.number},
              {"where", sweep.title},
              {"swept", sweep.variable},
              {"from", sweep.x.front()},
              {"to", sweep.x.back()},
              {"points", sweep.x.size()}}},
            {"error",
             {{"ulp", e.worst_ulp},
              {"at", e.worst_at},
              {"nan", e.nan},
              {"inf", e.inf},
              {"zero", e.zero},
              {"beyond_bound", e.over}}},
            {"bound_ulp",
             {{"least", std::ranges::min(sweep.bound)},
              {"most", std::ranges::max(sweep.bound)},
              {"share", share_of_bound(e, sweep.bound)}}},
            {"condition", sweep.condition},
            {"misprint", sweep.misprint},
            {"used", sweep.choice},
            {"bound_reason", sweep.because}};
}

Json rows_json(std::string_view axis, const std::vector<SweepResult>& sweeps) {
    Json rows = Json::array();
    for (const SweepResult& sweep : sweeps)
        for (const Column& column : columns(sweep)) rows.push_back(row_json(axis, sweep, column));
    return rows;
}

// ---- for people

/// "3.4", "57" or "4.2e6".
std::string ulp_text(double ulp) {
    if (ulp < 1e-9) return "0";
    if (ulp < 1000) return fmt::format("{:.{}f}", ulp, ulp < 10 ? 1 : 0);
    const std::string text = fmt::format("{:.1e}", ulp);  // "4.2e+06"
    return fmt::format("{}e{}", text.substr(0, 3), std::stoi(text.substr(4)));
}

/// The worst error of a form: its ulp, and what is no number at all.
Cell error_cell(const Column& column) {
    const SweepErrors& e = *column.errors;
    std::string text = e.worst_ulp >= column.no_digit ? "no digit" : ulp_text(e.worst_ulp);
    if (e.nan > 0) text += fmt::format(" · {} NaN", e.nan);
    if (e.inf > 0) text += fmt::format(" · {} Inf", e.inf);
    if (e.zero > 0) text += fmt::format(" · {} given up", e.zero);
    return number_cell(text, e.over > 0 ? "bad" : "good");
}

std::vector<Cell> error_row(const SweepResult& sweep) {
    std::vector<Cell> row{{sweep.number, "whole"}, {sweep.title}};
    if (!sweep.printed_f32) row.insert(row.end(), 2, Cell{"", ""});
    for (const Column& column : columns(sweep)) row.push_back(error_cell(column));
    row.push_back(number_cell(fmt::format("{:.0f} %", 100 * share_of_bound(sweep)), "faint"));
    row.push_back(number_cell(ulp_text(sweep.condition)));
    return row;
}

void add_errors(std::string_view what, const std::vector<SweepResult>& sweeps, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const SweepResult& sweep : sweeps) rows.push_back(error_row(sweep));
    page.table({std::string(what), "where", "printed, float", "printed, double", "ours, float",
                "ours, double", "of its bound", "condition"},
               rows);
}

/// The least and the largest bound along a sweep.
std::string bound_text(const SweepResult& sweep) {
    const auto [least, most] = std::minmax_element(sweep.bound.begin(), sweep.bound.end());
    if (*least == *most) return ulp_text(*least);
    return fmt::format("{} to {}", ulp_text(*least), std::isinf(*most) ? "∞" : ulp_text(*most));
}

void add_reasons(std::string_view what, const std::vector<SweepResult>& sweeps, Page& page) {
    std::vector<std::vector<Cell>> rows;
    for (const SweepResult& sweep : sweeps)
        rows.push_back({{sweep.number, "whole"},
                        {sweep.title},
                        {sweep.choice},
                        number_cell(bound_text(sweep)),
                        {sweep.because, "faint"}});
    page.table({std::string(what), "where", "what we use, and why", "bound, ulp", "because"}, rows);
}

/// What a plot shows, in a sentence.
std::string caption(const SweepResult& sweep) {
    const std::string_view verdict = sweep.misprint          ? ", a misprint"
                                     : sweep.printed_fails() ? ""
                                                             : ", as good as printed";
    return fmt::format("{} {}{}, against {}. Used: {}.", sweep.number, sweep.title, verdict,
                       sweep.variable, sweep.choice);
}

void add_figures(std::string_view kind, const std::vector<SweepResult>& sweeps, Page& page) {
    const std::vector<std::string> files = plot_files(kind, sweeps);
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < sweeps.size(); ++i)
        if (sweeps[i].plotted) figures.push_back({files[i], caption(sweeps[i])});
    page.figures(figures);
}

std::size_t numbers_in(const std::vector<SweepResult>& sweeps) {
    std::set<std::string> numbers;
    for (const SweepResult& sweep : sweeps) numbers.insert(sweep.number);
    return numbers.size();
}

}  // namespace

std::string equation_verdict(const EquationStability& equations) {
    const std::vector<SweepResult>& sweeps = equations.equations;
    const auto count = [&](auto what) { return std::count_if(sweeps.begin(), sweeps.end(), what); };
    if (sweeps.empty()) return "No equation was measured.";
    const std::size_t faults = equations.faults().size();
    const auto fails = count([](const SweepResult& s) { return s.printed_fails(); });
    const auto misprints = count([](const SweepResult& s) { return s.misprint; });
    const auto no_numbers =
        count([](const SweepResult& s) { return s.printed_f32->nan + s.printed_f32->inf > 0; });
    const std::string kept =
        faults == 0 ? fmt::format(
                          "{}very equation and every model keeps its error bound at all "
                          "extremes, in float and in double, without a NaN or an Inf.",
                          equations.partial ? "As far as it was measured, e" : "E")
                    : fmt::format("{} error bounds of equations or models are broken.", faults);
    return fmt::format(
        "{} Of {} sweeps of {} equations the forms that are printed in the formula sheet fail in "
        "{}: {} are misprints, {} end in NaN or Inf, and the others lose digits or go "
        "wrong outside of what they were printed for.",
        kept, sweeps.size(), numbers_in(sweeps), fails, misprints, no_numbers);
}

Json equation_scenes_json(const EquationStability& equations) {
    return {{{"name", "equations"}, {"rows", rows_json("equations", equations.equations)}},
            {{"name", "models"}, {"rows", rows_json("models", equations.models)}}};
}

void add_equation_sections(const EquationStability& equations, bool plots_drawn, Page& page) {
    page.section("Equations");
    page.paragraph(
        "Each equation that is misprinted in the formula sheet, or right on paper and unsafe in "
        "floating point, with one parameter that goes to its extremes. Errors are in ulp, the "
        "distance of neighbouring numbers at the exact result, which is computed with 113 bits; "
        "0.5 is perfect. No digit: the error is as large as the result. Given up: the answer is 0 "
        "where no digit would be sure, and the caller has another way. Condition: by how much the "
        "equation itself magnifies a relative error of the parameter. Green keeps the bound of our "
        "form, red breaks it.");
    add_errors("equation", equations.equations, page);
    if (plots_drawn) {
        page.paragraph(
            "The error along each sweep. Crosses at the top stand for NaN and Inf in float; a "
            "leftmost point apart from the curve is that of 0; errors below 0.1 ulp are drawn "
            "there.");
        add_figures("equation", equations.equations, page);
    }
    add_reasons("equation", equations.equations, page);
    page.section("Reflection models");
    page.paragraph(
        "Every model of the registry, and each of its choices, beside the printed form: f_r "
        "cosθ_i, "
        "with the roughness or exponent over its whole range at the side of the highlight, and "
        "with light, viewer and both from 1e-8 rad above the surface. The exact value is the "
        "model's own with 64 bits. Condition: the sum over all cosines of a direction.");
    add_errors("model", equations.models, page);
    if (plots_drawn) add_figures("model", equations.models, page);
    add_reasons("model", equations.models, page);
}

}  // namespace scanshade

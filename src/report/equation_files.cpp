// The equations' part of the stability report as files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "scanshade/report/equation_stability.hpp"

namespace scanshade {
namespace {

/// A form in a type of number, as tables and files name it.
struct Column {
    std::string_view method;  // "printed f32"
    double no_digit;          // an error of so many ulp leaves none
    const SweepErrors* errors;
};
std::vector<Column> columns(const SweepResult& sweep) {
    constexpr double f32 = 0x1p23, f64 = 0x1p52;
    std::vector<Column> all;
    if (sweep.printed_f32)
        all = {{"printed f32", f32, &*sweep.printed_f32},
               {"printed f64", f64, &*sweep.printed_f64}};
    all.push_back({"ours f32", f32, &sweep.ours_f32});
    all.push_back({"ours f64", f64, &sweep.ours_f64});
    return all;
}

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

// ---- plots

constexpr const char* sweep_script = R"(
set logscale y
set ylabel 'error, ulp' offset 1,0
set format y '1e%T'
set format x (wide ? '1e%T' : '%g')
set key outside top center horizontal samplen 1.5 font ',11'
set yrange [0.08:top]
set autoscale xfix
set offsets graph 0.02, graph 0.02, 0, 0
plot 'data' index 0 using 1:6 with lines linewidth 1 dashtype 2 linecolor rgb '#737a84' title 'bound', \
     'data' index 0 using 1:3 with lines linewidth 1 linecolor rgb '#f2b48c' title 'printed, double', \
     'data' index 0 using 1:2 with lines linewidth 1.6 linecolor rgb '#d55e00' title 'printed, float', \
     'data' index 0 using 1:5 with lines linewidth 1 linecolor rgb '#8cc0e0' title 'ours, double', \
     'data' index 0 using 1:4 with lines linewidth 1.6 linecolor rgb '#0072b2' title 'ours, float', \
     'data' index 1 using 1:2 with points pointtype 2 pointsize 0.6 linecolor rgb '#d55e00' notitle, \
     'data' index 2 using 1:2 with points pointtype 2 pointsize 0.6 linecolor rgb '#0072b2' notitle
)";
constexpr const char *linear_x = "\n", *logarithmic_x = "set logscale x\n";

// gnuplot's variables and their script above.
constexpr double least_shown = 0.1;

/// Where 0 stands on a logarithmic axis: a little to the left of the least other number.
double shown_x(const SweepResult& sweep, std::size_t i) {
    if (sweep.x[i] > 0 || !sweep.logarithmic) return sweep.x[i];
    return sweep.x[1] * std::pow(sweep.x[1] / sweep.x.back(), 0.06);
}

double shown(const SweepErrors* errors, std::size_t i) {
    if (!errors) return std::numeric_limits<double>::quiet_NaN();
    return errors->ulp[i] < least_shown ? least_shown : errors->ulp[i];
}

const SweepErrors* in(const std::optional<SweepErrors>& errors) {
    return errors ? &*errors : nullptr;
}

/// A mark at the top for each result that is no number.
void add_marks(const SweepResult& sweep, const SweepErrors* errors, double top, PlotData& data) {
    data.end_block();
    data.number(std::numeric_limits<double>::quiet_NaN()).number(top).end_line();  // never empty
    for (std::size_t i = 0; errors && i < sweep.x.size(); ++i)
        if (std::isnan(errors->ulp[i]) && errors->nan + errors->inf > 0)
            data.number(shown_x(sweep, i)).number(top / 3).end_line();
}

double largest_shown(const SweepResult& sweep) {
    double largest = 100;
    for (const Column& column : columns(sweep))
        largest = std::max(largest, std::min(column.errors->worst_ulp, 1e20));
    return largest;
}

Plot sweep_plot(const SweepResult& sweep, std::string file) {
    Plot plot{std::move(file), 440, 300, {}, {}, {}};
    const double top = std::pow(10, std::ceil(std::log10(largest_shown(sweep))) + 1);
    const bool wide = sweep.logarithmic;
    plot.numbers = {{"top", top}, {"wide", wide ? 1.0 : 0.0}};
    plot.script = {wide ? logarithmic_x : linear_x, sweep_script};
    const SweepErrors *printed32 = in(sweep.printed_f32), *printed64 = in(sweep.printed_f64);
    for (std::size_t i = 0; i < sweep.x.size(); ++i)
        plot.data.number(shown_x(sweep, i))
            .number(shown(printed32, i))
            .number(shown(printed64, i))
            .number(shown(&sweep.ours_f32, i))
            .number(shown(&sweep.ours_f64, i))
            .number(std::max(sweep.bound[i], least_shown))
            .end_line();
    add_marks(sweep, printed32, top, plot.data);
    add_marks(sweep, &sweep.ours_f32, top, plot.data);
    return plot;
}

/// "equation-B17c-2.svg": the second sweep of B17c.
std::vector<std::string> plot_files(std::string_view kind, const std::vector<SweepResult>& sweeps) {
    std::vector<std::string> files;
    std::multiset<std::string> seen;
    for (const SweepResult& sweep : sweeps) {
        seen.insert(sweep.number);
        files.push_back(fmt::format("{}-{}-{}.svg", kind, sweep.number, seen.count(sweep.number)));
    }
    return files;
}

void add_plots(std::string_view kind, const std::vector<SweepResult>& sweeps,
               std::vector<Plot>& plots) {
    const std::vector<std::string> files = plot_files(kind, sweeps);
    for (std::size_t i = 0; i < sweeps.size(); ++i)
        if (sweeps[i].plotted) plots.push_back(sweep_plot(sweeps[i], files[i]));
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
    const std::size_t faults = equations.faults().size();
    const auto fails = count([](const SweepResult& s) { return s.printed_fails(); });
    const auto misprints = count([](const SweepResult& s) { return s.misprint; });
    const auto no_numbers =
        count([](const SweepResult& s) { return s.printed_f32->nan + s.printed_f32->inf > 0; });
    const std::string kept =
        faults == 0 ? "Every equation and every model keeps its error bound at all extremes, in "
                      "float and in double, without a NaN or an Inf."
                    : fmt::format("{} error bounds are broken.", faults);
    return fmt::format(
        "{} Of {} sweeps of {} equations the forms that are printed in the formula sheet fail in "
        "{}: {} are misprints, {} end in NaN or Inf, and the others lose digits or have a wrong "
        "sign.",
        kept, sweeps.size(), numbers_in(sweeps), fails, misprints, no_numbers);
}

Json equation_scenes_json(const EquationStability& equations) {
    return {{{"name", "equations"}, {"rows", rows_json("equations", equations.equations)}},
            {{"name", "models"}, {"rows", rows_json("models", equations.models)}}};
}

std::vector<Plot> equation_plots(const EquationStability& equations) {
    std::vector<Plot> plots;
    add_plots("equation", equations.equations, plots);
    add_plots("model", equations.models, plots);
    return plots;
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

// The error along each sweep as a plot.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "report/equation_files.hpp"

namespace scanshade {
namespace {

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

/// In ulp; what is less, 0 among it, is drawn there.
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

void add_plots(std::string_view kind, const std::vector<SweepResult>& sweeps,
               std::vector<Plot>& plots) {
    const std::vector<std::string> files = plot_files(kind, sweeps);
    for (std::size_t i = 0; i < sweeps.size(); ++i)
        if (sweeps[i].plotted) plots.push_back(sweep_plot(sweeps[i], files[i]));
}

}  // namespace

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

std::vector<std::string> plot_files(std::string_view kind, const std::vector<SweepResult>& sweeps) {
    std::vector<std::string> files;
    std::multiset<std::string> seen;
    for (const SweepResult& sweep : sweeps) {
        seen.insert(sweep.number);
        files.push_back(fmt::format("{}-{}-{}.svg", kind, sweep.number, seen.count(sweep.number)));
    }
    return files;
}

std::vector<Plot> equation_plots(const EquationStability& equations) {
    std::vector<Plot> plots;
    add_plots("equation", equations.equations, plots);
    add_plots("model", equations.models, plots);
    return plots;
}

}  // namespace scanshade

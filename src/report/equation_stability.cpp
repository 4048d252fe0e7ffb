#include "scanshade/report/equation_stability.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "report/equation_sweep.hpp"
#include "report/model_sweeps.hpp"
#include "report/sweep_errors.hpp"
#include "scanshade/num/plain.hpp"

namespace scanshade {
namespace {

constexpr std::size_t points = 241;

using Sweeps = std::span<const EquationSweep>;

std::array<Sweeps, 6> chapters() {
    return {direction_sweeps(),  reflection_sweeps(), microfacet_sweeps(),
            oren_nayar_sweeps(), shading_sweeps(),    raycast_sweeps()};
}

/// Numbers of a float: the same in each type.
std::vector<double> points_of(const EquationSweep& sweep) {
    const bool zero = sweep.spacing == Spacing::from_zero || sweep.spacing == Spacing::whole;
    const double low = sweep.low > 0 ? sweep.low : 1;
    std::vector<double> x;
    if (zero) x.push_back(0);
    for (std::size_t i = 0; i < points; ++i) {
        const double share = double(i) / double(points - 1);
        double at = sweep.spacing == Spacing::linear ? sweep.low + share * (sweep.high - sweep.low)
                                                     : low * std::pow(sweep.high / low, share);
        if (sweep.spacing == Spacing::whole) at = std::round(at);
        if (x.empty() || at != x.back()) x.push_back(double(float(at)));
    }
    return x;
}

/// How much of a relative error of x is in the result: ‖x f′(x)‖/‖f(x)‖.
double condition_at(const EquationSweep& sweep, double x) {
    const Vec3<Dual> y = sweep.ours.dual(Dual(x, 1));
    const double value = std::hypot(y.x.value, y.y.value, y.z.value);
    const double slope = std::hypot(y.x.derivative, y.y.derivative, y.z.derivative);
    return condition_number(x, {value, slope});
}

template <class R>
void add_point(const EquationSweep& sweep, SweptFn<R> form, bool ours, double x, double bound,
               SweepErrors& errors) {
    const Vec3<Wide> exact = sweep.exact(Wide(x));
    const Vec3<R> computed = form(R(x));
    const auto component = [](R value, Wide exact_value) {
        return Component{double(value), double(Wide(double(value)) - exact_value),
                         double(exact_value)};
    };
    const Component parts[] = {component(computed.x, exact.x), component(computed.y, exact.y),
                               component(computed.z, exact.z)};
    const bool may_be_zero = ours && sweep.gives_up;
    add_error(parts, precision_of<R>(), x, bound, may_be_zero, errors);
}

SweepResult measure(const EquationSweep& sweep) {
    SweepResult result{};
    result.number = sweep.number;
    result.title = sweep.title;
    result.variable = sweep.variable;
    result.choice = sweep.choice;
    result.because = sweep.because;
    result.misprint = sweep.misprint;
    result.logarithmic = sweep.spacing != Spacing::linear;
    result.printed_f32 = result.printed_f64 = SweepErrors{};
    result.x = points_of(sweep);
    for (const double x : result.x) {
        const double condition = condition_at(sweep, x), bound = sweep.bound(x, condition);
        result.condition = std::max(result.condition, condition);
        result.bound.push_back(bound);
        add_point(sweep, sweep.printed.f32, false, x, bound, *result.printed_f32);
        add_point(sweep, sweep.printed.f64, false, x, bound, *result.printed_f64);
        add_point(sweep, sweep.ours.f32, true, x, bound, result.ours_f32);
        add_point(sweep, sweep.ours.f64, true, x, bound, result.ours_f64);
    }
    return result;
}

void add_fault(const SweepResult& sweep, std::string_view type, const SweepErrors& errors,
               std::vector<std::string>& faults) {
    if (errors.over > 0)
        faults.push_back(fmt::format(
            "{} {}: {} of {} results in {} break their bound; the largest error is {:.3g} ulp at "
            "{} = {:.6g}, and {} are no finite numbers",
            sweep.number, sweep.title, errors.over, sweep.x.size(), type, errors.worst_ulp,
            sweep.variable, errors.worst_at, errors.nan + errors.inf));
}

}  // namespace

EquationStability measure_equation_stability(const Watch& watch) {
    Steps steps{watch};
    steps.all = model_sweep_count();
    for (const Sweeps& chapter : chapters()) steps.all += chapter.size();
    EquationStability result;
    for (const Sweeps& chapter : chapters())
        for (const EquationSweep& sweep : chapter) {
            if (watch.stopped()) break;
            steps.tell(fmt::format("{} {}", sweep.number, sweep.title));
            result.equations.push_back(measure(sweep));
            ++steps.done;
        }
    result.models = measure_models(steps);
    result.partial = steps.done < steps.all;
    return result;
}

std::vector<std::string> EquationStability::faults() const {
    std::vector<std::string> faults;
    for (const auto* part : {&equations, &models})
        for (const SweepResult& sweep : *part) {
            add_fault(sweep, "float", sweep.ours_f32, faults);
            add_fault(sweep, "double", sweep.ours_f64, faults);
        }
    return faults;
}

}  // namespace scanshade

// How fast errors fall.
#include <algorithm>
#include <cmath>

#include "report/error_parts.hpp"

namespace scanshade {
namespace {

/// The last points of a series: three halvings.
constexpr std::size_t fitted_points = 4;

struct Measure {
    std::string_view metric;
    ErrorRegion region;
};
constexpr Measure measures[] = {{"mae", ErrorRegion::covered},
                                {"rmse", ErrorRegion::covered},
                                {"max", ErrorRegion::covered},
                                {"rmse", ErrorRegion::all}};

const ExpectedOrder* expected_of(const ErrorAxis& axis, const ErrorOrder& order) {
    for (const ExpectedOrder& row : axis.expected)
        if (order.series.starts_with(row.shading) && row.metric == order.metric &&
            row.region == order.region)
            return &row;
    return nullptr;
}

/// Rows of a series, by amount.
std::vector<const ErrorRow*> series_of(const ErrorAxisResult& result, const std::string& series) {
    std::vector<const ErrorRow*> rows;
    for (const ErrorRow& row : result.rows)
        if (row.method.series == series && row.method.amount > 0) rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(), [](const ErrorRow* a, const ErrorRow* b) {
        return a->method.amount < b->method.amount;
    });
    if (rows.size() > fitted_points) rows.erase(rows.begin(), rows.end() - long(fitted_points));
    return rows;
}

template <class Amount>
std::optional<Fit> fit_rows(const std::vector<const ErrorRow*>& rows, const Measure& measure,
                            Amount amount) {
    std::vector<double> x, y;
    for (const ErrorRow* row : rows) {
        x.push_back(amount(*row));
        y.push_back(row->error(measure.metric, measure.region));
    }
    return fit_power(x, y);
}

ErrorOrder order_of(const std::string& series, std::string_view against, const Measure& measure,
                    const Fit& fit) {
    return {series,
            std::string(against),
            measure.metric,
            measure.region,
            {-fit.slope.value, -fit.slope.high, -fit.slope.low}};
}

void add_orders(const std::string& series, ErrorAxisResult& result) {
    const std::vector<const ErrorRow*> rows = series_of(result, series);
    for (const Measure& measure : measures)
        if (const auto fit =
                fit_rows(rows, measure, [](const ErrorRow& row) { return row.method.amount; })) {
            ErrorOrder order = order_of(series, result.axis->against, measure, *fit);
            order.expected = expected_of(*result.axis, order);
            result.orders.push_back(std::move(order));
        }
    if (!std::all_of(rows.begin(), rows.end(), [](const ErrorRow* row) { return row->time; }))
        return;
    const Measure whole{"rmse", ErrorRegion::all};
    if (const auto fit =
            fit_rows(rows, whole, [](const ErrorRow& row) { return row.time->median; }))
        result.orders.push_back(order_of(series, "time", whole, *fit));
}

/// The law that the rows follow, at the samples of the reference.
void extrapolate_own_error(ErrorAxisResult& result) {
    const auto fit = fit_rows(series_of(result, "samples"), {"rmse", ErrorRegion::all},
                              [](const ErrorRow& row) { return row.method.amount; });
    if (!fit) return;
    result.own_rmse = fit->constant.value * std::pow(double(reference_samples), fit->slope.value);
    result.own_from = "the law that the errors of the rows follow, continued to its own samples";
}

}  // namespace

void finish_orders(ErrorAxisResult& result) {
    std::vector<std::string> done;
    for (const ErrorRow& row : result.rows) {
        if (std::find(done.begin(), done.end(), row.method.series) != done.end()) continue;
        done.push_back(row.method.series);
        add_orders(row.method.series, result);
    }
    if (result.own_from.empty()) extrapolate_own_error(result);
}

}  // namespace scanshade

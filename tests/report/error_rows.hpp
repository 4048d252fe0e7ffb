// Rows and axes of the error report, as its tests make them.
#pragma once

#include <set>
#include <stdexcept>
#include <string>

#include "report/error_parts.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"

namespace scanshade {

inline std::size_t metric_index(std::string_view name) {
    return std::size_t(&find_metric(name) - all_metrics().data());
}

/// A row with the errors that orders, fronts and verdicts read.
inline ErrorRow row_with(ErrorMethod method, double ms, double rmse, double over1 = 1) {
    ErrorRow row;
    row.method = std::move(method);
    row.run_ms = {ms};
    row.time = Times{ms, ms, 1};
    for (RegionErrors& region : row.regions) {
        region.values.assign(all_metrics().size(), 0);
        region.values[metric_index("rmse")] = rmse;
        region.values[metric_index("over1")] = over1;
        region.values[metric_index("flip")] = rmse;
    }
    return row;
}

inline ReportInput matt_teapot() {
    Material glaze;
    glaze.set("shininess", {60});
    ReportInput input{single_object_scene(make_shape_mesh(*find_shape("teapot"), 6), glaze),
                      small_picture()};
    input.settings.samples = 4;
    return input;
}

inline const ErrorAxis& axis_named(std::string_view name) {
    for (const ErrorAxis& axis : error_axes())
        if (axis.name == name) return axis;
    throw std::runtime_error("no such axis");
}

struct Measured {
    ErrorAxisResult result;
    std::set<std::string> pictures;
};

inline Measured measured(std::string_view axis, const ReportInput& input) {
    Measured m;
    const Watch watch;
    Steps steps{watch};
    const auto keep = [&](const std::string& file, const Image& image) {
        CHECK(image.width == input.settings.width);
        CHECK(m.pictures.insert(file).second);  // no picture hides another
    };
    m.result = measure_error_axis(axis_named(axis), input, "1 test", {0, 1, 1}, steps, keep);
    CHECK(steps.done == 1 + m.result.rows.size() + 1);
    return m;
}

}  // namespace scanshade

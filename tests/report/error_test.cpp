// The error report: orders that theory knows, and what each axis measures.
#include <cmath>

#include "report/error_rows.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"

using namespace scanshade;

namespace {

/// What measure_error_axis does, but for times and the measures that orders do not need.
ErrorAxisResult untimed(const ErrorAxis& axis, const ReportInput& input) {
    ErrorAxisResult result{&axis, {}, {}, 0, {}, {}, {}};
    const ErrorReference reference = axis.reference(input, make_drawing);
    result.own_rmse = reference.own_rmse;
    for (ErrorMethod& method : axis.methods(input)) {
        Framebuffer picture;
        Renderer(method.input.scene, method.input.settings).draw(picture);
        const Comparison pair(picture, reference.picture, Transfer::linear, 0);
        const Regions regions = regions_of(picture, reference.picture);
        ErrorRow row = row_with(method, 1, 0);
        row.time.reset();
        for (const char* metric : {"mae", "rmse", "max"}) {
            const std::size_t m = metric_index(metric);
            row.regions[0].values[m] = measure(all_metrics()[m], pair);
            row.regions[1].values[m] = measure(all_metrics()[m], pair, {}, &regions.covered);
        }
        result.rows.push_back(std::move(row));
    }
    finish_orders(result);
    return result;
}

double order_in(const ErrorAxisResult& result, std::string_view series, std::string_view metric) {
    for (const ErrorOrder& order : result.orders)
        if (order.series.starts_with(series) && order.metric == metric &&
            order.region == ErrorRegion::covered && order.against != "time")
            return order.order.value;
    return std::nan("");
}

}  // namespace

TEST_CASE("errors on a diffuse sphere fall as fast as theory says", "[report][orders]") {
    const ErrorStudy study = convergence_studies({}).front();
    const ErrorAxisResult result = untimed(*study.axis, study.input);
    std::size_t held = 0;
    for (const ErrorOrder& order : result.orders) {
        if (order.expected == nullptr) continue;
        CAPTURE(order.series, order.metric, int(order.region), order.order.value);
        // Means hold all pixels. Squares weigh those next to the silhouette, of which phong's are
        // off by a factor √log(1/h); the largest is that of one pixel, wherever its centre lies.
        const double room = order.metric == "mae" ? 0.15 : order.metric == "rmse" ? 0.2 : 0.35;
        CHECK(std::abs(order.order.value - order.expected->order) <= room);
        CHECK(order.order.low <= order.order.value);
        CHECK(order.order.value <= order.order.high);
        ++held;
    }
    CHECK(held == study.axis->expected.size());
    CHECK(result.own_rmse > 0);
    CHECK(result.own_rmse < 0.6 * result.rows.back().error("rmse"));
}

TEST_CASE(
    "without the terminator in view Gouraud's squares fall with order 2, and a highlight "
    "spoils them while it is smaller than polygons",
    "[report][orders]") {
    std::vector<ErrorStudy> studies = convergence_studies({});
    for (ErrorStudy& study : studies) {
        study.input.settings.width = study.input.settings.height = 256;
        study.input.scene.lights[0].direction = {-0.2, -0.1, -1};
    }
    const ErrorAxisResult matt = untimed(*studies[0].axis, studies[0].input);
    CHECK(std::abs(order_in(matt, "gouraud", "rmse") - 2) < 0.25);
    CHECK(std::abs(order_in(matt, "gouraud", "mae") - 2) < 0.15);
    const ErrorAxisResult shiny = untimed(*studies[1].axis, studies[1].input);
    const auto error = [&](std::string_view series, double amount) {
        for (const ErrorRow& row : shiny.rows)
            if (row.method.series.starts_with(series) && row.method.amount == amount)
                return row.error("rmse", ErrorRegion::covered);
        return std::nan("");
    };
    CHECK(std::log2(error("gouraud", 4) / error("gouraud", 8)) < 1.5);
    CHECK(std::log2(error("gouraud", 32) / error("gouraud", 64)) > 1.7);
    CHECK(error("phong", 4) < error("gouraud", 8));
}

TEST_CASE("each axis compares with its own reference", "[report]") {
    const ReportInput input = matt_teapot();
    for (const ErrorAxis& axis : error_axes()) {
        const Measured m = measured(axis.name, input);
        CAPTURE(axis.name);
        const auto given = std::count_if(m.result.rows.begin(), m.result.rows.end(),
                                         [](const ErrorRow& row) { return row.method.as_given; });
        CHECK(given == 1);
        CHECK(m.pictures.size() == m.result.rows.size() + 1);
        CHECK(m.pictures.count(m.result.reference_picture) == 1);
        CHECK_FALSE(m.result.own_from.empty());
        for (const ErrorRow& row : m.result.rows) {
            CAPTURE(row.method.name);
            REQUIRE(row.time.has_value());
            CHECK(row.time->runs == 1);
            CHECK(row.triangles > 0);
            CHECK(m.pictures.count(row.picture) == 1);
            const auto pixels = [&](ErrorRegion region) {
                return row.regions[std::size_t(region)].pixels;
            };
            CHECK(pixels(ErrorRegion::all) == 80 * 60);
            CHECK(pixels(ErrorRegion::interior) > 0);
            CHECK(pixels(ErrorRegion::interior) < pixels(ErrorRegion::covered));
            CHECK(pixels(ErrorRegion::silhouette) > 0);
            // The whole is made of its channels.
            const RegionErrors& all = row.regions[0];
            double squares = 0;
            for (const double rmse : all.channels[metric_index("rmse")]) squares += rmse * rmse;
            CHECK(all.values[metric_index("rmse")] == Approx(std::sqrt(squares / 3)));
        }
    }
}

TEST_CASE("numbers: double has no error, all others one that nobody sees", "[report]") {
    const ErrorAxisResult result = measured("numerical", matt_teapot()).result;
    std::size_t forms = 0;
    for (const ErrorRow& row : result.rows) {
        CAPTURE(row.method.name);
        // By exp and log the last digits are others, which pictures of floats do not hold.
        const bool exact = row.method.name.starts_with("scalar-f64");
        CHECK((row.error("rmse") == 0) == exact);
        CHECK(std::isinf(row.efficiency()) == exact);
        CHECK(row.error("max") < 1e-4);
        CHECK(row.error("over1") == 0);
        forms += row.method.name.ends_with("exp-log");
    }
    CHECK(2 * forms == result.rows.size());

    ReportInput matt = matt_teapot();
    matt.settings.brdf = "lambert";
    for (const ErrorMethod& method : axis_named("numerical").methods(matt))
        CHECK(method.name.find("squaring") == std::string::npos);  // there is no power
}

TEST_CASE("samples: more are nearer to 1024, which are nearest to the truth", "[report]") {
    const ErrorAxisResult result = measured("aliasing", matt_teapot()).result;
    REQUIRE(result.rows.size() == 4);
    for (std::size_t i = 1; i < 4; ++i) {
        CHECK(result.rows[i].error("rmse") < 0.7 * result.rows[i - 1].error("rmse"));
        CHECK(result.rows[i].method.amount == std::pow(4, i));
    }
    CHECK(result.rows[1].method.as_given);
    CHECK(result.own_rmse > 0);
    CHECK(result.own_rmse < 0.5 * result.rows[3].error("rmse"));
    // Edges at all angles: between that of a step along the grid and of a well spread pattern.
    const double order = order_in(result, "samples", "rmse");
    CHECK(order > 0.5);
    CHECK(order < 1);

    ReportInput odd = matt_teapot();
    odd.settings.samples = 9;
    const auto methods = axis_named("aliasing").methods(odd);
    REQUIRE(methods.size() == 5);
    CHECK(methods[2].name == "9 samples");
    CHECK(methods[2].as_given);
}

TEST_CASE("interpolation: finer polygons and phong shading are nearer to the smooth surface",
          "[report]") {
    const ErrorAxisResult result = measured("interpolation", matt_teapot()).result;
    REQUIRE(result.rows.size() == 4 * 7);
    const auto row = [&](const std::string& name) -> const ErrorRow& {
        const auto at = std::find_if(result.rows.begin(), result.rows.end(),
                                     [&](const ErrorRow& r) { return r.method.name == name; });
        REQUIRE(at != result.rows.end());
        return *at;
    };
    const auto inside = [&](const std::string& name) {
        return row(name).error("mae", ErrorRegion::interior);
    };
    for (const char* n : {"0.25", "0.5", "1", "2"}) {
        const std::string at = std::string(", tessellation ×") + n;
        CHECK(inside("phong, perspective" + at) < inside("gouraud, perspective" + at));
        CHECK(inside("gouraud, perspective" + at) < inside("flat" + at));
    }
    CHECK(inside("phong, perspective, tessellation ×2") <
          0.3 * inside("phong, perspective, tessellation ×0.5"));
    CHECK(row("phong, perspective, tessellation ×1").method.as_given);
    CHECK(row("flat, tessellation ×2").triangles > 14 * row("flat, tessellation ×0.5").triangles);
    CHECK(result.own_rmse > 0);
    CHECK(result.own_rmse < row("phong, perspective, tessellation ×2").error("rmse"));
}

TEST_CASE("a mesh from a file is its own reference, by phong shading", "[report]") {
    ReportInput input = matt_teapot();
    input.scene.objects[0].mesh = std::make_shared<Mesh>(
        build_mesh(find_shape("teapot")->make(6), {}));  // forgets what it is
    const ErrorAxisResult result = measured("interpolation", input).result;
    CHECK(result.rows.size() == 7);
    CHECK(result.reference.find("the same mesh") != std::string::npos);
    for (const ErrorRow& row : result.rows) {
        CHECK(row.method.amount == 0);
        if (row.method.name == "phong, perspective")
            CHECK(row.error("rmse") < 1e-3);  // corners snapped to 1/256 pixel
        else
            CHECK(row.error("rmse") > 2e-4);
    }
}

TEST_CASE("models are compared with what the scene asks for", "[report]") {
    const ErrorAxisResult result = measured("model", matt_teapot()).result;
    REQUIRE(result.rows.size() == 1 + all_brdfs().size());
    CHECK(result.rows[0].error("rmse") == 0);
    for (const ErrorRow& row : result.rows)
        if (row.method.name == "lambert") CHECK(row.error("rmse") > 1e-3);
}

TEST_CASE("scenes are made again in more polygons, each mesh once", "[report]") {
    Scene scene = matt_teapot().scene;
    scene.objects.push_back(scene.objects[0]);
    const auto add = [&](std::shared_ptr<const Mesh> mesh) {
        Object& object = scene.objects.emplace_back();
        object.mesh = std::move(mesh);
        object.materials = {0};
    };
    add(make_shape_mesh(*find_shape("cube"), 2));
    add(lit_sphere().objects[0].mesh);
    const Scene finer = retessellated(scene, 2);
    CHECK(finer.objects[0].mesh->tessellation == 12);
    CHECK(finer.objects[0].mesh == finer.objects[1].mesh);
    CHECK(finer.objects[2].mesh->tessellation == 4);
    CHECK(finer.objects[3].mesh == scene.objects[3].mesh);
    const Scene smooth = retessellated(scene, 2, Retessellate::smooth);
    CHECK(smooth.objects[0].mesh->tessellation == 12);
    CHECK(smooth.objects[2].mesh == scene.objects[2].mesh);
    CHECK(retessellated(scene, 1e-3).objects[0].mesh->tessellation == 1);
    // At poles quads are triangles, so the prediction is a little off.
    const double triangles = double(scene.objects[0].mesh->triangle_count());
    CHECK(predicted_triangles(scene, 2) == Approx(4 * triangles));
    CHECK(double(finer.objects[0].mesh->triangle_count()) == Approx(4 * triangles).epsilon(0.03));
    CHECK(predicted_triangles(scene, 1e6) == Approx(triangles * 512 * 512 / 36));  // the finest
}

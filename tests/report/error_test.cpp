// The error report: orders that theory knows, and what is made of measurements.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "report/error_parts.hpp"
#include "scanshade/report/document.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

std::size_t metric_index(std::string_view name) {
    return std::size_t(&find_metric(name) - all_metrics().data());
}

/// A row with the errors that orders, fronts and verdicts read.
ErrorRow row_with(ErrorMethod method, double ms, double rmse, double over1 = 1) {
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

ErrorMethod named(const std::string& name, bool as_given = false) {
    ErrorMethod method;
    method.name = method.series = name;
    method.as_given = as_given;
    return method;
}

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

ReportInput matt_teapot() {
    Material glaze;
    glaze.set("shininess", {60});
    ReportInput input{single_object_scene(make_shape_mesh(*find_shape("teapot"), 6), glaze),
                      small_picture()};
    input.settings.samples = 4;
    return input;
}

const ErrorAxis& axis_named(std::string_view name) {
    for (const ErrorAxis& axis : error_axes())
        if (axis.name == name) return axis;
    throw std::runtime_error("no such axis");
}

struct Measured {
    ErrorAxisResult result;
    std::set<std::string> pictures;
};

Measured measured(std::string_view axis, const ReportInput& input) {
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

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
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

TEST_CASE("the front has the rows that none is better than", "[report]") {
    std::vector<ErrorRow> rows{
        row_with(named("fast"), 1, 0.5),      row_with(named("good"), 10, 0.01),
        row_with(named("beaten"), 11, 0.02),  row_with(named("between"), 3, 0.1),
        row_with(named("as fast"), 1, 0.6),   row_with(named("twin"), 3, 0.1),
        row_with(named("no time"), 0, 0.0001)};
    rows.back().time.reset();
    mark_front(rows);
    std::string front;
    for (const ErrorRow& row : rows)
        if (row.on_front) front += row.method.name + " ";
    CHECK(front == "fast good between twin ");
}

TEST_CASE("the verdict says what is as good and takes less time", "[report]") {
    const ErrorAxis& axis = axis_named("interpolation");
    ErrorSceneResult scene{"s", 8, 8, {{&axis, {}, {}, 0, {}, {}, {}}}, {}};
    std::vector<ErrorRow>& rows = scene.axes[0].rows;
    rows = {row_with(named("X"), 1, 0.101), row_with(named("Y", true), 3, 0.1),
            row_with(named("Z"), 9, 0.01)};
    CHECK(
        verdict_of(scene).at(0) ==
        "Interpolation: for this scene, X is as good as Y at a third of the time (1 ms instead of "
        "3 ms). Z has 0.1 of the error of what it asks for, at 3 times the time.");
    rows[0] = row_with(named("X"), 1, 0.11);  // too far off
    CHECK(verdict_of(scene).at(0).find("nothing as good as Y is faster") != std::string::npos);
    rows[0] = row_with(named("X"), 12, 0.09);
    CHECK(verdict_of(scene).at(0).find("nothing as good as Y is faster") != std::string::npos);
    rows[0] = row_with(named("X"), 12, 0.099);
    CHECK(verdict_of(scene).at(0).find("Y is as good as X at a quarter of the time (3 ms instead "
                                       "of 12 ms). Nothing as good is faster.") !=
          std::string::npos);
    rows[0] = row_with(named("X"), 1, 0.2, 0);  // whatever its error, nobody sees it
    CHECK(verdict_of(scene).at(0).find("X is as good as Y") != std::string::npos);
    CHECK(verdict_of(scene).at(0).find("no pixel is off by more than a level") !=
          std::string::npos);
    // Half of the runs say the opposite: that may be chance.
    rows[0].run_ms = {1, 9, 1, 9, 1, 1, 9, 1, 1};
    rows[1].run_ms = {3, 3, 3, 3, 3, 3, 3, 3, 3};
    CHECK(verdict_of(scene).at(0).find("nothing as good as Y is faster") != std::string::npos);
    rows[0].run_ms = {1, 9, 1, 1, 1, 1, 1, 1, 1};
    CHECK(verdict_of(scene).at(0).find("X is as good as Y") != std::string::npos);
    for (ErrorRow& row : rows) row.time.reset();
    CHECK(verdict_of(scene).empty());
}

TEST_CASE("the verdict on a sphere says what finer polygons bring", "[report]") {
    const ErrorStudy study = convergence_studies({}).front();
    ErrorSceneResult scene{"s", 8, 8, {{study.axis, {}, {}, 0, {}, {}, {}}}, {}};
    for (const double n : {4, 8, 16}) {
        ErrorMethod method = named("phong", n == 8);
        method.amount = n;
        scene.axes[0].rows.push_back(row_with(method, n, 1 / n));
        scene.axes[0].rows.back().regions[1].values[metric_index("mae")] = 1 / (n * n);
    }
    finish_orders(scene.axes[0]);
    REQUIRE(verdict_of(scene).size() == 1);
    CHECK(verdict_of(scene)[0].find("what both pictures cover by 4.0 (phong).") !=
          std::string::npos);
}

TEST_CASE("the error report's files have every row, and say when they are partial", "[report]") {
    ErrorReport report{provenance({}, 1), true, {}};
    report.scenes.push_back({"a <b>", 80, 60, {measured("aliasing", matt_teapot()).result}, {}});
    report.scenes.back().verdict = verdict_of(report.scenes.back());
    report.scenes.push_back({"early", 80, 60, {}, {}});
    const TempFolder folder;
    CHECK(write_error_report(report, folder.path).empty());
    const Json json = Json::parse(text_of(folder.path / "report.json"));
    CHECK(json["report"] == "error");
    CHECK(json["partial"] == true);
    const Json& scene = json["scenes"][0];
    CHECK(scene["references"][0]["own_rmse"] > 0.0);
    REQUIRE(scene["rows"].size() == 4);
    for (const Json& row : scene["rows"]) {
        CHECK(row["axis"] == "aliasing");
        CHECK(row["parameters"].contains("samples"));
        CHECK(row["time_ms"]["runs"] == 1);
        CHECK(row["efficiency"] > 0.0);
        for (const char* region : {"all", "covered", "interior", "silhouette"})
            for (const Metric& metric : all_metrics())
                CHECK(row["errors"][region].contains(std::string(metric.name)));
        CHECK(row["errors"]["all"].contains("rmse-g"));
    }
    CHECK(scene["orders"].size() >= 4);
    const std::string page = text_of(folder.path / "index.html");
    CHECK(page.find("is partial") != std::string::npos);
    CHECK(page.find("a &lt;b&gt;") != std::string::npos);
    CHECK(page.find("Verdict") < page.find("Reference: "));
    CHECK(page.find("http") == std::string::npos);
    CHECK(std::filesystem::file_size(folder.path / "aliasing-1.svg") > 2000);
    CHECK(text_of(folder.path / "error.csv").find("errors.silhouette.flip") != std::string::npos);
}

TEST_CASE("a stopped error report keeps the rows that it has", "[report]") {
    int asked = 0;
    Watch watch;
    watch.stopped = [&] { return ++asked > 3; };
    const std::vector<ReportInput> inputs{matt_teapot(), matt_teapot()};
    Settings small = small_picture();
    small.given.insert("resolution");
    const ErrorReport report =
        measure_error(inputs, small, {0, 1, 1}, watch, [](const std::string&, const Image&) {});
    CHECK(report.partial);
    REQUIRE(report.scenes.size() == 1);
    REQUIRE(report.scenes[0].axes.size() == 1);
    const std::vector<ErrorRow>& rows = report.scenes[0].axes[0].rows;
    REQUIRE(rows.size() >= 1);
    CHECK(rows.size() < 14);
    CHECK_FALSE(rows[0].time.has_value());
    CHECK_FALSE(rows[0].on_front);
    CHECK(std::isnan(rows[0].efficiency()));
}

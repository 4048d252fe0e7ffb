// render --max-error and --budget-ms: what is said, what is written, and what is refused.
#include <nlohmann/json.hpp>

#include "cli/process.hpp"
#include "scanshade/report/choose.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

struct ChosenRun {
    Finished run;
    nlohmann::json choice, stats;
    std::string picture;
};

ChosenRun render_choosing(const TempFolder& folder, const std::string& input,
                          const std::vector<std::string>& options) {
    const std::string out = folder.path / "chosen.png", stats = folder.path / "stats.json";
    std::vector<std::string> args{"render",  input,     "-o",  out,     "--resolution",
                                  "160,120", "--stats", stats, "--isa", "auto"};
    args.insert(args.end(), options.begin(), options.end());
    ChosenRun result{run_scanshade(args), {}, {}, {}};
    INFO(result.run.err);
    REQUIRE(result.run.status == 0);
    result.stats = nlohmann::json::parse(read_file(stats));
    result.choice = result.stats["choice"];
    result.picture = read_file(out);
    return result;
}

/// The picture that render gives when it is told the method.
std::string picture_by(const TempFolder& folder, const std::string& input,
                       const std::string& method) {
    for (const Method& row : all_methods()) {
        if (row.name != method) continue;
        const std::string out = folder.path / "told.png";
        CHECK(run_scanshade({"render", input, "-o", out, "--resolution", "160,120", "--shading",
                             std::string(shading_names()[std::size_t(row.shading)]), "--renderer",
                             std::string(renderer_names()[std::size_t(row.renderer)])})
                  .status == 0);
        return read_file(out);
    }
    return {};
}

}  // namespace

TEST_CASE("--max-error says what it chose, why, and what the check took", "[cli][choose]") {
    const TempFolder folder;
    const std::string input = "models/scenes/materials.toml";
    const ChosenRun chosen = render_choosing(folder, input, {"--max-error", "1"});
    const auto& choice = chosen.choice;
    CAPTURE(choice.dump(), chosen.run.err);
    CHECK(choice["option"] == "max-error");
    CHECK(choice["limit"] == 1);
    CHECK(choice["fits"] == true);
    CHECK(choice["checked"] > 0);
    CHECK(choice["candidates"].size() >= 1);
    const std::string method = choice["method"];
    CHECK(chosen.run.err.find("--max-error 1: chose " + method) != std::string::npos);
    CHECK(chosen.run.err.find("drawing and checking ") != std::string::npos);
    CHECK(chosen.run.err.find(" covered pixels, ") != std::string::npos);
    CHECK(chosen.picture == picture_by(folder, input, method));
}

TEST_CASE("--max-error 255 takes the first method, and exact pictures the exact one",
          "[cli][choose]") {
    const TempFolder folder;
    const std::string triangle = write_triangle(folder);
    const ChosenRun any = render_choosing(folder, triangle, {"--max-error", "255"});
    CHECK(any.choice["candidates"].size() == 1);
    CHECK(any.choice["candidates"][0]["off"] == 0);
    const ChosenRun exact =
        render_choosing(folder, "models/scenes/lights.toml", {"--max-error", "0"});
    for (const auto& candidate : exact.choice["candidates"])
        if (candidate["method"] != exact.choice["method"])
            CHECK(candidate["off"] > exact.choice["allowed"]);
}

TEST_CASE("--budget-ms says what it chose, and how many frames kept it", "[cli][choose]") {
    const TempFolder folder;
    const std::string triangle = write_triangle(folder);
    const ChosenRun enough =
        render_choosing(folder, triangle, {"--budget-ms", "1e6", "--repeat", "3"});
    CHECK(enough.choice["option"] == "budget-ms");
    CHECK(enough.choice["method"] == all_methods().front().name);
    CHECK(enough.stats["frames"] == 3);
    CHECK(enough.run.err.find("kept in 3 of 3 frames") != std::string::npos);

    const ChosenRun none = render_choosing(folder, triangle, {"--budget-ms", "0.001"});
    CHECK(none.choice["fits"] == false);
    CHECK(none.run.err.find("no method takes 0.001 ms or less; chose ") != std::string::npos);
    CHECK(none.run.err.find("kept in 0 of 1 frames") != std::string::npos);
    CHECK(none.picture == picture_by(folder, triangle, none.choice["method"]));
}

TEST_CASE("methods are chosen or told, not both", "[cli][choose]") {
    const TempFolder folder;
    const std::string triangle = write_triangle(folder), out = folder.path / "out.png";
    const struct {
        std::vector<std::string> options;
        const char* words;
    } cases[] = {
        {{"--max-error", "1", "--budget-ms", "5"}, "exclude each other"},
        {{"--max-error", "1", "--shading", "flat"}, "--shading is chosen by --max-error"},
        {{"--budget-ms", "1", "--renderer", "simd"}, "--renderer is chosen by --budget-ms"},
        {{"--budget-ms", "1", "--interpolation", "edges"}, "--interpolation is chosen by"},
        {{"--max-error", "-1"}, "--max-error is a number from 0 to 255, not '-1'"},
        {{"--max-error", "nan"}, "--max-error is a number"},
        {{"--max-error", "256"}, "--max-error is a number"},
        {{"--budget-ms", "0"}, "--budget-ms is a number from 0.001 to"},
        {{"--budget-ms", "soon"}, "--budget-ms is a number"},
    };
    for (const auto& row : cases) {
        std::vector<std::string> args{"render", triangle, "-o", out};
        args.insert(args.end(), row.options.begin(), row.options.end());
        const Finished run = run_scanshade(args);
        CAPTURE(args, run.err);
        CHECK(run.status == 2);
        CHECK(run.err.find(row.words) != std::string::npos);
    }
    // Without either there is no choice in the statistics.
    const std::string stats = folder.path / "stats.json";
    run_scanshade({"render", triangle, "-o", out, "--stats", stats});
    CHECK_FALSE(nlohmann::json::parse(read_file(stats)).contains("choice"));
}

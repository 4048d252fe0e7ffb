// scanshade compare: both bounds, and the picture of the differences.
#include <set>
#include <sstream>

#include "cli/process.hpp"
#include "scanshade/image/metrics.hpp"
#include "scanshade/image/png.hpp"
#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("compare holds both bounds and writes the differences", "[cli]") {
    const TempFolder folder;
    const std::string a = folder.path / "a.png", b = folder.path / "b.png";
    const std::string picture = folder.path / "diff.png";
    Image image(4, 3);
    save_png(image, a);
    image.pixel(1, 1)[0] = 5;
    image.pixel(3, 2)[2] = 2;
    save_png(image, b);

    struct {
        std::vector<std::string> options;
        int status;
    } cases[] = {
        {{}, 1},
        {{"--max-delta", "5", "--max-count", "2"}, 0},
        {{"--max-delta", "4", "--max-count", "2"}, 1},
        {{"--max-delta", "5", "--max-count", "1"}, 1},
        {{"--max-count", "12"}, 1},
    };
    for (const auto& row : cases) {
        std::vector<std::string> args{"compare", a, b};
        args.insert(args.end(), row.options.begin(), row.options.end());
        const Finished run = run_scanshade(args);
        CAPTURE(args, run.out, run.err);
        CHECK(run.status == row.status);
        CHECK(run.out.find("5 of 255") != std::string::npos);
        CHECK(run.out.find("2 of 12") != std::string::npos);
    }
    CHECK(run_scanshade({"compare", a, a}).status == 0);

    CHECK(run_scanshade({"compare", a, b, "--diff", picture}).status == 1);
    const Image differences = load_image(picture);
    CHECK(int(differences.pixel(1, 1)[0]) == 255);
    CHECK(int(differences.pixel(0, 0)[0]) == 0);

    const Finished streamed = run_scanshade({"compare", a, b, "--diff", "-"});
    CHECK(streamed.out == read_file(picture));
}

TEST_CASE("pictures of different sizes cannot be compared", "[cli]") {
    const TempFolder folder;
    const std::string a = folder.path / "a.png", b = folder.path / "b.png";
    save_png(Image(4, 3), a);
    save_png(Image(3, 4), b);
    const Finished run = run_scanshade({"compare", a, b});
    CHECK(run.status == 4);
    CHECK(run.err.find("4 × 3") != std::string::npos);
}

namespace {

/// Two pictures: grey, and the same with a white square.
struct SquarePair {
    TempFolder folder;
    const std::string a = folder.path / "a.png", b = folder.path / "b.png";
    Image picture{40, 30}, reference{40, 30};

    SquarePair() {
        std::fill(reference.rgb.begin(), reference.rgb.end(), std::uint8_t{90});
        picture = reference;
        for (int y = 10; y < 16; ++y)
            for (int x = 20; x < 26; ++x) std::fill_n(picture.pixel(x, y), 3, std::uint8_t{255});
        save_png(picture, a);
        save_png(reference, b);
    }
};

/// The first words of lines.
std::set<std::string> first_words(const std::string& text) {
    std::set<std::string> words;
    std::istringstream lines(text);
    for (std::string line, word; std::getline(lines, line);)
        if (std::istringstream(line) >> word) words.insert(word);
    return words;
}

}  // namespace

TEST_CASE("compare lists every metric, or those that are asked for", "[cli]") {
    const SquarePair pair;
    const std::string all = run_scanshade({"compare", pair.a, pair.b}).out;
    const Comparison comparison(pair.picture, pair.reference);
    for (const Metric& metric : all_metrics()) {
        CAPTURE(std::string(metric.name), all);
        CHECK(first_words(all).count(std::string(metric.name)) == 1);
        std::ostringstream value;
        value << measure(metric, comparison);
        CHECK(all.find(value.str()) != std::string::npos);
    }
    const Finished two =
        run_scanshade({"compare", pair.a, pair.b, "--metric", "flip", "--metric", "rmse"});
    CHECK(two.status == 1);
    CHECK(first_words(two.out).count("flip") == 1);
    CHECK(first_words(two.out).count("rmse") == 1);
    CHECK(first_words(two.out).count("ssim") == 0);
}

TEST_CASE("the exit status of compare follows the bounds that are given", "[cli]") {
    const SquarePair pair;
    struct {
        std::vector<std::string> options;
        int status;
    } cases[] = {
        {{"--limit", "over1=3"}, 0},  // 36 of 1200 pixels
        {{"--limit", "over1=2.9"}, 1},
        {{"--limit", "ssim=0.1", "--limit", "flip=0.9"}, 0},
        {{"--limit", "ssim=0.999", "--limit", "flip=0.9"}, 1},
        {{"--limit", "psnr=200"}, 1},
        {{"--limit", "over1=3", "--max-delta", "165"}, 1},  // and then no pixel may differ
        {{"--limit", "over1=3", "--max-delta", "165", "--max-count", "36"}, 0},
        {{"--limit", "over1"}, 2},
        {{"--limit", "over1=few"}, 2},
        {{"--limit", "overs1=1"}, 2},
        {{"--metric", "flop"}, 2},
        {{"--diff", "d.png", "--heat", "d.png"}, 2},
    };
    for (const auto& row : cases) {
        std::vector<std::string> args{"compare", pair.a, pair.b};
        args.insert(args.end(), row.options.begin(), row.options.end());
        const Finished run = run_scanshade(args);
        CAPTURE(args, run.out, run.err);
        CHECK(run.status == row.status);
    }
    CHECK(run_scanshade({"compare", pair.a, pair.b, "--limit", "over1=2.9"})
              .err.find("over1 is 3, more than the limit of 2.9") != std::string::npos);
    // Equal pictures have an infinite ratio of signal to noise, which keeps any limit.
    CHECK(run_scanshade({"compare", pair.a, pair.a, "--limit", "psnr=200"}).status == 0);
}

TEST_CASE("a heat map shows where the error is, and a scale", "[cli]") {
    const SquarePair pair;
    const std::string heat = pair.folder.path / "heat.png";
    CHECK(run_scanshade({"compare", pair.a, pair.b, "--heat", heat, "--metric", "max"}).status ==
          1);
    const Image map = load_image(heat);
    REQUIRE(map.width >= 40);
    REQUIRE(map.height > 30);
    const auto is = [](const std::uint8_t* rgb, int grey) {
        return rgb[0] == grey && rgb[1] == grey && rgb[2] == grey;
    };
    CHECK(is(map.pixel(22, 12), 255));
    CHECK(is(map.pixel(19, 12), 0));
    CHECK(is(map.pixel(8, 40), 0));                // the scale begins
    CHECK(is(map.pixel(map.width - 9, 40), 255));  // and ends
    const Finished streamed =
        run_scanshade({"compare", pair.a, pair.b, "--heat", "-", "--metric", "max"});
    CHECK(streamed.out == read_file(heat));
    // Without --metric it is FLIP, which also sees the square from beside.
    CHECK(run_scanshade({"compare", pair.a, pair.b, "--heat", heat}).status == 1);
    CHECK_FALSE(is(load_image(heat).pixel(19, 12), 0));
}

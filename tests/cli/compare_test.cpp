// scanshade compare: both bounds, and the picture of the differences.
#include "cli/process.hpp"
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

// Signals, memory and odd files: a sentence and the right status, whatever happens.
#include <sys/resource.h>

#include <algorithm>

#include "cli/process.hpp"
#include "scanshade/image/png.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

std::size_t file_count(const TempFolder& folder) {
    return std::size_t(std::distance(std::filesystem::directory_iterator(folder.path),
                                     std::filesystem::directory_iterator()));
}

void check_sentence(const Finished& run) {
    CAPTURE(run.err);
    CHECK(run.err.starts_with("scanshade: "));
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("a signal while a picture is drawn ends in a sentence, and leaves no file", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const Finished run =
            run_scanshade_interrupted({"render", in, "-o", out, "--repeat", "100000"}, in,
                                      std::chrono::milliseconds(200), signal);
        CAPTURE(signal);
        CHECK(run.status == 128 + signal);
        check_sentence(run);
        CHECK(run.err.find("interrupted") != std::string::npos);
        CHECK(file_count(folder) == 1);
    }
}

TEST_CASE("a report that SIGTERM ends holds what was measured, and has status 143",
          "[cli][report]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "report";
    const Finished run = run_scanshade_interrupted(
        {"report", "speed", in, "-o", out, "--runs", "10000", "--resolution", "16,16"}, out,
        std::chrono::milliseconds(300), SIGTERM);
    CAPTURE(run.err);
    CHECK(run.status == 143);
    CHECK(std::filesystem::exists(out + "/index.html"));
}

TEST_CASE("too little memory is an error in a sentence, however little it is", "[cli]") {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    WARN("skipped: sanitizers map more than any machine has");
    return;
#endif
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    bool refused = false, drawn = false;
    for (std::uint64_t mib = 40; mib <= 3072; mib += mib / 12) {
        const Finished run = run_scanshade_limited(
            {"render", in, "-o", out, "--resolution", "1024,1024", "--threads", "8"}, RLIMIT_AS,
            mib << 20);
        CAPTURE(mib, run.err);
        if (run.status == 127) continue;  // not even the program itself
        CHECK((run.status == 0 || run.status == 5));
        refused |= run.status == 5;
        drawn |= run.status == 0;
        if (run.status == 5) check_sentence(run);
        CHECK(file_count(folder) == (run.status == 0 ? 2u : 1u));
        if (run.status == 0) break;
    }
    CHECK(refused);
    CHECK(drawn);
}

TEST_CASE("a disk that is full in the middle of an output is an error, and leaves what was there",
          "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder);
    const std::string out = folder.write("out.png", "before"), stats = folder.path / "s.json";
    const std::vector<std::string> args{"render", in, "-o", out, "--stats", stats};
    const Finished run = run_scanshade_limited(args, RLIMIT_FSIZE, 512);
    CHECK(run.status == 3);
    check_sentence(run);
    CHECK(read_file(out) == "before");
    CHECK(file_count(folder) == 2);
    CHECK(run_scanshade_limited(args, RLIMIT_FSIZE, 1 << 20).status == 0);
    CHECK(load_image(out).width == 960);
}

TEST_CASE("files that are not what their names say are refused in a sentence", "[cli]") {
    const TempFolder folder;
    const std::string out = folder.path / "out.png";
    std::string binary =
        "\x7f"
        "ELF";
    for (int i = 0; i < 5000; ++i) binary += char(i * 37 % 251);
    struct Case {
        std::string bytes;
        int status;
    };
    const Case cases[] = {{"", 4}, {binary, 4}, {std::string(3000, '\xff'), 4}, {"\n\n", 4}};
    for (const char* name : {"a.obj", "a.toml", "a.png"})
        for (const Case& row : cases) {
            const std::string in = folder.write(name, row.bytes);
            const bool picture = in.ends_with(".png");
            const Finished run = picture ? run_scanshade({"compare", in, in})
                                         : run_scanshade({"render", in, "-o", out});
            CAPTURE(name, row.bytes.size(), run.err);
            CHECK(run.status == row.status);
            check_sentence(run);
        }
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("long names do not make long sentences", "[cli]") {
    const TempFolder folder;
    const std::string name(100'000, 'x');
    const std::string in =
        folder.write("a.toml", "[[object]]\nshape = \"cube\"\nmaterial = \"" + name + "\"\n");
    for (const std::vector<std::string>& args : {std::vector<std::string>{"info", in},
                                                 {"info", name},
                                                 {name},
                                                 {"info", in, "--" + name}}) {
        const Finished run = run_scanshade(args);
        CHECK(run.status != 0);
        CHECK(run.err.size() < 4000);
        check_sentence(run);
    }
}

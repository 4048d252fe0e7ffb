// Exit statuses and sentences: what scripts and people rely on when something is wrong.
#include <algorithm>

#include "cli/process.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

struct Case {
    std::vector<std::string> args;
    int status;
    std::vector<std::string> words;  // each in standard error
};

void check(const Case& row) {
    const Finished run = run_scanshade(row.args);
    std::string line = "scanshade";
    for (const std::string& arg : row.args) line += " '" + arg + "'";
    CAPTURE(line, run.out, run.err);
    CHECK(run.status == row.status);
    CHECK(run.out.empty());
    CHECK(run.err.starts_with("scanshade: "));
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    for (const std::string& word : row.words) {
        CAPTURE(word);
        CHECK(run.err.find(word) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("wrong usage is one sentence that says what would be right, and status 2", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const Case cases[] = {
        {{"rendr"}, 2, {"'rendr'", "did you mean 'render'"}},
        {{"xyzzy"}, 2, {"'xyzzy'", "render", "compare", "brdf"}},
        {{"--foo"}, 2, {"'--foo'", "--help"}},
        {{in}, 2, {"render", "-o"}},
        {{"render"}, 2, {"INPUT", "missing"}},
        {{"render", in}, 2, {"-o,--output OUT.png", "missing"}},
        {{"render", "", "-o", out}, 2, {"INPUT", "empty"}},
        {{"render", in, "-o", ""}, 2, {"-o,--output", "empty"}},
        {{"render", in, "-o"}, 2, {"--output", "needs a value"}},
        {{"render", in, "-o", out, "surplus"}, 2, {"'surplus'", "too many"}},
        {{"render", in, "--outptu", out}, 2, {"'--outptu'", "did you mean '--output'"}},
        {{"render", in, "-o", out, "--shadng", "flat"}, 2, {"did you mean '--shading'"}},
        {{"render", in, "-o", out, "--shadng=flat"}, 2, {"did you mean '--shading'"}},
        {{"render", in, "-o", out, "--shading", "flt"}, 2, {"flt", "flat"}},
        {{"render", in, "-o", out, "--shading", "flt", "--help"}, 2, {"flt"}},
        {{"render", in, "-o", out, "--resolution"}, 2, {"--resolution", "needs a value"}},
        {{"render", in, "-o", out, "--resolution", "0,10"}, 2, {"resolution"}},
        {{"render", in, "-o", out, "--resolution", "99999999,10"}, 2, {"16384"}},
        {{"render", in, "-o", out, "--samples", "3"}, 2, {"samples"}},
        {{"render", in, "-o", out, "--exposure", "nan"}, 2, {"exposure"}},
        {{"render", in, "-o", out, "--exposure", "--verbose"}, 2, {"exposure"}},
        {{"render", in, "-o", out, "--mtl-ambient=7"}, 2, {"--mtl-ambient", "no value"}},
        {{"render", in, "-o", out, "--brdf", "blin-phong"}, 2, {"blin-phong", "'blinn-phong'"}},
        {{"render", in, "-o", out, "--set", "shinines=3"}, 2, {"shinines", "'shininess'"}},
        {{"render", in, "-o", out, "--light", "sun:0,0,0"}, 2, {"light", "point"}},
        {{"render", in, "-o", out, "--repeat", "0"}, 2, {"--repeat", "1 to 100000", "'0'"}},
        {{"render", in, "-o", out, "--repeat", "1e3"}, 2, {"--repeat", "'1e3'"}},
        {{"render", in, "-o", in}, 2, {"both input and output"}},
        {{"render", in, "-o", out, "--stats", out}, 2, {"--output", "--stats"}},
        {{"render", in, "-o", "-", "--stats", "-"}, 2, {"--output", "--stats"}},
        {{"render", in, "-o", folder.path / "out.jpg"}, 2, {".png"}},
        {{"render", "--", in, "-o", out}, 2, {"'-o'"}},
        {{"sheet", in, "-o", out, "--resolution", "16000,10"}, 2, {"--resolution", "16384"}},
        {{"compare", in}, 2, {"B", "missing"}},
        {{"compare", in, in, "--max-delta", "256"}, 2, {"--max-delta", "0 to 255"}},
        {{"compare", in, in, "--diff", in}, 2, {"both input and output"}},
        {{"brdf"}, 2, {"ACTION", "missing"}},
        {{"brdf", "shw", "phong"}, 2, {"'brdf shw'", "'show'"}},
        {{"brdf", "show"}, 2, {"needs a name", "brdf list"}},
        {{"brdf", "show", "phng"}, 2, {"'phng'", "did you mean 'phong'"}},
        {{"brdf", "list", "phong"}, 2, {"brdf show phong"}},
        {{"brdf", "show", "phong", "--set", "kk=1"}, 2, {"no parameter 'kk'"}},
        {{"brdf", "show", "phong", "-o", in + "/page"}, 3, {"folder cannot be made"}},
        {{"report"}, 2, {"KIND", "missing"}},
        {{"report", "plan"}, 2, {"-o,--output DIR", "missing"}},
        {{"report", "pln", "-o", out}, 2, {"'report pln'", "did you mean 'plan'"}},
        {{"report", "plan", in, "-o", out, "--runs", "0"}, 2, {"--runs", "1 to 10000"}},
        {{"view"}, 2, {"INPUT", "missing"}},
        {{"view", in, "--shading", "flt"}, 2, {"flt", "flat"}},
    };
    for (const Case& row : cases) check(row);
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("files that cannot be read or written give status 3", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const std::string nowhere = folder.path / "nowhere" / "out.png";
    const Case cases[] = {
        {{"render", folder.path / "no.obj", "-o", out}, 3, {"no.obj"}},
        {{"render", folder.path / "no.toml", "-o", out}, 3, {"no.toml"}},
        {{"render", folder.path, "-o", out}, 3, {}},
        {{"render", in, "-o", nowhere}, 3, {nowhere, "does not exist"}},
        {{"render", in, "-o", folder.path}, 3, {"folder"}},
        {{"render", in, "-o", out, "--stats", nowhere}, 3, {nowhere, "does not exist"}},
        {{"sheet", in, "-o", nowhere}, 3, {nowhere, "does not exist"}},
        {{"info", folder.path / "no.obj"}, 3, {"no.obj"}},
        {{"explain", folder.path / "no.obj"}, 3, {"no.obj"}},
        {{"compare", folder.path / "no.png", in}, 3, {"no.png"}},
        {{"report", "plan", in, "-o", in}, 3, {in, "folder"}},
        {{"report", "speed", in, "-o", in + "/below"}, 3, {in, "folder"}},
        {{"report", "plan", in, "-o", "/proc/nowhere"}, 3, {"/proc/nowhere", "folder"}},
    };
    for (const Case& row : cases) {
        check(row);
        CHECK_FALSE(std::filesystem::exists(out));
    }
    // The output is looked at before the input: a long drawing must not end in a wrong name.
    check({{"render", folder.path / "no.obj", "-o", nowhere}, 3, {nowhere}});
}

TEST_CASE("damaged files give status 4 and scenes that cannot be drawn status 5", "[cli]") {
    const TempFolder folder;
    const std::string out = folder.path / "out.png";
    const auto file = [&](const char* name, const char* text) {
        return folder.write(name, text).string();
    };
    const std::string bad_index = file("index.obj", "v 0 0 0\nf 1 2 9\n");
    const std::string no_face = file("points.obj", "v 0 0 0\n");
    const std::string bad_toml = file("bad.toml", "[camera\n");
    const std::string no_brdf =
        file("brdf.toml",
             "[[material]]\nname = \"m\"\nbrdf = \"phng\"\n[[object]]\nshape = "
             "\"cube\"\nmaterial = \"m\"\n");
    const std::string no_view =
        file("view.toml",
             "[camera]\nposition = [1, 1, 1]\nfocal_point = [1, 1, 1]\n[[object]]\nshape = "
             "\"cube\"\n");
    const Case cases[] = {
        {{"render", bad_index, "-o", out}, 4, {"index.obj:2:"}},
        {{"render", no_face, "-o", out}, 4, {"points.obj"}},
        {{"info", no_face}, 4, {"points.obj"}},
        {{"render", bad_toml, "-o", out}, 4, {"bad.toml"}},
        {{"compare", bad_index, bad_index}, 4, {"index.obj", "PNG"}},
        {{"render", no_brdf, "-o", out}, 5, {"brdf.toml", "phng", "'phong'"}},
        {{"explain", no_brdf}, 5, {"brdf.toml", "phng"}},
        {{"render", no_view, "-o", out}, 5, {}},
    };
    for (const Case& row : cases) {
        check(row);
        CHECK_FALSE(std::filesystem::exists(out));
    }
}

TEST_CASE("control characters in names do not reach the terminal", "[cli]") {
    const Finished run = run_scanshade({"rend\x1b[31mer"});
    CHECK(run.status == 2);
    CHECK(run.err.find('\x1b') == std::string::npos);
}

TEST_CASE("a full disk behind standard output is an error", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder);
    const std::vector<std::string> commands[] = {
        {"brdf", "list"}, {"info", in}, {"--help"}, {"render", in, "-o", "-"}};
    for (const std::vector<std::string>& args : commands) {
        const Finished run = run_scanshade(args, "/dev/full");
        CAPTURE(args, run.err);
        CHECK(run.status == 3);
        CHECK(run.err.find("standard output") != std::string::npos);
    }
}

TEST_CASE("a reader that goes away is an error, not a silent death", "[cli]") {
    const TempFolder folder;
    const std::vector<std::string> commands[] = {{"brdf", "list"},
                                                 {"render", write_triangle(folder), "-o", "-"}};
    for (const std::vector<std::string>& args : commands) {
        const Finished run = run_scanshade_unread(args);
        CAPTURE(args, run.err);
        CHECK(run.status == 3);
        CHECK(run.err.find("standard output") != std::string::npos);
    }
}

// Help: complete, because it is made from the tables.
#include <sstream>

#include "cli/process.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/scene/settings.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// The commands that the program's own help lists.
std::vector<std::string> commands() {
    std::vector<std::string> names;
    std::istringstream help(run_scanshade({"--help"}).out);
    for (std::string line; std::getline(help, line);) {
        std::istringstream words(line);
        std::string program, name;
        if (words >> program >> name && program == "scanshade" && line.starts_with("  "))
            names.push_back(name);
    }
    return names;
}

}  // namespace

TEST_CASE("every command prints its help to standard output", "[cli]") {
    REQUIRE(commands().size() >= 7);
    for (const std::string& command : commands())
        for (const char* flag : {"--help", "-h"}) {
            const Finished run = run_scanshade({command, flag});
            CAPTURE(command, run.out);
            CHECK(run.status == 0);
            CHECK(run.err.empty());
            CHECK(run.out.find("Usage: scanshade " + command + " ") != std::string::npos);
        }
}

TEST_CASE("commands that draw list every shared option with its meaning", "[cli]") {
    for (const char* command : {"render", "view", "info", "explain", "sheet", "report"}) {
        const std::string help = run_scanshade({command, "--help"}).out;
        CAPTURE(command, help);
        for (const OptionInfo& option : shared_options()) {
            CAPTURE(option.name);
            const std::string row = "  --" + std::string(option.name) + " ";
            CHECK(help.find(row) != std::string::npos);
            CHECK(help.find(std::string(option.values)) != std::string::npos);
            const std::string first_word(option.meaning.substr(0, option.meaning.find(' ')));
            CHECK(help.find(first_word) != std::string::npos);
        }
    }
}

TEST_CASE("scanshade alone prints the same help as --help, with all exit statuses", "[cli]") {
    const Finished alone = run_scanshade({}), asked = run_scanshade({"--help"});
    CHECK(alone.status == 0);
    CHECK(alone.out == asked.out);
    for (const char* words :
         {"0  done", "1  pictures differ", "2  usage", "3  file", "4  format", "5  scene"})
        CHECK(asked.out.find(words) != std::string::npos);
}

TEST_CASE("--version names program and version", "[cli]") {
    const Finished run = run_scanshade({"--version"});
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("scanshade "));
    CHECK(run.out.find('.') != std::string::npos);
}

TEST_CASE("brdf list and show print what the registry holds", "[cli]") {
    const std::string list = run_scanshade({"brdf", "list"}).out;
    for (const BrdfInfo* brdf : all_brdfs()) {
        CHECK(list.find(std::string(brdf->title)) != std::string::npos);
        const Finished run = run_scanshade({"brdf", "show", std::string(brdf->name)});
        CAPTURE(brdf->name, run.out);
        CHECK(run.status == 0);
        CHECK(run.out.find(std::string(brdf->equation)) != std::string::npos);
        CHECK(run.out.find("albedo") != std::string::npos);
        CHECK(run.out.find(std::string(brdf->source)) != std::string::npos);
        for (const ParamInfo& param : brdf->params) {
            CHECK(run.out.find("  " + std::string(param.name) + " ") != std::string::npos);
            CHECK(run.out.find(std::string(param.meaning)) != std::string::npos);
        }
    }
}

TEST_CASE("brdf show -o makes the folder and writes a page of what was set", "[cli]") {
    const TempFolder folder;
    const std::string page = folder.path / "new" / "page";
    const Finished run = run_scanshade({"brdf", "show", "torrance-sparrow", "-o", page, "--set",
                                        "distribution=beckmann", "--set", "shininess=98"});
    CAPTURE(run.err);
    CHECK(run.status == 0);
    CHECK(run.err.find("shininess 98 became m 0.141421") != std::string::npos);
    const std::string html = read_file(page + "/index.html");
    CHECK(html.find("<td>beckmann</td>") != std::string::npos);
    CHECK(html.find("<td>0.141421</td>") != std::string::npos);
}

// Command lines: an argument a line.
#include <optional>
#include <vector>

#include "cli/options.hpp"
#include "fuzz/fuzz.hpp"

using namespace scanshade;

namespace {

/// What an option shows of itself, it also takes.
void check_shown(const Settings& settings) {
    for (const OptionInfo& option : shared_options()) {
        if (option.show == nullptr) continue;
        const std::string shown = option.show(settings);
        if (shown.empty()) continue;  // no model is named
        Settings again;
        option.apply(again, shown);
        if (option.show(again) != shown) broken("--" + std::string(option.name) + " " + shown);
    }
}

void parse(const std::vector<std::string>& args) {
    std::vector<const char*> pointers;
    for (const std::string& arg : args) pointers.push_back(arg.c_str());
    pointers.push_back(nullptr);
    std::string input, output;
    std::vector<std::string> limits;
    long long repeat = 1;
    std::optional<double> error;
    bool verbose = false;
    Settings settings;
    OptionParser options("scanshade fuzz", "INPUT [options]", "parses");
    options.positional("INPUT", input, "a file");
    options.required_text("-o,--output", "OUT", output, "a file");
    options.texts("--limit", "NAME=X", limits, "limits");
    options.integer("--repeat", 1, 1000, repeat, "frames");
    options.real("--max-error", "L", 0, 255, error, "levels");
    options.flag("--verbose", verbose, "more");
    options.shared(settings);
    if (!options.parse(pointers.data())) return;
    if (input.empty() || output.empty() || repeat < 1 || repeat > 1000 || settings.width < 1 ||
        settings.width > max_image_side || settings.samples > 1024)
        broken("what is parsed is in range");
    check_shown(settings);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> args(1);
    for (const char c : text_of(data, size))
        if (c == '\n')
            args.emplace_back();
        else if (c != '\0')
            args.back() += c;
    try {
        parse(args);
    } catch (const Error& error) {
        check_sentence(error);
    }
    return 0;
}

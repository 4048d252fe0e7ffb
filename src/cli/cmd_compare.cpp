// scanshade compare: how much two pictures differ, in every metric.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/heat_map.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/image/image.hpp"
#include "scanshade/image/metrics.hpp"
#include "scanshade/image/png.hpp"

namespace scanshade {
namespace {

struct CompareArgs {
    std::string first, second, diff, heat;
    std::vector<std::string> metrics, limits;
    long long max_delta = -1, max_count = -1;  // −1: not given
};

/// The worst value that a metric may have.
struct Limit {
    const Metric* metric;
    double worst;
};

bool parse_args(OptionParser& options, char** args, CompareArgs& into) {
    options.positional("A", into.first, "a picture");
    options.positional("B", into.second, "its reference, of the same size");
    options.integer("--max-delta", 0, 255, into.max_delta, "allowed difference of a byte");
    options.integer("--max-count", 0, 1LL << 40, into.max_count,
                    "allowed number of pixels that differ at all");
    options.texts("--limit", "NAME=VALUE", into.limits,
                  "worst allowed value of a metric, as in flip=0.02 or ssim=0.99; repeatable. The "
                  "exit status is 1 where a bound is not kept; without any bound, where a byte "
                  "differs. Of --max-delta and --max-count the one not given is 0");
    options.texts("--metric", "NAME", into.metrics,
                  "show this metric, repeatable; otherwise all of them");
    options.text("--diff", "OUT.png", into.diff,
                 "write the differences, stretched so that the largest is white");
    options.text("--heat", "OUT.png", into.heat,
                 "write the errors of the first --metric (otherwise flip) in false colours with a "
                 "scale");
    return options.parse(args);
}

void check_outputs(const CompareArgs& args) {
    for (const std::string* picture : {&args.diff, &args.heat}) {
        if (picture->empty()) continue;
        check_picture_output(*picture, args.first);
        check_picture_output(*picture, args.second);
    }
    if (!args.diff.empty() && args.diff == args.heat)
        throw Error(Errc::usage, "--diff and --heat are the same; give each a name of its own");
}

std::vector<const Metric*> chosen_metrics(const std::vector<std::string>& names) {
    std::vector<const Metric*> metrics;
    for (const std::string& name : names) metrics.push_back(&find_metric(name));
    if (metrics.empty())
        for (const Metric& metric : all_metrics()) metrics.push_back(&metric);
    return metrics;
}

Limit parse_limit(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::optional<double> worst =
        equals == std::string::npos ? std::nullopt : parse_real(text.substr(equals + 1));
    if (!worst)
        throw Error(Errc::usage,
                    fmt::format("--limit is NAME=VALUE as in flip=0.02, not '{}'", text));
    return {&find_metric(text.substr(0, equals)), *worst};
}

std::string metrics_table(const std::vector<const Metric*>& metrics, const Comparison& pair) {
    std::vector<std::vector<std::string>> rows{
        {"metric", "all", "red", "green", "blue", "unit", "meaning"}};
    for (const Metric* metric : metrics) {
        std::vector<std::string> row{std::string(metric->name),
                                     fmt::format("{:.6g}", measure(*metric, pair))};
        for (std::size_t c = 0; c < 3; ++c)
            row.push_back(metric->per_channel
                              ? fmt::format("{:.6g}", measure(*metric, pair, {c, c + 1}))
                              : "-");
        row.emplace_back(metric->unit);
        row.push_back(fmt::format("{} of {} values", metric->title, metric->picture));
        rows.push_back(std::move(row));
    }
    return table(rows);
}

/// Says which limits are not kept.
bool keeps_limits(const std::vector<Limit>& limits, const Comparison& pair) {
    bool kept = true;
    for (const Limit& limit : limits) {
        const double value = measure(*limit.metric, pair);
        if (value == limit.worst || is_better(*limit.metric, value, limit.worst)) continue;
        kept = false;
        note(fmt::format("{} is {:.6g}, {} than the limit of {:g}", limit.metric->name, value,
                         limit.metric->better == Better::lower ? "more" : "less", limit.worst));
    }
    return kept;
}

/// Bounds on bytes hold where one is given, or no limit of another kind.
bool keeps_byte_bounds(const CompareArgs& args, const ImageDiff& d) {
    if (args.max_delta < 0 && args.max_count < 0 && !args.limits.empty()) return true;
    return d.max_delta <= std::max(args.max_delta, 0LL) &&
           d.count <= std::uint64_t(std::max(args.max_count, 0LL));
}

}  // namespace

int run_compare(OptionParser& options, char** raw_args) {
    CompareArgs args;
    if (!parse_args(options, raw_args, args)) return exit_done;
    check_outputs(args);
    const std::vector<const Metric*> metrics = chosen_metrics(args.metrics);
    std::vector<Limit> limits;
    for (const std::string& text : args.limits) limits.push_back(parse_limit(text));

    const Image a = load_image(args.first), b = load_image(args.second);
    const ImageDiff d = diff(a, b);
    const Comparison pair(a, b);
    if (args.diff != "-" && args.heat != "-") {
        const std::uint64_t pixels = std::uint64_t(a.width) * std::uint64_t(a.height);
        print(table({{"largest difference", fmt::format("{} of 255", d.max_delta)},
                     {"differing pixels", fmt::format("{} of {}", d.count, pixels)}}));
        print("\n" + metrics_table(metrics, pair));
    }
    if (!args.diff.empty()) save_png(d.picture, args.diff);
    if (!args.heat.empty()) {
        const Metric& shown = args.metrics.empty() ? find_metric("flip") : *metrics.front();
        save_png(heat_map(shown, pair), args.heat);
    }
    const bool kept = keeps_limits(limits, pair);
    return kept && keeps_byte_bounds(args, d) ? exit_done : exit_different;
}

}  // namespace scanshade

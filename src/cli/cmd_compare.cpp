// scanshade compare: how much two pictures differ.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "scanshade/image/image.hpp"
#include "scanshade/image/png.hpp"

namespace scanshade {

int run_compare(OptionParser& options, char** args) {
    std::string first, second, picture;
    long long max_delta = 0, max_count = 0;
    options.positional("A", first, "a picture");
    options.positional("B", second, "another of the same size");
    options.integer("--max-delta", 0, 255, max_delta, "allowed difference of a byte, default 0");
    options.integer("--max-count", 0, 1LL << 40, max_count,
                    "allowed number of pixels that differ at all, default 0; the exit status is 1 "
                    "where either bound is exceeded");
    options.text("--diff", "OUT.png", picture,
                 "write the differences, stretched so that the largest is white");
    if (!options.parse(args)) return exit_done;
    if (!picture.empty()) {
        check_picture_output(picture, first);
        check_picture_output(picture, second);
    }

    const Image a = load_image(first), b = load_image(second);
    const ImageDiff d = diff(a, b);
    const std::uint64_t pixels = std::uint64_t(a.width) * std::uint64_t(a.height);
    if (picture != "-")
        print(table({{"largest difference", fmt::format("{} of 255", d.max_delta)},
                     {"differing pixels", fmt::format("{} of {}", d.count, pixels)}}));
    if (!picture.empty()) save_png(d.picture, picture);
    const bool same = d.max_delta <= max_delta && d.count <= std::uint64_t(max_count);
    return same ? exit_done : exit_different;
}

}  // namespace scanshade

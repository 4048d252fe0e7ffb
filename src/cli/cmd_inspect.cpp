// scanshade inspect: the equation at one pixel with its numbers.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/report/inspection.hpp"

namespace scanshade {
namespace {

struct PixelArg {
    int x, y;
};

PixelArg parse_pixel(std::string_view text) {
    const auto parts = split(text, ',');
    int at[2] = {-1, -1};
    for (std::size_t i = 0; i < 2 && parts.size() == 2; ++i) {
        const auto n = parse_integer(parts[i]);
        if (n && *n >= 0 && *n < max_image_side) at[i] = static_cast<int>(*n);
    }
    if (at[0] < 0 || at[1] < 0)
        throw Error(
            Errc::usage,
            fmt::format("--pixel takes x,y from the upper left corner, such as 480,360, not "
                        "'{}'",
                        text));
    return {at[0], at[1]};
}

std::vector<std::string> table_row(const InspectionRow& row) {
    std::vector<std::string> cells{"    " + row.symbol, f32_text(row), f64_text(row)};
    if (!row.meaning.empty()) cells.push_back(row.meaning);
    return cells;
}

std::string as_text(const Inspection& inspection) {
    std::vector<std::vector<std::string>> rows{{"", "in float", "in double"}};
    for (const InspectionSection& section : inspection_sections(inspection))
        for (const InspectionRow& row : section.rows) rows.push_back(table_row(row));
    // One table, so that columns stand below each other; titles go between its lines.
    const std::string lines = table(rows);
    const auto line = split(lines, '\n');
    std::string out = fmt::format("pixel {}, {} of {} × {}\n{}\n", inspection.x, inspection.y,
                                  inspection.width, inspection.height, line[0]);
    std::size_t next = 1;
    for (const InspectionSection& section : inspection_sections(inspection)) {
        out += section.title + '\n';
        for (std::size_t i = 0; i < section.rows.size(); ++i)
            out += std::string(line[next++]) + '\n';
    }
    return out;
}

/// The bytes that the settings' own renderer puts into the picture.
std::string drawn_bytes(const Scene& scene, const Settings& settings, const Inspection& at) {
    PixelBuffer pixels;
    Renderer(scene, settings).draw(pixels);
    const Image image = to_image(pixels);
    const std::uint8_t* byte = image.pixel(at.x, at.y);
    return fmt::format("In the picture of renderer {} it is {} {} {}.\n",
                       renderer_names()[std::size_t(settings.renderer)], byte[0], byte[1], byte[2]);
}

}  // namespace

int run_inspect(OptionParser& options, char** args) {
    std::string input, pixel;
    bool json = false;
    Settings settings;
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.required_text("--pixel", "X,Y", pixel,
                          "which one; 0,0 is the upper left corner of the picture");
    options.flag("--json", json, "for programs, with all digits");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;

    const PixelArg at = parse_pixel(pixel);
    const Scene scene = load_scene(input, settings);
    const Inspection inspection = inspect_pixel(scene, settings, at.x, at.y);
    warn(scene.warnings);
    print(json ? inspection_json(inspection)
               : as_text(inspection) + drawn_bytes(scene, settings, inspection));
    return exit_done;
}

}  // namespace scanshade

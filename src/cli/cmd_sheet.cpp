// scanshade sheet: every shading with every reflection model in one labelled picture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/lettering.hpp"
#include "cli/progress.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade {
namespace {

constexpr Rgb8 paper{24, 26, 30}, ink{225, 228, 232};
constexpr int gap = 8;  // pixels between cells and around letters
const std::string row_title = "shading";
constexpr int default_cell_width = 320;

/// Where everything stands, in pixels.
struct Layout {
    int cell_width, cell_height;
    int left, top;  // of the first cell
    int width, height;

    int x(std::size_t column) const { return left + int(column) * (cell_width + gap); }
    int y(std::size_t row) const { return top + int(row) * (cell_height + gap); }
};

Layout make_layout(const Settings& settings, const std::vector<std::string>& rows,
                   const std::vector<std::string>& columns) {
    int row_label = lettering_width(row_title);
    for (const std::string& name : rows) row_label = std::max(row_label, lettering_width(name));
    Layout layout{
        settings.width, settings.height, row_label + 2 * gap, letter_height + 2 * gap, 0, 0};
    layout.width = layout.x(columns.size());
    layout.height = layout.y(rows.size());
    if (layout.width > max_image_side || layout.height > max_image_side)
        throw Error(Errc::usage,
                    fmt::format("a sheet of {} × {} cells of {} × {} pixels is larger than {} "
                                "pixels on a side; a smaller --resolution fits",
                                columns.size(), rows.size(), settings.width, settings.height,
                                max_image_side));
    return layout;
}

void paste(Image& sheet, const Image& cell, int x, int y) {
    for (int row = 0; row < cell.height; ++row)
        std::copy_n(cell.pixel(0, row), 3 * cell.width, sheet.pixel(x, y + row));
}

/// Column labels are cut at the cell's edge rather than drawn over the next.
std::string shortened(std::string name, int width) {
    while (!name.empty() && lettering_width(name) > width) name.pop_back();
    return name;
}

Image blank_sheet(const Layout& layout, const std::vector<std::string>& rows,
                  const std::vector<std::string>& columns) {
    Image sheet(layout.width, layout.height);
    fill_rectangle(sheet, 0, 0, sheet.width, sheet.height, paper);
    for (std::size_t c = 0; c < columns.size(); ++c)
        draw_lettering(sheet, layout.x(c), gap, shortened("brdf " + columns[c], layout.cell_width),
                       ink);
    // "phong" stands on both axes, so each axis says what it is.
    draw_lettering(sheet, gap, gap, row_title, ink);
    for (std::size_t r = 0; r < rows.size(); ++r)
        draw_lettering(sheet, gap, layout.y(r) + (layout.cell_height - letter_height) / 2, rows[r],
                       ink);
    return sheet;
}

/// A sheet of full pictures would be huge: without --resolution the cells are small, in the
/// proportions of the scene's picture.
void shrink_cells(Settings& settings) {
    if (settings.is_given("resolution")) return;
    const double aspect = double(settings.height) / double(settings.width);
    settings.width = default_cell_width;
    settings.height =
        std::clamp(int(std::lround(default_cell_width * aspect)), 1, 4 * default_cell_width);
}

}  // namespace

int run_sheet(OptionParser& options, char** args) {
    std::string input, output;
    Settings settings;
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.required_text("-o,--output", "OUT.png", output, "the picture; '-' is standard output");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;
    check_picture_output(output, input);

    Progress progress("loading " + input);
    const Scene scene = load_scene(input, settings);
    shrink_cells(settings);
    const std::vector<std::string> rows(shading_names().begin(), shading_names().end());
    std::vector<std::string> columns;
    for (const BrdfInfo* brdf : all_brdfs()) columns.emplace_back(brdf->name);
    columns.emplace_back("unlit");
    const Layout layout = make_layout(settings, rows, columns);
    Image sheet = blank_sheet(layout, rows, columns);

    settings.given.insert({"shading", "brdf"});  // stronger than what objects say
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            progress.text(fmt::format("drawing {}, cell {} of {}", input,
                                      r * columns.size() + c + 1, rows.size() * columns.size()));
            settings.shading = Shading(r);
            settings.brdf = columns[c];
            paste(sheet, render_image(scene, settings), layout.x(c), layout.y(r));
        }
    }
    save_png(sheet, output);
    progress.finish();
    warn(scene.warnings);
    note(fmt::format("wrote {}, {} × {}, {} cells", output == "-" ? "standard output" : output,
                     sheet.width, sheet.height, rows.size() * columns.size()));
    return exit_done;
}

}  // namespace scanshade

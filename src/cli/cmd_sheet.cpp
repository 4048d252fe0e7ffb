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

/// A label broken after spaces and hyphens, so that lines are no wider than `width` where that can
/// be.
std::vector<std::string> wrapped(const std::string& label, int width) {
    std::vector<std::string> lines(1);
    for (std::size_t begin = 0, end; begin < label.size(); begin = end) {
        end = std::min(label.find_first_of(" -", begin), label.size() - 1) + 1;
        const std::string piece = label.substr(begin, end - begin);
        if (!lines.back().empty() && lettering_width(lines.back() + piece) > width)
            lines.emplace_back();
        lines.back() += piece;
    }
    return lines;
}

int widest(const std::vector<std::string>& lines) {
    int width = 0;
    for (const std::string& line : lines) width = std::max(width, lettering_width(line));
    return width;
}

/// Where everything stands, in pixels.
struct Layout {
    int cell_height;
    int column_width;  // of a cell, or of a label that is wider
    int left, top;     // of the first cell
    int width, height;

    int x(std::size_t column) const { return left + int(column) * (column_width + gap); }
    int y(std::size_t row) const { return top + int(row) * (cell_height + gap); }
};

/// What stands beside the rows and, in lines, above the columns.
struct Labels {
    std::vector<std::string> rows;
    std::vector<std::vector<std::string>> columns;
};

Labels make_labels(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                   int cell_width) {
    Labels labels{rows, {}};
    for (const std::string& name : columns)
        labels.columns.push_back(wrapped("brdf " + name, cell_width));
    return labels;
}

Layout make_layout(const Settings& settings, const Labels& labels) {
    Layout layout{};
    std::size_t lines = 1;
    layout.column_width = settings.width;
    for (const std::vector<std::string>& label : labels.columns) {
        lines = std::max(lines, label.size());
        layout.column_width = std::max(layout.column_width, widest(label));
    }
    layout.cell_height = std::max(settings.height, letter_height);
    layout.left = std::max(lettering_width(row_title), widest(labels.rows)) + 2 * gap;
    layout.top = int(lines) * letter_height + 2 * gap;
    layout.width = layout.x(labels.columns.size());
    layout.height = layout.y(labels.rows.size());
    if (layout.width > max_image_side || layout.height > max_image_side)
        throw Error(Errc::usage,
                    fmt::format("a sheet of {} × {} cells of {} × {} pixels is larger than {} "
                                "pixels on a side; a smaller --resolution fits",
                                labels.columns.size(), labels.rows.size(), settings.width,
                                settings.height, max_image_side));
    return layout;
}

void paste(Image& sheet, const Image& cell, int x, int y) {
    for (int row = 0; row < cell.height; ++row)
        std::copy_n(cell.pixel(0, row), 3 * cell.width, sheet.pixel(x, y + row));
}

Image blank_sheet(const Layout& layout, const Labels& labels) {
    Image sheet(layout.width, layout.height);
    fill_rectangle(sheet, 0, 0, sheet.width, sheet.height, paper);
    for (std::size_t c = 0; c < labels.columns.size(); ++c) {
        int y = gap;
        for (const std::string& line : labels.columns[c]) {
            draw_lettering(sheet, layout.x(c), y, line, ink);
            y += letter_height;
        }
    }
    // "phong" stands on both axes, so each axis says what it is.
    draw_lettering(sheet, gap, gap, row_title, ink);
    for (std::size_t r = 0; r < labels.rows.size(); ++r)
        draw_lettering(sheet, gap, layout.y(r) + (layout.cell_height - letter_height) / 2,
                       labels.rows[r], ink);
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
    const Labels labels = make_labels(rows, columns, settings.width);
    const Layout layout = make_layout(settings, labels);
    Image sheet = blank_sheet(layout, labels);

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

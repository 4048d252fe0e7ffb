#include "cli/lettering.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace scanshade {
namespace {

/// What the font has a glyph for; it reads outside its table otherwise.
std::string ascii(std::string line) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return line;
}

/// A corner as the font writes it.
struct Corner {
    float x, y, z;
    std::uint8_t colour[4];
};
static_assert(sizeof(Corner) == 16);

}  // namespace

int lettering_width(const std::string& line) {
    return letter_scale * stb_easy_font_width(ascii(line).data());
}

void fill_rectangle(Image& image, int x, int y, int width, int height, Rgb8 colour) {
    const int x_end = std::min(x + width, image.width), y_end = std::min(y + height, image.height);
    for (int row = std::max(y, 0); row < y_end; ++row)
        for (int column = std::max(x, 0); column < x_end; ++column)
            std::copy(colour.begin(), colour.end(), image.pixel(column, row));
}

void draw_lettering(Image& image, int x, int y, const std::string& line, Rgb8 colour) {
    // A letter has a dozen strokes at most; each is a rectangle of four corners.
    std::vector<Corner> corners(line.size() * 16 * 4 + 4);
    const int quads = stb_easy_font_print(0, 0, ascii(line).data(), nullptr, corners.data(),
                                          int(corners.size() * sizeof(Corner)));
    for (int q = 0; q < quads; ++q) {
        const Corner& from = corners[std::size_t(4 * q)];
        const Corner& to = corners[std::size_t(4 * q + 2)];
        fill_rectangle(image, x + letter_scale * int(from.x), y + letter_scale * int(from.y),
                       letter_scale * int(to.x - from.x), letter_scale * int(to.y - from.y),
                       colour);
    }
}

}  // namespace scanshade

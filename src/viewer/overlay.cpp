#include "viewer/overlay.hpp"

#include <algorithm>

#include "cli/lettering.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade::viewer {
namespace {

constexpr int margin = 12;  // pixels around the text
constexpr int line_height = 3 * letter_height / 2;
constexpr Rgb8 paper = {0, 0, 0};
constexpr Rgb8 ink = {255, 255, 255};

}  // namespace

std::vector<std::string> wrapped(const std::string& text, int width) {
    std::vector<std::string> lines;
    for (const std::string_view line : split(text, '\n')) {
        lines.emplace_back();
        for (const std::string_view word : split(line, ' ')) {
            const std::string longer = lines.back() + (lines.back().empty() ? "" : " ");
            if (lines.back().empty() || lettering_width(longer + std::string(word)) <= width)
                lines.back() = longer + std::string(word);
            else
                lines.emplace_back(word);
        }
    }
    return lines;
}

void draw_overlay(Image& picture, const std::string& text) {
    const std::vector<std::string> lines = wrapped(text, picture.width - 2 * margin);
    int width = 0;
    for (const std::string& line : lines) width = std::max(width, lettering_width(line));
    const int height = static_cast<int>(lines.size()) * line_height;
    fill_rectangle(picture, 0, 0, width + 2 * margin, height + 2 * margin, paper);

    int y = margin;
    for (const std::string& line : lines) {
        draw_lettering(picture, margin, y, line, ink);
        y += line_height;
    }
}

}  // namespace scanshade::viewer

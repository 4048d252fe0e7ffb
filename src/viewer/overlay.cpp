#include "viewer/overlay.hpp"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace scanshade::viewer {
namespace {

constexpr float scale = 2;   // pixels for one of the font's
constexpr float margin = 8;  // font pixels around the text
constexpr int corners_per_quad = 4;
constexpr std::size_t max_characters = 2000;
constexpr std::size_t bytes_per_character = 1024;  // no glyph needs more of the vertex buffer

/// The layout of what stb_easy_font writes.
struct FontVertex {
    float x, y, z;
    unsigned char colour[4];
};

int text_width(std::string line) { return stb_easy_font_width(line.data()); }

/// The font knows the printable ASCII characters and reads beyond its table for others.
std::string printable(std::string_view text) {
    std::string result(text);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c != '\n' && (c < ' ' || c > '~'); },
        '?');
    return result;
}

/// Replaces spaces by line ends where a line would be wider than `width` font pixels.
std::string wrapped(std::string text, int width) {
    std::size_t line = 0;
    std::size_t space = std::string::npos;  // the last one that could end this line
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const bool end = i == text.size() || text[i] == '\n';
        if (!end && text[i] != ' ') continue;
        if (space != std::string::npos && text_width(text.substr(line, i - line)) > width) {
            text[space] = '\n';
            line = space + 1;
        }
        space = i;
        if (end) {
            line = i + 1;
            space = std::string::npos;
        }
    }
    return text;
}

void draw_quads(SDL_Renderer* renderer, const std::vector<FontVertex>& corners, int quads) {
    std::vector<SDL_Vertex> vertices;
    std::vector<int> indices;
    for (int quad = 0; quad < quads; ++quad) {
        const int first = corners_per_quad * quad;
        for (int corner = 0; corner < corners_per_quad; ++corner) {
            const FontVertex& v = corners[static_cast<std::size_t>(first + corner)];
            vertices.push_back({{scale * v.x, scale * v.y}, {255, 255, 255, 255}, {0, 0}});
        }
        for (const int corner : {0, 1, 2, 0, 2, 3}) indices.push_back(first + corner);
    }
    SDL_RenderGeometry(renderer, nullptr, vertices.data(), static_cast<int>(vertices.size()),
                       indices.data(), static_cast<int>(indices.size()));
}

}  // namespace

void draw_overlay(SDL_Renderer* renderer, std::string_view text, int width) {
    const int columns = static_cast<int>(float(width) / scale - 2 * margin);
    std::string lines = wrapped(printable(text.substr(0, max_characters)), columns);
    std::vector<FontVertex> corners(lines.size() * bytes_per_character / sizeof(FontVertex));
    const int quads = stb_easy_font_print(margin, margin, lines.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(FontVertex)));

    const SDL_FRect box{0, 0, scale * (float(text_width(lines)) + 2 * margin),
                        scale * (float(stb_easy_font_height(lines.data())) + 2 * margin)};
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    SDL_SetRenderDrawColor(renderer, 0, 0, 0, 200);
    SDL_RenderFillRectF(renderer, &box);
    draw_quads(renderer, corners, quads);
}

}  // namespace scanshade::viewer

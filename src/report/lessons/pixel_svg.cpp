#include "report/lessons/pixel_svg.hpp"

#include <fmt/format.h>

namespace scanshade {
namespace {

constexpr int side = 20;  // of a pixel, in units of the SVG

}  // namespace

std::string pixel_svg(const Image& image, const std::vector<Outline>& outlines) {
    const int width = side * image.width, height = side * image.height;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\">\n<g stroke=\"#000\" stroke-opacity=\"0.25\">\n",
        width, height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* p = image.pixel(x, y);
            svg += fmt::format(
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                "fill=\"#{:02x}{:02x}{:02x}\"/>\n",
                side * x, side * y, side, side, p[0], p[1], p[2]);
        }
    svg += "</g>\n<g fill=\"none\" stroke=\"#000\" stroke-width=\"1.5\">\n";
    for (const Outline& outline : outlines) {
        svg += "<polygon points=\"";
        for (const PlotPoint& p : outline)
            svg += fmt::format("{:.2f},{:.2f} ", side * p.x, side * p.y);
        svg += "\"/>\n";
    }
    svg += "</g>\n<g fill=\"#fff\" stroke=\"#000\" stroke-width=\"0.7\">\n";
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            svg += fmt::format("<circle cx=\"{:g}\" cy=\"{:g}\" r=\"2\"/>\n", side * (x + 0.5),
                               side * (y + 0.5));
    return svg + "</g>\n</svg>\n";
}

}  // namespace scanshade

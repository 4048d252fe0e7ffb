#include "render/debug_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/visibility.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade {
namespace {

Settings with_normals(Settings settings, bool carry_normals) {
    if (!carry_normals) return settings;
    settings.shading = Shading::phong;
    settings.given.insert("shading");
    return settings;
}

std::uint8_t byte(double v) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
}

/// Neighbours differ, the same number is always the same.
Rgb8 scattered(std::uint32_t number) {
    std::uint32_t h = number * 2654435761u;
    h = (h ^ (h >> 15)) * 2246822519u;
    h ^= h >> 13;
    return {std::uint8_t(64 + (h & 127)), std::uint8_t(64 + ((h >> 8) & 127)),
            std::uint8_t(64 + ((h >> 16) & 127))};
}

Rgb8 place_colour(const Place<float>& at) {
    switch (at.kind) {
        case Place<float>::Kind::weights:
            return {byte(double(at.weight[0])), byte(double(at.weight[1])),
                    byte(double(at.weight[2]))};
        case Place<float>::Kind::patch:
            return {byte(double(at.u)), byte(double(at.v)), 64};
        case Place<float>::Kind::scanline:
            // Along the span, and along the edge that it begins on.
            return {byte(double(-at.ab_x / (at.cd_x - at.ab_x))),
                    byte(double(at.a_y / (at.a_y - at.b_y))), 64};
    }
    return {};
}

}  // namespace

DebugPass::DebugPass(const Scene& scene, const Settings& settings, bool carry_normals)
    : scene_(normalised(scene)),
      plan_(make_plan(scene_, with_normals(settings, carry_normals))),
      target_(plan_.width, plan_.height),
      frame_(scene_, plan_, target_),
      surfaces_(scene_.objects.begin(), scene_.objects.end()) {
    for (const ObjectPlan& object : make_plan(scene_, settings).objects)
        shading_.push_back(object.shading);
    Renderer(scene, settings).draw(target_);
}

std::vector<double> DebugPass::coverage() {
    transform_vertices(frame_);
    std::vector<double> count(target_.id.size(), 0.0);
    visit_coverage(frame_, [&](const DrawnFace&, int y, int begin, int end) {
        for (int x = begin; x < end; ++x) count[target_.index(x, y)] += 1;
    });
    return count;
}

DebugPicture DebugPass::draw(DebugView view) {
    if (view == DebugView::plan) return draw_plan();
    DebugPicture out{PixelBuffer(width(), height()), {}, {}};
    LargeVector<std::uint32_t>& rgba = out.pixels.edit();
    parallel_for(std::size_t(height()), 8, plan_.threads,
                 [&](std::size_t begin, std::size_t end, int) {
                     EventCounts ignored;
                     FaceValues<float> face(frame_, surfaces_, ignored);
                     for (std::size_t y = begin; y < end; ++y)
                         for (int x = 0; x < width(); ++x) {
                             rgba[target_.index(x, int(y))] = opaque(colour(view, face, x, int(y)));
                         }
                 });
    return out;
}

Rgb8 DebugPass::colour(DebugView view, FaceValues<float>& face, int x, int y) const {
    const std::uint32_t id = target_.id[target_.index(x, y)];
    if (id == Framebuffer::no_triangle) return {0, 0, 0};
    if (view == DebugView::triangles) return scattered(id);
    face.begin(id);
    const Place<float> at = face.place(sample_point(x, y, frame_.sample));
    return view == DebugView::normals ? normal_colour(face, at) : place_colour(at);
}

Rgb8 DebugPass::normal_colour(FaceValues<float>& face, const Place<float>& at) const {
    glm::dvec3 n(0);
    if (shading_[face.drawn.object] == Shading::flat) {
        n = surfaces_[face.drawn.object].face_normal(face.drawn.face) *
            (face.drawn.back ? -1.0 : 1.0);
    } else {
        const Vec3<float> carried = normalise(face.normal(at));
        n = {double(carried.x), double(carried.y), double(carried.z)};
    }
    return {byte(0.5 + 0.5 * n.x), byte(0.5 + 0.5 * n.y), byte(0.5 + 0.5 * n.z)};
}

namespace {

/// A kind of work that a pixel took.
struct Work {
    Rgb8 colour;
    std::string meaning;
};

/// Shading gives the hue, how the face was drawn the tone.
Work work_of(const DrawnFace& face, Shading shading, bool textured) {
    constexpr Rgb8 hues[] = {{70, 130, 230}, {90, 190, 90}, {235, 150, 60}};
    constexpr std::string_view light[] = {"lit once a face", "lit at vertices", "lit at the pixel"};
    constexpr std::string_view drawn[] = {"", ", clipped", ", polygon walked whole"};
    constexpr double tones[] = {1, 0.45, 0.7};
    const auto carrier = static_cast<std::size_t>(face.carrier);
    Work work{hues[static_cast<std::size_t>(shading)],
              fmt::format("{}{}{}", light[static_cast<std::size_t>(shading)], drawn[carrier],
                          textured ? ", with a texture" : "")};
    for (std::uint8_t& c : work.colour)
        c = static_cast<std::uint8_t>(double(c) * tones[carrier] * (textured ? 0.8 : 1));
    return work;
}

/// Tiles without any surface.
std::vector<bool> empty_tiles(const Framebuffer& frame, int tile, int tiles_x) {
    const int tiles_y = (frame.height + tile - 1) / tile;
    std::vector<bool> empty(std::size_t(tiles_x) * std::size_t(tiles_y), true);
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x)
            if (frame.id[frame.index(x, y)] != Framebuffer::no_triangle)
                empty[std::size_t(y / tile) * std::size_t(tiles_x) + std::size_t(x / tile)] = false;
    return empty;
}

}  // namespace

DebugPicture DebugPass::draw_plan() {
    const int tiles_x = (width() + plan_.tile - 1) / plan_.tile;
    const std::vector<bool> empty = empty_tiles(target_, plan_.tile, tiles_x);
    const Work cleared{{18, 18, 24}, "background: the tile is only cleared"};
    const Work beside{{60, 60, 72}, "background in a tile with surfaces"};
    DebugPicture out{PixelBuffer(width(), height()), {}, {}};
    LargeVector<std::uint32_t>& rgba = out.pixels.edit();
    std::map<std::string, Rgb8> seen;
    EventCounts ignored;
    FaceValues<float> face(frame_, surfaces_, ignored);
    Work surface;
    for (int y = 0; y < height(); ++y)
        for (int x = 0; x < width(); ++x) {
            const std::size_t at = target_.index(x, y);
            const std::uint32_t id = target_.id[at];
            const bool nothing = id == Framebuffer::no_triangle;
            if (!nothing && face.begin(id))
                surface = work_of(face.drawn, shading_[face.drawn.object], face.texture != nullptr);
            const auto tile =
                std::size_t(y / plan_.tile) * std::size_t(tiles_x) + std::size_t(x / plan_.tile);
            const Work& work = !nothing ? surface : empty[tile] ? cleared : beside;
            seen.emplace(work.meaning, work.colour);
            rgba[at] = opaque(work.colour);
        }
    for (const auto& [meaning, colour] : seen) out.legend.push_back({colour, meaning});
    return out;
}

}  // namespace scanshade

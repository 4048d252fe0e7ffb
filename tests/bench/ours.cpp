// Scanshade, through its public interface.
#include <fmt/format.h>

#include "bench/rival.hpp"
#include "bench/scenes.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade::bench {
namespace {

/// One way of drawing: a renderer with its settings.
struct Way {
    std::string name;
    void (*choose)(Settings&);
};

constexpr auto scalar_f32 = [](Settings& s) { s.renderer = RendererKind::scalar_f32; };

std::vector<Way> all_ways() { return {{"scalar-f32", scalar_f32}}; }

class Ours final : public Rival {
public:
    explicit Ours(const Ground& ground) : ground_(ground) {}

    std::string about() const override { return "scanshade"; }

    std::vector<std::string> prepare(const Cell& cell) override {
        renderers_.clear();
        const Scene scene = lit_scene(ground_.scene, cell);
        std::vector<std::string> names;
        for (const Way& way : all_ways()) {
            Settings settings = settings_of(cell, ground_.cull);
            way.choose(settings);
            renderers_.emplace_back(scene, settings);
            names.push_back(way.name);
        }
        return names;
    }

    void draw(std::size_t way) override {
        renderers_[way].draw(frame_);
        image_ = encode(frame_, Transfer::linear, 0);
    }

    Picture picture(std::size_t way) override {
        draw(way);
        Picture picture;
        for (std::size_t i = 0; i < image_.rgb.size(); i += 3)
            picture.rgba.push_back(image_.rgb[i] | std::uint32_t(image_.rgb[i + 1]) << 8 |
                                   std::uint32_t(image_.rgb[i + 2]) << 16 | 0xff000000u);
        picture.id = frame_.id;
        return picture;
    }

private:
    Ground ground_;
    std::vector<Renderer> renderers_;  // [way]
    Framebuffer frame_;
    Image image_;
};

}  // namespace

std::unique_ptr<Rival> make_ours(const Ground& ground) { return std::make_unique<Ours>(ground); }

}  // namespace scanshade::bench

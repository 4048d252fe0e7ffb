// Scanshade, through its public interface.
#include <optional>

#include "bench/rival.hpp"
#include "bench/scenes.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/kernels/isa.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade::bench {
namespace {

/// Instruction sets that stand beside each other, those that this machine has.
std::vector<std::string> measured_sets() {
    std::vector<std::string> sets = instruction_sets();
    std::erase_if(sets, [](const std::string& isa) { return isa == "ssse3" || isa == "scalar"; });
    return sets;
}

class Ours final : public Rival {
public:
    explicit Ours(const Ground& ground) : ground_(ground), sets_(measured_sets()) {}

    std::string about() const override { return "scanshade"; }

    std::vector<std::string> prepare(const Cell& cell) override {
        renderer_.reset();
        const Scene scene = lit_scene(ground_.scene, cell);
        Settings settings = settings_of(cell, ground_.cull);
        settings.transfer = Transfer::linear;
        settings.threads = ground_.threads;
        renderer_.emplace(scene, settings);
        std::vector<std::string> names;
        for (const std::string& isa : sets_) names.push_back("simd " + isa);
        names.push_back(names.front() + ", fresh");
        return names;
    }

    /// Frames are drawn over one another, as a viewer draws them, and background that is there stays.
    /// The last way has each frame drawn as if nothing were known of the picture.
    void draw(std::size_t way) override {
        const bool fresh = way == sets_.size();
        use_instruction_set(sets_[fresh ? 0 : way]);
        if (fresh) pixels_.edit();
        renderer_->draw(pixels_);
    }

    Picture picture(std::size_t way) override {
        draw(way);
        Picture picture;
        picture.rgba.assign(pixels_.rgba().begin(), pixels_.rgba().end());
        Framebuffer frame;
        renderer_->draw(frame);
        picture.id = frame.id;
        return picture;
    }

private:
    Ground ground_;
    std::vector<std::string> sets_;     // [way]
    std::optional<Renderer> renderer_;  // of any instruction set
    PixelBuffer pixels_;
};

}  // namespace

std::unique_ptr<Rival> make_ours(const Ground& ground) { return std::make_unique<Ours>(ground); }

}  // namespace scanshade::bench

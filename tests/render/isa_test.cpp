// The vector renderer on each instruction set against scalar-f64: the same triangles at the same depth,
// colours within a level, and the same bytes whichever way they are written.
#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/level_check.hpp"

using namespace scanshade;

namespace {

/// Back to the best instruction set, however a test ends.
struct BestIsaAfterwards {
    ~BestIsaAfterwards() { use_instruction_set(""); }
};

}  // namespace

TEST_CASE("every instruction set draws the golden scenes as scalar-f64 does", "[engine][isa]") {
    const BestIsaAfterwards after;
    for (const GoldenPicture& picture : load_golden_list().pictures)
        for (const std::string& isa : instruction_sets()) {
            CAPTURE(picture.name, isa);
            Settings settings = picture.settings;
            settings.isa = isa;
            Drawn drawn;
            LevelCounts counts;
            CHECK(scalar_difference(picture.scene, settings, RendererKind::scalar_f64, drawn,
                                    counts) == "");
            CHECK(counts.exempt <= counts.pixels / 2000);
        }
}

TEST_CASE("bytes written at once are those of the float picture", "[engine][isa]") {
    const BestIsaAfterwards after;
    for (const GoldenPicture& picture : load_golden_list().pictures)
        for (const std::string& isa : instruction_sets())
            for (const Transfer transfer : {Transfer::srgb, Transfer::linear}) {
                CAPTURE(picture.name, isa, int(transfer));
                Settings settings = picture.settings;
                settings.isa = isa;
                settings.transfer = transfer;
                settings.exposure_ev = 0.7;
                PixelBuffer pixels, expected(settings.width, settings.height);
                Renderer(picture.scene, settings).draw(pixels);
                encode(draw(picture.scene, settings).frame, transfer, settings.exposure_ev,
                       expected);
                CHECK(pixels.rgba() == expected.rgba());
            }
}

TEST_CASE("highlights of huge exponents stay within 4e-5 levels times the exponent",
          "[engine][isa]") {
    // One rounding of the cosine is u; to the n-th power n u, of 255 levels and what is added on the
    // way to the cosine.
    const BestIsaAfterwards after;
    for (const std::string& isa : instruction_sets())
        for (const double shininess : {2e4, 1e5, 1e6}) {
            Scene scene = lit_sphere();
            scene.materials[0].set("ks", {1});
            scene.materials[0].set("shininess", {shininess});
            Settings settings = small_picture();
            settings.transfer = Transfer::linear;
            settings.isa = isa;
            const Image drawn = encode(draw(scene, settings).frame, settings.transfer, 0);
            settings.renderer = RendererKind::scalar_f64;
            const Image expected = encode(draw(scene, settings).frame, settings.transfer, 0);
            CAPTURE(isa, shininess);
            CHECK(diff(drawn, expected).max_delta <= 1 + 4e-5 * shininess);
        }
}

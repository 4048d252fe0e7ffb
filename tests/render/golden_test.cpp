// Golden pictures: what each scene of golden/manifest.toml drew when somebody last looked at it.
#include <filesystem>
#include <set>

#include "scanshade/image/png.hpp"
#include "scanshade/render/renderer.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

using namespace scanshade;

namespace {

const std::filesystem::path drawn_folder = "build/golden";

Framebuffer draw(const GoldenPicture& picture, RendererKind renderer) {
    Settings settings = picture.settings;
    settings.renderer = renderer;
    Framebuffer frame;
    Renderer(picture.scene, settings).draw(frame);
    return frame;
}

Image encoded(const Framebuffer& frame, const Settings& settings) {
    return encode(frame, settings.transfer, settings.exposure_ev);
}

}  // namespace

TEST_CASE("each golden picture is drawn as it was", "[golden]") {
    std::filesystem::create_directories(drawn_folder);
    const GoldenList list = load_golden_list();
    REQUIRE(list.pictures.size() >= 33);
    for (const GoldenPicture& picture : list.pictures) DYNAMIC_SECTION(picture.name) {
            const Image drawn = encoded(draw(picture, RendererKind::scalar_f32), picture.settings);
            save_png(drawn, drawn_folder / (picture.name + ".png"));
            const std::filesystem::path golden = "golden/" + picture.name + ".png";
            REQUIRE(std::filesystem::exists(golden));
            const ImageDiff difference = diff(load_image(golden), drawn);
            if (difference.count > 0)
                save_png(difference.picture, drawn_folder / (picture.name + ".diff.png"));
            CHECK(difference.max_delta <= list.max_delta);
            CHECK(difference.count <= list.max_count);
        }
}

TEST_CASE("each scene of models/scenes has a golden picture", "[golden]") {
    std::set<std::string> drawn;
    for (const GoldenPicture& picture : load_golden_list().pictures)
        drawn.insert(picture.scene_file);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator("models/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        CAPTURE(entry.path().string());
        CHECK(drawn.count(entry.path().filename().string()) == 1);
        ++files;
    }
    CHECK(files >= 8);
}

TEST_CASE("float and double shade the golden scenes alike: same ids, within a level",
          "[golden][numbers]") {
    for (const GoldenPicture& picture : load_golden_list().pictures) DYNAMIC_SECTION(picture.name) {
            const Framebuffer f32 = draw(picture, RendererKind::scalar_f32);
            const Framebuffer f64 = draw(picture, RendererKind::scalar_f64);
            CHECK(f32.id == f64.id);
            CHECK(f32.depth == f64.depth);
            const ImageDiff difference =
                diff(encoded(f32, picture.settings), encoded(f64, picture.settings));
            // Where a cosine is within its error of 0 or of a cone's rim, the two may part.
            CHECK(difference.max_delta <= 1);
        }
}

TEST_CASE("the picture's bits do not change when the scene is scaled by a power of two",
          "[golden][scale]") {
    for (const GoldenPicture& picture : load_golden_list().pictures) {
        if (picture.scene.camera->projection == Projection::orthographic) continue;
        DYNAMIC_SECTION(picture.name) {
            const double k = 0x1p12;
            GoldenPicture scaled = picture;
            for (Object& object : scaled.scene.objects)
                for (int column = 0; column < 4; ++column)
                    for (int row = 0; row < 3; ++row) object.to_world[column][row] *= k;
            for (Light& light : scaled.scene.lights) {
                light.position *= k;
                if (light.radius) *light.radius *= k;
                light.attenuation.y /= k;
                light.attenuation.z /= k * k;
            }
            scaled.scene.camera->position *= k;
            scaled.scene.camera->focal_point *= k;
            if (scaled.scene.camera->near) *scaled.scene.camera->near *= k;
            if (scaled.scene.camera->far) *scaled.scene.camera->far *= k;
            const Framebuffer a = draw(picture, RendererKind::scalar_f32);
            const Framebuffer b = draw(scaled, RendererKind::scalar_f32);
            CHECK(a.id == b.id);
            CHECK(a.depth == b.depth);
            CHECK(a.r == b.r);
            CHECK(a.g == b.g);
            CHECK(a.b == b.b);
        }
    }
}

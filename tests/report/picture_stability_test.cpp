// The pictures of the stability report: the table of hard cases, its bounds, and what is said where
// one is broken.
#include "scanshade/report/picture_stability.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "report/picture_cases.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

constexpr const char* hostile_name = "../<b>\"=1\n";

/// All cases and a user's scene, measured once.
const PictureStability& measured() {
    static const PictureStability pictures = [] {
        ReportInput input{lit_sphere(), small_picture()};
        input.scene.name = hostile_name;
        input.settings.width = 700;
        input.settings.height = 16;
        return measure_picture_stability({input}, {});
    }();
    return pictures;
}

const PictureCaseResult& result_of(std::string_view name) {
    const auto& cases = measured().cases;
    const auto at = std::find_if(cases.begin(), cases.end(),
                                 [&](const PictureCaseResult& c) { return c.name == name; });
    REQUIRE(at != cases.end());
    return *at;
}

std::uint64_t events(std::string_view name, Event event) {
    const PictureCaseResult& result = result_of(name);
    return result.loading[event] + result.renderers.front().events[event];
}

const HardCase& case_of(std::string_view name) {
    for (const HardCase& hard : hard_cases())
        if (hard.name == name) return hard;
    FAIL("there is no case " << name);
    return hard_cases().front();
}

/// The first case alone, with a damaged picture from one renderer.
PictureStability first_case(std::string_view isa,
                            const std::function<void(Framebuffer&, PixelBuffer&)>& damage) {
    int told = 0;
    Watch watch;
    watch.tell = [&](const std::string&, std::size_t, std::size_t) { ++told; };
    watch.stopped = [&] { return told > 0; };
    return measure_picture_stability({}, watch, [&](const Scene& scene, const Settings& settings) {
        const Drawing whole = make_drawing(scene, settings);
        if (settings.renderer != RendererKind::simd || settings.isa != isa) return whole;
        return Drawing{[=](PixelBuffer& pixels) {
                           const FrameStats stats = whole.pixels(pixels);
                           Framebuffer none(pixels.width, pixels.height);
                           damage(none, pixels);
                           return stats;
                       },
                       [=](Framebuffer& frame) {
                           const FrameStats stats = whole.planes(frame);
                           PixelBuffer none(frame.width, frame.height);
                           damage(frame, none);
                           return stats;
                       }};
    });
}

}  // namespace

TEST_CASE("every hard picture keeps its bounds, in every renderer", "[report][stability]") {
    const PictureStability& pictures = measured();
    for (const std::string& fault : pictures.faults()) FAIL_CHECK(fault);
    CHECK_FALSE(pictures.partial);
    REQUIRE(pictures.cases.size() == hard_cases().size() + 1);
    for (const PictureCaseResult& c : pictures.cases) {
        CAPTURE(c.name);
        REQUIRE(c.renderers.size() == 2 + instruction_sets().size());
        CHECK(c.renderers[0].renderer == "scalar-f64");
        CHECK(c.renderers[1].renderer == "scalar-f32");
        CHECK(c.geometry.samples > 100);
        CHECK(c.geometry.bound_share <= 1);
        CHECK(c.picture.width == c.width);
    }
}

TEST_CASE("a case has wider bounds only where it needs them, and says why", "[report][stability]") {
    for (const HardCase& hard : hard_cases()) {
        PictureStability alone;
        alone.cases.push_back(result_of(hard.name));
        alone.cases[0].bounds = {};
        CAPTURE(hard.name);
        CHECK(alone.faults().empty() == (hard.bounds.reason == PictureBounds{}.reason));
        // Not by orders of magnitude.
        const GeometryResult& geometry = alone.cases[0].geometry;
        CHECK(hard.bounds.displacement <= std::max(1.0, 4 * geometry.displacement));
        int levels = 0;
        for (const RendererResult& r : alone.cases[0].renderers)
            levels = std::max(levels, r.levels);
        CHECK(hard.bounds.levels <= std::max(1, 4 * levels));
    }
}

TEST_CASE("the table has every kind of hard scene", "[report][stability]") {
    std::set<std::string_view> names;
    for (const HardCase& hard : hard_cases()) {
        CAPTURE(hard.name);
        CHECK(names.insert(hard.name).second);
        CHECK(hard.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") ==
              std::string_view::npos);
        CHECK_FALSE(hard.difficulty.empty());
        CHECK_FALSE(hard.bounds.reason.empty());
    }
    for (const char* name :
         {"scale-1e-18",       "scale-1e18",          "offset-1e7-file", "offset-1e7-placed",
          "near-through-mesh", "w-ratio-1e6",         "slivers",         "t-junctions",
          "coplanar",          "duplicated-vertices", "zero-area-faces", "normals-zero",
          "normals-opposite",  "exponent-0",          "exponent-1",      "exponent-1e4",
          "exponent-1e6",      "light-on-surface",    "light-inside",    "light-at-1e15",
          "depth-1e-3-to-1e9"}) {
        CAPTURE(name);
        CHECK(names.count(name) == 1);
    }
}

TEST_CASE("hard scenes are what their names say", "[report][stability]") {
    const auto scene = [](std::string_view name) { return case_of(name).input().scene; };
    CHECK(scene("scale-1e-18").bounds().radius / 1e-18 == Approx(1.5).epsilon(0.01));
    CHECK(scene("scale-1e18").bounds().radius / 1e18 == Approx(1.5).epsilon(0.01));
    for (const char* name : {"offset-1e7-file", "offset-1e7-placed"})
        CHECK(scene(name).bounds().centre.x == Approx(1e7));
    CHECK(scene("exponent-1e6").materials.back().find("shininess")->values[0] == 1e6);
    CHECK(glm::length(scene("light-at-1e15").lights[0].position) == Approx(1e15).epsilon(0.1));
    const Camera depth = *scene("depth-1e-3-to-1e9").camera;
    CHECK(*depth.near == 1e-3);
    CHECK(*depth.far == 1e9);

    const TestFrame floor(scene("w-ratio-1e6"), case_of("w-ratio-1e6").input().settings);
    float least = INFINITY, most = 0;
    for (const VertexState& v : floor.frame.vertices[0]) {
        least = std::min(least, v.clip.w);
        most = std::max(most, v.clip.w);
    }
    CHECK(double(most / least) == Approx(1e6).epsilon(0.05));

    const struct {
        const char* name;
        Event event;
    } rare[] = {{"near-through-mesh", Event::near_clipped},
                {"behind-the-eye", Event::near_clipped},
                {"guard-band", Event::guard_clipped},
                {"zero-area-faces", Event::degenerate_face},
                {"zero-area-faces", Event::zero_area},
                {"tiny-triangles", Event::zero_area},
                {"odd-quads", Event::concave_face},
                {"odd-quads", Event::self_crossing_face},
                {"odd-quads-edges", Event::edges_fallback},
                {"odd-quads-patch", Event::patch_fallback},
                {"normals-zero", Event::repaired_normal},
                {"normals-opposite-edges", Event::zero_normal},
                {"normals-cancelling", Event::cancelled_normal},
                {"light-on-surface-gouraud", Event::light_at_surface}};
    for (const auto& [name, event] : rare) {
        CAPTURE(name, int(event));
        CHECK(events(name, event) > 0);
    }
}

TEST_CASE("T-junctions crack, and meshes that share their corners do not", "[report][stability]") {
    CHECK(result_of("t-junctions").geometry.opened > 0);
    for (const char* name : {"scale-1e-18", "slivers", "needles-1-256", "inside-mesh",
                             "duplicated-vertices", "tiny-triangles"}) {
        CAPTURE(name);
        CHECK(result_of(name).geometry.opened == 0);
        CHECK(result_of(name).geometry.moved > 0);
    }
}

TEST_CASE("a broken picture is found, with its case and renderer", "[report][stability]") {
    const std::string isa = instruction_sets().back();
    const struct {
        std::function<void(Framebuffer&, PixelBuffer&)> damage;
        const char* words;
    } rows[] = {
        {[](Framebuffer& f, PixelBuffer&) { f.g[77] = NAN; }, "NaN or Inf is 1"},
        {[](Framebuffer& f, PixelBuffer&) { f.r[78] = INFINITY; }, "NaN or Inf is 1"},
        {[](Framebuffer& f, PixelBuffer&) { f.id[5000] ^= 1; }, "another triangle or depth"},
        {[](Framebuffer& f, PixelBuffer&) { f.depth[5000] = std::nextafter(f.depth[5000], 1.0f); },
         "another triangle or depth"},
        {[](Framebuffer&, PixelBuffer& p) { p.edit()[5000] ^= 0x80; },
         "largest difference in levels"},
    };
    for (const auto& row : rows) {
        const PictureStability pictures = first_case(isa, row.damage);
        CHECK(pictures.partial);
        REQUIRE(pictures.cases.size() == 1);
        const std::vector<std::string> faults = pictures.faults();
        REQUIRE_FALSE(faults.empty());
        CAPTURE(faults[0]);
        CHECK(faults[0].find("picture '" + pictures.cases[0].name + "', simd " + isa) == 0);
        CHECK(faults[0].find(row.words) != std::string::npos);
    }
    CHECK(first_case("", [](Framebuffer&, PixelBuffer&) {}).faults().empty());
}

TEST_CASE("broken geometry is found", "[report][stability]") {
    const struct {
        void (*damage)(GeometryResult&);
        const char* words;
    } rows[] = {
        {[](GeometryResult& g) { g.displacement = 1.01; }, "displacement of a vertex"},
        {[](GeometryResult& g) { g.edge_distance = double(NAN); }, "moved sample"},
        {[](GeometryResult& g) { g.bound_share = 1.001; }, "what rounding can come to"},
        {[](GeometryResult& g) { g.mistaken = 1; }, "chooses another triangle"},
    };
    for (const auto& row : rows) {
        PictureStability pictures;
        pictures.cases.push_back(result_of("scale-1e9"));
        CHECK(pictures.faults().empty());
        row.damage(pictures.cases[0].geometry);
        REQUIRE(pictures.faults().size() == 1);
        CHECK(pictures.faults()[0].find("picture 'scale-1e9', geometry") == 0);
        CHECK(pictures.faults()[0].find(row.words) != std::string::npos);
    }
}

TEST_CASE("the pictures' files and their part of the page", "[report][stability]") {
    const PictureStability& pictures = measured();
    const TempFolder folder;
    write_pictures(pictures, folder.path);
    CHECK(load_image(folder.path / "case-t-junctions.png").width == 128);
    // A user's picture is shrunk, and its name is no path.
    const std::string last = "scene-" + std::to_string(pictures.cases.size()) + ".png";
    CHECK(load_image(folder.path / last).width == 175);

    CHECK(draw_plots(picture_plots(pictures), folder.path).empty());
    for (const char* file : {"pictures-levels.svg", "pictures-geometry.svg"})
        CHECK(std::filesystem::file_size(folder.path / file) > 5000);

    const Json scenes = picture_scenes_json(pictures);
    REQUIRE(scenes.size() == pictures.cases.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        CHECK(scenes[i]["name"] == pictures.cases[i].name);
        CHECK(scenes[i]["rows"].size() == pictures.cases[i].renderers.size() + 1);
        for (const Json& row : scenes[i]["rows"])
            CHECK(std::filesystem::exists(folder.path / row["image"].get<std::string>()));
    }
    CHECK(scenes.back()["generated"] == false);

    Page page("t", "l");
    add_picture_section(pictures, true, page);
    const std::string text = page.text();
    CHECK(text.find("<b>\"") == std::string::npos);
    CHECK(text.find("../&lt;b&gt;") != std::string::npos);
    CHECK(text.find("case-t-junctions.png") != std::string::npos);
    CHECK(text.find("pictures-levels.svg") != std::string::npos);
    CHECK(text.find(std::string(case_of("exponent-1e6").bounds.reason)) != std::string::npos);
    Page without("t", "l");
    add_picture_section(pictures, false, without);
    CHECK(without.text().find(".svg") == std::string::npos);
}

// Methods chosen by error or time: what was promised holds, on scenes that nothing was tuned for.
#include "scanshade/report/choose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "report/reference_check.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

const Tell silent = [](const std::string&) {};

/// P(X ≤ k) for X binomial, term by term from the definition.
double at_most(std::size_t k, std::size_t n, double p) {
    double sum = 0;
    for (std::size_t i = 0; i <= k; ++i)
        sum += std::exp(std::lgamma(double(n) + 1) - std::lgamma(double(i) + 1) -
                        std::lgamma(double(n - i) + 1) + double(i) * std::log(p) +
                        double(n - i) * std::log1p(-p));
    return sum;
}

/// Covered pixels of the whole picture that are off by more than `levels`, and all covered ones.
struct Faults {
    std::size_t off = 0, covered = 0;
};
Faults faults_of(const Scene& scene, const Settings& settings, const Method& method,
                 double levels) {
    const auto image = [&](const Framebuffer& frame) {
        return encode(frame, settings.transfer, settings.exposure_ev);
    };
    const Framebuffer drawn = draw(scene, settings_of(method, settings)).frame;
    const Framebuffer expected = draw(scene, settings_of(all_methods().front(), settings)).frame;
    const Image a = image(drawn), b = image(expected);
    Faults faults;
    for (std::size_t i = 0; i < expected.id.size(); ++i) {
        if (expected.id[i] == Framebuffer::no_triangle) continue;
        ++faults.covered;
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
            if (std::abs(a.rgb[k] - b.rgb[k]) > levels) {
                ++faults.off;
                break;
            }
    }
    return faults;
}

Scene sphere_with_highlight() {
    Scene scene = lit_sphere();
    scene.materials[0].set("ks", {0.8});
    scene.materials[0].set("shininess", {200});
    return scene;
}

Settings size(int width, int height) {
    Settings settings;
    settings.width = width, settings.height = height;
    return settings;
}

}  // namespace

TEST_CASE("allowed faults are the most that prove the share", "[choose]") {
    for (std::size_t n : {1u, 10u, 500u, 4096u, 8192u, 20000u, 100000u})
        for (double share : {0.5, 0.1, 0.001})
            for (double confidence : {0.9, 0.999}) {
                const auto k = allowed_faults(n, share, confidence);
                CAPTURE(n, share, confidence, k.value_or(n + 1));
                if (k) CHECK(at_most(*k, n, share) <= (1 - confidence) * (1 + 1e-9));
                CHECK(at_most(k ? *k + 1 : 0, n, share) > (1 - confidence) * (1 - 1e-9));
            }
    CHECK(allowed_faults(checked_pixels, allowed_share, promised_confidence) == 0);
    CHECK_FALSE(allowed_faults(checked_pixels / 2, allowed_share, promised_confidence));
}

TEST_CASE("pixels that are drawn alone have the bits of the whole picture", "[choose]") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const RandomScene random = make_random_scene(seed);
        Settings settings = random.settings;
        settings.renderer = RendererKind::scalar_f64;
        const Framebuffer whole = draw(random.scene, settings).frame;
        Mask mask(settings.width, settings.height);
        for (std::size_t i = 0; i < mask.inside.size(); i += 3) mask.inside[i] = 1;
        Framebuffer part;
        Renderer(random.scene, settings).draw(part, mask);
        for (std::size_t i = 0; i < mask.inside.size(); ++i) {
            CAPTURE(seed, i, describe(random));
            if (mask.inside[i]) {
                REQUIRE(part.r[i] == whole.r[i]);
                REQUIRE(part.g[i] == whole.g[i]);
                REQUIRE(part.b[i] == whole.b[i]);
                REQUIRE(part.id[i] == whole.id[i]);
            } else {
                REQUIRE(part.id[i] == Framebuffer::no_triangle);
                REQUIRE(part.r[i] == Approx(settings.background.x));
            }
        }
    }
}

TEST_CASE("the check counts what is off among the pixels that it took", "[choose]") {
    const Scene scene = lit_sphere();
    const Settings settings = settings_of(all_methods().front(), size(240, 180));
    const Framebuffer right = draw(scene, settings).frame;
    const ReferenceCheck check(scene, settings, right);
    CHECK(check.covered() == seen(right));
    REQUIRE(check.covered() > checked_pixels);
    CHECK(check.checked() == checked_pixels);
    CHECK(check.allowed() == 0);
    CHECK(check.off(right, 0) == 0);

    // A quarter of the covered pixels is brighter: so is about a quarter of the sample, and with
    // 8192 of them six standard deviations are 235.
    Framebuffer wrong = right;
    for (int y = 0; y < 180; ++y)
        for (int x = y % 2; x < 240; x += 2)
            if (x % 4 < 2) wrong.g[wrong.index(x, y)] = 4;
    std::size_t brighter = 0;
    for (std::size_t i = 0; i < wrong.g.size(); ++i)
        brighter += wrong.id[i] != Framebuffer::no_triangle && wrong.g[i] != right.g[i];
    const double expected = double(brighter) / double(check.covered()) * checked_pixels;
    CHECK(std::abs(double(check.off(wrong, 10)) - expected) < 235);
    CHECK(check.off(wrong, 254.5) == 0);
}

TEST_CASE("a small picture is checked whole", "[choose]") {
    const Scene scene = lit_sphere();
    const Settings settings = settings_of(all_methods().front(), size(80, 60));
    Framebuffer picture = draw(scene, settings).frame;
    const ReferenceCheck check(scene, settings, picture);
    CHECK(check.checked() == check.covered());
    CHECK(check.allowed() == check.covered() / 1000);
    picture.r[picture.index(40, 30)] += 1;
    CHECK(check.off(picture, 1) == 1);
}

TEST_CASE("a picture without surfaces may be drawn by the cheapest method", "[choose]") {
    Scene scene = lit_sphere();
    scene.camera->focal_point = {0, 0, 10};
    const Choice choice = choose_by_error(scene, small_picture(), 0, silent);
    CHECK(choice.covered == 0);
    CHECK(choice.candidates.size() == 1);
    CHECK(choice.method == choice.candidates[0].method);
}

TEST_CASE("no chosen method shows more faults than promised", "[choose][random]") {
    std::set<const Method*> chosen;
    for (std::uint64_t seed = 100; seed < 140; ++seed) {
        const RandomScene random = make_random_scene(seed);
        for (double levels : {0.0, 1.0, 8.0}) {
            const Choice choice = choose_by_error(random.scene, random.settings, levels, silent);
            chosen.insert(choice.method);
            const Faults faults = faults_of(random.scene, random.settings, *choice.method, levels);
            CAPTURE(seed, levels, std::string(choice.method->name), faults.off, faults.covered,
                    describe(random));
            CHECK(double(faults.off) <= allowed_share * double(faults.covered));
            CHECK(choice.sentences.size() >= 2);
        }
    }
    CHECK(chosen.count(&all_methods().front()) == 1);  // the reference was needed
    CHECK(chosen.size() >= 2);                         // and sometimes it was not
}

TEST_CASE("the promise holds where only a sample of the pixels is checked", "[choose]") {
    const Scene scene = sphere_with_highlight();
    Settings settings = size(320, 240);
    settings.samples = 4;
    for (double levels : {0.0, 1.0, 4.0, 30.0, 255.0}) {
        const Choice choice = choose_by_error(scene, settings, levels, silent);
        REQUIRE(choice.covered > choice.checked);
        const Faults faults = faults_of(scene, settings, *choice.method, levels);
        CAPTURE(levels, std::string(choice.method->name), faults.off, faults.covered);
        CHECK(faults.covered == choice.covered);
        CHECK(double(faults.off) <= allowed_share * double(faults.covered));
        // What was rejected came before in the order of cost, and was off at too many places.
        for (std::size_t i = 0; i + 1 < choice.candidates.size(); ++i) {
            CHECK(choice.candidates[i].predicted_ms <= choice.candidates[i + 1].predicted_ms);
            CHECK(*choice.candidates[i].off > choice.allowed);
        }
        if (levels == 255) CHECK(choice.candidates.size() == 1);
        if (levels <= 4) CHECK(choice.method->shading == Shading::phong);
    }
}

TEST_CASE("objects that ask for a shading are drawn by the chosen one", "[choose]") {
    Scene scene = sphere_with_highlight();
    scene.objects[0].shading = Shading::flat;
    const Choice choice = choose_by_error(scene, size(160, 120), 1, silent);
    CHECK(choice.method->shading == Shading::phong);
    const Faults faults = faults_of(scene, size(160, 120), *choice.method, 1);
    CHECK(double(faults.off) <= allowed_share * double(faults.covered));
}

TEST_CASE("with time enough it is the reference, without any the cheapest", "[choose]") {
    const Scene scene = sphere_with_highlight();
    const Choice slow = choose_by_time(scene, small_picture(), 1e9, silent);
    CHECK(slow.method == &all_methods().front());
    CHECK(slow.fits);
    REQUIRE(slow.candidates.size() == 1);
    CHECK(*slow.candidates[0].slowest_ms <= 1e9);

    const Choice fast = choose_by_time(scene, small_picture(), 1e-3, silent);
    CHECK_FALSE(fast.fits);
    REQUIRE(fast.candidates.size() == 3);  // the reference is not even measured
    for (const Candidate& candidate : fast.candidates) {
        CHECK(candidate.predicted_ms > 1e-3);
        CHECK_FALSE(candidate.slowest_ms);
        if (candidate.method != fast.method) continue;
        for (const Candidate& other : fast.candidates)
            CHECK(candidate.predicted_ms <= other.predicted_ms);
    }
    CHECK(fast.sentences[3].find("no method takes 0.001 ms or less") != std::string::npos);
}

TEST_CASE("frames cost about what small ones predict", "[choose]") {
    Scene scene = sphere_with_highlight();
    for (int i = 0; i < 60; ++i) scene.lights.push_back(scene.lights[std::size_t(i % 3)]);
    const Settings settings = size(480, 360);
    for (const Candidate& candidate : choose_by_time(scene, settings, 1e-3, silent).candidates) {
        Renderer renderer(scene, settings_of(*candidate.method, settings));
        PixelBuffer pixels;
        double fastest = 1e9;
        for (int i = 0; i < 8; ++i) fastest = std::min(fastest, renderer.draw(pixels).frame_ms);
        CAPTURE(std::string(candidate.method->name), fastest, candidate.predicted_ms);
        CHECK(candidate.predicted_ms > fastest / 8);  // a busy machine disturbs both
        CHECK(candidate.predicted_ms < fastest * 8);
    }
}

TEST_CASE("a budget between two methods takes the better one that fits", "[choose]") {
    // Light at each of so many pixels is dear, at eight vertices it is not.
    Scene scene = single_object_scene(
        std::make_shared<Mesh>(build_mesh(find_shape("cube")->make(1), {})), Material{});
    for (int i = 0; i < 200; ++i) scene.lights.push_back(scene.lights[std::size_t(i % 3)]);
    const Settings settings = size(400, 300);
    const auto prediction = [&] {
        return choose_by_time(scene, settings, 1e-3, silent).candidates;
    };
    const auto candidates = prediction();
    REQUIRE(candidates[1].predicted_ms < 0.5 * candidates[0].predicted_ms);
    const double budget = std::sqrt(candidates[0].predicted_ms * candidates[1].predicted_ms);
    const Choice choice = choose_by_time(scene, settings, budget, silent);
    CAPTURE(budget, choice.sentences);
    CHECK(choice.method->shading != Shading::phong);
    if (choice.fits) {
        CHECK(*choice.candidates.back().slowest_ms <= budget);
        CHECK(choice.candidates.back().method == choice.method);
    }
}

// Only an idle machine keeps it: for people who ask for it by its tag.
TEST_CASE("a budget is kept in 95 of 100 frames", "[.][idle]") {
    for (std::uint64_t seed = 300; seed < 310; ++seed) {
        const RandomScene random = make_random_scene(seed);
        Settings settings = random.settings;
        settings.width = 640, settings.height = 480;
        const auto candidates = choose_by_time(random.scene, settings, 1e-3, silent).candidates;
        for (const Candidate& candidate : candidates) {
            const double budget = 1.3 * candidate.predicted_ms;
            const Choice choice = choose_by_time(random.scene, settings, budget, silent);
            if (!choice.fits) continue;
            Renderer renderer(random.scene, settings_of(*choice.method, settings));
            PixelBuffer pixels;
            renderer.draw(pixels);
            int kept = 0;
            for (int i = 0; i < 100; ++i) kept += renderer.draw(pixels).frame_ms <= budget;
            CAPTURE(seed, budget, std::string(choice.method->name));
            CHECK(kept >= 95);
        }
    }
}

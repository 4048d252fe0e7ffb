// Small scenes for tests of the renderer.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "render/frame.hpp"
#include "render/visibility.hpp"
#include "scanshade/num/target.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {

/// A soup of faces over shared positions, all of material 0.
inline PolygonSoup make_soup(const std::vector<glm::dvec3>& positions,
                             const std::vector<std::vector<std::uint32_t>>& faces) {
    PolygonSoup soup;
    soup.positions = positions;
    for (const auto& face : faces) {
        for (const std::uint32_t v : face) soup.corners.push_back({v, no_index, no_index});
        soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
        soup.face_material.push_back(0);
    }
    return soup;
}

inline Scene make_scene(const PolygonSoup& soup, const Camera& camera) {
    Scene scene = single_object_scene(std::make_shared<Mesh>(build_mesh(soup, {})), Material{});
    scene.camera = camera;
    return scene;
}

/// A camera at the origin that looks down −z, and the points that it shows at given pixels.
struct PixelCamera {
    int width, height;
    Camera camera;

    PixelCamera(int w, int h, double near = 1e-3, double far = 1e4) : width(w), height(h) {
        camera.position = {0, 0, 0};
        camera.focal_point = {0, 0, -1};
        camera.view_angle_deg = 90;
        camera.near = near;
        camera.far = far;
    }
    glm::dvec3 point(double px, double py, double w) const {
        const double half = height / 2.0;  // pixels a unit at w = 1
        return {(px - width / 2.0) / half * w, -(py - half) / half * w, -w};
    }
    Settings settings() const {
        Settings s;
        s.width = width;
        s.height = height;
        return s;
    }
};

/// A frame that has gone through `transform`.
struct TestFrame {
    Scene scene;
    RenderPlan plan;
    Framebuffer target;
    Frame frame;

    TestFrame(const Scene& input, const Settings& settings)
        : scene(normalised(input)),
          plan(make_plan(scene, settings)),
          target(settings.width, settings.height),
          frame(scene, plan, target) {
        transform_vertices(frame);
    }

    /// How many faces cover each sample.
    std::vector<int> coverage() {
        std::vector<int> count(target.depth.size());
        visit_coverage(frame, [&](const DrawnFace&, int y, int begin, int end) {
            for (int x = begin; x < end; ++x) ++count[target.index(x, y)];
        });
        return count;
    }
};

/// A scene as Renderer draws it.
struct Drawn {
    Framebuffer frame;
    FrameStats stats;
};

inline Drawn draw(const Scene& scene, const Settings& settings) {
    Drawn d;
    d.stats = Renderer(scene, settings).draw(d.frame);
    return d;
}

/// Samples that show something.
inline std::size_t seen(const Framebuffer& frame) {
    std::size_t count = 0;
    for (const std::uint32_t id : frame.id) count += id != Framebuffer::no_triangle;
    return count;
}

/// The unit sphere, lit and seen from (0, 0, 5).
inline Scene lit_sphere() {
    Scene scene = single_object_scene(
        std::make_shared<Mesh>(build_mesh(find_shape("sphere")->make(16), {})), Material{});
    scene.camera = Camera{};
    return scene;
}

inline Settings small_picture() {
    Settings s;
    s.width = 80;
    s.height = 60;
    return s;
}

}  // namespace scanshade

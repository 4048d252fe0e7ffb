#include "scanshade/scene/camera.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

glm::dvec3 in_eye_space(const Camera& camera, const glm::dvec3& p) {
    return eye_rotation(camera) * (p - camera.position);
}

std::string refusal(const Camera& camera) {
    try {
        eye_rotation(camera);
        depth_range(camera, Bounds{});
    } catch (const Error& error) {
        CHECK(error.code() == Errc::scene);
        return error.what();
    }
    return "taken";
}

Camera looking(const glm::dvec3& position, const glm::dvec3& focal_point,
               const glm::dvec3& view_up = {0, 1, 0}) {
    Camera camera;
    camera.position = position;
    camera.focal_point = focal_point;
    camera.view_up = view_up;
    return camera;
}

}  // namespace

TEST_CASE("a framed camera sees the whole sphere with a margin of 5 percent", "[camera]") {
    for (const Bounds& bounds : {Bounds{}, Bounds{{1e6, -2e6, 3e6}, 1e-3}, Bounds{{0, 0, 0}, 1e20}})
        for (const double aspect : {0.01, 0.25, 0.75, 1.0, 4.0 / 3, 16.0 / 9, 100.0}) {
            CAPTURE(bounds.radius, aspect);
            const Camera camera = framed_camera(bounds, aspect);
            CHECK(camera.view_angle_deg == 30);
            const double distance = glm::length(camera.position - bounds.centre);
            const double half_height = std::tan(glm::radians(camera.view_angle_deg) / 2);
            const double narrow = std::atan(half_height * std::min(1.0, aspect));
            // The cone around the sphere against the narrower half angle of the picture.
            CHECK(distance * std::sin(narrow) == Approx(1.05 * bounds.radius).epsilon(1e-3));
            // In particular the corners of a box inside the sphere.
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                      corner & 4 ? 1 : -1);
                const glm::dvec3 eye =
                    in_eye_space(camera, bounds.centre + sign * (bounds.radius / std::sqrt(3.0)));
                CHECK(eye.z < 0);
                CHECK(std::abs(eye.y) < -eye.z * half_height);
                CHECK(std::abs(eye.x) < -eye.z * half_height * aspect);
            }
        }
}

TEST_CASE("a framed camera stands front right and a little above", "[camera]") {
    const Camera camera = framed_camera({}, 1);
    const glm::dvec3 d = glm::normalize(camera.position);
    CHECK(std::atan2(d.x, d.z) == Approx(glm::radians(30.0)));
    CHECK(std::asin(d.y) == Approx(glm::radians(20.0)));
}

TEST_CASE("eye space has x to the right, y up and z backward", "[camera]") {
    const Camera front = looking({0, 0, 5}, {0, 0, 0});
    CHECK(in_eye_space(front, {1, 2, 3}) == glm::dvec3(1, 2, -2));
    const Camera side = looking({4, 0, 0}, {0, 0, 0});  // sees −z on the right
    const glm::dvec3 p = in_eye_space(side, {1, 2, -3});
    CHECK(glm::length(p - glm::dvec3(3, 2, -3)) < 1e-15);
    const Camera tilted = looking({3, -2, 7}, {0.5, 1, -2}, {0.2, 5, 0.1});
    const glm::dmat3 r = eye_rotation(tilted);
    CHECK(glm::determinant(r) == Approx(1));
    const glm::dmat3 product = r * glm::transpose(r);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) CHECK(std::abs(product[i][j] - (i == j ? 1 : 0)) < 1e-15);
    CHECK((r * tilted.view_up).x == Approx(0).margin(1e-15));
    CHECK((r * tilted.view_up).y > 0);
}

TEST_CASE("the length of view up and the distance do not matter", "[camera]") {
    const glm::dmat3 plain = eye_rotation(looking({0, 3, 4}, {0, 0, 0}));
    for (const double size : {1e-90, 1e90}) {
        const glm::dmat3 r =
            eye_rotation(looking(glm::dvec3(0, 3, 4) * size, {0, 0, 0}, {0, size, 0}));
        for (int i = 0; i < 3; ++i) CHECK(glm::length(r[i] - plain[i]) < 1e-15);
    }
}

TEST_CASE("a camera that looks nowhere is refused with what would be right", "[camera]") {
    CHECK(refusal(looking({1, 2, 3}, {1, 2, 3})).find("two different") != std::string::npos);
    CHECK(refusal(looking({0, 5, 0}, {0, 0, 0})).find("view up") != std::string::npos);
    CHECK(refusal(looking({0, 0, 5}, {0, 0, 0}, {0, 0, -2})).find("view up") != std::string::npos);
    CHECK(refusal(looking({0, 0, 5}, {0, 0, 0}, {0, 0, 0})).find("view up") != std::string::npos);
    Camera camera;
    camera.near = 2;
    camera.far = 2;
    CHECK(refusal(camera).find("0 < near < far") != std::string::npos);
    camera.near = -1;
    CHECK(refusal(camera).find("0 < near < far") != std::string::npos);
}

TEST_CASE("the depth range encloses the sphere", "[camera]") {
    for (const double radius : {1e-6, 1.0, 1e12})
        for (const double distance : {1.5, 10.0, 1e6}) {
            CAPTURE(radius, distance);
            const Bounds bounds{{radius, 0, 0}, radius};
            const Camera camera =
                looking(bounds.centre + glm::dvec3(0, 0, distance * radius), bounds.centre);
            const DepthRange range = depth_range(camera, bounds);
            CHECK(range.near < (distance - 1) * radius);
            CHECK(range.near > (distance - 1.1) * radius - 1e-5 * distance * radius);
            CHECK(range.far > (distance + 1) * radius);
        }
}

TEST_CASE("from inside the sphere near is a thousandth of its radius", "[camera]") {
    const Bounds bounds{{0, 0, 0}, 8};
    CHECK(depth_range(looking({0, 0, 1}, {0, 0, 0}), bounds).near == 8e-3);
    // Everything behind the camera: nothing is seen, but the range is one.
    const DepthRange away = depth_range(looking({0, 0, 50}, {0, 0, 60}), bounds);
    CHECK(away.near > 0);
    CHECK(away.far > away.near);
}

TEST_CASE("given planes are kept and the fitted one gives way", "[camera]") {
    Camera camera = looking({0, 0, 10}, {0, 0, 0});
    camera.near = 0.25;
    CHECK(depth_range(camera, {}).near == 0.25);
    CHECK(depth_range(camera, {}).far > 11);
    camera.near = 40;
    CHECK(depth_range(camera, {}).near == 40);
    CHECK(depth_range(camera, {}).far > 40);
    camera.near.reset();
    camera.far = 5;
    CHECK(depth_range(camera, {}).far == 5);
    CHECK(depth_range(camera, {}).near < 5);
    CHECK(depth_range(camera, {}).near > 0);
}

// Gestures on cameras: what stays, what returns, where they stop.
#include "viewer/camera_control.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;
using namespace scanshade::viewer;

namespace {

constexpr int height = 480;

Camera random_camera(Rng& rng) {
    const auto vector = [&](double size) {
        return glm::dvec3(rng.real(-size, size), rng.real(-size, size), rng.real(-size, size));
    };
    Camera camera;
    camera.focal_point = vector(3);
    do {
        camera.position = camera.focal_point + vector(5);
        camera.view_up = vector(2);
    } while (glm::length(glm::cross(glm::normalize(camera.view_up),
                                    glm::normalize(camera.position - camera.focal_point))) < 0.1);
    return camera;
}

double distance(const Camera& camera) { return glm::length(camera.position - camera.focal_point); }

/// Angle between view_up and the direction towards the camera.
double polar(const Camera& camera) {
    return std::acos(glm::dot(glm::normalize(camera.view_up),
                              glm::normalize(camera.position - camera.focal_point)));
}

void check_same(const glm::dvec3& a, const glm::dvec3& b) {
    CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
    CHECK(glm::length(a - b) < 1e-9);
}

Camera zoomed_in_place(const Camera& camera, double steps, double radius) {
    return zoomed(camera, steps, radius, 0, 0, height);
}

Camera some_camera() {
    Camera camera;
    camera.focal_point = {0.3, -0.2, 0.5};
    camera.position = {2, 3, 4};
    return camera;
}

}  // namespace

TEST_CASE("orbit keeps the distance, the focal point and view up", "[viewer]") {
    Rng rng(1);
    for (int i = 0; i < 200; ++i) {
        const Camera before = random_camera(rng);
        const Camera after = orbited(before, rng.real(-300, 300), rng.real(-300, 300), height);
        CHECK(distance(after) == Approx(distance(before)));
        CHECK(after.focal_point == before.focal_point);
        CHECK(after.view_up == before.view_up);
    }
}

TEST_CASE("a drag over the window's height is a full turn, half of it the other side", "[viewer]") {
    Rng rng(2);
    for (int i = 0; i < 50; ++i) {
        const Camera before = random_camera(rng);
        check_same(orbited(before, height, 0, height).position, before.position);

        const Camera half = orbited(before, height / 2.0, 0, height);
        const glm::dvec3 axis = glm::normalize(before.view_up);
        const glm::dvec3 offset = before.position - before.focal_point;
        const glm::dvec3 along = glm::dot(offset, axis) * axis;
        check_same(half.position, before.focal_point + 2.0 * along - offset);
    }
}

TEST_CASE("what faces the camera follows a drag", "[viewer]") {
    const Camera camera;  // on the z axis
    CHECK(orbited(camera, 10, 0, height).position.x < 0);
    CHECK(orbited(camera, 0, 10, height).position.y > 0);
}

TEST_CASE("orbit stops before the poles and comes back from there", "[viewer]") {
    const Camera camera;
    for (const double dy : {1e4, -1e4}) {
        const Camera pole = orbited(camera, 0, dy, height);
        const double beyond = dy > 0 ? polar(pole) : std::acos(-1.0) - polar(pole);
        CHECK(beyond == Approx(0.01).margin(1e-6));
        CHECK_NOTHROW(eye_rotation(pole));
        check_same(orbited(pole, 0, dy, height).position, pole.position);
        CHECK(polar(orbited(pole, 0, -dy / 100, height)) ==
              Approx(polar(pole) + dy / 100 * 2 * std::acos(-1.0) / height));
    }
}

TEST_CASE("a camera nearer to a pole than orbit goes does not jump", "[viewer]") {
    Camera camera;
    camera.position = {0, 5, 0.01};
    check_same(orbited(camera, 0, 0, height).position, camera.position);
    check_same(orbited(camera, 0, 5, height).position, camera.position);
}

TEST_CASE("pan moves the focal point under the cursor", "[viewer]") {
    Rng rng(3);
    for (int i = 0; i < 50; ++i) {
        const Camera before = random_camera(rng);
        const double dx = rng.real(-100, 100), dy = rng.real(-100, 100);
        const Camera after = panned(before, dx, dy, height);
        check_same(after.position - after.focal_point, before.position - before.focal_point);

        // Where the old focal point is in the new picture, in pixels from its centre, y down.
        const glm::dvec3 eye = eye_rotation(after) * (before.focal_point - after.position);
        const double focal_length =
            height / (2 * std::tan(glm::radians(before.view_angle_deg) / 2));
        CHECK(focal_length * eye.x / -eye.z == Approx(dx).margin(1e-6));
        CHECK(focal_length * -eye.y / -eye.z == Approx(dy).margin(1e-6));
    }
}

TEST_CASE("zoom multiplies the distance for each step", "[viewer]") {
    const Camera camera;
    CHECK(distance(zoomed_in_place(camera, 1, 1)) == Approx(0.9 * 5));
    CHECK(distance(zoomed_in_place(camera, -1, 1)) == Approx(5 / 0.9));
    CHECK(distance(zoomed_in_place(camera, 2.5, 1)) == Approx(5 * std::pow(0.9, 2.5)));
    check_same(zoomed_in_place(zoomed_in_place(camera, 3, 1), -3, 1).position, camera.position);
    CHECK(zoomed_in_place(camera, 3, 1).focal_point == camera.focal_point);
}

TEST_CASE("zoom stays within a thousandth and a thousand radii", "[viewer]") {
    const Camera camera;
    for (const double radius : {1e-2, 1.0, 1e2}) {
        CHECK(distance(zoomed_in_place(camera, 1e6, radius)) == Approx(1e-3 * radius));
        CHECK(distance(zoomed_in_place(camera, -1e6, radius)) == Approx(1e3 * radius));
    }
}

TEST_CASE("a camera outside the limits of zoom may come back but not go on", "[viewer]") {
    const Camera camera;  // at a distance of 5
    check_same(zoomed_in_place(camera, -1, 1e-4).position, camera.position);
    CHECK(distance(zoomed_in_place(camera, 1, 1e-4)) == Approx(4.5));
}

TEST_CASE("zooming keeps what is under the cursor there", "[viewer]") {
    const Camera camera = some_camera();
    constexpr int width = 400;
    const glm::dmat3 eye = glm::transpose(eye_rotation(camera));
    // A point at the focal point's depth, up and to the left of it.
    const glm::dvec3 point = camera.focal_point - 0.6 * eye[0] + 0.4 * eye[1];
    const glm::dvec2 before = *project(camera, width, height, point);
    for (const double steps : {1.0, 7.0, -3.0}) {
        const Camera moved =
            zoomed(camera, steps, 1, before.x - width / 2.0, before.y - height / 2.0, height);
        const glm::dvec2 after = *project(moved, width, height, point);
        CHECK(after.x == Approx(before.x));
        CHECK(after.y == Approx(before.y));
    }
}

TEST_CASE("a projected point is where the renderer draws it", "[viewer]") {
    Camera camera = some_camera();
    const glm::dvec2 middle = *project(camera, 400, 300, camera.focal_point);
    CHECK(middle.x == Approx(200));
    CHECK(middle.y == Approx(150));
    CHECK_FALSE(project(camera, 400, 300, camera.position + (camera.position - camera.focal_point))
                    .has_value());
    // Half of the view angle above the middle is the upper edge, in both projections.
    const glm::dmat3 eye = glm::transpose(eye_rotation(camera));
    const double half = distance(camera) * std::tan(glm::radians(camera.view_angle_deg) / 2);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        camera.projection = projection;
        const glm::dvec2 top = *project(camera, 400, 300, camera.focal_point + eye[1] * half);
        CHECK(top.x == Approx(200));
        CHECK(top.y == Approx(0).margin(1e-9));
    }
}

TEST_CASE("standard views look at the same point from the same distance", "[viewer]") {
    const Camera camera = some_camera();
    const double far = glm::length(camera.position - camera.focal_point);
    const auto offset = [&](const Camera& c) { return (c.position - camera.focal_point) / far; };
    for (const glm::dvec3 direction :
         {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -3, 0)}) {
        const Camera seen = seen_from(camera, direction);
        CHECK(seen.focal_point == camera.focal_point);
        CHECK(glm::length(offset(seen)) == Approx(1));
        CHECK(glm::dot(offset(seen), glm::normalize(direction)) > 0.999);
        CHECK_NOTHROW(eye_rotation(seen));
    }
    check_same(offset(opposite(camera)), -offset(camera));
    check_same(opposite(opposite(camera)).position, camera.position);
}

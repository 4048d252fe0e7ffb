#include "render/transform.hpp"

#include <cmath>
#include <glm/glm.hpp>

namespace scanshade {

float View::depth(const ClipVertex& v) const {
    if (orthographic) return 1.0f - 0.5f * ((v.d - near) / (far - near));
    return near / v.w;
}

std::uint8_t View::outcode(const ClipVertex& v) const {
    const float g = guard_band * v.w;
    int code = 0;
    if (!(v.d >= near)) code |= out_near;
    if (!(v.d <= far)) code |= out_far;
    if (!(v.x >= -g)) code |= out_left;
    if (!(v.x <= g)) code |= out_right;
    if (!(v.y >= -g)) code |= out_top;
    if (!(v.y <= g)) code |= out_bottom;
    return static_cast<std::uint8_t>(code);
}

SnappedPoint View::snap(const ClipVertex& v) const {
    // Division rounds, so a vertex on the guard band can end up a hair outside.
    const auto to_grid = [](float x, float w) {
        const float limit = guard_band * float(subpixels);
        const float s = std::nearbyint(x / w * float(subpixels));
        return static_cast<std::int32_t>(std::min(std::max(s, -limit), limit));
    };
    return {to_grid(v.x, v.w) + width * (subpixels / 2),
            to_grid(v.y, v.w) + height * (subpixels / 2)};
}

View make_view(const Camera& camera, const DepthRange& depth, int width, int height) {
    View view{};
    view.eye = camera.position;
    view.rotation = eye_rotation(camera);
    view.orthographic = camera.projection == Projection::orthographic;
    const double half_angle = glm::radians(camera.view_angle_deg) / 2;
    const double half_height_at_1 = std::tan(half_angle);
    view.pixels_per_unit = height / 2.0 / half_height_at_1;
    if (view.orthographic)
        view.pixels_per_unit /= glm::distance(camera.focal_point, camera.position);
    view.near = static_cast<float>(depth.near);
    view.far = static_cast<float>(depth.far);
    view.width = width;
    view.height = height;
    return view;
}

ObjectView make_object_view(const Object& object, const View& view) {
    const glm::dmat3 linear = view.rotation * glm::dmat3(object.to_world);
    const glm::dvec3 origin = view.rotation * (glm::dmat3(object.to_world) * object.mesh->origin +
                                               glm::dvec3(object.to_world[3]) - view.eye);
    // From the mesh's own units; the eye looks down −z.
    const double scale[3] = {view.pixels_per_unit, -view.pixels_per_unit, -1};
    ObjectView out{};
    auto& m = out.to_clip;
    for (int r = 0; r < 3; ++r) {
        auto& row = m[std::size_t(r)];
        for (int c = 0; c < 3; ++c)
            row[std::size_t(c)] = static_cast<float>(scale[r] * linear[c][r] * object.mesh->unit);
        row[3] = static_cast<float>(scale[r] * origin[r]);
    }
    if (view.orthographic)
        m[3] = {0, 0, 0, 1};
    else
        m[3] = m[2];
    out.mirrored = glm::determinant(glm::dmat3(object.to_world)) < 0;
    return out;
}

VertexState transform_vertex(const Mesh& mesh, std::uint32_t vertex, const ObjectView& object,
                             const View& view) {
    const float x = mesh.x[vertex], y = mesh.y[vertex], z = mesh.z[vertex];
    const auto row = [&](std::size_t r) {
        const auto& m = object.to_clip[r];
        return ((m[0] * x + m[1] * y) + m[2] * z) + m[3];
    };
    VertexState out{{row(0), row(1), row(2), row(3)}};
    out.outcode = view.outcode(out.clip);
    if ((out.outcode & out_depth) != 0) return out;
    out.depth = view.depth(out.clip);
    if (out.outcode == 0) out.point = view.snap(out.clip);
    return out;
}

}  // namespace scanshade

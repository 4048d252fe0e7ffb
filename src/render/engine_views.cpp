// What the kernels of one pass read: the picture, the objects, the rays, the lights.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render/engine_pass.hpp"

namespace scanshade {

/// A point found from depth is off by about 2^-21 of its distance, and by the share of a pixel that
/// snapping moves corners. That does not matter to a light 128 times farther away.
bool Engine::Pass::position_from_depth() const {
    const View& view = frame_.view;
    // `edges` carries positions linearly on the picture: not the points that depth stands for.
    if (frame_.plan.interpolation == Interpolation::edges && !view.orthographic) return false;
    // Of a normalised scene everything is within 2.25 radii of an eye that is the origin, else
    // within one radius of the origin.
    const double reach = view.orthographic ? 4 * (double(view.far) - double(view.near))
                                           : std::max(glm::length(view.eye) + 2, 4.5);
    return state_.scene.nearest_light * 128 >= reach;
}

void Engine::Pass::make_setup_view() {
    const View& view = frame_.view;
    const RenderPlan& plan = frame_.plan;
    setup_.near = view.near, setup_.far = view.far, setup_.guard_band = guard_band;
    setup_.steepest = steepest_weight(plan);
    setup_.width = view.width, setup_.height = view.height;
    setup_.tile = tile_, setup_.tiles_x = tiles_x_;
    setup_.sample_x = frame_.sample.x, setup_.sample_y = frame_.sample.y;
    setup_.orthographic = view.orthographic;
    setup_.affine = view.orthographic || plan.interpolation == Interpolation::edges;
    setup_.cull_back = plan.cull == Cull::back;

    setup_.attributes = make_attributes(row_attributes, 3);
    setup_.quad_attributes = make_attributes(row_quad_attributes, 4);
}

/// Offsets of what something reads, from row `first` on.
Attributes Engine::Pass::make_attributes(int first, int stride) const {
    const RenderPlan& plan = frame_.plan;
    const bool points = plan.vertex_light || plan.face_light;
    const bool position =
        !(leaves_out(PlanRow::positions) && !plan.position_read) && !position_from_depth();
    Attributes at{stride, first};
    const auto take = [&](bool needed, int& offset, int values) {
        if (!needed) return;
        offset = at.rows;
        at.rows += stride * values;
    };
    const bool all_unlit = plan.unlit_materials == plan.used_materials;
    take(points || !all_unlit || !leaves_out(PlanRow::normals), at.main, 3);
    take(plan.texture || !leaves_out(PlanRow::texcoords), at.texcoord, 2);
    take(plan.texture && points, at.dark, 3);
    take(position, at.position, 3);
    return at;
}

void Engine::Pass::make_objects() {
    for (std::size_t i = 0; i < frame_.scene.objects.size(); ++i) {
        const EngineObject& engine = state_.scene.objects[i];
        const ObjectView& view = frame_.object_views[i];
        const Shading shading = frame_.plan.objects[i].shading;
        materials_.emplace_back();
        for (const std::uint32_t m : frame_.plan.objects[i].materials) {
            const bool reads_normal =
                shading == Shading::phong && shading_.materials[m].reads_normal;
            materials_.back().push_back(
                {m, shading_.materials[m].textured,
                 reads_normal || (shading != Shading::gouraud && !leaves_out(PlanRow::normals)),
                 shading_.materials[m].textured || !leaves_out(PlanRow::texcoords)});
        }
        SetupObject object{};
        object.mesh = engine.mesh;
        for (int c = 0; c < 3; ++c) object.normal[c] = engine.normal[c].data();
        object.normals_disagree = engine.normals_disagree.data();
        object.index = static_cast<std::uint32_t>(i);
        object.first_triangle = frame_.plan.objects[i].first_triangle;
        for (std::size_t r = 0; r < 4; ++r)
            std::copy(view.to_clip[r].begin(), view.to_clip[r].end(), object.to_clip[r]);
        for (int r = 0; r < 3; ++r)
            std::copy(engine.to_world[r], engine.to_world[r] + 4, object.to_world[r]);
        object.mirrored = view.mirrored;
        object.fragments = (shading != Shading::phong || setup_.attributes.position < 0) &&
                           !shading_.objects[i].scalar;
        object.shading = shading;
        objects_.push_back(object);
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) objects_[i].material = materials_[i].data();
}

void Engine::Pass::make_resolve_view() {
    ResolveView& resolve = shading_.resolve;
    const View& view = frame_.view;
    resolve.raster = {
        &state_.batches, &state_.fragments, &state_.quads,     nullptr,     objects_.data(),
        frame_.sample.x, frame_.sample.y,   view.width,        view.height, tile_,
        view.near,       view.far,          view.orthographic, false};
    resolve.attributes = setup_.attributes;
    resolve.quad_attributes = setup_.quad_attributes;
    resolve.affine = setup_.affine;
    resolve.sample_spacing = 1.0f / static_cast<float>(frame_.plan.samples_side);
    const bool needed = !(leaves_out(PlanRow::positions) && !frame_.plan.position_read);
    resolve.position_from_depth = needed && position_from_depth();
    const std::vector<ResolveObject>& objects = shading_.objects;
    const bool all_lit = std::none_of(objects.begin(), objects.end(), [](const ResolveObject& o) {
        return o.shading == Shading::phong;
    });
    resolve.shaded_alike =
        !frame_.plan.texture && (leaves_out(PlanRow::material_lookup) || all_lit);
    // Columns right, up, backward of the eye; a pixel is 1/pixels_per_unit wide at distance 1.
    const glm::dmat3 to_world = glm::transpose(view.rotation);
    const double pixel = 1 / view.pixels_per_unit;
    const double left = (frame_.sample.x / 256.0 - view.width / 2.0) * pixel;
    const double top = -(frame_.sample.y / 256.0 - view.height / 2.0) * pixel;
    const glm::dvec3 corner = to_world[0] * left + to_world[1] * top;
    const glm::dvec3 forward = -to_world[2];
    const glm::dvec3 eye = view.orthographic ? forward : view.eye;
    const glm::dvec3 ray = view.orthographic ? view.eye + corner : corner + forward;
    for (int c = 0; c < 3; ++c) {
        resolve.eye[c] = static_cast<float>(eye[c]);
        resolve.ray[c] = static_cast<float>(ray[c]);
        resolve.ray_x[c] = static_cast<float>(to_world[0][c] * pixel);
        resolve.ray_y[c] = static_cast<float>(-to_world[1][c] * pixel);
    }
}

void Engine::Pass::make_lights() {
    std::vector<LightTerm<float>>& lights = shading_.lighting.lit.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        LightTerm<float>& light = lights[i];
        light.touches = double(light.point_scale) * state_.scene.light_distance[i] <=
                        double(light.radius) * 1.01;
        light.constant = leaves_out(PlanRow::attenuation) && light.attenuation[1] == 0 &&
                         light.attenuation[2] == 0;
        if (frame_.first_sample) count(frame_.saved, PlanRow::attenuation, {light.constant, 1});
    }
    shading_.aimed_lights =
        std::any_of(lights.begin(), lights.end(), [](const LightTerm<float>& light) {
            return !light.touches && light.emission != LightEmission::uniform;
        });
    if (leaves_out(PlanRow::dark_lights)) drop_dark_lights();
}

void Engine::Pass::drop_dark_lights() {
    std::vector<LightTerm<float>>& lights = shading_.lighting.lit.lights;
    std::erase_if(lights, [](const LightTerm<float>& light) {
        return light.irradiance[0] == 0 && light.irradiance[1] == 0 && light.irradiance[2] == 0;
    });
}

/// Whether nobody but resolve asks what a subtile shows that one record covers.
bool Engine::Pass::leaves_owned() const {
    const bool lights_ask = shading_.aimed_lights || shading_.tolerance.radiance > 0 ||
                            leaves_out(PlanRow::unseen_points);
    // Values that only the scalar functions know are asked for by refs.
    const bool values_ask = (frame_.plan.texture && setup_.affine) ||
                            std::any_of(shading_.objects.begin(), shading_.objects.end(),
                                        [](const ResolveObject& object) { return object.scalar; });
    return frame_.picture.id == nullptr && !lights_ask && !values_ask;
}

}  // namespace scanshade

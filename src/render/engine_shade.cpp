#include "render/engine_shade.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/background.hpp"
#include "render/light_reach.hpp"

namespace scanshade {

TileShading::TileShading(const Frame& f)
    : frame(f),
      resolve{},
      lighting(lighting_of<float>(f)),
      surfaces(f.scene.objects.begin(), f.scene.objects.end()) {
    for (std::size_t m = 0; m < f.plan.materials.size(); ++m) {
        const bool textured = f.scene.materials[m].map_kd != nullptr;
        materials.push_back({textured, !f.plan.materials[m].unlit});
        params.push_back(to_float(f.plan.materials[m].params));
        params.back().matt = f.plan.leaves_out(PlanRow::specular) && is_matt(f.plan.materials[m]);
    }
    for (std::size_t i = 0; i < f.scene.objects.size(); ++i) {
        const Mesh& mesh = *f.scene.objects[i].mesh;
        const bool patches = f.plan.interpolation == Interpolation::patch && mesh.has_quads;
        objects.push_back({f.plan.objects[i].shading, patches});
    }
    tolerance = light_tolerance(f.plan);
    aimed_lights = f.plan.narrow_lights > 0;
    resolve.objects = objects.data();
    resolve.materials = materials.data();
}

TileShader::TileShader(const TileShading& shading)
    : shading_(shading),
      surface_{},
      face_(shading.frame, shading.surfaces, events),
      mixed_{},
      lit_(shading.lighting.lit) {}

std::uint64_t TileShader::shade(int x, int y, const TileBuffer& tile) {
    choose_lights(x, y, tile);
    std::uint64_t seen = 0;
    for (int s = 0; s < TileBuffer::subtiles; ++s) {
        if (!shading_.resolve.raster.has_subtile(s)) continue;
        const int sx = x + (s % 4) * subtile_side, sy = y + (s / 4) * subtile_side;
        if (sx >= shading_.frame.picture.width || sy >= shading_.frame.picture.height) continue;
        if (find_surface(x, y, s, tile)) {
            cover(shading_.frame.picture, sx, sy);
            shade_subtile(x, y, s, tile);
            seen += surface_.covered;
        } else {
            saved[PlanRow::unchanged_background] +=
                draw_background(shading_.frame.picture, sx, sy, subtile_side);
        }
    }
    if (shading_.frame.picture.id != nullptr && shading_.frame.first_sample)
        write_visibility(x, y, tile);
    return seen;
}

bool TileShader::find_surface(int x, int y, int subtile, const TileBuffer& tile) {
    if (!tile.shows(subtile)) return false;
    resolve_subtile(shading_.resolve, x, y, subtile, tile, surface_);
    return surface_.covered > 0;
}

void TileShader::shade_subtile(int x, int y, int subtile, const TileBuffer& tile) {
    if (!surface_.open.empty()) fill_open(x, y, tile);
    if (shading_.frame.plan.texture) look_up_textures(x, y, tile);
    illuminate();
    const std::uint64_t black = write_radiance(shading_.frame.picture, x, y, subtile, surface_);
    if (black > 0) events.add(Event::not_finite, black);
}

// ---- samples that the kernels leave open

void TileShader::fill_open(int x, int y, const TileBuffer& tile) {
    for (const Surface::Open& open : surface_.open) {
        begin_face(open.at, tile);
        if (face_.texture != nullptr) surface_.texstep[0][open.at] = NAN;
        fill_values(open, sample_of(x, y, open.at));
    }
}

/// The sample of an element of the surface's arrays.
SnappedPoint TileShader::sample_of(int x, int y, std::uint32_t element) const {
    const int at = tile_at(element), block = at / block_samples, in_block = at % block_samples;
    constexpr int columns = tile_side / block_side;
    return sample_point(x + (block % columns) * block_side + in_block % block_side,
                        y + (block / columns) * block_side + in_block / block_side,
                        shading_.frame.sample);
}

int TileShader::tile_at(std::uint32_t element) const {
    const std::uint32_t lanes = shading_.resolve.raster.batches->lanes();
    return surface_.tile_at[element / lanes] + int(element % lanes);
}

void TileShader::begin_face(std::uint32_t element, const TileBuffer& tile) {
    const std::uint32_t id = ref_id(shading_.resolve.raster, tile.ref[tile_at(element)]);
    if (face_.begin(id) && face_.shading != Shading::phong) light_corners();
}

void TileShader::fill_values(const Surface::Open& open, SnappedPoint p) {
    const auto put = [&](float(&to)[3][subtile_samples], float a, float b, float c) {
        to[0][open.at] = a, to[1][open.at] = b, to[2][open.at] = c;
    };
    if (face_.shading == Shading::flat && face_.texture == nullptr) {
        const Rgb<float>& lit = face_.radiance[0];
        return put(surface_.radiance, lit.r, lit.g, lit.b);
    }
    const Place<float> at = face_.place(p);
    if (face_.shading == Shading::phong) {
        const Vec3<float> n = face_.normal(at);
        put(surface_.normal, n.x, n.y, n.z);
        if (open.zero_normal) return;
        const Vec3<float> P = face_.position(at);
        put(surface_.position, P.x, P.y, P.z);
    } else {
        const Rgb<float> lit = face_.lit(at);
        put(surface_.radiance, lit.r, lit.g, lit.b);
        if (face_.texture != nullptr) {
            const Rgb<float> dark = face_.dark(at);
            put(surface_.dark, dark.r, dark.g, dark.b);
        }
    }
    if (face_.texture == nullptr) return;
    const Vec3<float> uv = face_.texcoord(at);
    surface_.texcoord[0][open.at] = uv.x;
    surface_.texcoord[1][open.at] = uv.y;
}

Rgb<float> TileShader::light_point(const Vec3<float>& P, const Vec3<float>& n, float albedo) {
    const ResolvedMaterial& material = shading_.frame.plan.materials[face_.material];
    Batch<float> batch;
    batch.vectors = batch.textured = true;
    batch.push(P, n, 0);
    batch.push_albedo({albedo, albedo, albedo});
    batch.illuminate(material, shading_.lighting.of(material), events);
    return {batch.radiance[0][0], batch.radiance[1][0], batch.radiance[2][0]};
}

/// Gouraud and flat faces that only the scalar functions carry.
void TileShader::light_corners() {
    const ObjectSurface& surface = shading_.surfaces[face_.drawn.object];
    const float side = face_.drawn.back ? -1.0f : 1.0f;
    const auto add = [&](const glm::dvec3& position, const glm::dvec3& normal) {
        const Vec3<float> P = to_vec3<float>(position), n = to_vec3<float>(normal) * side;
        face_.radiance.push_back(light_point(P, n, 1));
        if (face_.texture != nullptr) face_.unreflecting.push_back(light_point(P, n, 0));
    };
    if (face_.shading == Shading::flat)
        return add(surface.face_centre(face_.drawn.face), surface.face_normal(face_.drawn.face));
    for (const std::uint32_t v : face_.vertex)
        add(surface.vertex_position(v), surface.vertex_normal(v));
}

// ---- light

void TileShader::look_up_textures(int x, int y, const TileBuffer& tile) {
    const std::uint32_t lanes = shading_.resolve.raster.batches->lanes();
    for (const Surface::Part& part : surface_.parts()) {
        const Texture* texture = shading_.frame.scene.materials[part.material].map_kd.get();
        if (texture == nullptr) continue;
        for (std::uint32_t bits = part.lanes; bits != 0; bits &= bits - 1) {
            const std::uint32_t at = part.vector * lanes + std::uint32_t(__builtin_ctz(bits));
            const auto& step = surface_.texstep;
            TextureGradient gradient = {step[0][at], step[1][at], step[2][at], step[3][at]};
            if (std::isnan(gradient.du_dx)) {
                begin_face(at, tile);
                gradient = face_.gradient(sample_of(x, y, at));
            }
            const std::array<float, 3> albedo =
                texture->sample(surface_.texcoord[0][at], surface_.texcoord[1][at], gradient);
            for (std::size_t c = 0; c < 3; ++c) {
                surface_.albedo[c][at] = albedo[c];
                // Reflected light is linear in the albedo, so two lit values give it at any.
                float& L = surface_.radiance[c][at];
                if (part.lit) L = surface_.dark[c][at] + albedo[c] * (L - surface_.dark[c][at]);
            }
        }
    }
}

/// Spot and cosine lights that shine past everything in the tile add exactly 0 there.
void TileShader::choose_lights(int x, int y, const TileBuffer& tile) {
    const RenderPlan& plan = shading_.frame.plan;
    const bool dark = plan.leaves_out(PlanRow::dark_lights);
    if (dark) saved[PlanRow::dark_lights] += {plan.dark_lights, plan.light_count};
    const bool aimed = dark && shading_.aimed_lights;
    if (!aimed && shading_.tolerance.radiance == 0) return;
    const TileSphere sphere = tile_sphere(shading_.resolve, x, y, tile);
    lit_.lights.clear();
    for (const LightTerm<float>& light : shading_.lighting.lit.lights)
        if (!aimed || light.touches || reaches(light, sphere))
            lit_.lights.push_back(light);
        else
            ++saved[PlanRow::dark_lights].saved;
    if (shading_.tolerance.radiance > 0) drop_tolerated(sphere);
}

/// The weakest lights of the tile, as long as they add no more than the tolerance together.
void TileShader::drop_tolerated(const TileSphere& sphere) {
    std::vector<LightTerm<float>>& lights = lit_.lights;
    std::vector<std::pair<double, std::size_t>> most;  // bound, light
    for (std::size_t i = 0; i < lights.size(); ++i)
        most.emplace_back(most_radiance(lights[i], sphere, shading_.tolerance), i);
    std::sort(most.begin(), most.end());
    double sum = 0;
    std::vector<bool> dropped(lights.size());
    for (const auto& [bound, i] : most) {
        if (!((sum += bound) <= shading_.tolerance.radiance)) break;
        dropped[i] = true;
        ++tolerated_lights;
    }
    // In their order: sums keep theirs.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!dropped[i]) lights[kept++] = lights[i];
    lights.resize(kept);
}

const Lighting<float>& TileShader::lighting_for(const ResolvedMaterial& material) const {
    return material.unlit ? shading_.lighting.unlit : lit_;
}

void TileShader::illuminate() {
    const RenderPlan& plan = shading_.frame.plan;
    if (plan.leaves_out(PlanRow::material_lookup) && surface_.vectors > 0) {
        saved[PlanRow::material_lookup] += {1, 1};
        float* radiance[3] = {surface_.radiance[0], surface_.radiance[1], surface_.radiance[2]};
        return illuminate_all(surface_.part[0].material, radiance);
    }
    materials_.clear();
    bool lit = false;
    for (const Surface::Part& part : surface_.parts()) {
        lit |= part.lit;
        if (!part.lit &&
            std::find(materials_.begin(), materials_.end(), part.material) == materials_.end())
            materials_.push_back(part.material);
    }
    float* radiance[3] = {surface_.radiance[0], surface_.radiance[1], surface_.radiance[2]};
    if (materials_.size() == 1 && !lit) return illuminate_all(materials_[0], radiance);
    const std::uint32_t lanes = shading_.resolve.raster.batches->lanes();
    float* mixed[3] = {mixed_[0], mixed_[1], mixed_[2]};
    for (const std::uint32_t material : materials_) {
        illuminate_all(material, mixed);
        for (const Surface::Part& part : surface_.parts()) {
            if (part.lit || part.material != material) continue;
            for (std::uint32_t bits = part.lanes; bits != 0; bits &= bits - 1) {
                const std::uint32_t at = part.vector * lanes + std::uint32_t(__builtin_ctz(bits));
                for (int c = 0; c < 3; ++c) surface_.radiance[c][at] = mixed_[c][at];
            }
        }
    }
}

void TileShader::illuminate_all(std::uint32_t number, float* (&radiance)[3]) {
    const ResolvedMaterial& material = shading_.frame.plan.materials[number];
    SurfaceSpan<float> span{};
    for (int c = 0; c < 3; ++c) {
        span.position[c] = surface_.position[c];
        span.normal[c] = surface_.normal[c];
        span.albedo[c] = shading_.materials[number].textured ? surface_.albedo[c] : nullptr;
        span.radiance[c] = radiance[c];
    }
    span.counted = surface_.counted;
    span.count = surface_.vectors * shading_.resolve.raster.batches->lanes();
    const SpanEvents seen =
        material.brdf->illuminate_simd(span, lighting_for(material), shading_.params[number]);
    if (seen.light_at_surface > 0) events.add(Event::light_at_surface, seen.light_at_surface);
}

void TileShader::write_visibility(int x, int y, const TileBuffer& tile) const {
    const PictureView& picture = shading_.frame.picture;
    const int side = shading_.resolve.raster.tile;
    for (int row = 0; row < std::min(side, picture.height - y); ++row)
        for (int column = 0; column < std::min(side, picture.width - x); ++column) {
            const int at = tile_index(column, row);
            const int subtile = (row / subtile_side) * 4 + column / subtile_side;
            const bool seen = tile.written[subtile] && tile.ref[at] != no_ref;
            const std::size_t to =
                std::size_t(y + row) * std::size_t(picture.width) + std::size_t(x + column);
            picture.depth[to] = seen ? tile.depth[at] : 0.0f;
            picture.id[to] =
                seen ? ref_id(shading_.resolve.raster, tile.ref[at]) : Framebuffer::no_triangle;
        }
}

}  // namespace scanshade

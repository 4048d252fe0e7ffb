// What the hard scenes are put together from.
#pragma once

#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "scanshade/report/subject.hpp"

namespace scanshade {

inline constexpr int case_width = 128, case_height = 96;

/// A scene that is filled part by part.
class SceneBuilder {
public:
    /// Ambient light, and a picture of 128 × 96 pixels.
    SceneBuilder();

    /// `degrees`: how high the picture is.
    SceneBuilder& camera(const glm::dvec3& position, const glm::dvec3& focal_point,
                         double degrees = 30);
    /// At the origin, looks down −z, 90° high: pixel_point() tells what it shows where.
    SceneBuilder& pixel_camera(double near, double far);
    SceneBuilder& depth(double near, double far);

    /// A directional light from the front left above.
    SceneBuilder& front_light();
    SceneBuilder& light(const Light& light);

    /// Objects get the material that was added last.
    SceneBuilder& material(const Material& material);
    SceneBuilder& object(const PolygonSoup& soup, const glm::dmat4& to_world = glm::dmat4(1),
                         const NormalOptions& normals = {});
    ReportInput take() { return std::move(input_); }

private:
    ReportInput input_;
};

/// The point in distance w that the pixel camera shows at (px, py).
glm::dvec3 pixel_point(double px, double py, double w);

/// Blinn-Phong in that colour.
Material coloured(double red, double green, double blue);

/// A palette of colours that differ well.
Material palette(std::size_t number);

/// A sphere, torus, ... of the table of shapes.
PolygonSoup shape(std::string_view name, int tessellation);

/// Adds a face with corners of its own. `normals`: none, or one for each corner.
void add_face(PolygonSoup& soup, const std::vector<glm::dvec3>& corners,
              const std::vector<glm::dvec3>& normals = {});

Light point_light(const glm::dvec3& position, double intensity, const glm::dvec3& attenuation);
Light directional_light(const glm::dvec3& direction, double intensity);

}  // namespace scanshade

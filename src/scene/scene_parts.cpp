#include "scene/scene_parts.hpp"

#include <algorithm>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scanshade/scene/obj.hpp"
#include "scanshade/scene/shapes.hpp"
#include "scene/limits.hpp"
#include "scene/mesh_parts.hpp"
#include "scene/up_axis.hpp"

namespace scanshade {

Camera read_camera(const TomlReader& reader, const Camera& framed) {
    reader.allow_only(
        {"position", "focal_point", "view_up", "view_angle", "projection", "near", "far"});
    constexpr std::string_view projections[] = {"perspective", "orthographic"};
    Camera camera = framed;
    camera.position = reader.point("position").value_or(camera.position);
    camera.focal_point = reader.point("focal_point").value_or(camera.focal_point);
    camera.view_up = reader.point("view_up").value_or(camera.view_up);
    camera.view_angle_deg =
        reader.real_between("view_angle", min_view_angle_deg, max_view_angle_deg)
            .value_or(camera.view_angle_deg);
    camera.projection =
        static_cast<Projection>(reader.choice("projection", projections).value_or(0));
    camera.near = reader.real_between("near", 1e-30, 1e30);
    camera.far = reader.real_between("far", 1e-30, 1e30);
    if (camera.near && camera.far && *camera.near >= *camera.far)
        throw reader.error(*reader.node("far"), "far must be larger than near");
    try {
        eye_rotation(camera);
    } catch (const Error& e) {
        throw reader.error(e.what());
    }
    return camera;
}

Light read_light(const TomlReader& reader) {
    reader.allow_only({"type", "position", "direction", "intensity", "attenuation", "cutoff",
                       "penumbra", "radius"});
    Light light;
    const auto kind = reader.choice("type", light_kind_names());
    if (!kind)
        throw reader.error(
            "[[light]] has no type; give type = \"point\", \"directional\", "
            "\"spot\" or \"cosine\"");
    light.kind = static_cast<LightKind>(*kind);
    light.position = reader.point("position").value_or(light.position);
    light.direction = reader.point("direction").value_or(light.direction);
    if (light.direction == glm::dvec3(0))
        throw reader.error(*reader.node("direction"),
                           "the direction of a light must not be 0, 0, 0");
    light.intensity = reader.radiance("intensity").value_or(light.intensity);
    light.attenuation = reader.radiance("attenuation").value_or(light.attenuation);
    if (light.attenuation == glm::dvec3(0))
        throw reader.error(*reader.node("attenuation"),
                           "attenuation = [c, l, q] must not be all 0; [1, 0, 0] is none");
    light.cutoff_deg = reader.real_between("cutoff", 1e-3, 180).value_or(light.cutoff_deg);
    light.penumbra_deg = reader.real_between("penumbra", 0, light.cutoff_deg).value_or(0);
    light.radius = reader.real_between("radius", 1e-30, 1e30);
    return light;
}

Material read_material(const TomlReader& reader, const std::filesystem::path& folder,
                       SceneFiles& files) {
    Material material;
    const auto name = reader.text("name");
    if (!name || name->empty()) throw reader.error("[[material]] has no name; give name = \"...\"");
    material.name = *name;
    material.place = reader.place(reader.table());
    material.brdf = reader.text("brdf").value_or(material.brdf);
    if (const auto map = reader.text("map_kd")) {
        try {
            material.map_file = files.find(folder, *map);
            material.map_kd = files.texture(material.map_file);
        } catch (const Error& e) {
            throw reader.error(*reader.node("map_kd"), fmt::format("map_kd: {}", e.what()));
        }
    }
    if (reader.table().size() > max_parameters)
        throw reader.error(fmt::format("[[material]] has {} keys; at most {} are read",
                                       reader.table().size(), max_parameters));
    // Every other key is a parameter; its name is checked when the model is known for good.
    for (const auto& [key, node] : reader.table()) {
        if (key == "name" || key == "brdf" || key == "map_kd") continue;
        if (const toml::value<std::string>* word = node.as_string()) {
            material.set_word(key.str(), word->get(), reader.place(node));
            continue;
        }
        std::vector<double> values;
        if (const toml::array* array = node.as_array())
            for (const toml::node& element : *array)
                values.push_back(reader.number(element, key.str(), "one number or three"));
        else
            values.push_back(reader.number(node, key.str(), "one number or three"));
        if (values.size() != 1 && values.size() != 3)
            throw reader.error(node, fmt::format("{} takes one number or three, not {}", key.str(),
                                                 values.size()));
        material.set(key.str(), std::move(values), reader.place(node));
    }
    return material;
}

namespace {

/// scale, then rotate about x, y, z, then translate; or a matrix given by rows.
glm::dmat4 read_placement(const TomlReader& reader) {
    if (const auto m = reader.reals("matrix", 16)) {
        for (const std::string_view key : {"scale", "rotate", "translate"})
            if (reader.has(key))
                throw reader.error(*reader.node("matrix"),
                                   fmt::format("give either matrix or {}, not both", key));
        glm::dmat4 matrix(0);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                matrix[column][row] = (*m)[static_cast<std::size_t>(4 * row + column)];
        if (glm::row(matrix, 3) != glm::dvec4(0, 0, 0, 1))
            throw reader.error(*reader.node("matrix"), "the last row of matrix must be 0, 0, 0, 1");
        return matrix;
    }
    const glm::dvec3 scale = reader.vector_or_number("scale").value_or(glm::dvec3(1));
    const glm::dvec3 rotate = glm::radians(reader.vector("rotate").value_or(glm::dvec3(0)));
    glm::dmat4 matrix =
        glm::translate(glm::dmat4(1), reader.point("translate").value_or(glm::dvec3(0)));
    matrix = glm::rotate(matrix, rotate.z, {0, 0, 1});
    matrix = glm::rotate(matrix, rotate.y, {0, 1, 0});
    matrix = glm::rotate(matrix, rotate.x, {1, 0, 0});
    return glm::scale(matrix, scale);
}

/// Whether the axes of the object stay apart, however long each becomes.
bool invertible(const glm::dmat4& matrix) {
    glm::dmat3 axes;
    for (int i = 0; i < 3; ++i)
        axes[i] = safe_normalize(glm::dvec3(matrix[i])).value_or(glm::dvec3(0));
    return std::abs(glm::determinant(axes)) > 1e-12;
}

}  // namespace

const ObjectReader::Source& ObjectReader::file_source(const TomlReader& reader,
                                                      const std::string& name) {
    const auto [at, is_new] = sources_.try_emplace("mesh " + name);
    Source& source = at->second;
    if (!is_new) return source;
    ObjFile file;
    try {
        file = load_obj(files_.find(folder_, name), files_, settings_.mtl_ambient);
    } catch (const Error& e) {
        Error here(e.code(), fmt::format("mesh: {}", e.what()));
        throw here.at(reader.place(*reader.node("mesh")));
    }
    source.mesh = std::make_shared<Mesh>(build_mesh(file.soup, settings_.normals));
    source.file = folder_ / name;
    if (source.mesh->face_count() == 0)
        throw Error(Errc::format, fmt::format("mesh: {} has no face that can be drawn",
                                              (folder_ / name).string()))
            .at(reader.place(*reader.node("mesh")));
    add_materials(reader, source, std::move(file.materials));
    scene_.warnings.insert(scene_.warnings.end(), file.warnings.begin(), file.warnings.end());
    scene_.events += file.events;
    scene_.events += source.mesh->events;
    return source;
}

void ObjectReader::add_materials(const TomlReader& reader, Source& source,
                                 std::vector<Material> materials) {
    if (scene_.materials.size() + materials.size() > max_materials)
        throw reader.error(
            fmt::format("the scene has more than {} materials by here", max_materials));
    for (Material& material : materials) {
        source.materials.push_back(static_cast<std::uint32_t>(scene_.materials.size()));
        scene_.materials.push_back(std::move(material));
    }
}

const ObjectReader::Source& ObjectReader::shape_source(const TomlReader& reader,
                                                       const std::string& name) {
    std::vector<std::string_view> names;
    for (const ShapeInfo& info : all_shapes()) names.push_back(info.name);
    const ShapeInfo& shape = all_shapes()[*reader.choice("shape", names)];
    const double n = reader.real_between("tessellation", 1, shape.max_tessellation)
                         .value_or(shape.default_tessellation);
    if (n != std::floor(n))
        throw reader.error(*reader.node("tessellation"), "tessellation takes a whole number");
    const auto [at, is_new] = sources_.try_emplace(fmt::format("shape {} {}", name, n));
    Source& source = at->second;
    if (!is_new) return source;
    source.mesh = make_shape_mesh(shape, static_cast<int>(n), settings_.normals);
    source.shape = name;
    source.tessellation = static_cast<int>(n);
    add_materials(reader, source, shape.materials());
    scene_.events += source.mesh->events;
    return source;
}

std::uint32_t ObjectReader::material_index(const TomlReader& reader, const toml::node& at) const {
    const toml::value<std::string>* text = at.as_string();
    if (text == nullptr) throw reader.error(at, "a material is named by a text in quotes");
    const std::string& name = text->get();
    if (const auto found = names_.find(name); found != names_.end())
        return static_cast<std::uint32_t>(found->second);
    std::vector<std::string_view> names;
    for (const auto& [known, number] : names_) names.push_back(known);
    throw reader.error(at, fmt::format("no [[material]] has the name '{}'{}", name,
                                       names.empty() ? "" : suggestion(name, names)));
}

void ObjectReader::read_materials(const TomlReader& reader, Object& object) const {
    if (const toml::node* one = reader.node("material"))
        std::fill(object.materials.begin(), object.materials.end(), material_index(reader, *one));
    const toml::node* several = reader.node("materials");
    if (several == nullptr) return;
    if (reader.has("material"))
        throw reader.error(*several, "give either material or materials, not both");
    const toml::array* names = several->as_array();
    if (names == nullptr || names->size() != object.materials.size())
        throw reader.error(*several, fmt::format("materials takes {} names, one for each material "
                                                 "of the mesh",
                                                 object.materials.size()));
    for (std::size_t i = 0; i < names->size(); ++i)
        object.materials[i] = material_index(reader, *names->get(i));
}

void ObjectReader::read(const TomlReader& reader) {
    reader.allow_only({"mesh", "shape", "tessellation", "scale", "rotate", "translate", "matrix",
                       "material", "materials", "shading"});
    const auto mesh = reader.text("mesh"), shape = reader.text("shape");
    if (mesh.has_value() == shape.has_value())
        throw reader.error("[[object]] takes either mesh = \"file.obj\" or shape = \"...\"");
    if (mesh && reader.has("tessellation"))
        throw reader.error(*reader.node("tessellation"),
                           "tessellation is for shapes, not for a mesh");
    const Source& source = mesh ? file_source(reader, *mesh) : shape_source(reader, *shape);
    Object object;
    object.mesh = source.mesh;
    object.materials = source.materials;
    object.mesh_file = source.file, object.shape = source.shape;
    object.tessellation = source.tessellation;
    read_materials(reader, object);
    if (const auto shading = reader.choice("shading", shading_names()))
        object.shading = static_cast<Shading>(*shading);
    object.to_world = read_placement(reader);
    if (mesh) object.to_world *= up_rotation(settings_.up);
    for (int i = 0; i < 4; ++i)
        if (!(max_abs(glm::dvec3(object.to_world[i])) <= max_coordinate))
            throw reader.error("the object's scale or matrix has numbers above 1e100");
    if (!invertible(object.to_world))
        throw reader.error("the object's scale or matrix flattens it; no factor may be 0");
    triangles_ += object.mesh->triangle_count();
    if (triangles_ > max_scene_triangles)
        throw reader.error(
            fmt::format("the scene has more than {} triangles by here; use fewer "
                        "objects or a lower tessellation",
                        max_scene_triangles));
    scene_.objects.push_back(std::move(object));
}

}  // namespace scanshade

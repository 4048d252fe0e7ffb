// The OBJ loader. The library splits statements into numbers; what it leaves open is decided
// here: it takes "nan" for 0, lets indices wrap and numbers overflow, knows neither line numbers
// nor continued lines, and its own triangulation drops concave faces far from the origin.
#include "scanshade/scene/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <istream>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scene/limits.hpp"
#include "scene/obj_mtl.hpp"
#include "scene/obj_text.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

namespace scanshade {
namespace {

/// A word must be a number that a double can hold; the library takes anything else for 0.
void check_real(std::string_view word) {
    if (parse_real(word)) return;
    const std::string text(word.substr(0, 64));
    const bool decimal = word.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
    const std::string whole(word);
    char* stop = nullptr;
    const double value = std::strtod(whole.c_str(), &stop);  // knows too large from too small
    if (!decimal || *stop != '\0')
        throw Error(Errc::format,
                    fmt::format("'{}' is not a number; numbers look like -1.5e3", text));
    if (!std::isfinite(value))
        throw Error(Errc::format, fmt::format("'{}' is too large for a number", text));
}

/// What the library made of it: "0e999" is NaN there.
void check_finite(const glm::dvec3& v) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        throw Error(Errc::format, "a number is not finite; coordinates must be");
}

void check_reals(const Statement& s, int least) {
    std::string_view rest = s.arguments;
    int count = 0;
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest), ++count)
        check_real(word);
    if (count < least)
        throw Error(Errc::format, fmt::format("'{}' has {} numbers; it needs at least {}",
                                              s.keyword, count, least));
}

/// A corner is v, v/vt, v//vn or v/vt/vn with integers.
void check_corner(std::string_view word) {
    std::string_view rest = word;
    for (int part = 0; part < 3; ++part) {
        const std::string_view number = rest.substr(0, rest.find('/'));
        const std::optional<long long> value = parse_integer(number);
        const bool absent = number.empty() && part > 0;
        if (!absent && (!value || *value != int(*value))) break;
        rest.remove_prefix(number.size());
        if (rest.empty()) return;
        rest.remove_prefix(1);
    }
    throw Error(Errc::format, fmt::format("'{}' is not a corner of a face; corners are v, v/vt, "
                                          "v//vn or v/vt/vn with integers",
                                          word.substr(0, 64)));
}

/// Vertices, texture vertices or vertex normals: what faces refer to by number.
class Numbering {
public:
    explicit Numbering(const char* name) : name_(name) {}

    /// Index for a number of the file when `count` things are known. Negative numbers count back
    /// from there; positive ones may refer to what comes later.
    std::uint32_t index(int number, std::size_t count, long line) {
        const std::int64_t index =
            number > 0 ? number - std::int64_t{1} : std::int64_t(count) + number;
        if (number == 0 || index < 0) throw refusal(number, count, " so far");
        const std::size_t known = ahead_.empty() ? count : std::max(count, ahead_.back().number);
        if (number > 0 && std::size_t(number) > known)
            ahead_.push_back({std::size_t(number), line});
        return std::uint32_t(index);
    }

    /// At the end of the file: no face may have referred to more than there is.
    void check(std::size_t count, const std::string& file) const {
        for (const Reference& r : ahead_)
            if (r.number > count) throw refusal(std::int64_t(r.number), count, "").at(file, r.line);
    }

private:
    struct Reference {
        std::size_t number;
        long line;
    };

    Error refusal(std::int64_t number, std::size_t count, const char* so_far) const {
        return {Errc::format,
                fmt::format("face refers to {0} {1}, but the file has {2}{3}; {0} numbers start "
                            "at 1, or at -1 backwards",
                            name_, number, count, so_far)};
    }

    const char* name_;
    std::vector<Reference> ahead_;  // to what had not come yet, each larger than the one before
};

class ObjReader {
public:
    ObjReader(const std::filesystem::path& path, SceneFiles& files, bool mtl_ambient)
        : path_(path), libraries_(file_, files, mtl_ambient) {
        file_.soup.name = path.stem().string();
    }

    ObjFile read() {
        const std::string text = read_text(path_, max_obj_bytes);
        StatementStream statements(text, [this](const Statement& s) { visit(s); });
        std::istream stream(&statements);
        stream.exceptions(std::ios::badbit);  // errors of visit() come through
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, double x, double y, double z, double) {
            static_cast<ObjReader*>(self)->add_position({x, y, z});
        };
        callbacks.normal_cb = [](void* self, double x, double y, double z) {
            check_finite({x, y, z});
            static_cast<ObjReader*>(self)->file_.soup.normals.emplace_back(x, y, z);
        };
        callbacks.texcoord_cb = [](void* self, double u, double v, double) {
            check_finite({u, v, 0});
            static_cast<ObjReader*>(self)->file_.soup.texcoords.emplace_back(u, v);
        };
        callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<ObjReader*>(self)->add_face({corners, std::size_t(count)});
        };
        try {
            tinyobj::LoadObjWithCallback(stream, callbacks, this);
        } catch (Error& error) {
            throw error.at(path_.string(), line_);
        }
        finish();
        return std::move(file_);
    }

private:
    /// Sees each statement before the library does.
    void visit(const Statement& s) {
        line_ = s.line;
        if (s.keyword == "v" || s.keyword == "vn") return check_reals(s, 3);
        if (s.keyword == "vt") return check_reals(s, 1);
        if (s.keyword == "f") return check_face(s);
        if (s.keyword == "s") return set_smoothing(s.arguments);
        if (s.keyword == "usemtl") return use_material(std::string(trimmed(s.arguments)));
        if (s.keyword == "mtllib") return read_libraries(trimmed(s.arguments));
    }

    void check_face(const Statement& s) {
        std::string_view rest = s.arguments;
        std::size_t count = 0;
        for (auto word = next_word(rest); !word.empty(); word = next_word(rest), ++count)
            check_corner(word);
        if (count > max_face_corners)
            throw Error(Errc::format, fmt::format("face has {} corners; at most {} are read", count,
                                                  max_face_corners));
        if (count == 0) add_face({});  // the library says nothing of it
    }

    void set_smoothing(std::string_view arguments) {
        smoothing_given_ = true;
        const std::string_view word = next_word(arguments);
        smoothing_ = word == "on" ? 1 : 0;
        std::from_chars(word.data(), word.data() + word.size(), smoothing_);
    }

    void use_material(const std::string& name) {
        const auto next = std::uint32_t(material_numbers_.size());
        if (next == max_materials && !material_numbers_.contains(name))
            throw Error(Errc::format,
                        fmt::format("the file uses more than {} materials", max_materials));
        material_ = material_numbers_.try_emplace(name, next).first->second;
    }

    /// One name, which may have blanks in it, or several.
    void read_libraries(std::string_view names) {
        std::string spelled(names);
        std::replace(spelled.begin(), spelled.end(), '\\', '/');
        const std::filesystem::path folder = path_.parent_path();
        std::error_code ignored;
        if (std::filesystem::exists(folder / spelled, ignored))
            return libraries_.read(folder, spelled);
        std::string_view rest = spelled;
        for (auto name = next_word(rest); !name.empty(); name = next_word(rest))
            libraries_.read(folder, std::string(name));
    }

    void add_position(const glm::dvec3& p) {
        for (const double c : {p.x, p.y, p.z})
            if (!(std::abs(c) <= max_coordinate))
                throw Error(Errc::format, fmt::format("the coordinate {} is too large; at most {} "
                                                      "can be drawn",
                                                      c, max_coordinate));
        file_.soup.positions.push_back(p);
    }

    void add_face(std::span<const tinyobj::index_t> corners) {
        PolygonSoup& soup = file_.soup;
        for (const tinyobj::index_t& c : corners) {
            const auto optional = [&](Numbering& numbers, int number, std::size_t count) {
                return number == 0 ? no_index : numbers.index(number, count, line_);
            };
            soup.corners.push_back(
                {vertices_.index(c.vertex_index, soup.positions.size(), line_),
                 optional(texture_vertices_, c.texcoord_index, soup.texcoords.size()),
                 optional(normals_, c.normal_index, soup.normals.size())});
        }
        soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
        soup.face_smoothing.push_back(smoothing_);
        if (material_ == no_index) use_material("");
        soup.face_material.push_back(material_);
    }

    void finish() {
        PolygonSoup& soup = file_.soup;
        vertices_.check(soup.positions.size(), path_.string());
        texture_vertices_.check(soup.texcoords.size(), path_.string());
        normals_.check(soup.normals.size(), path_.string());
        if (!smoothing_given_) soup.face_smoothing.clear();
        make_materials();
    }

    void make_materials() {
        std::vector<std::uint64_t> faces(material_numbers_.size(), 0);
        for (const std::uint32_t m : file_.soup.face_material) ++faces[m];
        file_.materials.resize(std::max<std::size_t>(1, faces.size()));
        for (const auto& [name, number] : material_numbers_) {
            Material& material = file_.materials[number];
            if (libraries_.defines(name)) {
                material = libraries_.make(name);
            } else if (!name.empty() && faces[number] > 0) {
                material.name = name;
                file_.events.add(Event::missing_material, faces[number]);
                file_.warnings.push_back(fmt::format(
                    "{}: no material library defines '{}'; the default material is drawn",
                    path_.string(), name));
            }
        }
        if (const auto count = file_.events[Event::transparency_ignored])
            file_.warnings.push_back(fmt::format("{}: materials with d < 1 are drawn opaque: {}",
                                                 path_.string(), count));
    }

    std::filesystem::path path_;
    ObjFile file_;
    MaterialLibraries libraries_;
    Numbering vertices_{"vertex"}, texture_vertices_{"texture vertex"}, normals_{"vertex normal"};
    std::map<std::string, std::uint32_t> material_numbers_;  // by name, in the order of use
    std::uint32_t material_ = no_index;
    std::uint32_t smoothing_ = 0;
    bool smoothing_given_ = false;
    long line_ = 0;
};

}  // namespace

ObjFile load_obj(const std::filesystem::path& path, SceneFiles& files, bool mtl_ambient) {
    return ObjReader(path, files, mtl_ambient).read();
}

ObjFile load_obj(const std::filesystem::path& path, bool mtl_ambient) {
    SceneFiles files(path.parent_path(), false);
    return load_obj(path, files, mtl_ambient);
}

}  // namespace scanshade

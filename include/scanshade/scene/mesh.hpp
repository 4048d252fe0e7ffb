// Polygon meshes: as a file gives them, and as the renderers read them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scanshade/base/events.hpp"

namespace scanshade {

struct ClusterCache;  // scene/clusters.hpp
struct ShapeInfo;     // scene/shapes.hpp

inline constexpr std::uint32_t no_index = 0xffffffffu;

/// Polygons with an index for each attribute, in double: what loaders and shapes make.
/// Indices are in range (whoever fills a soup checks its input); no_index: attribute absent.
struct PolygonSoup {
    struct Corner {
        std::uint32_t position, texcoord, normal;
    };
    std::string name;
    std::vector<glm::dvec3> positions;  // finite
    std::vector<glm::dvec2> texcoords;  // finite; v up, as OBJ has it
    std::vector<glm::dvec3> normals;    // finite, any length
    std::vector<std::uint32_t> face_begin{
        0};                       // face f has corners [face_begin[f], face_begin[f+1])
    std::vector<Corner> corners;  // counter-clockwise seen from the front
    std::vector<std::uint32_t> face_material;  // per face: index into the materials beside the soup
    std::vector<std::uint32_t> face_smoothing;  // per face: smoothing group, 0: off; may be empty

    std::size_t face_count() const { return face_begin.size() - 1; }
};

/// Where vertex normals come from.
enum class NormalSource {
    automatic,  // the file's; else its smoothing groups; else equation (C1) with the crease angle
    average,    // (C1): normalised sum of unit face normals
    area,       // the same, weighted by face area
    angle,      // the same, weighted by the corner's angle
};

struct NormalOptions {
    NormalSource source = NormalSource::automatic;
    double crease_deg = 60;  // [0, 180]; faces that meet at a larger angle do not share a normal;
                             // 180: never split
};

/// A mesh as renderers read it: structure of arrays, one vertex for each distinct combination of
/// position, normal and texture coordinate. Immutable once built.
struct Mesh {
    std::string name;

    // A vertex stands at origin + unit·(x, y, z) of object space. |x|, |y|, |z| ≤ 1, and unit is
    // a power of two, so scaling the input by 2^k changes unit alone.
    glm::dvec3 origin{0};
    double unit = 1;
    std::vector<float> x, y, z;     // [vertex]
    std::vector<float> nx, ny, nz;  // [vertex] unit length, object space
    std::vector<float> u, v;        // [vertex] texture coordinates, v up; 0 where the file has none

    // Faces as they stand in the file, degenerate ones left out.
    std::vector<std::uint32_t> face_begin{0};        // CSR into corner
    std::vector<std::uint32_t> corner;               // vertex of each corner, counter-clockwise
    std::vector<std::uint32_t> face_material;        // [face]
    std::vector<std::array<float, 3>> face_normal;   // [face] Newell normal, unit length
    std::vector<std::array<float, 3>> face_centre;   // [face] mean of the corners, units as x, y, z
    std::vector<std::uint32_t> face_first_triangle;  // [face + 1]

    // Triangles, in the order of their faces: a face of n corners has n − 2.
    std::vector<std::array<std::uint32_t, 3>> triangle;  // vertices, counter-clockwise
    std::vector<std::uint32_t> triangle_face;            // [triangle]

    bool has_texcoords = false;
    bool has_quads = false;     // some face has four corners
    bool has_polygons = false;  // some face has more than three
    EventCounts events;         // what was odd while building

    // What it was made from, where it was: then it can be made again, finer or coarser.
    const ShapeInfo* shape = nullptr;
    int tessellation = 0;

    /// Made when clusters_of asks for it first; copies of a mesh share it.
    std::shared_ptr<ClusterCache> cluster_cache;

    std::size_t vertex_count() const { return x.size(); }
    std::size_t face_count() const { return face_material.size(); }
    std::size_t triangle_count() const { return triangle.size(); }
    std::size_t corner_count(std::size_t face) const {
        return face_begin[face + 1] - face_begin[face];
    }
};

/// Drops degenerate faces, triangulates the others (a fan where convex, ear clipping relative to
/// the face where not), makes vertex normals, joins equal vertices. O(corners · log corners).
/// A soup without a drawable face gives a mesh without faces: the caller decides what to say.
Mesh build_mesh(const PolygonSoup& soup, const NormalOptions& options);

/// Triangles of one polygon in space as triples of corner numbers [0, n), counter-clockwise, n − 2
/// of them, each corner used. Convex polygons give the fan from corner 0; concave ones are
/// ear-clipped in the plane of their Newell normal, relative to their own size, so position and
/// scale do not matter. Counts concave_face and self_crossing_face.
/// Empty for fewer than three corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<glm::dvec3>& polygon,
                                                      EventCounts& events);

/// Newell's normal: Σ over the edges of a cross product, twice the area long; the plane that fits
/// a non-planar polygon best. Computed relative to the first corner. 0 where that is no more than
/// rounding, but for a quadrilateral that crosses itself in equal halves, which cancel: that of its
/// first three corners.
glm::dvec3 newell_normal(const std::vector<glm::dvec3>& polygon);

}  // namespace scanshade

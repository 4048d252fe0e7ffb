// Scenes that are hard for numbers, each a function of the number that makes it so.
#pragma once

#include "scanshade/report/subject.hpp"

namespace scanshade {

// ---- where things are

/// A ring, its lights and its camera, `scale` times as large.
ReportInput scaled_scene(double scale);
/// A ring whose file has it `offset` away from the origin along each axis; or placed there.
ReportInput far_in_file(double offset);
ReportInput far_placed(double offset);
/// A ring, and another one `distance` behind it and as much larger.
ReportInput far_pair(double distance);
/// A sphere that the near plane cuts at `depth` of its radius before the middle; a small one in it.
ReportInput cut_by_near(double depth);
/// A ring in orthographic projection, of which near and far leave what is up to `share` before and
/// behind the middle.
ReportInput cut_by_both(double share);
/// The camera in the middle of a sphere, `angle` degrees high.
ReportInput inside_mesh(double angle);
/// Triangles of 100 · `times` pixels; one of them passes behind the eye.
ReportInput beyond_guard_band(double times);
/// Triangles of which one or two corners are `w` behind the eye, in both windings.
ReportInput behind_eye(double w);
/// A floor of one quadrilateral between distances 1/√ratio and √ratio; with a texture.
ReportInput w_ratio(double ratio);
ReportInput w_ratio_texture(double ratio);
/// Boards from distance 2·near to far/2, with far = 1e9.
ReportInput depth_range_scene(double near);
/// Two crossing boards, and two that lie `gap` of their distance apart.
ReportInput z_fighting(double gap);

// ---- meshes

/// A disc of needles around a point, `width` of a pixel wide at its rim.
ReportInput slivers(double width);
/// Slanted strips beside each other, `width` of a pixel wide.
ReportInput needles(double width);
/// Strips whose neighbours have `parts` times as many corners on the common edge.
ReportInput t_junctions(double parts);
/// Coloured polygons in one plane, tilted by `degrees`, that overlap.
ReportInput coplanar(double degrees);
/// A sphere in which each face has corners of its own and stands in the file `times`.
ReportInput duplicated_vertices(double times);
/// A sphere between faces without area: `width` high.
ReportInput zero_area_faces(double width);
/// A sphere of so many triangles that `per_pixel` of them meet in a pixel.
ReportInput tiny_triangles(double per_pixel);
/// Coordinates of `tiny` among those of a usual size.
ReportInput tiny_coordinates(double tiny);
/// Quadrilaterals that are concave, crossed, flattened to a line, or folded by `fold`.
ReportInput odd_quads(double fold);
/// A surface whose file has normals of length 0, 1/`length` and `length`.
ReportInput normal_lengths(double length);
/// Quadrilaterals whose corners' normals are `degrees` apart.
ReportInput opposite_normals(double degrees);
/// Front and back of sheets, with averaged normals; a corner of the back is lifted by 0 to `lift`.
ReportInput cancelling_normals(double lift);

// ---- light and reflection

/// Spheres of phong and blinn-phong with that exponent.
ReportInput exponent(double n);
/// Spheres of torrance-sparrow with that roughness: each distribution of facets.
ReportInput roughness(double m);
/// A point light `height` above a plane, over a vertex and over the middle of a face; brightness
/// falls with the square of the distance.
ReportInput light_at_height(double height);   // over a plane through the scene's middle
ReportInput light_off_origin(double height);  // over one beside it
/// A point light in the middle of a mesh, that the camera sees the inside of.
ReportInput light_inside(double radius);
/// A point light in that distance.
ReportInput light_far(double distance);
/// Light and view that graze a plane at that angle in radians.
ReportInput grazing(double angle);
/// A spot light with a sharp rim, of that half angle.
ReportInput spot_rim(double degrees);
/// More light than a byte holds: `intensity` times.
ReportInput bright(double intensity);

}  // namespace scanshade

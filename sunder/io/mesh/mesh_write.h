// The text of a mesh, as OBJ, OFF, PLY (ASCII) or STL (ASCII). Put it into a file with write_file_atomically (file.h).
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <cstdint>
#include <span>
#include <string>

namespace sunder::io {

// W1. Coordinates are written in the shortest decimal form that reads back as the same double. Reading the text gives
//     the same vertices and polygons in the same order; STL the same triangles, and vertices in their order of use.
// W2. Polygons are as in Mesh: polygon p has the corners polygon_vertices[polygon_begin[p] .. polygon_begin[p + 1]),
//     and polygon_begin has one entry more than there are polygons. Requires properties M1 and M3 of mesh.h.
// W3. The text ends with a line feed, and depends on nothing but the arguments (no locale, no date).
// STL holds triangles only: each polygon becomes the fan of its first corner, which is right for convex polygons; and
// normals are those of the triangles, rounded, or 0 0 0 where a triangle has none in doubles.
// Throws Error bad_call for an STL without polygons. Cost: linear.
std::string to_obj(std::span<const Point3> vertices, std::span<const std::uint32_t> polygon_begin,
                   std::span<const std::uint32_t> polygon_vertices);
std::string to_off(std::span<const Point3> vertices, std::span<const std::uint32_t> polygon_begin,
                   std::span<const std::uint32_t> polygon_vertices);
std::string to_ply(std::span<const Point3> vertices, std::span<const std::uint32_t> polygon_begin,
                   std::span<const std::uint32_t> polygon_vertices);
std::string to_stl(std::span<const Point3> vertices, std::span<const std::uint32_t> polygon_begin,
                   std::span<const std::uint32_t> polygon_vertices);

// One of the four. Throws Error bad_call for the formats that are only read.
std::string to_text(MeshFormat format, std::span<const Point3> vertices, std::span<const std::uint32_t> polygon_begin,
                    std::span<const std::uint32_t> polygon_vertices);
std::string to_text(MeshFormat format, const solid::ConvexPolyhedron& body);  // its vertices and facets

}  // namespace sunder::io

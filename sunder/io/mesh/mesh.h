// Meshes and point sets out of files: OBJ, STL, PLY, OFF, COLLADA, glTF, VRML, 3MF. See mesh_formats.h for what each
// format allows, mesh_write.h for the way back, urdf.h for robots.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/text/left_out.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

enum class MeshFormat { obj, stl, ply, off, collada, gltf, vrml, three_mf };  // those from collada on are only read

// What makes a part: an object, or in OBJ also a group ("g NAME"), such as the pieces of a convex decomposition.
enum class PartsOf { objects, objects_and_groups };

// An object within a file: an OBJ's "o NAME", an ASCII STL's "solid NAME", a mesh in a node of a scene.
struct MeshPart {
  std::string name;         // one line of UTF-8; may be empty
  std::uint32_t first = 0;  // its first polygon, or its first vertex in a mesh without polygons
};

// What a file holds: vertices, and polygons as cycles of vertex numbers. Without polygons it is a set of points.
//
// A mesh that a reader returns has these properties:
// M1. There is a vertex, and every coordinate is finite and not -0. There are fewer than 2^31 vertices.
// M2. Vertex i is the file's i-th, for OBJ, PLY and OFF; for COLLADA, VRML and 3MF the i-th in use, of all instances in
//     their order.
//     In STL and glTF faces do not share vertices: there equal points are joined into one, in the order of their first
//     appearance.
// M3. polygon_begin has one entry more than there are polygons, begins with 0 and ends with polygon_vertices.size();
//     every polygon has at least three corners, and every corner is a vertex number. There are fewer than 2^32 corners.
// M4. parts is not empty; the first part's `first` is 0, and they increase strictly. An object in the file without a
//     polygon is no part, unless no object has any.
// What one might assume and does not hold: polygons may be flat or not, repeat a corner, be turned either way, and
// leave holes; and vertices may be in no polygon (see used_vertices).
struct Mesh {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> polygon_begin{0};  // polygon p has the corners
  std::vector<std::uint32_t> polygon_vertices;  // polygon_vertices[polygon_begin[p] .. polygon_begin[p + 1])
  std::vector<MeshPart> parts;
  std::vector<LeftOut> left_out;     // beside polygons: lines, points, vertices in no polygon, elements of other kinds
  std::vector<std::string> remarks;  // a line each: what was rounded, or not read, and changes no answer about the rest
  std::string name;    // as the file says, else (read_mesh only) the file's name without folder and ending
  std::string format;  // for people: "OBJ", "STL (binary)" (single precision), "PLY (binary_little_endian)", ...

  std::uint32_t polygon_count() const { return static_cast<std::uint32_t>(polygon_begin.size() - 1); }
};

// Reads the file whole, finds its format by its first bytes, then by the ending of its name, and parses it.
// Coordinates are the doubles nearest to the numbers in the file; of COLLADA, glTF, VRML and 3MF, these moved by
// the nodes above them (mesh_formats.h). A glTF's buffers are read, too, where they are regular files within its
// folder; a symbolic link that leads out of it is refused.
// Throws Error bad_file: what is wrong and the remedy, in one line that begins with "FILE:LINE: " (text),
// "FILE: byte OFFSET: " (binary) or "FILE: ". A file is taken whole or refused: nothing in it is guessed or repaired.
// Cost: linear in the size of the file, n log n for STL; memory a small multiple of the file, whatever its header says.
// inputs: as of read_file (file.h).
Mesh read_mesh(const std::filesystem::path& path, InputFiles* inputs = nullptr, PartsOf parts = PartsOf::objects);

// As read_mesh, from memory. place: the file's name for messages.
Mesh parse_mesh(std::string_view bytes, std::string_view place, MeshFormat format, PartsOf parts = PartsOf::objects);

// The format of these bytes, where they tell it.
std::optional<MeshFormat> mesh_format_of_content(std::string_view bytes);

// The format of these bytes; where they leave it open, by the ending of `place`.
// Throws Error bad_file, naming what the file is instead where that shows (a PNG image, FBX, a zip archive, ...).
MeshFormat mesh_format(std::string_view bytes, std::string_view place);

// The format to write that the ending names (".obj", ".STL", ...). Throws Error bad_call for any other.
MeshFormat mesh_format_of_name(const std::filesystem::path& path);

// The vertices that the mesh is about, in increasing order: those in some polygon, or all when there is no polygon.
std::vector<std::uint32_t> used_vertices(const Mesh& mesh);

// One mesh per part, with its used vertices only, in the order of the file; left_out stays with the whole.
// `used`, where it is given, gets for each part which vertices of the mesh its vertices are. Cost: n log n.
std::vector<Mesh> split_parts(const Mesh& mesh, std::vector<std::vector<std::uint32_t>>* used = nullptr);

}  // namespace sunder::io

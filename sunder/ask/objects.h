// Objects out of mesh files, as the verbs need them.
#pragma once

#include <sunder/ask/left_out.h>
#include <sunder/ask/report.h>

#include <sunder/io/mesh.h>
#include <sunder/scene/mesh_departure.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sunder::ask {

// What stands for a mesh.
enum class Shape : std::uint8_t {
  convex,  // the mesh itself, which is exactly convex
  hull,    // the hull of a mesh that is not
  points,  // the hull of a set of points
};

const char* name_of(Shape shape);

struct Object {
  std::string file;  // as the user wrote it, in one line of UTF-8
  std::string name;
  std::string format;
  std::uint32_t mesh_vertices = 0;  // those in use
  std::uint32_t mesh_polygons = 0;
  Shape shape = Shape::convex;
  std::string why_hull;                           // in words, with numbers of the file; empty unless shape is hull
  std::optional<scene::MeshDeparture> departure;  // of a mesh from its hull: where shape is hull, of dimension 3
  solid::ConvexPolyhedron hull;
};

// The mesh as one object, without the vertices that are in no polygon. Throws Error bad_shape where convexity is
// required and missing, naming the reflex edge.
Object make_object(io::Mesh mesh, const std::filesystem::path& file, bool require_convex);

// Reads the file as one object, or as one object for each of its parts; what is not read goes into `left_out`, what is
// read into `inputs`, where given. Throws Error also where something is not read, and the list has no consent.
Object read_object(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out,
                   InputFiles* inputs = nullptr);
// The same with the points that the hull is of.
struct ObjectOfPoints {
  Object object;
  std::vector<Point3> points;
};
ObjectOfPoints read_object_of_points(const std::filesystem::path& file, LeftOutList& left_out, InputFiles* inputs);
std::vector<Object> read_parts(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out,
                               InputFiles* inputs = nullptr);

// By how much the mesh departs from its hull: "deepest edge about 0.5 below the hull, ...". Empty where not known.
std::string departure_text(const Object& object);

// Says on standard error which hulls stand for meshes: one line, however many there are.
void note_hulls(const std::vector<const Object*>& objects);

// "body", "polygon", "segment", "point".
const char* dimension_name(int dimension);

Json to_json(const Object& object);

}  // namespace sunder::ask

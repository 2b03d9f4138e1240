// The body that a mesh stands for: itself where it is exactly convex, else its hull, and why.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/text/left_out.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_departure.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// What stands for a mesh.
enum class BodyShape : std::uint8_t {
  convex,  // the mesh itself, which is exactly convex
  hull,    // the hull of a mesh that is not
  points,  // the hull of a set of points
};
std::string_view name_of(BodyShape shape);

struct MeshBody {
  std::string file;  // as the caller wrote it, in one line of UTF-8
  std::string name;
  std::string format;
  std::uint32_t mesh_vertices = 0;  // those in use
  std::uint32_t mesh_polygons = 0;
  BodyShape shape = BodyShape::convex;
  std::string why_hull;                           // in words, with numbers of the file; empty unless shape is hull
  std::optional<solid::MeshDeparture> departure;  // of a mesh from its hull: where shape is hull, of dimension 3
  solid::ConvexPolyhedron hull;
  std::uint64_t inner_vertices = 0;    // unused ones of the file in the hull of the others: not taken, to be told
  std::shared_ptr<const Mesh> mesh{};  // as it is, with the vertices in use; null for a set of points
};

// The mesh as it is; of what has none the surface of its hull.
solid::Mesh mesh_as_it_is(const MeshBody& body);

// The mesh as one body, without the vertices that are in no polygon. Throws Error bad_shape where convexity is required
// and missing, naming the reflex edge. Cost: that of the hull.
MeshBody body_of_mesh(Mesh mesh, const std::filesystem::path& file, bool require_convex);

// The kind of vertices that are in no polygon (Mesh::left_out).
inline constexpr std::string_view unused_vertex = "unused vertex";

// Drops from mesh.left_out the unused vertices that lie in the closed hull of those in use: without them the mesh, its
// hull, and every answer are the same. Returns how many these are. Exact. Cost: that of the hull, where there are any.
std::uint64_t drop_inner_vertices(Mesh& mesh);

// "2 unused vertices lie in the hull of the others, and change nothing"; empty for none.
std::string inner_vertices_text(std::uint64_t count);

// Reads the file as one body, or as a body for each of its parts; what is not read goes into `left_out`, what is read
// into `inputs`, where given. Unused vertices in the hull of the others (drop_inner_vertices) are a remark.
// Throws Error also where something is not read, and the list has no consent.
MeshBody read_body(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out,
                   InputFiles* inputs = nullptr);
std::vector<MeshBody> read_bodies(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out,
                                  InputFiles* inputs = nullptr, PartsOf parts = PartsOf::objects);

// One body, never required to be convex, with the mesh that it is the hull of, whose vertices are all in use.
struct HullOfPoints {
  MeshBody body;
  Mesh mesh;
};
HullOfPoints read_hull(const std::filesystem::path& file, LeftOutList& left_out, InputFiles* inputs = nullptr);

}  // namespace sunder::io

// Collects a mesh while a file is read, and keeps the properties M1 to M4 of mesh.h that need no knowledge of the file.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::io {

// A polygon needs this many corners; a reader refuses fewer, since it knows the line.
constexpr std::uint32_t fewest_corners = 3;

class MeshBuilder {
 public:
  static constexpr std::uint32_t largest_vertex = std::numeric_limits<std::int32_t>::max() - 1;

  // file: its name, for messages; must outlive the builder.
  explicit MeshBuilder(std::string_view file) : file_(file) {}

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(mesh_.vertices.size()); }

  // Corners since the last end_polygon.
  std::uint32_t corner_count() const {
    return static_cast<std::uint32_t>(mesh_.polygon_vertices.size()) - mesh_.polygon_begin.back();
  }

  // Room for this many vertices. Requires a number that the file's size bears out.
  void reserve_vertices(std::size_t count) { mesh_.vertices.reserve(count); }

  // Requires finite coordinates. Throws Error bad_file for too many vertices.
  void add_vertex(const Point3& point);

  // The reader checks the vertex number, now or before finish. Throws Error bad_file for too many corners.
  void add_corner(std::uint32_t vertex);
  void end_polygon() { mesh_.polygon_begin.push_back(static_cast<std::uint32_t>(mesh_.polygon_vertices.size())); }

  // What follows belongs to a part of this name.
  void begin_part(std::string_view name);

  // Something of the file that the mesh does not hold.
  void leave_out(std::string_view kind, std::uint64_t count);

  // One line about how the file was read (Mesh::remarks).
  void remark(std::string text) { mesh_.remarks.push_back(std::move(text)); }

  // Joins equal vertices into one, in the order of their first appearance.
  void join_equal_vertices();

  // The mesh, with the vertices in no polygon told as left out. Throws Error bad_file when it has no vertex.
  Mesh finish(std::string_view format);

 private:
  struct Start {
    std::string name;
    std::uint32_t vertex, polygon;
  };

  std::string_view file_;
  Mesh mesh_;
  std::vector<Start> starts_;
};

}  // namespace sunder::io

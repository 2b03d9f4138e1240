#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/text/text.h>
#include <sunder/solid/mesh/mesh_sides.h>

#include <algorithm>

namespace sunder::io {

void MeshBuilder::add_vertex(const Point3& point) {
  if (mesh_.vertices.size() > largest_vertex) fail_file(file_, "has 2^31 vertices or more; split it");
  // Adding 0 turns -0 into 0 and changes nothing else.
  mesh_.vertices.push_back({point.x + 0.0, point.y + 0.0, point.z + 0.0});
}

void MeshBuilder::add_corner(std::uint32_t vertex) {
  if (mesh_.polygon_vertices.size() == std::numeric_limits<std::uint32_t>::max()) {
    fail_file(file_, "has 2^32 corners of faces or more; split it");
  }
  mesh_.polygon_vertices.push_back(vertex);
}

void MeshBuilder::begin_part(std::string_view name) {
  if (starts_.empty()) mesh_.name = one_line(name);
  starts_.push_back({one_line(name), vertex_count(), mesh_.polygon_count()});
}

void MeshBuilder::leave_out(std::string_view kind, std::uint64_t count) {
  if (count == 0) return;
  const auto known = std::find_if(mesh_.left_out.begin(), mesh_.left_out.end(),
                                  [&](const LeftOut& item) { return item.kind == kind; });
  if (known == mesh_.left_out.end()) {
    mesh_.left_out.push_back({std::string(kind), "", count});
  } else {
    known->count += count;
  }
}

void MeshBuilder::join_equal_vertices() {
  std::vector<Point3>& points = mesh_.vertices;
  const std::vector<std::uint32_t> first = solid::lowest_of_equals(points);
  std::vector<std::uint32_t> joined(points.size());
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (first[i] == i) {
      points[count] = points[i];
      joined[i] = count++;
    } else {
      joined[i] = joined[first[i]];
    }
  }
  points.resize(count);
  points.shrink_to_fit();
  for (std::uint32_t& corner : mesh_.polygon_vertices) corner = joined[corner];
}

Mesh MeshBuilder::finish(std::string_view format) {
  if (mesh_.vertices.empty()) fail_file(file_, "the file has no vertices; export the mesh again");
  mesh_.format = format;

  // What stands before the first named part is a part without a name; parts that got nothing are dropped.
  const bool polygons = mesh_.polygon_count() > 0;
  const std::uint32_t total = polygons ? mesh_.polygon_count() : vertex_count();
  const auto first = [&](const Start& start) { return polygons ? start.polygon : start.vertex; };
  if (starts_.empty() || first(starts_.front()) > 0) mesh_.parts.push_back({});
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const std::uint32_t end = i + 1 < starts_.size() ? first(starts_[i + 1]) : total;
    if (first(starts_[i]) < end) mesh_.parts.push_back({std::move(starts_[i].name), first(starts_[i])});
  }
  leave_out("unused vertex", mesh_.vertices.size() - used_vertices(mesh_).size());
  return std::move(mesh_);
}

}  // namespace sunder::io

// For tests and fuzzers: do the properties M1, M3 and M4 of mesh.h hold?
#pragma once

#include <sunder/io/mesh/mesh.h>

#include <cmath>
#include <string>

namespace sunder::io {

// What is wrong with the mesh, or nothing.
inline std::string mesh_fault(const Mesh& mesh) {
  if (mesh.vertices.empty()) return "no vertices";
  for (const Point3& point : mesh.vertices) {
    for (const double c : {point.x, point.y, point.z}) {
      if (!std::isfinite(c)) return "a coordinate is not finite";
      if (c == 0 && std::signbit(c)) return "a coordinate is -0";
    }
  }
  if (mesh.polygon_begin.empty() || mesh.polygon_begin.front() != 0) return "polygon_begin does not begin with 0";
  if (mesh.polygon_begin.back() != mesh.polygon_vertices.size()) return "polygon_begin does not end at the end";
  for (std::size_t p = 0; p + 1 < mesh.polygon_begin.size(); ++p) {
    if (mesh.polygon_begin[p + 1] < mesh.polygon_begin[p] + 3) return "a polygon of fewer than 3 corners";
  }
  for (const std::uint32_t v : mesh.polygon_vertices) {
    if (v >= mesh.vertices.size()) return "a corner out of range";
  }
  if (mesh.parts.empty() || mesh.parts.front().first != 0) return "the parts do not begin at 0";
  const std::size_t total = mesh.polygon_count() > 0 ? mesh.polygon_count() : mesh.vertices.size();
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const std::size_t end = i + 1 < mesh.parts.size() ? mesh.parts[i + 1].first : total;
    if (mesh.parts[i].first >= end) return "an empty part";
  }
  if (mesh.format.empty()) return "no format";
  return "";
}

}  // namespace sunder::io

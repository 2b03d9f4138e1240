#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_write.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace sunder::io {
namespace {

using Points = std::span<const Point3>;
using Numbers = std::span<const std::uint32_t>;

// The longest double has 24 characters: -2.2250738585072014e-308.
constexpr std::size_t longest_number = 32;

template <class Number>
void append(std::string& text, Number number) {
  std::array<char, longest_number> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), result.ptr);
}

void append_point(std::string& text, const Point3& point) {
  append(text, point.x);
  text += ' ';
  append(text, point.y);
  text += ' ';
  append(text, point.z);
  text += '\n';
}

std::size_t polygon_count(Numbers begin) { return begin.empty() ? 0 : begin.size() - 1; }

Numbers corners(Numbers begin, Numbers vertices, std::size_t p) {
  return vertices.subspan(begin[p], begin[p + 1] - begin[p]);
}

// One line per polygon: the number of its corners, then the corners.
void append_counted_polygons(std::string& text, Numbers begin, Numbers vertices) {
  for (std::size_t p = 0; p < polygon_count(begin); ++p) {
    const Numbers cycle = corners(begin, vertices, p);
    append(text, cycle.size());
    for (const std::uint32_t v : cycle) {
      text += ' ';
      append(text, v);
    }
    text += '\n';
  }
}

// For people and viewers only: no answer depends on it.
Point3 rounded_normal(const Point3& a, const Point3& b, const Point3& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const double length = std::hypot(x, y, z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {x / length + 0.0, y / length + 0.0, z / length + 0.0};
}

}  // namespace

std::string to_obj(Points vertices, Numbers polygon_begin, Numbers polygon_vertices) {
  std::string text;
  for (const Point3& point : vertices) {
    text += "v ";
    append_point(text, point);
  }
  for (std::size_t p = 0; p < polygon_count(polygon_begin); ++p) {
    text += 'f';
    for (const std::uint32_t v : corners(polygon_begin, polygon_vertices, p)) {
      text += ' ';
      append(text, std::uint64_t{v} + 1);
    }
    text += '\n';
  }
  return text;
}

std::string to_off(Points vertices, Numbers polygon_begin, Numbers polygon_vertices) {
  std::string text = "OFF\n";
  append(text, vertices.size());
  text += ' ';
  append(text, polygon_count(polygon_begin));
  text += " 0\n";
  for (const Point3& point : vertices) append_point(text, point);
  append_counted_polygons(text, polygon_begin, polygon_vertices);
  return text;
}

std::string to_ply(Points vertices, Numbers polygon_begin, Numbers polygon_vertices) {
  std::size_t longest = 0;
  for (std::size_t p = 0; p < polygon_count(polygon_begin); ++p) {
    longest = std::max(longest, corners(polygon_begin, polygon_vertices, p).size());
  }
  std::string text = "ply\nformat ascii 1.0\nelement vertex ";
  append(text, vertices.size());
  text += "\nproperty double x\nproperty double y\nproperty double z\n";
  if (polygon_count(polygon_begin) > 0) {
    text += "element face ";
    append(text, polygon_count(polygon_begin));
    text += longest < 256 ? "\nproperty list uchar int vertex_indices\n" : "\nproperty list uint int vertex_indices\n";
  }
  text += "end_header\n";
  for (const Point3& point : vertices) append_point(text, point);
  append_counted_polygons(text, polygon_begin, polygon_vertices);
  return text;
}

std::string to_stl(Points vertices, Numbers polygon_begin, Numbers polygon_vertices) {
  if (polygon_count(polygon_begin) == 0) {
    throw Error(ErrorCode::bad_call, "without a polygon there is no STL; write OBJ, OFF or PLY");
  }
  std::string text = "solid\n";
  for (std::size_t p = 0; p < polygon_count(polygon_begin); ++p) {
    const Numbers cycle = corners(polygon_begin, polygon_vertices, p);
    for (std::size_t i = 1; i + 1 < cycle.size(); ++i) {
      const Point3 triangle[] = {vertices[cycle[0]], vertices[cycle[i]], vertices[cycle[i + 1]]};
      text += "facet normal ";
      append_point(text, rounded_normal(triangle[0], triangle[1], triangle[2]));
      text += "outer loop\n";
      for (const Point3& point : triangle) {
        text += "vertex ";
        append_point(text, point);
      }
      text += "endloop\nendfacet\n";
    }
  }
  return text + "endsolid\n";
}

std::string to_text(MeshFormat format, Points vertices, Numbers polygon_begin, Numbers polygon_vertices) {
  switch (format) {
    case MeshFormat::obj: return to_obj(vertices, polygon_begin, polygon_vertices);
    case MeshFormat::stl: return to_stl(vertices, polygon_begin, polygon_vertices);
    case MeshFormat::ply: return to_ply(vertices, polygon_begin, polygon_vertices);
    case MeshFormat::off: return to_off(vertices, polygon_begin, polygon_vertices);
    case MeshFormat::collada:
    case MeshFormat::gltf:
    case MeshFormat::three_mf:
    case MeshFormat::vrml: break;
  }
  throw Error(ErrorCode::bad_call, "meshes are written as OBJ, STL, PLY and OFF only");
}

std::string to_text(MeshFormat format, const solid::ConvexPolyhedron& body) {
  std::vector<std::uint32_t> begin{0}, corners;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    corners.insert(corners.end(), body.facet(f).begin(), body.facet(f).end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return to_text(format, body.vertices(), begin, corners);
}

}  // namespace sunder::io

#include <sunder/solid/mesh/mesh_sides.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace sunder::solid {

namespace {

std::uint64_t hash_of(const Point3& p) {
  std::uint64_t hash = 0;
  for (const double x : {p.x, p.y, p.z}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15;  // -0 + 0 is 0
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

std::vector<std::uint32_t> lowest_of_equals_by_sorting(std::span<const Point3> points) {
  std::vector<std::uint32_t> order(points.size()), lowest(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeated = k > 0 && points[order[k]] == points[order[k - 1]];
    lowest[order[k]] = repeated ? lowest[order[k - 1]] : order[k];
  }
  return lowest;
}

std::vector<std::uint32_t> lowest_of_equals(std::span<const Point3> points) {
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> lowest(points.size()), table(std::bit_ceil(2 * points.size() + 1), none);
  const std::size_t last = table.size() - 1;
  std::size_t steps_left = 8 * points.size();  // past places that others have: far more than there are by chance
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t at = hash_of(points[i]) & last;
    while (table[at] != none && points[table[at]] != points[i]) {
      if (steps_left-- == 0) return lowest_of_equals_by_sorting(points);
      at = (at + 1) & last;
    }
    if (table[at] == none) table[at] = i;
    lowest[i] = table[at];
  }
  return lowest;
}

MeshCorners::MeshCorners(const MeshView& mesh) : lowest(lowest_of_equals(mesh.vertices)), corner_begin{0} {
  corners.reserve(mesh.polygon_vertices.size());
  corner_begin.reserve(mesh.polygon_begin.size());
  for (std::uint32_t f = 0; f < mesh.polygon_count(); ++f) {
    const std::size_t begin = corners.size();
    for (const std::uint32_t v : mesh.polygon(f)) {
      if (corners.size() == begin || corners.back() != lowest[v]) corners.push_back(lowest[v]);
    }
    while (corners.size() > begin + 1 && corners.back() == corners[begin]) corners.pop_back();
    corner_begin.push_back(corners.size());
  }
}

MeshSides::MeshSides(const MeshView& mesh) : MeshCorners(mesh) {
  sides.reserve(corners.size());
  for (std::uint32_t f = 0; f < mesh.polygon_count(); ++f) {
    const auto of_face = corners_of(f);
    for (std::size_t i = 0; i < of_face.size(); ++i) {
      const std::uint32_t next = of_face[i + 1 < of_face.size() ? i + 1 : 0];
      if (next != of_face[i]) sides.push_back({of_face[i], next, f});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& s, const Side& t) { return std::pair(s.ends(), s.face) < std::pair(t.ends(), t.face); });
}

}  // namespace sunder::solid

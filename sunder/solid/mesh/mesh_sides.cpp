#include <sunder/solid/mesh/mesh_sides.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace sunder::solid {

std::vector<std::uint32_t> lowest_of_equals(std::span<const Point3> points) {
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

MeshSides::MeshSides(const MeshView& mesh) : lowest(lowest_of_equals(mesh.vertices)), corner_begin{0} {
  for (std::uint32_t f = 0; f < mesh.polygon_count(); ++f) {
    const std::size_t begin = corners.size();
    for (const std::uint32_t v : mesh.polygon(f)) {
      if (corners.size() == begin || corners.back() != lowest[v]) corners.push_back(lowest[v]);
    }
    while (corners.size() > begin + 1 && corners.back() == corners[begin]) corners.pop_back();
    corner_begin.push_back(corners.size());
    for (std::size_t i = begin; i < corners.size(); ++i) {
      const std::uint32_t next = corners[i + 1 < corners.size() ? i + 1 : begin];
      if (next != corners[i]) sides.push_back({corners[i], next, f});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& s, const Side& t) { return std::pair(s.ends(), s.face) < std::pair(t.ends(), t.face); });
}

}  // namespace sunder::solid

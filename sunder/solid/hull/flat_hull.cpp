#include <sunder/base/contract.h>
#include <sunder/solid/hull/flat_hull.h>

#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

// The extreme points in counter-clockwise order of their projections, of equal points the lowest index.
std::vector<std::uint32_t> monotone_chain(std::span<const Point3> points, int axis) {
  const auto projected = [&](std::uint32_t i) {
    const Point3& p = points[i];
    return axis == 0 ? std::pair{p.y, p.z} : axis == 1 ? std::pair{p.z, p.x} : std::pair{p.x, p.y};
  };
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::tuple(projected(i), i) < std::tuple(projected(j), j);
  });
  const auto same = [&](std::uint32_t i, std::uint32_t j) { return projected(i) == projected(j); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());

  std::vector<std::uint32_t> cycle;
  // Appends the lower chain of the points in the order given, without its last point: that begins the next chain.
  const auto append_chain = [&](const auto& first, const auto& last) {
    const std::size_t begin = cycle.size();
    for (auto i = first; i != last; ++i) {
      while (cycle.size() >= begin + 2 && orient_2d_along(axis, points[cycle[cycle.size() - 2]], points[cycle.back()],
                                                          points[*i]) != Sign::positive) {
        cycle.pop_back();
      }
      cycle.push_back(*i);
    }
    cycle.pop_back();
  };
  append_chain(order.begin(), order.end());
  append_chain(order.rbegin(), order.rend());
  return cycle;
}

}  // namespace

ConvexHull point_hull(std::uint32_t a) {
  ConvexHull hull;
  hull.vertices = {a};
  hull.neighbour_begin = {0, 0};
  return hull;
}

ConvexHull segment_hull(std::uint32_t a, std::uint32_t b) {
  ConvexHull hull;
  hull.dimension = 1;
  hull.vertices = {a, b};
  hull.neighbour_begin = {0, 1, 2};
  hull.neighbours = {1, 0};
  return hull;
}

ConvexHull polygon_hull(std::span<const Point3> points, int axis) {
  SUNDER_REQUIRE(axis >= 0 && axis < 3);
  ConvexHull hull;
  hull.dimension = 2;
  hull.vertices = monotone_chain(points, axis);
  const auto size = static_cast<std::uint32_t>(hull.vertices.size());
  for (std::uint32_t v = 0; v < size; ++v) {
    hull.neighbours.push_back((v + size - 1) % size);
    hull.neighbours.push_back((v + 1) % size);
    hull.neighbour_begin.push_back(2 * (v + 1));
  }
  hull.facet_vertices.resize(2 * hull.vertices.size());
  std::iota(hull.facet_vertices.begin(), hull.facet_vertices.begin() + size, 0u);
  std::iota(hull.facet_vertices.rbegin(), hull.facet_vertices.rbegin() + size, 0u);
  hull.facet_begin = {0, size, 2 * size};
  return hull;
}

}  // namespace sunder::solid

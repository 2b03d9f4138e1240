#include <sunder/base/contract.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace sunder::solid {

struct ConvexPolyhedron::Data {
  int dimension = 0;
  SearchGraph graph;
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> facet_begin;
  std::vector<std::uint32_t> facet_vertices;
  LazySlots slots;
};

namespace {

// Spreads the lowest ten bits of x to every third bit.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

// The vertices along a Morton curve through their box, so that neighbours tend to share cache lines.
std::vector<std::uint32_t> order_along_curve(std::span<const Point3> points, std::span<const std::uint32_t> vertices) {
  Point3 low = points[vertices[0]], high = low;
  for (const std::uint32_t v : vertices) {
    const Point3& p = points[v];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto cell = [](double x, double least, double greatest) {
    const double part = (x / 2 - least / 2) / (greatest / 2 - least / 2);  // halves: no overflow
    return part >= 0 && part <= 1 ? static_cast<std::uint32_t>(part * 1023) : 0u;
  };
  std::vector<std::uint32_t> code(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point3& p = points[vertices[i]];
    code[i] = spread(cell(p.x, low.x, high.x)) | spread(cell(p.y, low.y, high.y)) << 1 |
              spread(cell(p.z, low.z, high.z)) << 2;
  }
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return code[i] != code[j] ? code[i] < code[j] : i < j; });
  return order;
}

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(std::span<const Point3> points) {
  const ConvexHull hull = convex_hull(points);
  const std::uint32_t n = static_cast<std::uint32_t>(hull.vertices.size());

  const std::vector<std::uint32_t> order = order_along_curve(points, hull.vertices);
  std::vector<std::uint32_t> place(n);  // of a vertex of the hull, here
  for (std::uint32_t i = 0; i < n; ++i) place[order[i]] = i;

  auto data = std::make_shared<Data>();
  data->dimension = hull.dimension;
  std::vector<Point3> vertices(n);
  std::vector<std::uint32_t> begin{0}, neighbours;
  neighbours.reserve(hull.neighbours.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t v = order[i];
    vertices[i] = points[hull.vertices[v]];
    data->source.push_back(hull.vertices[v]);
    for (std::uint32_t j = hull.neighbour_begin[v]; j < hull.neighbour_begin[v + 1]; ++j) {
      neighbours.push_back(place[hull.neighbours[j]]);
    }
    begin.push_back(static_cast<std::uint32_t>(neighbours.size()));
  }
  data->facet_begin = hull.facet_begin;
  for (const std::uint32_t v : hull.facet_vertices) data->facet_vertices.push_back(place[v]);
  data->graph = make_search_graph(std::move(vertices), std::move(begin), std::move(neighbours));
  data_ = std::move(data);
}

int ConvexPolyhedron::dimension() const { return data_->dimension; }

std::span<const Point3> ConvexPolyhedron::vertices() const { return data_->graph.vertices; }

std::span<const std::uint32_t> ConvexPolyhedron::source() const { return data_->source; }

std::span<const std::uint32_t> ConvexPolyhedron::neighbours(std::uint32_t v) const {
  SUNDER_REQUIRE(v < vertices().size());
  const SearchGraph& graph = data_->graph;
  return {graph.neighbours.data() + graph.begin[v], graph.begin[v + 1] - graph.begin[v]};
}

std::uint32_t ConvexPolyhedron::facet_count() const {
  return static_cast<std::uint32_t>(data_->facet_begin.size() - 1);
}

std::span<const std::uint32_t> ConvexPolyhedron::facet(std::uint32_t f) const {
  SUNDER_REQUIRE(f < facet_count());
  return {data_->facet_vertices.data() + data_->facet_begin[f], data_->facet_begin[f + 1] - data_->facet_begin[f]};
}

std::span<const std::uint32_t> ConvexPolyhedron::facet_begin() const { return data_->facet_begin; }

std::span<const std::uint32_t> ConvexPolyhedron::facet_vertices() const { return data_->facet_vertices; }

std::array<Point3, 2> ConvexPolyhedron::box() const { return {data_->graph.low, data_->graph.high}; }

const SearchGraph& ConvexPolyhedron::search_graph() const { return data_->graph; }

const LazySlots& ConvexPolyhedron::slots() const { return data_->slots; }

std::size_t ConvexPolyhedron::memory() const {
  const auto bytes = [](const std::vector<std::uint32_t>& of) { return of.capacity() * sizeof(of[0]); };
  return sizeof(*data_) + data_->graph.memory() + bytes(data_->source) + bytes(data_->facet_begin) +
         bytes(data_->facet_vertices);
}

}  // namespace sunder::solid

#include <sunder/base/contract.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/polar.h>
#include <sunder/solid/represent/polar_hierarchy.h>
#include <sunder/solid/represent/search_graph.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <utility>

namespace sunder::solid {

struct ConvexPolyhedron::Data {
  int dimension = 0;
  SearchGraph graph;
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> facet_begin;
  std::vector<std::uint32_t> facet_vertices;
  mutable std::once_flag made_hierarchy;
  mutable Hierarchy hierarchy;
  mutable std::once_flag made_polar;
  mutable Polar polar;
  mutable std::once_flag made_polar_hierarchy;
  mutable PolarHierarchy polar_hierarchy;
  mutable std::once_flag made_half_edges;
  mutable HalfEdges half_edges;
  mutable std::once_flag made_drums;
  mutable Drums drums;
  mutable std::once_flag made_facet_graph;
  mutable FacetGraph facet_graph;
};

namespace {

// Spreads the lowest ten bits of x to every third bit.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

void require_interior(const ConvexPolyhedron& body) {
  if (body.dimension() == 3) return;
  throw Error(ErrorCode::bad_shape, "a polyhedron without an interior has no polar about a point inside");
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

std::array<Point3, 2> ConvexPolyhedron::box() const { return {data_->graph.low, data_->graph.high}; }

const SearchGraph& ConvexPolyhedron::search_graph() const { return data_->graph; }

const Hierarchy& ConvexPolyhedron::hierarchy() const {
  SUNDER_REQUIRE(vertices().size() >= 3);
  std::call_once(data_->made_hierarchy, [this] {
    data_->hierarchy = make_hierarchy(data_->graph.vertices, data_->facet_begin, data_->facet_vertices);
  });
  return data_->hierarchy;
}

const Polar& ConvexPolyhedron::polar() const {
  require_interior(*this);
  std::call_once(data_->made_polar, [this] {
    data_->polar = make_polar(data_->graph.vertices, data_->facet_begin, data_->facet_vertices);
  });
  return data_->polar;
}

const PolarHierarchy& ConvexPolyhedron::polar_hierarchy() const {
  require_interior(*this);
  std::call_once(data_->made_polar_hierarchy, [this] {
    data_->polar_hierarchy = make_polar_hierarchy(data_->graph.vertices, data_->facet_begin, data_->facet_vertices);
  });
  return data_->polar_hierarchy;
}

const HalfEdges& ConvexPolyhedron::half_edges() const {
  SUNDER_REQUIRE(vertices().size() >= 3);
  std::call_once(data_->made_half_edges, [this] {
    data_->half_edges =
        make_half_edges(static_cast<std::uint32_t>(vertices().size()), data_->facet_begin, data_->facet_vertices);
  });
  return data_->half_edges;
}

const Drums& ConvexPolyhedron::drums() const {
  std::call_once(data_->made_drums, [this] {
    const Point3 &low = data_->graph.low, &high = data_->graph.high;
    const Point3 direction = low.z < high.z ? Point3{0, 0, 1} : low.x < high.x ? Point3{1, 0, 0} : Point3{0, 1, 0};
    data_->drums = make_drums(direction, DrumsForm::persistent);
  });
  return data_->drums;
}

Drums ConvexPolyhedron::make_drums(const Point3& direction, DrumsForm form) const {
  return {data_->graph.vertices, data_->facet_begin, data_->facet_vertices, direction, form};
}

const FacetGraph& ConvexPolyhedron::facet_graph() const {
  SUNDER_REQUIRE(vertices().size() >= 3);
  std::call_once(data_->made_facet_graph, [this] {
    data_->facet_graph = make_facet_graph(data_->graph.vertices, data_->facet_begin, data_->facet_vertices);
  });
  return data_->facet_graph;
}

std::size_t ConvexPolyhedron::memory() const {
  const auto bytes = [](const std::vector<std::uint32_t>& of) { return of.capacity() * sizeof(of[0]); };
  std::size_t sum = sizeof(*data_) + data_->graph.memory() + bytes(data_->source) + bytes(data_->facet_begin) +
                    bytes(data_->facet_vertices);
  if (vertices().size() >= 3) sum += hierarchy().memory();
  if (dimension() == 3) sum += polar_hierarchy().hierarchy.memory();
  return sum;
}

}  // namespace sunder::solid

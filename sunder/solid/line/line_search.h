// The search that proposes where a line comes into a convex polyhedron and where it goes out: Newton's method along the
// line, on the convex function that is 1 on the body's surface. Nothing here decides anything.
// Also called: ray shooting by the polar; Dinkelbach's method.
//
// In the frame of the facet graph the body is where g(y) <= 1, g(y) the greatest m.y of the polar's vertices m. One
// step takes the facet m that the ray from the middle through the last point goes through, and goes on to where the
// line comes through its plane. From before the body it never goes beyond the first point inside, and is there when the
// same facet comes again. Where g grows along the line and is above 1 there is none: both last facets tell why.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/line/line_proposal.h>
#include <sunder/solid/object/line.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/radial_walk.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace sunder::solid {

template <class V, class Real>
V along_by(const V& p, const V& d, const Real& s) {
  return {p.x + d.x * s, p.y + d.y * s, p.z + d.z * s};
}

// The line in the frame of the facet graph: the point nearest to the middle, and a direction of length 1. Rounded.
template <class Real>
struct LineInFrame {
  using Vector = VectorOf<Real>;
  Vector nearest, way;
  bool is_finite = false;

  LineInFrame(const Placed& body, const FacetGraph& graph, const Line& line) {
    const auto& m = body.pose.linear;
    const auto& t = body.pose.translation;
    // The columns of the map from the frame to the world, each times a power of two that brings it near 1. The points
    // of the world are halved, so that differences do not overflow.
    const Point3 &one = graph.to_one, &o = graph.center;
    Point3 by;
    const auto column = [&](std::size_t j) {
      const Point3 c{m[j] / one[j], m[3 + j] / one[j], m[6 + j] / one[j]};
      const double size = std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
      by[j] = scale_to_one(size);
      return Vector{c.x * by[j], c.y * by[j], c.z * by[j]};
    };
    const Vector x = column(0), y = column(1), z = column(2);
    const Vector r0 = cross(y, z), r1 = cross(z, x), r2 = cross(x, y);
    const Real whole = Real(1) / dot(x, r0);
    const auto row = [&](std::size_t i) -> Real {
      const Real image = product<Real>(m[3 * i], o.x / 2) + product<Real>(m[3 * i + 1], o.y / 2) +
                         product<Real>(m[3 * i + 2], o.z / 2) + Real(t[i] / 2);
      return Real(line.a[i] / 2) - image;
    };
    const Vector from{row(0), row(1), row(2)};
    const auto halves = [&](std::size_t i) { return difference<Real>(line.b[i] / 2, line.a[i] / 2); };
    const Vector to{halves(0), halves(1), halves(2)};
    const auto in_frame = [&](const Vector& v, double scale) {
      return Vector{dot(r0, v) * whole * Real(by.x) * Real(scale), dot(r1, v) * whole * Real(by.y) * Real(scale),
                    dot(r2, v) * whole * Real(by.z) * Real(scale)};
    };
    const Vector a = in_frame(from, 2);
    Vector d = in_frame(to, 2);
    const Point3 size = rounded(d);
    const double greatest = std::max({std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)});
    d = {d.x * Real(1 / greatest), d.y * Real(1 / greatest), d.z * Real(1 / greatest)};
    const double length = std::sqrt(nearest_double(dot(d, d)));
    way = {d.x * Real(1 / length), d.y * Real(1 / length), d.z * Real(1 / length)};
    nearest = along_by(a, way, -dot(a, way) / dot(way, way));
    const Point3 p = rounded(nearest), w = rounded(way);
    is_finite = std::isfinite(p.x + p.y + p.z + w.x + w.y + w.z);
  }

 private:
  static double nearest_double(const Real& x) { return sunder::nearest(x); }
};

// Which facet the ray from the middle along a direction goes through: over the facet graph, in doubles.
class FacetsByGraph {
 public:
  using Real = double;
  using Vector = Point3;

  FacetsByGraph(const ConvexPolyhedron& body, const FacetGraph& graph, Cost& cost)
      : body_(body),
        graph_(graph.facets),
        number_(graph.number),
        cost_(cost),
        cell_(8.0 / std::max(graph.facets.side, 1u)) {}

  struct Facet {
    std::uint32_t rank = 0;
    Point3 m;
  };
  std::uint32_t number(const Facet& facet) const { return number_[facet.rank]; }

  // For the corners of a facet that will be looked at.
  void ask_ahead(std::uint32_t facet) const {
    const Point3* vertices = body_.vertices().data();
    const auto corners = body_.facet(facet);
    for (const std::size_t k : {std::size_t{0}, corners.size() / 3, 2 * corners.size() / 3}) {
      __builtin_prefetch(vertices + corners[k]);
    }
  }

  // Where a search begins; asks for the memory that it will read.
  std::uint32_t start(const Point3& direction) const { return search_start(graph_, direction); }

  // From its start. Nothing where walks are long.
  std::optional<Facet> along(const Point3& direction, std::uint32_t start_of_it) {
    last_ = direction;
    if (graph_.is_slow) return std::nullopt;
    if (graph_.padded != 0) return of_few(direction);
    return walk_from(start_of_it, direction);
  }
  // From the last one, where that is near.
  std::optional<Facet> going_on(const Point3& direction) {
    const Point3 way = minus(direction, last_);
    const double moved = std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)});
    if (graph_.padded != 0 || !(moved <= cell_)) return along(direction, start(direction));
    last_ = direction;
    return walk_from(place_, direction);
  }

 private:
  static constexpr std::uint64_t most_steps = 32;

  Facet of_few(const Point3& direction) {
    const std::uint32_t f = furthest_of_few(graph_, direction, cost_.probes);
    return {f, graph_.vertices[f]};
  }
  std::optional<Facet> walk_from(std::uint32_t start, const Point3& direction) {
    const Walk end = walk(graph_, direction, start, cost_.probes, most_steps);
    if (!end.has_ended) return std::nullopt;
    place_ = end.place;
    const VertexBlock block = graph_.block(end.place);
    return Facet{block.vertex(), block.at()};
  }

  const ConvexPolyhedron& body_;
  const SearchGraph& graph_;
  const std::vector<std::uint32_t>& number_;
  Cost& cost_;
  const double cell_;  // some cells of the table, as a part of a direction
  Point3 last_;
  std::uint32_t place_ = 0;
};

// The same down the hierarchy, in doubles or in twice the precision.
template <class RealT>
class FacetsByHierarchy {
 public:
  using Real = RealT;
  using Vector = VectorOf<Real>;

  FacetsByHierarchy(const ConvexPolyhedron& body, const FacetGraph& graph, Cost& cost)
      : graph_(graph), hierarchy_(represent::of<Hierarchy>(body)), cost_(cost) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Vector p = scaled(hierarchy_.nodes[k].at);
      middle_ = {middle_.x + p.x * Real(0.25), middle_.y + p.y * Real(0.25), middle_.z + p.z * Real(0.25)};
    }
  }

  struct Facet {
    std::uint32_t rank = 0;  // the facet's number
    Vector m;
  };
  static std::uint32_t number(const Facet& facet) { return facet.rank; }

  static std::uint32_t start(const Vector&) { return 0; }
  static void ask_ahead(std::uint32_t) {}

  std::optional<Facet> along(const Vector& to, std::uint32_t) {
    const auto at = [&](std::uint32_t rank) { return minus(scaled(hierarchy_.nodes[rank].at), middle_); };
    const auto turn = [&](std::uint32_t i, std::uint32_t j) { return sign_of_rounded(dot(cross(at(i), at(j)), to)); };
    const RankTriangle t = triangle_on_ray(hierarchy_, turn, cost_.probes);
    const Vector p = at(t[0]), n = cross(minus(at(t[1]), p), minus(at(t[2]), p));
    const Real h = dot(n, p);
    const std::uint32_t number =
        graph_.facet_of(hierarchy_.nodes[t[0]].vertex, hierarchy_.nodes[t[1]].vertex, hierarchy_.nodes[t[2]].vertex);
    return Facet{number, {n.x / h, n.y / h, n.z / h}};
  }
  std::optional<Facet> going_on(const Vector& to) { return along(to, 0); }

  // From the middle of the facet graph's frame to the middle here.
  const Vector& shift() const { return middle_; }

 private:
  Vector scaled(const Point3& p) const {
    return {difference<Real>(p.x, graph_.center.x) * Real(graph_.to_one.x),
            difference<Real>(p.y, graph_.center.y) * Real(graph_.to_one.y),
            difference<Real>(p.z, graph_.center.z) * Real(graph_.to_one.z)};
  }

  const FacetGraph& graph_;
  const Hierarchy& hierarchy_;
  Cost& cost_;
  Vector middle_{};
};

template <class Facets>
class LineSearch {
 public:
  using Real = typename Facets::Real;
  using Vector = typename Facets::Vector;

  LineSearch(Facets& facets, const Vector& nearest, const Vector& way, Cost& cost)
      : facets_(facets), nearest_(nearest), way_(way), cost_(cost) {}

  // Nothing where the search came to no end. Both ends are begun before one is searched for, as both wait for memory.
  std::optional<LineProposal> run() {
    const Real outside = Real(1) - dot(nearest_, nearest_);
    const Real before = outside > Real(0) ? Real(-std::sqrt(sunder::nearest(outside))) : Real(0);
    const Vector first = along_by(nearest_, way_, before), last = along_by(nearest_, way_, -before);
    const std::uint32_t of_first = facets_.start(first), of_last = facets_.start(last);
    LineProposal found;
    const Ending in = search(way_, first, of_first, found.enters, found.leaves);
    if (in == Ending::none) return std::nullopt;
    if (in == Ending::apart) return LineProposal{LineProposal::Claim::apart, found.enters, found.leaves};
    facets_.ask_ahead(found.enters);
    const Ending out = search(negated(way_), last, of_last, found.leaves, found.enters);
    if (out == Ending::none) return std::nullopt;
    if (out == Ending::apart) found.claim = LineProposal::Claim::apart;
    return found;
  }

 private:
  enum class Ending : std::uint8_t { none, through, apart };
  static constexpr int most_steps = 64;

  // From the first point along the way that is near the body. `enters` is the facet through which it comes in; where it
  // does not, the line in its plane is beyond `leaves`.
  Ending search(const Vector& way, const Vector& from, std::uint32_t start, std::uint32_t& enters,
                std::uint32_t& leaves) {
    auto facet = facets_.along(from, start);
    ++cost_.iterations;
    if (facet && !(dot(facet->m, way) < Real(0))) {
      facet = facets_.along(negated(way), facets_.start(negated(way)));
      ++cost_.iterations;
    }
    Real reached = -std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps && facet; ++step) {
      const Real slope = dot(facet->m, way);
      if (!(slope < Real(0))) return Ending::none;
      const Real at = (Real(1) - dot(facet->m, nearest_)) / slope;
      if (!(at > reached)) return Ending::through;  // what is left is rounding
      reached = at;
      enters = facets_.number(*facet);
      const Vector p = along_by(nearest_, way, at);
      const auto next = facets_.going_on(p);
      ++cost_.iterations;
      if (!next) return Ending::none;
      if (next->rank == facet->rank || !(dot(next->m, p) > Real(1))) return Ending::through;
      if (!(dot(next->m, way) < Real(0))) {
        leaves = facets_.number(*next);
        return Ending::apart;
      }
      facet = next;
    }
    return Ending::none;
  }

  Facets& facets_;
  const Vector nearest_, way_;
  Cost& cost_;
};

// holds(proposal): see polyhedron_line_answer.h. True where one held; so below. In doubles, and then in twice the
// precision.
template <class Holds>
bool propose_by_hierarchy(const Placed& body, const Line& line, const Holds& holds, Cost& cost) {
  const FacetGraph& graph = represent::of<FacetGraph>(body.body);
  const auto propose = [&]<class Real>(const LineInFrame<Real>& frame) {
    if (!frame.is_finite) return false;
    FacetsByHierarchy<Real> facets(body.body, graph, cost);
    const auto from = minus(frame.nearest, facets.shift());
    const auto nearest = along_by(from, frame.way, -dot(from, frame.way) / dot(frame.way, frame.way));
    const auto found = LineSearch(facets, nearest, frame.way, cost).run();
    return found && holds(*found);
  };
  return propose(LineInFrame<double>(body, graph, line)) || propose(LineInFrame<DoubleDouble>(body, graph, line));
}

template <class Holds>
bool propose_by_facets(const Placed& body, const Line& line, const Holds& holds, Cost& cost) {
  const FacetGraph& graph = represent::of<FacetGraph>(body.body);
  const LineInFrame<double> in_frame(body, graph, line);
  if (in_frame.is_finite) {
    FacetsByGraph by_graph(body.body, graph, cost);
    const auto found = LineSearch(by_graph, in_frame.nearest, in_frame.way, cost).run();
    if (found && holds(*found)) return true;
  }
  return propose_by_hierarchy(body, line, holds, cost);
}

}  // namespace sunder::solid

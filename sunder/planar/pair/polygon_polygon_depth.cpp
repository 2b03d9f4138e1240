// The boundary of D = A - B has the edges of A and those of B turned round. The edge of D that an edge e of A becomes
// is e less the vertex of B that is least far along the outward normal of e, which is furthest to the left of e. With
// the origin in D that vertex is on the left of e, and as far from its line as the edge of D is from the origin; the
// same holds of an edge of B and the vertex of A furthest to its left. The depth is the least of these heights.
#include <sunder/base/contract.h>
#include <sunder/certificate/depth_claims.h>
#include <sunder/number/root.h>
#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/in_world.h>
#include <sunder/planar/pair/placed.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_depth.h>
#include <sunder/predicate/coordinates.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::planar {

namespace {

// The square of the height of p above the line: a numerator and a denominator.
template <class Number, class V>
std::pair<Number, Number> height_above(const V& from, const V& to, const V& p) {
  const auto start = coordinates<Number>(from);
  const auto edge = coordinates<Number>(to) - start;
  const Number area = cross(edge, coordinates<Number>(p) - start);
  return {area * area, dot(edge, edge)};
}

// Calls visit(k, v) for each edge of p: it begins at position k, and v is the position of q's vertex furthest to its
// left; of two such vertices the one further along the edge, or else the other one.
template <class P, class Q, class Visit>
void for_each_edge(const P& p, const Q& q, bool further, Cost& cost, StageTally& tally, const Visit& visit) {
  for (std::uint32_t k = 0; p.size() > 1 && k < p.size(); ++k) {
    const auto from = p[k];
    const auto to = vertex_at(p, k + 1);
    visit(k, further ? extreme_vertex_by_bisection(q, from, to, cost, tally)
                     : extreme_vertices_by_bisection(q, to, from, cost, tally).right);
  }
}

// The edge with the least height of those that are tried. Exact numbers are made where intervals do not tell.
template <class A, class B>
class LeastHeight {
 public:
  LeastHeight(const A& a, const B& b) : a_(a), b_(b) {}

  // Edge k of A, or of B, with the other one's vertex.
  void try_edge_of_a(std::uint32_t k, std::uint32_t vertex) { try_edge({true, k, vertex}); }
  void try_edge_of_b(std::uint32_t k, std::uint32_t vertex) { try_edge({false, vertex, k}); }

  std::uint32_t exact_heights() const { return exact_heights_; }

  PolygonDepth depth() {
    PolygonDepth out;
    if (!least_) return out;  // of two points
    const auto& [of_a, i, j] = least_->edge;
    out.edge_of_a = of_a;
    out.edge_of_b = !of_a;
    out.a = of_a ? edge_number(a_, i) : a_.number(i);
    out.b = of_a ? b_.number(j) : edge_number(b_, j);
    const auto way = of_a ? edge_way(a_, i) : edge_way(b_, j);
    out.direction = of_a ? std::array{way.y, -way.x} : std::array{-way.y, way.x};
    out.squared = exact_height(*least_);
    out.depth = root(out.squared);
    return out;
  }

 private:
  struct Edge {
    bool of_a;
    std::uint32_t i, j;  // positions in A and B
  };
  struct Tried {
    Edge edge;
    Interval square;  // of the height
    std::optional<ExactFraction> exact{};
  };

  template <class P>
  static Vector2<Dyadic> edge_way(const P& p, std::uint32_t k) {
    return coordinates<Dyadic>(vertex_at(p, k + 1)) - coordinates<Dyadic>(p[k]);
  }

  template <class Number>
  std::pair<Number, Number> height(const Edge& e) const {
    return e.of_a ? height_above<Number>(a_[e.i], vertex_at(a_, e.i + 1), b_[e.j])
                  : height_above<Number>(b_[e.j], vertex_at(b_, e.j + 1), a_[e.i]);
  }
  const ExactFraction& exact_height(Tried& of) {
    if (!of.exact) {
      ++exact_heights_;
      auto [numerator, denominator] = height<Dyadic>(of.edge);
      of.exact = {std::move(numerator), std::move(denominator)};
    }
    return *of.exact;
  }

  void try_edge(const Edge& edge) {
    const auto [numerator, denominator] = height<Interval>(edge);
    Tried tried{edge, numerator / denominator};
    if (least_) {
      if (tried.square.low > least_->square.high) return;
      const bool is_sure = tried.square.high < least_->square.low;
      if (!is_sure && exact_height(tried) >= exact_height(*least_)) return;
    }
    least_ = std::move(tried);
  }

  const A& a_;
  const B& b_;
  std::optional<Tried> least_;
  std::uint32_t exact_heights_ = 0;
};

PolygonDepthAnswer answer_of(const PairAnswer& pair) {
  PolygonDepthAnswer out;
  out.decided_by = pair.decided_by;
  out.cost = pair.cost;
  if (const auto* apart = std::get_if<Separation>(&pair.evidence)) {
    out.evidence = *apart;
  } else {
    out.evidence = PolygonDepth();
  }
  return out;
}

// The edges of A - B, as pairs of a vertex of A and one of B, each the end of one edge and the start of one.
struct Outline {
  using Corner = std::array<std::uint32_t, 2>;
  std::vector<Corner> corners;
  std::vector<std::array<std::uint32_t, 2>> edges;  // of corners, counterclockwise
};

// A and B may have parallel edges that lie on one edge of A - B. There the edge of A comes first, with the vertex at
// which the edge of B starts; the edge of B follows, with the vertex at which the edge of A ends.
template <class A, class B>
Outline outline_of(const A& a, const B& b) {
  std::vector<std::array<Outline::Corner, 2>> edges;
  Cost cost;
  StageTally tally;
  const auto corner = [&](std::uint32_t i, std::uint32_t j) {
    return Outline::Corner{a.number(position(a, i)), b.number(position(b, j))};
  };
  for_each_edge(a, b, true, cost, tally,
                [&](std::uint32_t k, std::uint32_t v) { edges.push_back({corner(k, v), corner(k + 1, v)}); });
  for_each_edge(b, a, false, cost, tally,
                [&](std::uint32_t k, std::uint32_t v) { edges.push_back({corner(v, k), corner(v, k + 1)}); });
  Outline out;
  for (const auto& edge : edges) out.corners.push_back(edge[0]);
  std::sort(out.corners.begin(), out.corners.end());
  const auto index = [&](const Outline::Corner& of) {
    return static_cast<std::uint32_t>(std::lower_bound(out.corners.begin(), out.corners.end(), of) -
                                      out.corners.begin());
  };
  for (const auto& [from, to] : edges) out.edges.push_back({index(from), index(to)});
  return out;
}

}  // namespace

PolygonDepthAnswer polygon_polygon_depth(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b) {
  PolygonDepthAnswer out = answer_of(polygon_polygon(a, pose_a, b, pose_b));
  if (!out.meet()) return out;
  with_placed(a, pose_a, b, pose_b, [&](const auto& in_a, const auto& in_b) {
    StageTally tally;
    LeastHeight least(in_a, in_b);
    for_each_edge(in_a, in_b, true, out.cost, tally,
                  [&](std::uint32_t k, std::uint32_t v) { least.try_edge_of_a(k, v); });
    for_each_edge(in_b, in_a, true, out.cost, tally,
                  [&](std::uint32_t k, std::uint32_t v) { least.try_edge_of_b(k, v); });
    out.evidence = least.depth();
    out.cost.exact += tally.exact + least.exact_heights();
  });
  return out;
}

PolygonDepthAnswer polygon_polygon_depth_by_scan(const ConvexPolygon& polygon_a, const Pose& pose_a,
                                                 const ConvexPolygon& polygon_b, const Pose& pose_b) {
  PolygonDepthAnswer out = answer_of(polygon_polygon_by_scan(polygon_a, pose_a, polygon_b, pose_b));
  if (!out.meet()) return out;
  const PosedPolygon a(polygon_a, pose_a), b(polygon_b, pose_b);
  // How far A reaches beyond where B begins, along the direction, times its length; and the vertices that say so.
  const auto overlap = [&](const std::array<Dyadic, 2>& d, std::uint32_t& of_a, std::uint32_t& of_b) {
    const auto along = [&](const Posed2& p) {
      const auto at = coordinates<Dyadic>(p);
      return d[0] * at.x + d[1] * at.y;
    };
    for (std::uint32_t k = 0; k < a.size(); ++k) {
      if ((along(a[k]) - along(a[of_a])).sign() == Sign::positive) of_a = k;
    }
    for (std::uint32_t k = 0; k < b.size(); ++k) {
      if ((along(b[k]) - along(b[of_b])).sign() == Sign::negative) of_b = k;
    }
    return along(a[of_a]) - along(b[of_b]);
  };
  PolygonDepth best;
  const auto try_edges = [&](const PosedPolygon& p, bool of_a) {
    for (std::uint32_t k = 0; p.size() > 1 && k < p.size(); ++k) {
      const auto edge = coordinates<Dyadic>(vertex_at(p, k + 1)) - coordinates<Dyadic>(p[k]);
      const std::array<Dyadic, 2> d = of_a ? std::array{edge.y, -edge.x} : std::array{-edge.y, edge.x};
      std::uint32_t i = 0, j = 0;
      const Dyadic reach = overlap(d, i, j);
      ExactFraction squared{reach * reach, d[0] * d[0] + d[1] * d[1]};
      const bool is_first = !best.edge_of_a && !best.edge_of_b;
      if (!is_first && squared >= best.squared) continue;
      best.edge_of_a = of_a;
      best.edge_of_b = !of_a;
      best.a = of_a ? edge_number(a, k) : a.number(i);
      best.b = of_a ? b.number(j) : edge_number(b, k);
      best.direction = d;
      best.squared = std::move(squared);
    }
  };
  try_edges(a, true);
  try_edges(b, false);
  best.depth = root(best.squared);
  out.evidence = best;
  return out;
}

Sign compare_depth(const PolygonDepth& depth, double than) {
  SUNDER_REQUIRE(than >= 0 && std::isfinite(than));
  return compare_root(depth.squared, than);
}

void add_depth(ClaimsWriter& file, std::uint32_t index_a, std::uint32_t index_b, const ConvexPolygon& a,
               const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b, const PolygonDepth& depth) {
  if (std::isfinite(depth.depth.high)) add_depth_at_most(file, index_a, index_b, depth.depth.high, depth.direction);
  if (!(depth.depth.low > 0) || !std::isfinite(depth.depth.low)) return;
  const Outline outline =
      with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) { return outline_of(in_a, in_b); });
  add_depth_at_least(file, index_a, index_b, depth.depth.low, outline.corners, outline.edges);
}

}  // namespace sunder::planar

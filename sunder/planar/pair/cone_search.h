// Do two convex polygons meet: a triangle in each; a triangle in their difference; then one search behind one of its
// sides.
//
// Where two triangles meet, each of three vertices a third of the way round apart, the polygons do. Else:
// D = A - B holds the origin iff A and B meet (minkowski_difference_search.h). In doubles: r is a difference of
// vertices, s the vertex of D furthest from r towards the origin, t the one furthest from the line rs on the origin's
// side. Where the origin is beyond s, or beyond t, A and B are apart; this is how most pairs that are apart are told.
// Where it is in the triangle rst they meet. Else it is beyond the side st, seen from r, or beyond rt, seen from s (not
// both: D would not reach that far). The ray from there through the origin leaves D behind that side: between two
// vertices of D that are known, which bound the chains of edges to be searched. (Without the triangle, finding the
// chains takes half of a search.)
//
// Beyond rt the chain does not end with r where r, a difference of any two vertices, is inside of D. Where what is
// proposed there does not hold, the chain is ended with w instead, the vertex of D furthest to that side of the ray.
//
// All of this proposes. What is proposed does not hold where rounding spoils it, near contact.
// Cost: two searches for a furthest vertex in each polygon, then two probes for each halving of what is left: at most
// 4 (log2 n + log2 m) + O(1); with w, about twice in 1,000 pairs, three more for each halving.
#pragma once

#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/planar/pair/proposal.h>
#include <sunder/planar/pair/support.h>

namespace sunder::planar {

namespace cone_search {

// Three vertices of each, a third of the way round apart: do their triangles meet? Most polygons that have more than a
// little in common are told by this.
template <class A, class B, class Holds>
bool thirds_meet(const A& a, const B& b, const Holds& holds, Cost& cost) {
  using in_doubles::dot;
  using in_doubles::operator-;
  const auto thirds = [](std::uint32_t n) { return std::array{0u, n / 3, n - n / 3}; };
  const std::array at_a = thirds(a.size()), at_b = thirds(b.size());
  cost.probes += 6;
  // Seen along the arrow from the middle of one to that of the other: most that do not meet are told apart by this.
  const std::array<Point2, 3> p{a.rounded(at_a[0]), a.rounded(at_a[1]), a.rounded(at_a[2])};
  const std::array<Point2, 3> q{b.rounded(at_b[0]), b.rounded(at_b[1]), b.rounded(at_b[2])};
  const Point2 along{((q[0].x - p[0].x) + (q[1].x - p[1].x)) + (q[2].x - p[2].x),
                     ((q[0].y - p[0].y) + (q[1].y - p[1].y)) + (q[2].y - p[2].y)};
  const double end = std::max({dot(along, p[0]), dot(along, p[1]), dot(along, p[2])});
  const double start = std::min({dot(along, q[0]), dot(along, q[1]), dot(along, q[2])});
  return start <= end && holds(meet_plainly(at_a, at_b));
}

// Edges of the polygon from the position `begin` on to the position `end`.
inline EdgeRun run_between(std::uint32_t begin, std::uint32_t end, std::uint32_t n) {
  return {begin, end < begin ? end + n : end};
}

// The origin is seen from `apex` between `from` and `to`, counter-clockwise in this order: does the ray leave D through
// an edge between these two that decides?
template <class A, class B, class Holds>
bool propose_behind(const A& a, const B& b, const Difference& apex, const Difference& from, const Difference& to,
                    const Holds& holds, Cost& cost, StageTally& tally) {
  const EdgeRun chain_a = run_between(from.i, to.i, a.size()), chain_b = run_between(from.j, to.j, b.size());
  if (chain_a.empty() && chain_b.empty()) return false;
  const auto [of_a, i, j] = minkowski_difference_search::exit_edge(a, apex.i, b, apex.j, chain_a, chain_b, cost, tally);
  if (of_a) {
    return holds(apart_by_edge_of_a(i, j)) || holds(meet(std::array{apex.i, i, i + 1}, std::array{apex.j, j}));
  }
  return holds(apart_by_edge_of_b(i, j)) || holds(meet(std::array{apex.i, i}, std::array{apex.j, j, j + 1}));
}

}  // namespace cone_search

// Requires three vertices at least of both. holds(proposal): see answer_by in polygon_polygon_answer.h.
template <class A, class B, class Holds>
bool propose_by_cone(const A& a, const B& b, const Holds& holds, Cost& cost, StageTally& tally) {
  using in_doubles::cross;
  using in_doubles::dot;
  using in_doubles::operator-;
  if (cone_search::thirds_meet(a, b, holds, cost)) return true;
  const SupportOfDifference support(a, b, cost);
  const auto is_apart = [&](const Difference& w) { return holds(apart_at_vertices(w.i, w.j)); };

  const Difference r = support.vertex(0, 0);
  const Point2 to_origin{-r.p.x, -r.p.y};
  const Difference s = support.furthest_along(to_origin);
  if (dot(to_origin, s.p) < 0) return is_apart(s);
  const double side = cross(r.p, s.p);  // positive: the origin is to the left of the arrow from r to s
  const Point2 along = s.p - r.p, across = side > 0 ? Point2{-along.y, along.x} : Point2{along.y, -along.x};
  const Difference t = support.furthest_along(across);
  if (dot(across, t.p) < 0) return is_apart(t);

  // Counter-clockwise: r, s, t where `side` is positive, else r, t, s.
  const bool left = side > 0;
  const double st = left ? cross(s.p, t.p) : cross(t.p, s.p), tr = left ? cross(t.p, r.p) : cross(r.p, t.p);
  if (st < 0) {
    return cone_search::propose_behind(a, b, r, left ? s : t, left ? t : s, holds, cost, tally);
  }
  if (tr < 0) {
    if (cone_search::propose_behind(a, b, s, left ? t : r, left ? r : t, holds, cost, tally)) return true;
    const Difference w = support.furthest_along(left ? Point2{s.p.y, -s.p.x} : Point2{-s.p.y, s.p.x});
    return cone_search::propose_behind(a, b, s, left ? t : w, left ? w : t, holds, cost, tally);
  }
  return holds(meet(std::array{r.i, s.i, t.i}, std::array{r.j, s.j, t.j}));
}

}  // namespace sunder::planar

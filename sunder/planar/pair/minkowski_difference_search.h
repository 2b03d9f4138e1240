// Do two convex polygons meet: a search for the edge of their difference through which a ray leaves it.
// Also called: search over the Minkowski difference, the configuration space obstacle (C-obstacle).
//
// D = A - B, the polygon of all differences a - b, holds the origin iff A and B meet. Its vertices are differences of
// vertices; its edges are those of A and those of B turned round, in the order of their directions. r = a0 - b0 is in
// D. The ray from r through the origin, along u = b0 - a0, leaves D through an edge e of the chain of those that point
// to its left; the origin is in D iff it is on the inner side of e.
//
// Along that chain the heights u x (v - r) = u x (a_i - b_j) of the vertices grow, so e is the first edge whose end has
// a height that is not negative. Neither the chain nor its order is stored: edges i of A and j of B in the middle of
// what is left of either are compared by direction. Let i come first.
//   - Is the vertex (i + 1, j) below the ray? Then so is the end of edge i, which is some (i + 1, j') with j' <= j:
//     e is not among the edges of A up to i.
//   - Else the start of edge j, some (i', j) with i' > i, is not below: e is not among the edges of B from j on.
// So each step halves one of the two, by two signs. All signs are those of products of two differences.
// Cost: two probes for each halving, and as many again to find the chains (edge_runs.h).
//
// The idea, that the middle edges of two sorted chains tell which of them may be cut, is that of finding an element of
// given rank in two sorted arrays at once; the question is that of Chazelle & Dobkin 1987, section 2.4.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/pair/evidence.h>

namespace sunder::planar {

namespace minkowski_difference_search {

// What is asked about D beyond the origin being in it.
struct Found {
  bool meet = false;
  bool inside = false;     // the origin is in the relative interior of D; unknown (false) where `at_corner`
  bool at_corner = false;  // a0 and b0 are one point

  // The edges to the left of the ray, and e: edge `edge_a` of A where `of_a`, else edge `edge_b` of B; the other number
  // is the vertex that belongs to it. Where D is on the ray's line there are no edges: the vertices furthest along it.
  EdgeRun chain_a{}, chain_b{};
  bool of_a = true;
  std::uint32_t edge_a = 0, edge_b = 0;
};

// An edge of D: edge i of A with vertex j of B where of_a, else edge j of B with vertex i of A. Numbers modulo n.
struct Edge {
  bool of_a = true;
  std::uint32_t i = 0, j = 0;
};

// The height u x (v - r) of vertex (i, j) of D.
template <class A, class B>
Sign height(const A& a, std::uint32_t of_a, const B& b, std::uint32_t of_b, std::uint32_t i, std::uint32_t j,
            StageTally& tally) {
  if (position(a, i) == of_a && position(b, j) == of_b) return Sign::zero;  // where the ray begins
  return cross_2d(a[of_a], b[of_b], vertex_at(b, j), vertex_at(a, i), &tally);
}

// Which side of edge e of p is vertex k of q on?
template <class P, class Q>
Sign side_of_edge(const P& p, std::uint32_t e, const Q& q, std::uint32_t k, StageTally& tally) {
  const auto &from = vertex_at(p, e), &to = vertex_at(p, position(p, e) + 1);
  return cross_2d(from, to, from, vertex_at(q, k), &tally);
}

// The edge e among those of two chains, not both empty. Where the ray leaves D elsewhere: any of them.
template <class A, class B>
Edge exit_edge(const A& a, std::uint32_t of_a, const B& b, std::uint32_t of_b, const EdgeRun& chain_a,
               const EdgeRun& chain_b, Cost& cost, StageTally& tally) {
  std::uint32_t low_a = chain_a.begin, high_a = chain_a.end, low_b = chain_b.begin, high_b = chain_b.end;
  const auto below = [&](std::uint32_t i, std::uint32_t j) {
    ++cost.probes;
    return height(a, of_a, b, of_b, i, j, tally) == Sign::negative;
  };
  while (low_a < high_a && low_b < high_b) {
    ++cost.iterations;
    ++cost.probes;
    const std::uint32_t i = low_a + (high_a - low_a) / 2, j = low_b + (high_b - low_b) / 2;
    const bool a_first = cross_2d(vertex_at(a, i), vertex_at(a, position(a, i) + 1),  //
                                  vertex_at(b, position(b, j) + 1), vertex_at(b, j), &tally) != Sign::negative;
    if (a_first) {
      if (below(position(a, i) + 1, j)) {
        low_a = i + 1;
      } else {
        high_b = j;
      }
    } else if (below(i, position(b, j) + 1)) {
      low_b = j + 1;
    } else {
      high_a = i;
    }
  }
  // One chain has no edge left, so that its vertex is known.
  if (low_a < high_a) {
    const std::uint32_t i = first_where(low_a, high_a - 1, [&](std::uint32_t k) {
      ++cost.iterations;
      return !below(position(a, k) + 1, low_b);
    });
    return {true, i, low_b};
  }
  const std::uint32_t j = first_where(low_b, high_b - 1, [&](std::uint32_t k) {
    ++cost.iterations;
    return !below(low_a, position(b, k) + 1);
  });
  return {false, low_a, j};
}

}  // namespace minkowski_difference_search

// Decides exactly, with positions `of_a` and `of_b` for a0 and b0. Fills in the certificate.
template <class A, class B>
minkowski_difference_search::Found search_difference(const A& a, std::uint32_t of_a, const B& b, std::uint32_t of_b,
                                                     PairCertificate& certificate, Cost& cost, StageTally& tally) {
  using minkowski_difference_search::Edge;
  using minkowski_difference_search::exit_edge;
  using minkowski_difference_search::height;
  using minkowski_difference_search::side_of_edge;
  const auto a0 = a[of_a];
  const auto b0 = b[of_b];
  if (evidence::equal(a0, b0, tally)) {
    check_meet(a, {&of_a, 1}, b, {&of_b, 1}, certificate, tally);
    return {.meet = true, .inside = false, .at_corner = true};
  }
  const EdgeRun chain_a = edges_to_left(a, a0, b0, cost, tally), chain_b = edges_to_left(b, b0, a0, cost, tally);
  const auto found = [&](bool meet, bool inside, bool of_edge_a, std::uint32_t i, std::uint32_t j) {
    return minkowski_difference_search::Found{meet, inside, false, chain_a, chain_b, of_edge_a, i, j};
  };
  if (chain_a.empty() && chain_b.empty()) {  // points, and segments along u: what is furthest along it
    const auto last_along = [&](const auto& p, const auto& from, const auto& to) {
      return p.size() == 2 && dot_2d(from, to, p[0], p[1], &tally) == Sign::positive ? 1u : 0u;
    };
    const std::uint32_t i = last_along(a, a0, b0), j = last_along(b, b0, a0);
    const Sign beyond = dot_2d(a0, b0, a[i], b[j], &tally);  // of b's end beyond that of a
    if (beyond == Sign::positive) {
      certificate = Separation{
          {.kind = Direction::Kind::difference, .index = {a.number(of_a), b.number(of_b)}}, a.number(i), b.number(j)};
      return found(false, false, true, i, j);
    }
    check_meet(a, std::array{of_a, i}, b, std::array{of_b, j}, certificate, tally);
    return found(true, beyond == Sign::negative, true, i, j);
  }

  const Edge exit = exit_edge(a, of_a, b, of_b, chain_a, chain_b, cost, tally);
  // The ray does not run along an edge of D, nor through a vertex only: D is on both sides of it.
  const auto is_inner_ray = [&] {
    cost.probes += 2;
    return height(a, of_a, b, of_b, chain_a.begin, chain_b.begin, tally) == Sign::negative &&
           height(a, of_a, b, of_b, chain_a.end, chain_b.end, tally) == Sign::positive;
  };
  if (exit.of_a) {
    const Sign side = side_of_edge(a, exit.i, b, exit.j, tally);
    if (side == Sign::negative) {
      certificate = apart_by_edge_of_a(a, exit.i, b, exit.j);
      return found(false, false, true, exit.i, exit.j);
    }
    check_meet(a, std::array{of_a, exit.i, exit.i + 1}, b, std::array{of_b, exit.j}, certificate, tally);
    return found(true, side == Sign::positive && is_inner_ray(), true, exit.i, exit.j);
  }
  const Sign side = side_of_edge(b, exit.j, a, exit.i, tally);
  if (side == Sign::negative) {
    certificate = apart_by_edge_of_b(a, exit.i, b, exit.j);
    return found(false, false, false, exit.i, exit.j);
  }
  check_meet(a, std::array{of_a, exit.i}, b, std::array{of_b, exit.j, exit.j + 1}, certificate, tally);
  return found(true, side == Sign::positive && is_inner_ray(), false, exit.i, exit.j);
}

// Touching or overlapping? Where the two vertices that the ray begins with are one point, another vertex is taken.
template <class A, class B>
Relation contact_by_difference(const A& a, const B& b) {
  PairCertificate certificate;
  Cost cost;
  StageTally tally;
  const std::uint32_t other_a = a.size() > 1 ? 1 : 0, other_b = a.size() > 1 || b.size() == 1 ? 0 : 1;
  auto found = search_difference(a, 0, b, 0, certificate, cost, tally);
  if (found.at_corner) found = search_difference(a, other_a, b, other_b, certificate, cost, tally);
  if (!found.meet) return Relation::none;
  return found.inside || found.at_corner ? Relation::overlapping : Relation::touching;  // at_corner: two points
}

}  // namespace sunder::planar

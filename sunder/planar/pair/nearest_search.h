// Gilbert, Johnson & Keerthi 1988 in the plane: which point of the difference D = A - B is nearest to the origin? A and
// B meet iff it is the origin.
// Also called: GJK algorithm; distance of the origin to the Minkowski difference.
//
// A simplex, of one to three vertices of D, walks towards the origin: the part of it that is nearest to the origin is
// kept, and the vertex of D that is furthest from there in the direction of the origin (a difference of two support
// vertices) is added. If the origin is beyond this vertex, then A and B are apart; if it is in the simplex, then they
// meet; if the vertex is no further than the part kept, then that part is the nearest of D.
// All of this in doubles. In the plane the nearest point itself is not needed: from an edge of the simplex the way is
// at a right angle.
//
// Everything here proposes.
#pragma once

#include <sunder/planar/pair/proposal.h>
#include <sunder/planar/pair/support.h>

namespace sunder::planar {

namespace nearest_search {

using in_doubles::cross;
using in_doubles::dot;
using in_doubles::operator-;

struct Simplex {
  std::array<Difference, 3> at{};
  std::uint32_t size = 0;

  void add(const Difference& w) { at[size++] = w; }
  bool has(const Difference& w) const {
    for (std::uint32_t k = 0; k < size; ++k) {
      if (at[k].i == w.i && at[k].j == w.j) return true;
    }
    return false;
  }

  // Keeps the part nearest to the origin; returns the direction from there to the origin, or {0, 0} where the origin is
  // in the simplex. Of three vertices the last one is new, and the origin is not beyond the edge of the others.
  Point2 reduce() {
    if (size == 3) {
      const Difference w = at[2];
      const Point2 to_u = at[0].p - w.p, to_v = at[1].p - w.p;
      // Is the origin strictly beyond the edges that w has with them?
      const double turn = cross(to_u, to_v), of_u = cross(at[0].p, w.p), of_v = cross(w.p, at[1].p);
      const bool past_u = turn > 0 ? of_u > 0 : of_u < 0, past_v = turn > 0 ? of_v > 0 : of_v < 0;
      if (!past_u && !past_v) return {0, 0};
      // Past both, it can still be nearest to the inside of one of them.
      size = 0;
      if (past_u && (!past_v || dot(w.p, to_u) < 0)) {
        add(at[0]);
      } else if (past_v && (!past_u || dot(w.p, to_v) < 0)) {
        add(at[1]);
      }
      add(w);
    }
    if (size == 2) {
      const Point2 &u = at[0].p, &v = at[1].p, along = v - u;
      if (dot(along, u) < 0 && dot(along, v) > 0) {
        const double side = cross(u, v);  // positive: the origin is to the left of the arrow from u to v
        if (side == 0) return {0, 0};
        return side > 0 ? Point2{-along.y, along.x} : Point2{along.y, -along.x};
      }
      if (dot(along, u) < 0) at[0] = at[1];
      size = 1;
    }
    return {-at[0].p.x, -at[0].p.y};
  }
};

}  // namespace nearest_search

// holds(proposal): see answer_by in polygon_polygon_answer.h.
template <class A, class B, class Holds>
bool propose_by_nearest(const A& a, const B& b, const Holds& holds, Cost& cost) {
  using in_doubles::dot;
  using in_doubles::operator-;
  using nearest_search::Simplex;
  constexpr std::uint32_t most_rounds = 64;
  const SupportOfDifference support(a, b, cost);
  Difference furthest = support.vertex(0, 0);
  Simplex simplex;
  const auto are_apart = [&] { return holds(apart_at_vertices(furthest.i, furthest.j)); };
  simplex.add(furthest);
  while (cost.iterations < most_rounds) {
    ++cost.iterations;
    const Point2 d = simplex.reduce();
    if (d.x == 0 && d.y == 0) break;
    furthest = support.furthest_along(d);
    if (dot(d, furthest.p) < 0 && are_apart()) return true;
    if (simplex.has(furthest) || !(dot(d, furthest.p - simplex.at[0].p) > 0)) break;
    simplex.add(furthest);
  }
  // The origin is in the simplex, or nearest to it, or the rounds are used up.
  std::array<std::uint32_t, 3> in_a{}, in_b{};
  for (std::uint32_t k = 0; k < simplex.size; ++k) in_a[k] = simplex.at[k].i, in_b[k] = simplex.at[k].j;
  const Corners of_simplex_a{in_a.data(), simplex.size}, of_simplex_b{in_b.data(), simplex.size};
  if (holds(meet(of_simplex_a, of_simplex_b)) || are_apart()) return true;
  // As rounding may have it, they only just overlap, beside the two vertices that are nearest to parting them.
  const auto [i, j, p] = furthest;
  return holds(meet(std::array{i, i + 1, i + a.size() - 1}, std::array{j, j + 1, j + b.size() - 1}));
}

}  // namespace sunder::planar

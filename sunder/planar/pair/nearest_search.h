// Gilbert, Johnson & Keerthi 1988 in the plane: which point of the difference D = A - B is nearest to the origin? A and
// B meet iff it is the origin.
//
// A simplex, of one to three vertices of D, walks towards the origin: the part of it that is nearest to the origin is
// kept, and the vertex of D that is furthest from there in the direction of the origin (a difference of two support
// vertices) is added. If the origin is beyond this vertex, then A and B are apart; if it is in the simplex, then they
// meet; if the vertex is no further than the part kept, then that part is the nearest of D.
// All of this in doubles. In the plane the nearest point itself is not needed: from an edge of the simplex the way is
// at a right angle.
//
// Everything here proposes; a proposal is checked exactly.
#pragma once

#include <sunder/planar/pair/proposal.h>

namespace sunder::planar {

namespace nearest_search {

using in_doubles::cross;
using in_doubles::dot;
using in_doubles::operator-;
using in_doubles::scaled;

// The arrow from p to q.
inline Point2 arrow(const Point2& p, const Point2& q) { return q - p; }
inline Point2 arrow(const Posed2& p, const Posed2& q) {
  const auto& m = p.pose->linear;
  const Point2 v = q.point - p.point;
  return {m[0] * v.x + m[1] * v.y, m[2] * v.x + m[3] * v.y};
}

// The polygon's vertex that is furthest along a direction: log2 n + O(1) probes.
template <class Sequence>
class Support {
 public:
  Support(const Sequence& sequence, double scale, Cost& cost) : sequence_(sequence), scale_(scale), cost_(cost) {
    const auto [below, above] = sequence.up();
    up_ = arrow(below, above);
  }

  Point2 vertex(std::uint32_t k) const { return scaled(sequence_.rounded(k), scale_); }

  // Where the edges begin that descend, seen along d; these are to the left of d turned left: see edge_runs.h. Where
  // rounding takes the wrong half, the extreme vertex is at an end of it.
  std::uint32_t furthest_along(const Point2& d) const {
    const std::uint32_t n = sequence_.size();
    const double down = -dot(d, up_), upward = down != 0 ? down : cross(d, up_);
    const std::uint32_t first = upward > 0 ? sequence_.first() : sequence_.second();
    std::uint32_t second = upward > 0 ? sequence_.second() : sequence_.first();
    if (second < first) second += n;
    const std::uint32_t k = first_where(first, second, [&](std::uint32_t e) {
      ++cost_.probes;
      return dot(d, vertex(position(sequence_, position(sequence_, e) + 1)) - vertex(position(sequence_, e))) < 0;
    });
    return position(sequence_, k);
  }

 private:
  const Sequence& sequence_;
  double scale_;
  Cost& cost_;
  Point2 up_;
};

// A vertex of D: that of a at position i, less that of b at position j.
struct Difference {
  std::uint32_t i = 0, j = 0;
  Point2 p{};
};

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

// When to give up: after so many rounds; where the vertex found is beyond the origin by less than this part of how far
// the simplex is on its other side, which tells a contact, or nearly one. To the end: propose what is likely then.
struct Patience {
  std::uint32_t rounds = 64;
  double near = 0;
  bool to_the_end = true;
};

template <class A, class B>
bool search_nearest(const A& a, const B& b, const Patience& patience, PairCertificate& certificate, Cost& cost,
                    StageTally& tally) {
  using nearest_search::Difference;
  using nearest_search::dot;
  using nearest_search::operator-;
  using nearest_search::Simplex;
  using nearest_search::Support;
  const double scale = scale_near_one({a.rounded(0), a.rounded(a.size() / 2), b.rounded(0), b.rounded(b.size() / 2)});
  const Support of_a(a, scale, cost), of_b(b, scale, cost);
  Difference furthest{0, 0, of_a.vertex(0) - of_b.vertex(0)};
  cost.probes += 2;
  Simplex simplex;
  const auto are_apart = [&] { return propose_apart(a, furthest.i, b, furthest.j, certificate, tally); };
  simplex.add(furthest);
  bool inside = false;
  while (cost.iterations < patience.rounds) {
    ++cost.iterations;
    const Point2 d = simplex.reduce();
    inside = d.x == 0 && d.y == 0;
    if (inside) break;
    furthest.i = of_a.furthest_along(d);
    furthest.j = of_b.furthest_along({-d.x, -d.y});
    furthest.p = of_a.vertex(furthest.i) - of_b.vertex(furthest.j);
    cost.probes += 2;
    const double beyond = dot(d, furthest.p);
    if (beyond < 0 && are_apart()) return true;
    if (beyond >= 0 && beyond < -patience.near * dot(d, simplex.at[0].p)) return false;
    if (simplex.has(furthest) || !(dot(d, furthest.p - simplex.at[0].p) > 0)) break;
    simplex.add(furthest);
  }
  if (!inside && !patience.to_the_end) return false;
  // The origin is in the simplex, or nearest to it, or the rounds are used up.
  std::array<std::uint32_t, 3> in_a{}, in_b{};
  for (std::uint32_t k = 0; k < simplex.size; ++k) in_a[k] = simplex.at[k].i, in_b[k] = simplex.at[k].j;
  const Corners of_simplex_a{in_a.data(), simplex.size}, of_simplex_b{in_b.data(), simplex.size};
  if (check_meet(a, of_simplex_a, b, of_simplex_b, certificate, tally) || are_apart()) return true;
  // As rounding may have it, they only just overlap, beside the two vertices that are nearest to parting them.
  const auto [i, j, p] = furthest;
  return check_meet(a, std::array{i, i + 1, i + a.size() - 1}, b, std::array{j, j + 1, j + b.size() - 1}, certificate,
                    tally);
}

}  // namespace sunder::planar

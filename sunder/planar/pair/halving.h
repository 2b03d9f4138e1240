// Chazelle & Dobkin 1987, section 2.4: two chains, one of each polygon, are halved until one of them is short (IGG).
//
// A and B are the first vertices of the polygons P and Q, neither in the other polygon. The pencil of tangents from A
// to Q holds Q, that from B to P holds P. So what P and Q have in common is in both pencils, and what counts of P is
// the chain of its edges v in the pencil of A, what counts of Q the chain of its edges w in that of B. INTERSECT looks
// at the middle edge of either chain and cuts off what is before or after it. Vertices run counter-clockwise, so that
// the figures are those of the paper in a mirror: x is to the left of the arrow from A to B, y to its right.
//
// Everything is decided by signs about vertices. The paper compares the points E, F, G, H where the lines of the two
// edges leave the pencils, and so needs the corners X and Y, which may be at infinity or beyond. What it cuts off, it
// turns out, depends on the following only.
//   Case 1. B is not beyond the line of v (so that F and G are on one side of AB): the edge's own side of AB decides.
//   Case 3. The turn from v to w tells which two of the four ends may be beyond the other edge's line; one that is, or
//           is on it, cuts its chain. Where the lines cross outside the pencils, the paper has case 2, apart; but then
//           what Theorem 4 needs is not cut off either: the line of an edge before the cut has Q ahead of the edge,
//           and that of an edge behind it has Q behind, if they cross Q at all. So it is sound to cut anyway.
//   Case 5. v and w are both behind the other's line: the side of w from A v decides for both chains.
// That leaves case 2 as a way to be done early. Only there a point is constructed, in floating point: where the two
// lines cross. If it seems to be outside the pencils, then one of the two edges should part the polygons; should none
// of them, the search goes on with case 3.
//
// When a chain has less than six vertices, at most four edges of its polygon are left (Theorem 4). Take P: by the
// intersection of an edge's line with Q (IGL), the edge parts the polygons, or meets Q, or Q crosses the line ahead of
// the edge, or behind it. Where ahead turns to behind, at a vertex p, the paper parts the polygons by a line through p.
// Every edge of Q that faces p does as well: the normals that part p from Q make one arc, and neither normal of the
// edges at p is in it, so that P has no vertex but p furthest along any of them. And the lines' intersections with Q
// end at such edges. (If Q is behind even the first edge left, or ahead of even the last, then it meets P in what was
// cut off, and so the chord of that, or the edge in which the chain began or ended.)
//
// Departures from the paper: signs for constructed points, vertex 0 for a point within the polygon, an edge that faces
// p for a line through it; and the chains' ends, which may be within edges, are kept as the numbers of these edges.
#pragma once

#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/proposal.h>

#include <array>
#include <cstdint>

namespace sunder::planar {

namespace halving {

// What a point sees of a polygon of three vertices at least.
struct View {
  bool inside = false;      // it is in the polygon: in the triangle of vertices 0, wedge and wedge + 1
  std::uint32_t wedge = 0;  // meaningless where the point is not inside
  // Else: seen from the point, the polygon is between these vertices. Edges from `left` on, up to `right`, face it.
  std::uint32_t left = 0, right = 0;
};

// Step (I). The paper takes a point within the polygon; its vertex 0 does as well.
// Cost: 2 log2 n + O(1) probes where the point is inside or sees one edge at vertex 0 only; else 3 log2 n + O(1).
template <class P>
View view_from(const typename P::Vertex& point, const P& p, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  const auto faces = [&](std::uint32_t k) {
    ++cost.probes;
    const auto& from = p[k];
    return cross_2d(from, vertex_at(p, k + 1), from, point, &tally) == Sign::negative;
  };
  const auto does_not_face = [&](std::uint32_t k) { return !faces(k); };
  const bool first_faces = faces(0), last_faces = faces(n - 1);
  if (first_faces && !last_faces) return {.left = 0, .right = first_where(1, n - 1, does_not_face)};
  if (last_faces && !first_faces) return {.left = first_where(1, n - 1, faces), .right = 0};
  // The line through vertex 0 and the point goes through the polygon: which edge does it leave it by?
  const auto& apex = p[0];
  const Sign not_yet = first_faces ? Sign::negative : Sign::positive;
  const std::uint32_t across = first_where(1, n - 2, [&](std::uint32_t k) {
    ++cost.probes;
    return cross_2d(apex, p[k + 1], apex, point, &tally) != not_yet;
  });
  if (first_faces) {
    return {.left = position(p, first_where(across + 1, n - 1, faces)), .right = first_where(1, across, does_not_face)};
  }
  if (!faces(across)) return {.inside = true, .wedge = across};
  return {.left = first_where(1, across, faces), .right = first_where(across + 1, n - 1, does_not_face)};
}

// What is left of a polygon's chain: edges low - 1 .. high are, and vertices low .. high between them.
struct Chain {
  std::uint32_t low = 0, high = 0;
  std::uint32_t begin = 0, end = 0;  // its first and its last edge before anything was cut off
  bool is_short() const { return high < low + 3; }
  std::uint32_t middle() const { return low + (high - low - 1) / 2; }  // of its edges; requires that it is not short
};

// Step (II): the edges of p in the pencil at its vertex 0 from `right` to `left`. Its first edge begins at vertex 0, or
// outside the pencil, or on its border; so it is with the end of its last edge. If the pencil does not enter p, then
// these are the last edge of p and the first one. Cost: 2 log2 n + O(1) probes.
template <class P>
Chain chain_in_pencil(const P& p, const typename P::Vertex& right, const typename P::Vertex& left, Cost& cost,
                      StageTally& tally) {
  const std::uint32_t n = p.size();
  const auto &apex = p[0], &first = p[1], &last = p[n - 1];
  const auto turn = [&](const auto& from, const auto& to) { return cross_2d(apex, from, apex, to, &tally); };
  const auto between = [&](const auto& point, const auto& from, const auto& to) {
    return turn(from, point) != Sign::negative && turn(point, to) != Sign::negative;
  };
  cost.probes += 2;
  const bool right_enters = between(right, first, last), left_enters = between(left, first, last);
  Chain c;
  if (!right_enters && !between(first, right, left)) {
    c.low = c.high = n;
  } else {
    const auto is_past_right = [&](std::uint32_t k) {
      ++cost.probes;
      return turn(right, p[k]) != Sign::negative;
    };
    const auto is_past_left = [&](std::uint32_t k) {
      ++cost.probes;
      return turn(p[k], left) == Sign::negative;
    };
    c.low = right_enters ? first_where(1, n - 1, is_past_right) : 1;
    c.high = left_enters ? first_where(c.low, n, is_past_left) - 1 : n - 1;
  }
  c.begin = c.low - 1;
  c.end = c.high;
  return c;
}

// Case 1 for the chain of p and its edge i.
template <class P>
bool cut_on_one_side(const P& p, Chain& chain, std::uint32_t i, const typename P::Vertex& other_apex,
                     StageTally& tally) {
  const auto &v = p[i], &apex = p[0];
  if (cross_2d(v, p[i + 1], v, other_apex, &tally) == Sign::negative) return false;
  if (cross_2d(apex, other_apex, apex, v, &tally) == Sign::positive) {
    chain.high = i + 1;
  } else {
    chain.low = i;
  }
  return true;
}

// Where does the line through two points cross a polygon?
struct LineCrossing {
  enum class Place : std::uint8_t {
    right,   // nowhere: the polygon is strictly to the right of the arrow; vertex `edge` is nearest
    left,    // nowhere: it is strictly to the left
    ahead,   // strictly ahead of the segment between the points; edge `edge` of the polygon faces the arrow's head
    behind,  // strictly behind the segment; edge `edge` faces its tail
    within,  // the segment meets the polygon: the line enters it by edge `edge` and leaves it by edge `exit`
  };
  Place place;
  std::uint32_t edge = 0, exit = 0;
};

// IGL for q, of three vertices at least. Exact.
// Cost: log2 n + O(1) probes for `right`, and as many more for `ahead`, and for `behind` and `within` again; twice that
// much again at most where vertex 0 of q is not to the right of the line.
template <class Q>
LineCrossing cross_line(const typename Q::Vertex& tail, const typename Q::Vertex& head, const Q& q, Cost& cost,
                        StageTally& tally) {
  using enum LineCrossing::Place;
  const std::uint32_t n = q.size();
  const auto side = [&](std::uint32_t k) {
    ++cost.probes;
    return cross_2d(tail, head, tail, vertex_at(q, k), &tally);
  };
  std::uint32_t top = extreme_vertex_by_bisection(q, tail, head, cost, tally);
  const Sign leftmost = side(top);
  if (leftmost == Sign::negative) return {right, top};
  // A vertex to the right of the line: vertex 0, or the one furthest to the right.
  std::uint32_t bottom = 0;
  Sign rightmost = side(bottom);
  if (rightmost != Sign::negative) {
    bottom = edges_to_left(q, tail, head, cost, tally).begin;
    rightmost = side(bottom);
    if (rightmost == Sign::positive) return {left};
  }
  if (top < bottom) top += n;
  const auto is_beyond = [&](std::uint32_t edge, const auto& point) {
    const auto& from = vertex_at(q, edge);
    return cross_2d(from, vertex_at(q, position(q, edge) + 1), from, point, &tally) == Sign::negative;
  };
  // Of the edges that touch the line, the two that are not on it.
  const auto is_past_entry = [&](std::uint32_t k) {
    const Sign s = side(k);
    return s == Sign::negative || (s == Sign::zero && rightmost == Sign::zero);
  };
  const std::uint32_t entry = first_where(top + 1, bottom + n, is_past_entry) - 1;
  if (is_beyond(entry, head)) return {ahead, position(q, entry)};
  const auto is_past_exit = [&](std::uint32_t k) {
    const Sign s = side(k);
    return s == Sign::positive || (s == Sign::zero && leftmost == Sign::zero);
  };
  const std::uint32_t exit = first_where(bottom + 1, top, is_past_exit) - 1;
  if (is_beyond(exit, tail)) return {behind, position(q, exit)};
  return {within, position(q, entry), position(q, exit)};
}

// What is proposed about one of the polygons and the other: a and b, or b and a. True where it holds.
template <bool Swapped, class Own, class Other, class Holds>
struct Proposals {
  const Own& own;
  const Other& other;
  const Holds& holds;

  bool meet(Corners of_own, Corners of_other) const {
    return holds(Swapped ? planar::meet(of_other, of_own) : planar::meet(of_own, of_other));
  }
  bool apart_by_own(std::uint32_t edge, std::uint32_t near) const {
    return holds(Swapped ? apart_by_edge_of_b(near, edge) : apart_by_edge_of_a(edge, near));
  }
  bool apart_by_other(std::uint32_t edge, std::uint32_t near) const {
    return holds(Swapped ? apart_by_edge_of_a(edge, near) : apart_by_edge_of_b(near, edge));
  }
  // The segment from vertex i to vertex j meets the other one, as cross_line says.
  bool meet(std::uint32_t i, std::uint32_t j, const LineCrossing& within) const {
    const std::uint32_t entry = within.edge, exit = within.exit;
    return meet(std::array{i, j}, std::array{entry, entry + 1}) || meet({&i, 1}, std::array{entry, entry + 1, exit}) ||
           meet({&i, 1}, std::array{entry, exit, exit + 1});
  }
};

// Theorem 4, when own chain is short. `view` is what own vertex 0 sees of the other polygon.
template <class About>
bool propose_short(const About& about, const Chain& chain, const View& view, Cost& cost, StageTally& tally) {
  using enum LineCrossing::Place;
  const auto& own = about.own;
  const auto cross = [&](std::uint32_t i, std::uint32_t j) {
    return cross_line(vertex_at(own, i), vertex_at(own, j), about.other, cost, tally);
  };
  const auto meets = [&](std::uint32_t i, std::uint32_t j) {
    if (i == j) return false;
    const LineCrossing c = cross(i, j);
    return c.place == within && about.meet(i, j, c);
  };
  const std::uint32_t first = chain.low - 1, last = chain.high;
  std::uint32_t low = first, high = last + 1;
  std::uint32_t facing = 0;  // an edge of the other that faces vertex low, or vertex high
  while (low < high) {
    const std::uint32_t i = low + (high - low) / 2;
    const LineCrossing c = cross(i, position(own, i) + 1);
    if (c.place == right) return about.apart_by_own(i, c.edge);
    if (c.place == within) return about.meet(i, position(own, i) + 1, c);
    // All of the other on the left: the segment between its two tangents is before an end of the edge, seen from vertex
    // 0. Unless the pencil does not enter own polygon: then the first of its two edges parts them.
    if (c.place == left && about.meet(std::array{0u, i > first ? i : i + 1}, std::array{view.left, view.right})) {
      return true;
    }
    if (c.place == ahead) {
      low = i + 1;
    } else {
      high = i;
    }
    facing = c.edge;
  }
  if (low == first) return meets(chain.begin + 1, low + 1) || meets(chain.begin, chain.begin + 1);
  if (low == last + 1) return meets(last, chain.end) || meets(chain.end, position(own, chain.end) + 1);
  return about.apart_by_other(facing, low);
}

// Case 2: do the lines of two edges cross outside the pencils? In floating point: a guess. The edges are from v and
// from w to the next vertex.
template <class A, class B>
bool seem_to_cross_outside(const A& a, std::uint32_t v, const View& of_b, const B& b, std::uint32_t w,
                           const View& of_a) {
  const auto minus = [](const Point2& p, const Point2& q) { return Point2{p.x - q.x, p.y - q.y}; };
  const auto cross = [](const Point2& p, const Point2& q) { return p.x * q.y - p.y * q.x; };
  const Point2 from = a.rounded(v), along_v = minus(a.rounded(v + 1), from);
  const Point2 along_w = minus(b.rounded(w + 1), b.rounded(w));
  const double t = cross(minus(b.rounded(w), from), along_w) / cross(along_v, along_w);
  const Point2 at{from.x + t * along_v.x, from.y + t * along_v.y};
  const auto outside = [&](const Point2& apex, const Point2& right, const Point2& left) {
    const Point2 to = minus(at, apex);
    return cross(minus(right, apex), to) < 0 || cross(to, minus(left, apex)) < 0;
  };
  return outside(a.rounded(0), b.rounded(of_b.right), b.rounded(of_b.left)) ||
         outside(b.rounded(0), a.rounded(of_a.right), a.rounded(of_a.left));
}

}  // namespace halving

// Algorithm IGG for polygons of three vertices at least. holds(proposal): see answer_by in polygon_polygon_answer.h.
template <class A, class B, class Holds>
bool propose_by_halving(const A& a, const B& b, const Holds& holds, Cost& cost, StageTally& tally) {
  const halving::Proposals<false, A, B, Holds> about{a, b, holds};
  const halving::Proposals<true, B, A, Holds> about_b{b, a, holds};
  const auto &apex_a = a[0], &apex_b = b[0];
  const halving::View of_b = halving::view_from(apex_a, b, cost, tally);
  if (of_b.inside) return about.meet(std::array{0u}, std::array{0u, of_b.wedge, of_b.wedge + 1});
  const halving::View of_a = halving::view_from(apex_b, a, cost, tally);
  if (of_a.inside) return about.meet(std::array{0u, of_a.wedge, of_a.wedge + 1}, std::array{0u});
  halving::Chain in_a = halving::chain_in_pencil(a, b[of_b.right], b[of_b.left], cost, tally);
  halving::Chain in_b = halving::chain_in_pencil(b, a[of_a.right], a[of_a.left], cost, tally);

  bool may_guess = true;
  while (!in_a.is_short() && !in_b.is_short()) {
    ++cost.iterations;
    cost.probes += 2;
    const std::uint32_t i = in_a.middle(), j = in_b.middle();
    const bool cut_a = halving::cut_on_one_side(a, in_a, i, apex_b, tally),
               cut_b = halving::cut_on_one_side(b, in_b, j, apex_a, tally);
    if (cut_a || cut_b) continue;  // case 1
    const auto &v = a[i], &v_next = a[i + 1], &w = b[j], &w_next = b[j + 1];
    const Sign turn = cross_2d(v, v_next, w, w_next, &tally);
    const auto of_v = [&](const auto& point) { return cross_2d(v, v_next, v, point, &tally); };
    const auto of_w = [&](const auto& point) { return cross_2d(w, w_next, w, point, &tally); };
    if (turn == Sign::zero) {  // the lines cross nowhere
      const Sign side = of_w(v);
      if (side == Sign::negative) return about.apart_by_own(i, j);
      if (side == Sign::zero) {  // edges of one line, the polygons on either side of it
        if (about.meet(std::array{i, i + 1}, std::array{j, j + 1})) return true;
        if (dot_2d(v, v_next, v_next, w, &tally) == Sign::positive) {
          in_a.low = i, in_b.low = j;
        } else {
          in_a.high = i + 1, in_b.high = j + 1;
        }
        continue;
      }
    } else {
      const bool left_turn = turn == Sign::positive;
      const Sign end_of_v = of_w(left_turn ? v_next : v), end_of_w = of_v(left_turn ? w : w_next);
      if (end_of_v == Sign::negative && end_of_w == Sign::negative && may_guess &&
          of_w(left_turn ? v : v_next) == Sign::negative && of_v(left_turn ? w_next : w) == Sign::negative &&
          halving::seem_to_cross_outside(a, i, of_b, b, j, of_a)) {
        may_guess = false;  // case 2
        if (about.apart_by_other(j, extreme_vertex_by_bisection(a, w, w_next, cost, tally))) return true;
        if (about.apart_by_own(i, extreme_vertex_by_bisection(b, v, v_next, cost, tally))) return true;
      }
      // Case 3.
      if (end_of_v != Sign::positive) (left_turn ? in_a.high : in_a.low) = left_turn ? i + 1 : i;
      if (end_of_w != Sign::positive) (left_turn ? in_b.low : in_b.high) = left_turn ? j : j + 1;
      if (end_of_v != Sign::positive || end_of_w != Sign::positive) continue;
    }
    const Sign w_side = cross_2d(apex_a, v, apex_a, w, &tally);
    if (w_side * cross_2d(apex_a, v, apex_a, apex_b, &tally) != Sign::positive &&
        cross_2d(apex_b, w, apex_b, apex_a, &tally) * cross_2d(apex_b, w, apex_b, v, &tally) != Sign::positive &&
        about.meet(std::array{0u, i}, std::array{0u, j})) {
      return true;  // case 4
    }
    // Case 5.
    if (w_side != Sign::negative) {
      in_a.low = i, in_b.low = j;
    } else {
      in_a.high = i + 1, in_b.high = j + 1;
    }
  }
  return in_a.is_short() ? halving::propose_short(about, in_a, of_b, cost, tally)
                         : halving::propose_short(about_b, in_b, of_a, cost, tally);
}

}  // namespace sunder::planar

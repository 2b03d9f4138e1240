// The oracle: it shares no search with the other methods. Two convex polygons are apart iff the normal of an edge of
// one of them parts them strictly, or they are segments of one line, or points: then the difference of two vertices
// does.
#include <sunder/planar/pair/placed.h>
#include <sunder/planar/pair/polygon_polygon.h>

#include <algorithm>
#include <initializer_list>

namespace sunder::planar {

namespace {

// Counts what it looks at.
struct PairScan {
  const ConvexPolygon &a, &b;
  const Pose &pose_a, &pose_b;
  PairAnswer answer{};
  StageTally tally{};

  Posed2 of_a(std::uint32_t v) { return {a[v], &pose_a.affine(), false}; }
  Posed2 of_b(std::uint32_t v) { return {b[v], &pose_b.affine(), false}; }

  // Is every vertex of the other strictly beyond the line of p and q, on the side where none of its own is?
  template <class Own, class Other>
  bool parts(const Posed2& p, const Posed2& q, std::uint32_t own_count, const Own& own, std::uint32_t other_count,
             const Other& other, Sign outer, std::uint32_t& nearest) {
    for (std::uint32_t v = 0; v < own_count; ++v) {
      ++answer.cost.probes;
      if (cross_2d(p, q, p, own(v), &tally) == outer) return false;
    }
    nearest = 0;
    for (std::uint32_t v = 0; v < other_count; ++v) {
      ++answer.cost.probes;
      if (cross_2d(p, q, p, other(v), &tally) != outer) return false;
      if (cross_2d(p, q, other(nearest), other(v), &tally) == -outer) nearest = v;
    }
    return true;
  }

  bool apart() {
    Separation& c = answer.evidence.emplace<Separation>();
    const auto in_a = [this](std::uint32_t v) { return of_a(v); };
    const auto in_b = [this](std::uint32_t v) { return of_b(v); };
    for (const Sign outer : {Sign::negative, Sign::positive}) {  // to the right of an edge, or to its left
      const bool left = outer == Sign::positive;
      for (std::uint32_t i = 0; a.size() > 1 && i < a.size(); ++i) {
        const std::uint32_t next = (i + 1) % a.size();
        c.direction = {.kind = Direction::Kind::side_of_a, .reversed = left, .index = {i, next}};
        c.extreme_a = i;
        if (parts(of_a(i), of_a(next), a.size(), in_a, b.size(), in_b, outer, c.extreme_b)) return true;
      }
      for (std::uint32_t j = 0; b.size() > 1 && j < b.size(); ++j) {
        const std::uint32_t next = (j + 1) % b.size();
        c.direction = {.kind = Direction::Kind::side_of_b, .reversed = !left, .index = {j, next}};
        c.extreme_b = j;
        if (parts(of_b(j), of_b(next), b.size(), in_b, a.size(), in_a, outer, c.extreme_a)) return true;
      }
    }
    // Along the difference of two vertices: only what is short enough to be on a line is looked at.
    for (std::uint32_t i = 0; a.size() < 3 && i < a.size(); ++i) {
      for (std::uint32_t j = 0; b.size() < 3 && j < b.size(); ++j) {
        const auto beyond = [&](const Posed2& p, const Posed2& q) {
          ++answer.cost.probes;
          return dot_2d(of_a(i), of_b(j), p, q, &tally) == Sign::positive;
        };
        bool all = true;
        for (std::uint32_t v = 0; v < a.size(); ++v) all = all && !beyond(of_a(i), of_a(v));
        for (std::uint32_t v = 0; v < b.size(); ++v) all = all && !beyond(of_b(v), of_b(j));
        if (all && beyond(of_a(i), of_b(j))) {
          c.direction = {.kind = Direction::Kind::difference, .index = {i, j}};
          c.extreme_a = i;
          c.extreme_b = j;
          return true;
        }
      }
    }
    return false;
  }

  Sign turn(const Posed2& p, const Posed2& q, const Posed2& r) {
    ++answer.cost.probes;
    return cross_2d(p, q, p, r, &tally);
  }

  void fill(std::initializer_list<std::uint32_t> in_a, std::initializer_list<std::uint32_t> in_b) {
    CommonVertices& c = answer.evidence.emplace<CommonVertices>();
    c.count_a = static_cast<std::uint8_t>(in_a.size());
    c.count_b = static_cast<std::uint8_t>(in_b.size());
    std::copy(in_b.begin(), in_b.end(), std::copy(in_a.begin(), in_a.end(), c.vertices.begin()));
  }

  // Is p one of the vertices, inside a segment from vertex 0 to another one or of an edge, or inside a triangle of
  // vertex 0 and an edge? These make up the whole polygon.
  template <class Polygon, class Fill>
  bool holds(const Posed2& p, std::uint32_t count, const Polygon& at, const Fill& fill_corners) {
    const auto between = [&](std::uint32_t k, std::uint32_t l) {
      return turn(at(k), at(l), p) == Sign::zero && dot_2d(at(k), p, at(l), p, &tally) == Sign::negative;
    };
    for (std::uint32_t k = 0; k < count; ++k) {
      if (dot_2d(at(k), p, at(k), p, &tally) == Sign::zero) return fill_corners({k}), true;
    }
    for (std::uint32_t k = 1; k < count; ++k) {
      if (between(0, k)) return fill_corners({0, k}), true;
      if (k > 1 && between(k - 1, k)) return fill_corners({k - 1, k}), true;
      if (k == 1) continue;
      const Sign side = turn(at(0), at(k - 1), at(k));
      if (turn(at(0), at(k - 1), p) == side && turn(at(k - 1), at(k), p) == side && turn(at(k), at(0), p) == side) {
        return fill_corners({0, k - 1, k}), true;
      }
    }
    return false;
  }

  // A vertex of one is in the other, or two edges cross.
  void meet() {
    const auto in_a = [this](std::uint32_t v) { return of_a(v); };
    const auto in_b = [this](std::uint32_t v) { return of_b(v); };
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      if (holds(of_b(j), a.size(), in_a, [&](std::initializer_list<std::uint32_t> c) { fill(c, {j}); })) return;
    }
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      if (holds(of_a(i), b.size(), in_b, [&](std::initializer_list<std::uint32_t> c) { fill({i}, c); })) return;
    }
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      const std::uint32_t i_next = (i + 1) % a.size();
      const Posed2 p = of_a(i), q = of_a(i_next);
      for (std::uint32_t j = 0; j < b.size(); ++j) {
        const std::uint32_t j_next = (j + 1) % b.size();
        const Posed2 r = of_b(j), s = of_b(j_next);
        if (turn(p, q, r) * turn(p, q, s) == Sign::negative && turn(r, s, p) * turn(r, s, q) == Sign::negative) {
          return fill({i, i_next}, {j, j_next});
        }
      }
    }
    answer.evidence = {};  // cannot be
  }
};

}  // namespace

PairAnswer polygon_polygon_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                   const ConvexPolygon& b, const Pose& pose_b) {
  PairScan scan{a, b, pose_a, pose_b};
  if (!scan.apart()) scan.meet();
  scan.answer.cost.exact = scan.tally.exact;
  scan.answer.decided_by = DecidedBy::scan;
  return scan.answer;
}

}  // namespace sunder::planar

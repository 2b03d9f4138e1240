// The oracle: it shares no search with the other methods. Two convex polygons are apart iff the normal of an edge of one
// of them parts them strictly, or they are segments of one line, or points: then the difference of two vertices does.
#include <sunder/planar/pair/placed.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/predicate/common_point.h>

#include <array>

namespace sunder::planar {

namespace {

// Counts what it looks at.
struct Scan {
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
    PairCertificate& c = answer.evidence;
    c.verdict = Verdict::apart;
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

  // Which of all sets of at most four vertices have a common point that they alone determine? The first.
  void meet() {
    const Affine3 in_space_a = in_space(pose_a.affine()), in_space_b = in_space(pose_b.affine());
    PairCertificate& c = answer.evidence;
    c = {};
    c.verdict = Verdict::meet;
    std::array<Posed, 4> points{};
    const auto meet_with = [&](std::uint8_t count_a, std::uint8_t count_b) {
      c.count_a = count_a;
      c.count_b = count_b;
      const std::uint32_t k = count_a + std::uint32_t{count_b};
      for (std::uint32_t s = 0; s < k; ++s) c.vertices[s] = s < count_a ? s : s - count_a;
      const auto limit = [&](std::uint32_t s) { return s < count_a ? a.size() : b.size(); };
      if (count_a > a.size() || count_b > b.size()) return false;
      while (true) {
        for (std::uint32_t s = 0; s < k; ++s) {
          const Point2& p = s < count_a ? a[c.vertices[s]] : b[c.vertices[s]];
          points[s] = {{p.x, p.y, 0}, s < count_a ? &in_space_a : &in_space_b, false};
        }
        ++answer.cost.probes;
        const std::span<const Posed> all(points.data(), k);
        if (have_common_point(all.first(count_a), all.subspan(count_a), &tally)) return true;
        // The next set: the last number that can grow, and those behind it as small as can be.
        std::uint32_t s = k;
        while (s > 0) {
          --s;
          const std::uint32_t behind = s < count_a ? count_a - 1 - s : k - 1 - s;
          if (c.vertices[s] + 1 + behind < limit(s)) break;
          if (s == 0) return false;
        }
        ++c.vertices[s];
        for (std::uint32_t t = s + 1; t < k; ++t) c.vertices[t] = t == count_a ? 0 : c.vertices[t - 1] + 1;
      }
    };
    const bool found = meet_with(1, 1) || meet_with(1, 2) || meet_with(2, 1) || meet_with(2, 2) || meet_with(1, 3) ||
                       meet_with(3, 1);
    if (!found) c = {};  // cannot be: Caratheodory
  }
};

}  // namespace

PairAnswer polygon_polygon_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                   const ConvexPolygon& b, const Pose& pose_b) {
  Scan scan{a, b, pose_a, pose_b};
  if (!scan.apart()) scan.meet();
  scan.answer.cost.exact = scan.tally.exact;
  scan.answer.decided_by = scan.tally.exact == 0 ? DecidedBy::filter : DecidedBy::evidence;
  return scan.answer;
}

}  // namespace sunder::planar

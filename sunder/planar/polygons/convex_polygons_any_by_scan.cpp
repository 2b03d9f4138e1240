// The oracle: it shares no search with the other methods.
#include <sunder/planar/object/segments.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/predicate/line/arrows.h>

#include <algorithm>

namespace sunder::planar {

namespace {

// Are all differences of points of a and b on one line?
bool one_direction(const ConvexPolygon& a, const ConvexPolygon& b) {
  if (a.size() > 2 || b.size() > 2) return false;
  return a.size() == 1 || b.size() == 1 || cross_2d(a[0], a[1], b[0], b[1]) == Sign::zero;
}

// Of points and segments that are parallel.
bool flat_ones_overlap(const ConvexPolygon& a, const ConvexPolygon& b) {
  const ConvexPolygon& along = a.size() == 2 ? a : b;
  const ConvexPolygon& other = a.size() == 2 ? b : a;
  if (along.size() == 1) return a[0] == b[0];
  if (cross_2d(along[0], along[1], along[0], other[0]) != Sign::zero) return false;
  const Point2 first = along[along.leftmost()], last = along[along.rightmost()];
  const Point2 low = other[other.leftmost()], high = other[other.rightmost()];
  return lexicographically_less(first, high) && lexicographically_less(low, last);
}

// Is all of b outside of the line of an edge of a, or on it?
bool edge_parts(const ConvexPolygon& a, const ConvexPolygon& b) {
  for (std::uint32_t k = 0; a.size() > 1 && k < a.size(); ++k) {
    const Point2 &from = a[k], &to = a[(k + 1) % a.size()];
    const auto outside = [&](const Point2& p) { return cross_2d(from, to, from, p) != Sign::positive; };
    if (std::all_of(b.vertices().begin(), b.vertices().end(), outside)) return true;
  }
  return false;
}

// Have the relative interiors a common point? If not, and the differences a - b do not lie on one line, they have an
// edge with the origin on it or outside, which has the direction of an edge of a or b.
bool overlap(const ConvexPolygon& a, const ConvexPolygon& b) {
  if (one_direction(a, b)) return flat_ones_overlap(a, b);
  return !edge_parts(a, b) && !edge_parts(b, a);
}

}  // namespace

ConvexPolygonsAnswer convex_polygons_any_by_scan(std::span<const ConvexPolygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  ConvexPolygonsAnswer answer;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    for (std::uint32_t j = i + 1; j < polygons.size(); ++j) {
      if (may_meet(options.groups, i, j)) continue;
      const PairAnswer pair = polygon_polygon_by_scan(polygons[i], Pose(), polygons[j], Pose());
      answer.cost.probes += pair.cost.probes;
      if (!pair.meet()) continue;
      const Relation contact = overlap(polygons[i], polygons[j]) ? Relation::overlapping : Relation::touching;
      if (!counts(contact, options.allowed)) continue;
      answer.found = {{i, j, contact}, std::get<CommonVertices>(pair.evidence)};
      return answer;
    }
  }
  return answer;
}

}  // namespace sunder::planar

#include <sunder/certificate/common_point.h>
#include <sunder/near/set_statement.h>
#include <sunder/planar/polygons/convex_polygons_any_claims.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/polygons/polygons_common_point.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/sweep_claims.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

const Affine3 in_place;

// What the certificate of a pair says: some common point.
ExactPoint2 common_point(const ConvexPolygon& a, const ConvexPolygon& b, const CommonVertices& c) {
  std::vector<Posed3> points;
  for (std::uint32_t k = 0; k < c.count_a + c.count_b; ++k) {
    const Point2& p = (k < c.count_a ? a : b)[c.vertices[k]];
    points.push_back({{p.x, p.y, 0}, &in_place, false});
  }
  const ExactPoint3 p = sunder::common_point(c, points).at;
  return {p.x, p.y, p.denominator};
}

bool is_same(const ExactPoint2& p, const ExactPoint2& q) {
  return p.x * q.denominator == q.x * p.denominator && p.y * q.denominator == q.y * p.denominator;
}

bool holds(const ConvexPolygon& polygon, const Point2& p) {
  for (std::uint32_t k = 0; k < polygon.size(); ++k) {
    if (orient_2d(polygon[k], polygon[polygon.next(k)], p) == Sign::negative) return false;
  }
  return true;
}

// Of a segment and a polygon, whose relative interiors meet: the middle between two of their common points, or the
// only one.
ExactPoint2 point_within(const Segment& s, const ConvexPolygon& polygon) {
  std::vector<ExactPoint2> found;
  const auto add = [&](const ExactPoint2& p) {
    if (found.empty() || (found.size() == 1 && !is_same(found[0], p))) found.push_back(p);
  };
  for (std::uint32_t k = 0; k < polygon.size(); ++k) {
    const Segment t = sorted({polygon[k], polygon[polygon.next(k)]});
    const ContactKind kind = segment_segment(s, t);
    if (kind == ContactKind::overlap) {
      const auto [first, last] = common_part(s, t);
      add(exactly(first));
      add(exactly(last));
    } else if (kind != ContactKind::none) {
      add(planar::common_point(s, t));
    }
  }
  if (polygon.size() > 2) {
    for (const Point2& end : {s.a, s.b}) {
      if (holds(polygon, end)) add(exactly(end));
    }
  }
  if (found.size() < 2) return found.at(0);
  const auto& [p, q] = std::pair(found[0], found[1]);
  return {p.x * q.denominator + q.x * p.denominator, p.y * q.denominator + q.y * p.denominator,
          Dyadic(2.0) * p.denominator * q.denominator};
}

// Of two whose relative interiors meet, a point of both of these.
ExactPoint2 point_within(const ConvexPolygon& a, const ConvexPolygon& b) {
  if (b.size() < a.size()) return point_within(b, a);
  if (a.size() == 1) return exactly(a[0]);
  if (a.size() == 2) return point_within(sorted({a[0], a[1]}), b);
  const auto polygon = [](const ConvexPolygon& convex) {
    const std::vector<Point2> ring(convex.vertices().begin(), convex.vertices().end());
    return Polygon(std::span(&ring, 1));
  };
  const Polygon i = polygon(a), j = polygon(b);
  return common_point(i, j, polygons_contact(i, j).found.value());
}

SweepEvents events_of(std::span<const ConvexPolygon> polygons) {
  std::vector<Segment> edges;
  for (const ConvexPolygon& polygon : polygons) {
    for (std::uint32_t k = 0; k < polygon.size(); ++k) {
      edges.push_back({polygon[k], polygon[polygon.next(k)]});
    }
  }
  return *sweep_events(Segments(std::move(edges)), std::numeric_limits<std::size_t>::max());
}

}  // namespace

std::string certificate_text(std::span<const ConvexPolygon> polygons, Allowed allowed,
                             const ConvexPolygonsAnswer& answer, Groups groups) {
  return claims_text({}, [&](ClaimsWriter& file) {
    const Allowed rule = allowed == Allowed::touch ? allowed : Allowed::nothing;
    begin_set_statement(file, "polygons", polygons, rule, groups, answer.meet() ? "some" : "none");
    if (answer.meet()) {
      const ConvexPolygonsContact& found = *answer.found;
      const ConvexPolygon &a = polygons[found.i], &b = polygons[found.j];
      const ExactPoint2 p = allowed == Allowed::touch ? point_within(a, b) : common_point(a, b, found.evidence);
      file.index("i", found.i);
      file.index("j", found.j);
      file.fractions("point", std::array{p.x, p.y}, p.denominator);
      file.begin_claims();
      file.claim("common_point");
    } else {
      write_sweep(file, "none_counts", events_of(polygons));
    }
    file.end_statement();
  });
}

}  // namespace sunder::planar

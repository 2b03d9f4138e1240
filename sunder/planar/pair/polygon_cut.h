// What a line, a ray or a segment has in common with a placed convex polygon: by the names of features, and exactly.
// Also called: clipped line; chord of a convex polygon.
//
// The line runs from its point a through its point b; so do the ray, from a on, and the segment, from a to b.
#pragma once

#include <sunder/certificate/cut.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/polygon_point.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/line/crossing.h>

#include <cstdint>
#include <optional>
#include <variant>

namespace sunder::planar {

// An end of the common part. It is on a vertex, in the inside of an edge, or (an own end only) inside the polygon.
struct CutEnd {
  Place place = Place::vertex;  // never `outside`
  std::uint32_t feature = 0;    // number of the vertex, or of the edge as in InEdge; zero for `inside`
  OwnEnd own = OwnEnd::none;    // of a segment whose ends are one point: a
  friend bool operator==(const CutEnd&, const CutEnd&) = default;
};

// All vertices are strictly on one side of the line, which the two edges at the one nearest to it tell. Of two such
// vertices, it is the one from which the edge between them starts, counter-clockwise in the world; of a segment, the
// one further along the direction in which the polygon is to the right of the line.
struct BesideLine {
  static constexpr Verdict verdict = Verdict::apart;
  static constexpr CutKind kind = CutKind::nothing;
  std::uint32_t nearest = 0;
  friend bool operator==(const BesideLine&, const BesideLine&) = default;
};

// The line meets the polygon, and the ray or segment does not: all of the polygon on the line is beyond this own end.
// A segment whose ends are both the point a has this outcome where a is outside the polygon.
struct BeyondEnd {
  static constexpr Verdict verdict = Verdict::apart;
  static constexpr CutKind kind = CutKind::nothing;
  OwnEnd own = OwnEnd::a;
  friend bool operator==(const BeyondEnd&, const BeyondEnd&) = default;
};

struct CutPoint {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::point;
  CutEnd at;
  friend bool operator==(const CutPoint&, const CutPoint&) = default;
};

// A part of this edge, of positive length. The ends are in the direction from a to b; so below.
struct CutAlong {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::along;
  CutEnd first, last;
  std::uint32_t edge = 0;
  friend bool operator==(const CutAlong&, const CutAlong&) = default;
};

// A segment through the polygon's inside.
struct CutAcross {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::across;
  CutEnd first, last;
  friend bool operator==(const CutAcross&, const CutAcross&) = default;
};

using PolygonCut = Answer<std::variant<BesideLine, BeyondEnd, CutPoint, CutAlong, CutAcross>>;

// Nothing where they are apart.
inline std::optional<CutEnds<CutEnd>> ends_of(const PolygonCut::Evidence& evidence) {
  return ends_in<CutEnd>(evidence);
}

// The own end that is in the polygon there; nothing where it is outside.
std::optional<CutEnd> end_at(const PolygonPoint& place, OwnEnd own);

// Where an end is, exactly.
struct ExactEnd {
  // The point, in the world. Its rounded coordinates are the nearest doubles; infinite beyond the range.
  ExactPoint2 point;
  Point2 rounded() const { return nearest(point); }

  // The point is a + t (b - a). Zero where a and b are one point.
  ExactFraction along_line;

  // In an edge, the point is v + t (w - v), where v and w are its vertices, in the polygon's own order. Else zero.
  ExactFraction along_edge;
};

// The exact place of an end of the common part of this polygon and the line, ray or segment through a and b, as one of
// the functions polygon_line, polygon_ray and polygon_segment gave it for them. Cost: exact arithmetic.
ExactEnd exact_end(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b, const CutEnd& end);

}  // namespace sunder::planar

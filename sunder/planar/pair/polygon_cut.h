// What a line, a ray or a segment has in common with a placed convex polygon: by the names of features, and exactly.
// Also called: clipped line; chord of a convex polygon.
//
// The line runs from its point a through its point b; so do the ray, from a on, and the segment, from a to b.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/polygon_point.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/line/crossing.h>

#include <cstdint>
#include <string_view>

namespace sunder::planar {

enum class CutKind : std::uint8_t {
  nothing,
  point,   // one point
  along,   // a part of an edge, of positive length
  across,  // a segment through the polygon's inside
};

std::string_view name_of(CutKind);

// Is an end of the common part one of the ray or segment itself?
enum class OwnEnd : std::uint8_t { none, a, b };

// An end of the common part. It is on a vertex, in the inside of an edge, or (an own end only) inside the polygon.
struct CutEnd {
  Place place = Place::vertex;  // never `outside`
  std::uint32_t feature = 0;    // number of the vertex, or of the edge as in PolygonPoint; meaningless for `inside`
  OwnEnd own = OwnEnd::none;    // of a segment whose ends are one point: a
  friend bool operator==(const CutEnd&, const CutEnd&) = default;
};

struct [[nodiscard]] PolygonCut {
  CutKind kind = CutKind::nothing;
  CutEnd first, last;      // in the direction from a to b; the same for `point`; meaningless for `nothing`
  std::uint32_t edge = 0;  // meaningless but for `along`

  // Of a line and `nothing`: the vertex nearest to it. All vertices are strictly on one side of the line, which the two
  // edges at this vertex tell. Of two such vertices, the one from which the edge between them starts, counter-clockwise
  // in the world; of a segment, the one further along the direction in which the polygon is to the right of the line.
  std::uint32_t nearest = 0;

  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;

  bool meet() const { return kind != CutKind::nothing; }
};

// Where an end is, exactly.
struct ExactEnd {
  // The point, in the world. Its rounded coordinates are the nearest doubles; infinite beyond the range.
  ExactPoint2 point;
  Point2 rounded() const { return nearest(point); }

  // The point is a + t (b - a). Zero where a and b are one point.
  ExactFraction along_line;

  // The point is v + t (w - v), where v and w are the vertices of the edge in which it is, in the polygon's own order;
  // zero for a vertex. Meaningless for `inside`.
  ExactFraction along_edge;
};

// The exact place of an end of the common part of this polygon and the line, ray or segment through a and b, as one of
// the functions polygon_line, polygon_ray and polygon_segment gave it for them. Cost: exact arithmetic.
ExactEnd exact_end(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b, const CutEnd& end);

}  // namespace sunder::planar

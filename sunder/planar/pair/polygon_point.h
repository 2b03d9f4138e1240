// Is a point outside a placed convex polygon, on its boundary (where?), or inside? And from outside: its two tangents.
// Also called: point location in a convex polygon; point in polygon.
//
// Exactly right for the doubles given. The point is in the world; the polygon is closed. Segments and points are
// polygons of two vertices and of one: all their points are on the boundary.
//   P1. The answer is that of the exact images of the vertices under the pose.
//   P2. All methods give the same place and the same feature, and evidence that passes certificate/check.h.
// None allocates while filters decide, and none throws, but for want of memory. Requires finite coordinates.
// Source: the question is that of Shamos, Preparata and others; Chazelle & Dobkin 1987, section 2.3, reduce it to the
// intersection with a line, and name log2 n as its lower bound. Here it is a search in the fan of a vertex.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <cstdint>
#include <string_view>
#include <variant>

namespace sunder::planar {

// Where a point is, seen from a polygon.
enum class Place : std::uint8_t { outside, vertex, edge, inside };

std::string_view name_of(Place);  // "inside"

// What proves it is said of the polygon as A and the point as B, of the one vertex 0.

// Parted by an edge that has the point strictly beyond it, or by the difference to the nearest vertex.
struct OutsidePolygon {
  static constexpr Verdict verdict = Verdict::apart;
  static constexpr Place place = Place::outside;
  Separation parting;
};

struct AtVertex {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr Place place = Place::vertex;
  std::uint32_t vertex = 0;
  CommonVertices common;  // the vertex
};

// Edge v goes from vertex v to the next one in the polygon's own order (of two vertices, edge 0). Not at its ends.
struct InEdge {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr Place place = Place::edge;
  std::uint32_t edge = 0;
  CommonVertices common;  // its ends
};

struct InsidePolygon {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr Place place = Place::inside;
  CommonVertices common;  // two or three whose hull holds the point
};

using PolygonPoint = Answer<std::variant<OutsidePolygon, AtVertex, InEdge, InsidePolygon>>;

// That of what is held.
Place place_of(const PolygonPoint& answer);

// What proves it, whatever is held; for certificate/check.h.
PairCertificate pair_certificate(const PolygonPoint& answer);

// Cost: at most log2 n + 4 probes, one sign each.
PolygonPoint polygon_point(const ConvexPolygon& polygon, const Pose& pose, const Point2& point);
inline PolygonPoint polygon_point(const ConvexPolygon& polygon, const Point2& point) {
  return polygon_point(polygon, Pose(), point);
}

// Against every edge: the oracle.
PolygonPoint polygon_point_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& point);

// The vertices in which the lines through a point outside touch the polygon: seen from the point, no vertex is further
// to the left than `left`, none further to the right than `right`. Of two in line with the point, the nearer one.
struct TangentVertices {
  static constexpr Verdict verdict = Verdict::apart;
  std::uint32_t left = 0, right = 0;
  friend bool operator==(const TangentVertices&, const TangentVertices&) = default;
};

// The point is not outside: there are no tangents.
struct NoTangents {
  static constexpr Verdict verdict = Verdict::meet;
  Place place = Place::inside;
  friend bool operator==(const NoTangents&, const NoTangents&) = default;
};

using Tangents = Answer<std::variant<TangentVertices, NoTangents>>;

// Cost: at most 4 log2 n + 6 probes, one sign each. (A search each for an edge that has the point beyond it, for the
// vertex furthest from this edge, at which there is an edge that does not, and for the ends of the run between.)
Tangents tangents(const ConvexPolygon& polygon, const Pose& pose, const Point2& point);
inline Tangents tangents(const ConvexPolygon& polygon, const Point2& point) { return tangents(polygon, Pose(), point); }

// Of all vertices: the oracle.
Tangents tangents_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& point);

}  // namespace sunder::planar

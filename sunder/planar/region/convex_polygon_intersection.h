// What is the common part of N convex polygons? (Segments and points are polygons of two vertices and of one.)
//
// The answer is exactly right for the doubles given, whatever the position: touching, nested and equal polygons, edges
// in one line, many through one point, barely empty or barely not. Corners are named by edges, never rounded.
// Also called: intersection of convex polygons.
//   C1. The kind, and the corners as points, are determined by the polygons. Corners run counter-clockwise, strictly
//       convex, each once, from the lexicographically first one.
//   C2. A corner is a vertex, or the crossing of an edge with the next one that bounds the region. Of edges in one line
//       the lowest polygon's is named.
//   C3. Of an empty part, two or three supports have no common point.
//   C4. The answer does not depend on the compiler.
// None throws, but for want of memory.
// Source: Shamos & Hoey 1976, section V, Theorem 14.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/predicate/line/line_points.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::planar {

enum class PolygonsPartKind : std::uint8_t {
  empty,
  point,
  segment,
  polygon,
  plane,  // of no polygons
};

std::string_view name_of(PolygonsPartKind);  // "segment"

// Edge `number` of a polygon begins at its vertex `number`.
struct PolygonFeature {
  std::uint32_t polygon = 0, number = 0;
  friend bool operator==(const PolygonFeature&, const PolygonFeature&) = default;
};

struct PolygonsCorner {
  bool is_vertex = true;
  PolygonFeature a, b;  // the vertex a; or the edges a and b, which cross; where both bound a region, b after a
  friend bool operator==(const PolygonsCorner&, const PolygonsCorner&) = default;
};

// A half-plane that holds a polygon: what is left of the arrow, moved so that it begins at a vertex of the polygon. The
// arrow is that of an edge, or vertical or horizontal.
struct PolygonSupport {
  PolygonFeature vertex;
  Point2 from, to;
};

struct [[nodiscard]] PolygonsPart {
  PolygonsPartKind kind = PolygonsPartKind::plane;
  std::vector<PolygonsCorner> corners;  // one of a point, two of a segment; none of `empty` and `plane`

  std::array<PolygonSupport, 3> contradiction{};  // of `empty`
  std::uint32_t contradiction_size = 0;           // 2 or 3; 0 unless empty

  Cost cost;  // probes: vertices and edges looked at, and stretches of abscissas in which two lines were compared

  std::span<const PolygonSupport> supports() const& { return {contradiction.data(), contradiction_size}; }
};

// The point: exactly by exact_point, as nearest doubles by nearest_ratio of its coordinates.
LinePoint corner_point(std::span<const ConvexPolygon> polygons, const PolygonsCorner& corner);

// Do two or three half-planes that hold the polygons contradict each other? Of a support it is checked that all of the
// polygon is left of it. Cost: exact arithmetic, and linear in the polygons' sizes.
bool is_contradiction(std::span<const ConvexPolygon> polygons, std::span<const PolygonSupport> supports);

// The front door: the fastest method measured, by batches. Cost: as
// convex_polygon_intersection_by_batches.
PolygonsPart convex_polygon_intersection(std::span<const ConvexPolygon> polygons);

// Upper boundaries are merged as functions of x, pair by pair, and lower ones; then both are cut at each other. Of N
// polygons of k vertices. Cost: O(N k log N) probes; O(N k) memory.
// Departure: the paper has parts of halves merged as figures, which may be empty or thin; as functions between the
// abscissas that all polygons reach over, no such case is left but at the end.
PolygonsPart convex_polygon_intersection_by_division(std::span<const ConvexPolygon> polygons);

// The same, all edges' lines by themselves: by Theorem 9. Cost: O(N k log (N k)) probes.
PolygonsPart convex_polygon_intersection_by_edges(std::span<const ConvexPolygon> polygons);

// A sample by division; then batches that double: polygons that hold a box around the common part so far are done with,
// the others are merged as by division. Cost: as by division at most; O(N k) where few edges bound each part.
PolygonsPart convex_polygon_intersection_by_batches(std::span<const ConvexPolygon> polygons);

// The oracle: all vertices and crossings of edges, against all polygons; the hull of those that are in all.
// O((N k)^3) signs.
PolygonsPart convex_polygon_intersection_by_scan(std::span<const ConvexPolygon> polygons);

}  // namespace sunder::planar

// How far apart are two placed convex polygons? The closest features, the distance as an exact number's enclosure, and
// exact comparisons.
// Also called: separation distance of convex polygons; closest points.
//
//   D1. The features are those of the exact images: the distance between them is the distance of the polygons. Where
//       parallel edges are closest, an edge and a vertex of the other one that faces it are named.
//   D2. `distance` encloses the exact distance: no double is between its ends, and where the distance is a double, both
//       are that (number/root.h).
//   D3. compare_distance is exact for every finite radius.
// None throws, but for want of memory. Cost: that of polygon_polygon, and 5 (log2 n + log2 m) + c probes.
// Source: the question and its bound are those of Edelsbrunner 1985. Here it is one more search over the difference
// A - B (minkowski_difference_search.h), which is argued in the .cpp.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <cstdint>
#include <variant>

namespace sunder::planar {

// They are apart: of each polygon a vertex, or of one of them the edge that begins at the vertex, in the polygon's own
// order.
struct ClosestFeatures {
  static constexpr Verdict verdict = Verdict::apart;
  bool edge_of_a = false, edge_of_b = false;  // not both
  std::uint32_t a = 0, b = 0;
  Interval distance;
  ExactFraction squared;  // of the distance
};

using PolygonDistance = Answer<std::variant<CommonVertices, ClosestFeatures>>;

// nullptr where they meet; and 0.
inline const ClosestFeatures* closest_of(const PolygonDistance& answer) {
  return std::get_if<ClosestFeatures>(&answer.evidence);
}
inline Interval distance_of(const PolygonDistance& answer) {
  const ClosestFeatures* closest = closest_of(answer);
  return closest != nullptr ? closest->distance : Interval{0, 0};
}

// The front door. Distances are in the world, in the unit of its coordinates. `squared` and `distance` take exact
// numbers, of one pair of features.
PolygonDistance polygon_polygon_distance(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b);

// Of all vertices and edges: the oracle. Cost: O(n m) exact numbers.
PolygonDistance polygon_polygon_distance_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                                 const ConvexPolygon& b, const Pose& pose_b);

// positive: further apart than the radius; zero: exactly so far; negative: closer. Requires a finite radius >= 0.
Sign compare_distance(const PolygonDistance& distance, double radius);

}  // namespace sunder::planar

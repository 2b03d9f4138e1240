// How far apart are two placed convex polygons? The closest features, the distance as an exact number's enclosure, and
// exact comparisons.
//
//   D1. The features are those of the exact images: the distance between them is the distance of the polygons. Where
//       parallel edges are closest, an edge and a vertex of the other one that faces it are named.
//   D2. `distance` encloses the exact distance, within 2^-49 of it but for results below 2^-500 or above 2^500.
//   D3. compare_distance is exact for every finite radius.
// None throws. Cost: that of polygon_polygon, and 5 (log2 n + log2 m) + c probes.
// Source: the question and its bound are those of Edelsbrunner 1985. Here it is one more search over the difference
// A - B (difference_search.h), which is argued in the .cpp.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <array>
#include <cstdint>

namespace sunder::planar {

struct [[nodiscard]] PolygonDistance {
  PairAnswer answer;  // do they meet? Its cost is that of everything. The rest is meaningless where they meet

  // The closest features: a vertex of each, or the edge that begins at the vertex (in the polygon's own order) of one.
  bool edge_of_a = false, edge_of_b = false;  // not both
  std::uint32_t a = 0, b = 0;
  Interval distance;  // [0, 0] where they meet

  // The square of the distance: numerator over denominator, both exact; the denominator is positive.
  std::array<Dyadic, 2> squared{};

  bool meet() const { return answer.meet(); }
};

PolygonDistance polygon_polygon_distance(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b);

// Of all vertices and edges: the oracle. Cost: O(n m) exact numbers.
PolygonDistance polygon_polygon_distance_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                                 const ConvexPolygon& b, const Pose& pose_b);

// positive: further apart than the radius; zero: exactly so far; negative: closer. Requires a finite radius >= 0.
Sign compare_distance(const PolygonDistance& distance, double radius);

}  // namespace sunder::planar

// How deep are two placed convex polygons in each other: how far does one have to be moved until they do not overlap?
// Also called: penetration depth; minimum translational distance.
//
// The depth of polygons that meet is the least length of a translation of A, in the plane, after which the interior of
// the difference A - B does not hold the origin: the distance from the origin to the boundary of A - B. It is 0 where
// they only touch, and where all of A - B is on one line. Of polygons that are apart there is none.
//
//   P1. The square of the depth is the fraction `squared`, exactly. `depth` encloses the depth: no double is between
//       its ends, and where the depth is a double, both are that (number/root.h).
//   P2. A, moved back along `direction` by the depth, does not overlap B; moved by less, in any direction, it meets B.
//   P3. The depth is the same for polygons that are swapped; scaled by a power of two, `squared` is larger by its
//       square, and the ends of `depth` by the power where none of them overflows or underflows.
// What one might assume and does not hold: the direction is not the only one, where several edges of A - B are as near
// to the origin. And the distance of the edges has many local minima along the boundary, so that no search by halving
// finds the least: each edge is looked at.
// Functions throw only std::bad_alloc.
// Source: Cameron, Culley 1986.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/number/interval.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <array>
#include <cstdint>
#include <variant>

namespace sunder::planar {

struct PolygonDepth {
  static constexpr Verdict verdict = Verdict::meet;

  // What A - B's edge is made of that is nearest to the origin: of one polygon the edge that begins at the vertex, of
  // the other one the vertex that is furthest on its inner side, in the polygons' own orders. Two points have no edge:
  // then all of this is as it is initialized here.
  bool edge_of_a = false, edge_of_b = false;  // not both
  std::uint32_t a = 0, b = 0;
  std::array<Dyadic, 2> direction{1.0, 0.0};  // from A to B, across the edge
  ExactFraction squared;                      // of the depth
  Interval depth{0.0};
};

// If the polygons are apart, the evidence is that of polygon_polygon.
using PolygonDepthAnswer = Answer<std::variant<Separation, PolygonDepth>>;

// The front door. Asks first whether they meet. Cost: that of polygon_polygon; then, for n and m vertices,
// n (log2 m + 1) + m (log2 n + 1) probes, and exact numbers for edges that intervals cannot tell from the nearest one.
PolygonDepthAnswer polygon_polygon_depth(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b);

// The oracle: for each edge of both polygons it compares all vertices in exact numbers. Cost: O((n + m)^2) of these.
PolygonDepthAnswer polygon_polygon_depth_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                                 const ConvexPolygon& b, const Pose& pose_b);

// positive: deeper than that; zero: exactly so deep; negative: less deep. Requires a finite number >= 0.
Sign compare_depth(const PolygonDepth& depth, double than);

// States the depth of two bodies of a certificate file, these polygons (docs/claims.md, "depth"): that it is at most
// `high`, and, unless low is 0, at least `low`. One of them is left out where the number is not finite. Requires the
// depth of these polygons, and that a statement was written to the file before. Cost: n (log2 m + 1) + m (log2 n + 1)
// probes.
void add_depth(ClaimsWriter& file, std::uint32_t index_a, std::uint32_t index_b, const ConvexPolygon& a,
               const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b, const PolygonDepth& depth);

}  // namespace sunder::planar

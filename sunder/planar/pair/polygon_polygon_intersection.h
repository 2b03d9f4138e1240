// The common part of two placed convex polygons, as a polygon whose corners are named by features of the two.
// Also called: intersection of two convex polygons.
//
//   I1. The corners run counter-clockwise in the world, strictly convex, each once: one is a point, two are a segment,
//       none: they are apart.
//   I2. The names are exact; coordinates are computed when asked for (exact_corner).
// None throws, but for want of memory.
// Cost: O(n + m + s log l) probes, where s is the smaller and l the larger one of n and m.
// Source: the question is that of Shamos 1975; Chazelle & Dobkin 1987 name it as what their methods avoid. Here the
// edges of the smaller polygon are cut by the larger one (line_search.h); what is missing between two pieces is a chain
// of the larger one.
#pragma once

#include <sunder/near/set_question.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/predicate/line/crossing.h>

#include <cstdint>
#include <vector>

namespace sunder::planar {

struct CommonCorner {
  enum class Kind : std::uint8_t {
    vertex_of_a,  // a is its number
    vertex_of_b,  // b is its number
    crossing,     // edges a of A and b of B cross; edge k begins at vertex k, in the polygon's own order
  };
  Kind kind = Kind::vertex_of_a;
  std::uint32_t a = 0, b = 0;  // meaningless where the kind does not name it
  friend bool operator==(const CommonCorner&, const CommonCorner&) = default;
};

using CommonPart = AllAnswer<CommonCorner>;

// The front door: the corners by name, none where the polygons are apart. Vertices and edges are numbered as in the
// polygons; the order of the corners is that of the world, also where a pose reflects.
CommonPart polygon_polygon_intersection(const ConvexPolygon& a, const Pose& pose_a,  //
                                        const ConvexPolygon& b, const Pose& pose_b);

// The point, exactly; nearest_ratio of its coordinates are the nearest doubles. Cost: exact arithmetic.
ExactPoint2 exact_corner(const CommonCorner& corner, const ConvexPolygon& a, const Pose& pose_a,  //
                         const ConvexPolygon& b, const Pose& pose_b);

}  // namespace sunder::planar

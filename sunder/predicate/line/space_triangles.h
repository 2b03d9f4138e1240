// Triangles of space under poses: do two have a common point? Does a segment cross one, and from which side? Exact, for
// every finite double and triangles of any shape: corners may be on one line, or equal.
// Also called: triangle-triangle intersection; Moeller's test (1997), that of Guigue and Devillers (2003);
// segment-triangle intersection.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstdint>

namespace sunder {

using Triangle3 = std::array<Point3, 3>;
using PosedTriangle = std::array<Posed3, 3>;

// Have the closed triangles a common point? Where they are not in one plane, their common part is a point or a segment
// whose ends are on edges: so an edge of one has a point of the other. In one plane they meet as in a projection.
// Cost: at most 6 + 18 orientations where they are not in one plane.
bool triangles_meet(const PosedTriangle& t, const PosedTriangle& u, StageTally* tally = nullptr);
bool triangles_meet(const Triangle3& t, const Triangle3& u, StageTally* tally = nullptr);

// Has the segment from p to q a point of the triangle? Its ends are on these sides of the plane of that, as orient_3d says
// of its corners. Requires a triangle with an area.
bool segment_meets(const Point3& p, Sign of_p, const Point3& q, Sign of_q, const Triangle3& t,
                   StageTally* tally = nullptr);

// How the segment from p to q crosses a triangle.
//   none                they have no common point
//   positive, negative  in one point, which is inside both: it comes to the side from which the corners appear
//                       counter-clockwise, or leaves it
//   touch               else: they have a common point on the triangle's edge, or at an end of the segment
enum class TriangleCrossing : std::uint8_t { none, positive, negative, touch };
TriangleCrossing crossing_of(const Posed3& p, const Posed3& q, const PosedTriangle& t, StageTally* tally = nullptr);

}  // namespace sunder

// Does a placed convex polygon meet a closed half-plane? (Touching its line is meeting.)
// Also called: half-plane intersection test; support query.
//
// The answer is exactly right for the doubles given; the half-plane is in the world. P1 of polygon_line.h holds.
// The witness is the polygon's vertex furthest into the half-plane, of two the one further along its direction: the two
// edges beside it tell that it is; if it is not in the half-plane, no vertex is.
// None allocates while filters decide, and none throws, but for want of memory. Source: Chazelle & Dobkin 1987,
// section 2.2.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/line.h>
#include <sunder/planar/object/pose.h>

#include <cstdint>

namespace sunder::planar {

struct [[nodiscard]] PolygonHalfPlane {
  bool meet = false;
  bool touching = false;      // they meet, and only on the half-plane's line
  std::uint32_t witness = 0;  // number of a vertex
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;
};

// Cost: at most log2 n + 2 probes, one sign each.
PolygonHalfPlane polygon_half_plane(const ConvexPolygon& polygon, const Pose& pose, const HalfPlane& half_plane);
inline PolygonHalfPlane polygon_half_plane(const ConvexPolygon& polygon, const HalfPlane& half_plane) {
  return polygon_half_plane(polygon, Pose(), half_plane);
}

// All vertices: the oracle.
PolygonHalfPlane polygon_half_plane_by_scan(const ConvexPolygon& polygon, const Pose& pose,
                                            const HalfPlane& half_plane);

}  // namespace sunder::planar

// Do a placed convex polyhedron and a plane meet (IHP)? On which side of it is the body?
// Also called: plane-polyhedron intersection; half-space test; plane side of a convex hull.
//
// Objects are closed: touching is meeting. The plane is in the world. The answer is exactly right for the numbers
// given.
//   P1. The verdict is that of the exact images of the vertices under the pose.
//   P2. All methods give the same verdict and the same side.
//   P3. What is named proves it: a nearest vertex, or one on each side; polyhedron_plane_claims.h writes it down.
// None allocates while filters decide, but the scan, and none throws, but for want of memory.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/number/sign.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/plane.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <variant>

namespace sunder::solid {

class Drums;  // see solid/represent/drums.h

// All of the body is above the plane (positive), or below it (negative); no vertex is nearer to it than `nearest`.
struct BesidePlane {
  static constexpr Verdict verdict = Verdict::apart;
  Sign side = Sign::zero;
  std::uint32_t nearest = 0;
};

// Vertices: `below` is not above the plane, `above` is not below it; one may be both, on the plane.
struct AcrossPlane {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint32_t below = 0, above = 0;
};

using PolyhedronPlane = Answer<std::variant<BesidePlane, AcrossPlane>>;

// The side of the plane on which the body is; zero where they meet.
inline Sign side_of(const PolyhedronPlane& answer) {
  const auto* beside = std::get_if<BesidePlane>(&answer.evidence);
  return beside != nullptr ? beside->side : Sign::zero;
}

// The front door: extreme vertices along the normal, over the vertex graph or the hierarchy. Cost: O(log n) probes.
PolyhedronPlane polyhedron_plane(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane);

// By sections of the body at the heights of its vertices: a search in the polygon whose corners are extreme vertices of
// sections. The first question about a body makes its drums (represent/drums.h).
// Cost: at most 2 log2^2 n probes for n of 1,000 and more (the constant tested), times the steps of an access to a
// drum's edge; where the proposal does not hold, as above.
// Source: CD87 section 3.3, Lemmas 6 and 7, Theorem 8. Departures: one chain of the polygon is searched, by directions
// of its sides; these are known without its corners (search/drum_search.h).
PolyhedronPlane polyhedron_plane_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane);
// The same with other drums of the body.
PolyhedronPlane polyhedron_plane_by_drums(const ConvexPolyhedron& body, const Drums& drums, const Pose& pose,
                                          const Plane& plane);

// All vertices: the oracle. Cost: n probes.
PolyhedronPlane polyhedron_plane_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane);

// Touching (the plane supports the body) or overlapping (it goes through the inside, or holds all of a flat body)?
Relation polyhedron_plane_contact(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane);

}  // namespace sunder::solid

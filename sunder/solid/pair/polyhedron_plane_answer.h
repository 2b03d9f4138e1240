// How every method answers whether a convex polyhedron and a plane meet: its search proposes two vertices, and
// answer_by() checks them exactly. What it finds to be wrong it decides by the way, and this is counted as finishing.
#pragma once

#include <sunder/solid/pair/placed.h>
#include <sunder/solid/pair/polyhedron_plane.h>

#include <cstdint>

namespace sunder::solid {

// Vertices on both sides of the plane, or on it; or one that is furthest towards it, twice: the plane is beyond it. A
// proposal may be wrong in any way, but for numbers that are no vertices.
struct PlaneProposal {
  std::uint32_t low = 0, high = 0;
};

// `answer` has the cost of the search, and gets that of the exact walk.
void conclude_plane(const Placed& body, const Plane& plane, const PlaneProposal& proposal, PolyhedronPlane& answer);

// The sign of a vertex, as side_of_plane (predicate/plane_side.h) has it.
Sign side_of(const Plane& plane, const Posed3& vertex, StageTally* tally = nullptr);

// The normal as the body's frame sees it, scaled: for searches.
Point3 pulled_normal(const Placed& body, const Plane& plane);

// propose(cost) gives a PlaneProposal.
template <class Propose>
PolyhedronPlane plane_answer_by(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                                const Propose& propose) {
  const Placed placed(body, pose);
  PolyhedronPlane answer;
  answer.cost.proposals = 1;
  conclude_plane(placed, plane, propose(placed, answer.cost), answer);
  return answer;
}

}  // namespace sunder::solid

// How every method answers whether a convex polyhedron and a plane meet: its search proposes two vertices, and
// answer_by() checks them exactly. What it finds to be wrong it decides by the way, and this is counted as finishing.
#pragma once

#include <sunder/predicate/point/along.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/search_vector.h>
#include <sunder/solid/section/polyhedron_plane.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sunder::solid {

// A vertex, and the one that should be furthest from it towards the plane and beyond, or beyond it at least. A proposal
// may be wrong in any way, but for numbers that are no vertices.
struct PlaneProposal {
  std::uint32_t first = 0, furthest = 0;
};

// Does the proposal hold? Fills in the answer in any case, by an exact walk where it does not hold.
bool conclude_plane(const Placed& body, const Plane& plane, const PlaneProposal& proposal, PolyhedronPlane& answer,
                    StageTally& tally);

// The sign of a vertex, as side_of_plane (predicate/point/plane_side.h) has it.
Sign side_of(const Plane& plane, const Posed3& vertex, StageTally* tally = nullptr);

// The same ray, times a power of two, where no bit is lost, so that filters serve.
WorldDirection direction_of(const Point3& normal);

// The normal as the body's frame sees it, scaled: for searches.
template <class Real>
VectorOf<Real> pulled_normal(const Placed& body, const Plane& plane) {
  Point3 n = plane.normal;
  make_tame(n);
  const auto& m = body.pose.linear;
  const auto column = [&](std::size_t j) {
    return product<Real>(m[j], n.x) + product<Real>(m[3 + j], n.y) + product<Real>(m[6 + j], n.z);
  };
  VectorOf<Real> pulled{column(0), column(1), column(2)};
  const Point3 size = rounded(pulled);
  const double by = scale_to_one(std::max({std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)}));
  return {pulled.x * by, pulled.y * by, pulled.z * by};
}

// propose(placed, Real(), cost) gives a PlaneProposal: in doubles, and where that does not hold in double-doubles.
template <class Propose>
PolyhedronPlane plane_answer_by(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                                const Propose& propose) {
  const Placed placed(body, pose);
  PolyhedronPlane answer;
  StageTally tally;
  const auto holds = [&](const PlaneProposal& proposal) {
    ++answer.cost.proposals;
    return conclude_plane(placed, plane, proposal, answer, tally);
  };
  const bool held =
      holds(propose(placed, double(), answer.cost)) || holds(propose(placed, DoubleDouble(), answer.cost));
  conclude(answer, tally.exact, !held);
  return answer;
}

}  // namespace sunder::solid

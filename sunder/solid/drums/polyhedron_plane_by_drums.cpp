// Algorithm IHP: the plane T meets P iff it meets the polygon Q, whose corners are the extreme corners of P's slices,
// seen along the line that T and the slices have in common (Lemmas 6 and 7). IGL looks for the corners of Q that are
// furthest to both sides of T; as Q's sides are seen lateral edges, each the extreme one of its drum, their directions
// are searched (the conclusion's binary search on edge directions), until a vertex on the other side is found.
#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/drum_search.h>
#include <sunder/solid/section/polyhedron_plane.h>
#include <sunder/solid/section/polyhedron_plane_answer.h>

namespace sunder::solid {

PolyhedronPlane polyhedron_plane_by_drums(const ConvexPolyhedron& body, const Drums& drums, const Pose& pose,
                                          const Plane& plane) {
  return plane_answer_by(body, pose, plane, [&]<class Real>(const Placed& placed, Real, Cost& cost) -> PlaneProposal {
    const std::uint32_t first = drums.vertex_of(0);
    ++cost.probes;
    const Sign of_first = side_of(plane, placed[first]);
    const DrumSearch search(drums, body.vertices(), cost);
    const VectorOf<Real> normal = search.pulled<Real>(placed.pose, plane.normal);
    const auto is_beyond = [&](std::uint32_t v) {
      ++cost.probes;
      return side_of(plane, placed[v]) != of_first;
    };
    return {first, search.furthest_vertex<Real>(of_first == Sign::positive ? negated(normal) : normal, is_beyond)};
  });
}

PolyhedronPlane polyhedron_plane_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  return polyhedron_plane_by_drums(body, represent::of<Drums>(body), pose, plane);
}

}  // namespace sunder::solid

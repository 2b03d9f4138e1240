// The search that proposes. See docs/design/solid-pair.md.
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/search/axis_scaled.h>
#include <sunder/solid/search/gjk_proposals.h>

namespace sunder::solid {

PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  return answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    const auto propose_of = [&](const Placed& p, const Placed& q, const Holds& of) {
      return propose_by_gjk(p, q, of, cost);
    };
    return propose_axis_scaled_where_wanted(a, b, holds, propose_of);
  });
}

}  // namespace sunder::solid

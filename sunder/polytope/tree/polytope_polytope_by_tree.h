// Do two convex polytopes of R^d meet? The query of Barba and Langerman's section 6: one descent down two hierarchical
// trees, of the faces of one body and of the faces of the polar of the other.
// Also called: detecting intersections in higher dimensions; Theorem 6.3.
// These functions throw only std::bad_alloc.
#pragma once

#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/tree/face_trees.h>

#include <optional>

namespace sunder::polytope {

// Both bodies are given by points, and each was prepared by itself. One descent goes down the tree of A's faces and the
// tree of the faces of B's polar. (If B alone has fewer dimensions than space, A and B exchange their parts.) A round
// asks whether the net of A's node, with the points that had weight before, meets the facets of the net of B's node. If
// not, a plane parts these (the separation invariant), and A goes down to the faces that reach beyond it; else a point
// of A is within these facets (the inverse separation invariant; its polar is a plane between B's polar and A's), and B
// goes down to the facets that the point may break. At the bottom of A's tree without a common point, they are apart;
// at the bottom of B's with one, they meet. A round is a small matrix game in floating point. What it says is then
// proved: the last plane, moved by at most 2 d + 2 furthest points of A; or weights of the points and corners at hand,
// in exact numbers, likewise. So the verdict is exact.
//   T5. iterations, the rounds, are at most as many as both trees have levels: depths + 2.
//   T6. decided_by is `evidence`; `finishing` where the descent has no say, or was not confirmed so: then the simplex
//       method of by_columns decides. It has none where both bodies have fewer dimensions than space.
// Cost: probes are points, facets and cones that were looked at: in each round some replies, each a look at two nets.
// Source: BL15 section 6, Theorem 6.3. Departures: docs/design/polytope.md.
PolytopeAnswer polytope_polytope_by_tree(const FaceTrees& a, const Pose& pose_a, const FaceTrees& b,
                                         const Pose& pose_b);

// The remark after Theorem 6.3: of bodies that are apart, the planes of the rounds of the descent, each moved to the
// end of the body whose polar it is about. Their half-spaces hold that body, and what they have in common excludes the
// other, as each parts all faces that its round let go: multipliers of at most d + 1 of them make a plane that has the
// other body beyond it.
//   T7. Around the body with the polar there are at most as many planes as rounds, around the other is one.
// Nothing where the descent does not say that they are apart, or a last bit is between the planes and the other body.
std::optional<HyperplaneEvidence> hyperplanes_by_tree(const FaceTrees& a, const Pose& pose_a, const FaceTrees& b,
                                                      const Pose& pose_b);

}  // namespace sunder::polytope

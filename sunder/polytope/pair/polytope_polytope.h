// Do two convex polytopes of R^d meet, 2 <= d <= 6, each under its own affine pose?
// Also called: collision of convex hulls in any dimension; linear separability of two point sets; feasibility of a
// system of linear inequalities; Farkas' lemma.
//
// The bodies are closed: touching is meeting. The answer is exactly right for the doubles given, whatever the position.
//   T1. All methods give the same verdict. Evidence may differ.
//   T2. check() accepts exact_evidence() of the answer.
//   T3. The answer does not depend on the compiler.
//   T4. An empty body meets nothing.
// Requires: both polytopes and poses of one dimension. None throws, but for want of memory.
#pragma once

#include <sunder/polytope/pair/evidence.h>
#include <sunder/polytope/represent/hierarchical_tree.h>

namespace sunder::polytope {

// The front door: by_gjk.
PolytopeAnswer polytope_polytope(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b);

// Of two bodies of points: the nearest point of the difference A - B to the origin is searched in floating point, with
// support points found by scans; each direction is a proposal to part the bodies, a simplex of differences one that
// they meet. Filters check these; where they are not sure, exact numbers; where no proposal holds, the simplex method
// in integers decides. With half-spaces (half_space_search.h): where both are of half-spaces, the same search among the
// rows (a, -b) of R^(d+1), for a point inside of all, or multipliers that contradict; of half-spaces and points, a
// matrix game of few rows and points, to which the best replies come in. Exact numbers check what is proposed, and
// where it does not hold, the simplex method in integers decides from there.
// Cost: some 3 to 5 d scans of both bodies. Allocates nothing while filters decide.
// Source: Gilbert, Johnson & Keerthi 1988; Wolfe 1976, "Finding the nearest point in a polytope".
PolytopeAnswer polytope_polytope_by_gjk(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b);

// By a simplex method whose columns walks down trees find, of trees that were made before, each by itself. Two bodies
// of points: first the search of by_gjk with walks for scans, in floating point; its filters and exact walks check what
// it proposes. Where nothing holds, and where a body is of half-spaces: down both at once, by small linear programs in
// integers, from the simplex of the search on.
// At each level the program is solved over the apexes of the cones that the directions come to, A's of points inside of
// A, of half-spaces around it; then both trees go a level down, the program goes on with what pays there; at the leaves
// nothing that was pruned can pay (H1). So the shell-simplices along both last paths, some log n hyperplanes each,
// prove where the bodies end; the answer is one direction, or one common point, that stands by itself.
// decided_by: as of by_gjk, but the simplex method is `evidence`, too; `finishing` where a node that is no leaf had to
// be looked at whole.
// Cost: probes are rows, and cones. Some d + 2 to 5 d walks down each tree, whose depth is at most log n (H3).
// Source: BL15 section 6 has the trees; the search and the method are others.
PolytopeAnswer polytope_polytope_by_columns(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b,
                                            const Pose& pose_b);

// The oracle: one linear program with all points and half-spaces, by a full tableau in integers with Bland's rule.
// Cost: some (d + 2) (n + m) to n (n + m) integers a pivot. Probes are all rows, at each pivot.
PolytopeAnswer polytope_polytope_by_scan(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b);

}  // namespace sunder::polytope

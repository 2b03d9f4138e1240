// The exact finishing of pair questions: the simplex method in integers, with the vertex graph as its pricing.
// Also called: revised simplex method; phase one of a linear program.
//
// The linear program: weights l_i >= 0 of A's vertices and m_j >= 0 of B's with
//   sum l_i a_i - sum m_j b_j = 0,  sum l_i = 1,  sum m_j = 1
// over the exact images a_i, b_j. Phase one starts from five artificial variables and minimises their sum. Its
// multipliers (d, alpha, beta) price a vertex of A at d . a_i + alpha and one of B at -d . b_j + beta: the best to
// enter is an extreme vertex along d, which a walk over the vertex graph finds by exact comparisons. When none has a
// positive price, either the sum is zero, and the basis is a common point with at most five vertices, or d parts the
// bodies strictly:  d . a_i <= -alpha < beta <= d . b_j.
//
// The question of overlapping interiors is a second program of the same kind. Let c be a point in the relative interior
// of the difference A - B. The relative interiors meet iff the origin is in that of A - B (Rockafellar 1970,
// theorem 6.3 and corollary 6.6.2), that is, iff -c is in the cone of A - B:
//   sum l_i a_i - sum m_j b_j = -c,  sum l_i - sum m_j = 0.
//
// Arithmetic is on integers, images scaled by one power of two (number/exact/basis_internal.h); the method ends whatever
// the degeneracy.
#pragma once

#include <sunder/certificate/common_point.h>
#include <sunder/certificate/pair.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/search/closest_simplex.h>
#include <sunder/solid/search/extreme_vertex.h>

namespace sunder::solid {

// Decides; never fails. `hint`: vertices to try first, as a search left them. Allocates.
// Cost: mostly five to thirty exact pivots, each with a walk over the graph: every price and every comparison of rows
// is an exact sign, every neighbour a probe. After 24 steps it goes down the hierarchies of both bodies, which takes
// some two steps a level: of bodies whose vertices crowd together at most 200 log2 n signs up to 65,536 vertices
// (SolidHierarchyComplexity.SignsOfFinishingGrowAsALogarithm).
PairCertificate decide_by_exact_simplex(const Placed& a, const Placed& b, const DifferenceSimplex& hint, Cost& cost,
                                        StageTally& tally);

// Do the relative interiors of two bodies that meet have a common point? Allocates.
bool interiors_meet(const ConvexPolyhedron& body_a, const Placed& a, const ConvexPolyhedron& body_b, const Placed& b,
                    StageTally& tally);

// Have the relative interiors of A and B a common point?
struct Interiors {
  bool meet = false;
  // Where they do: one, with how it is made of vertices of each, all weights positive, which span all that the body
  // spans.
  CommonPoint point;
  // Where they do not: along this direction no point of A is further than any of B, and not all of both are as far.
  std::array<Dyadic, 3> direction{};
};

// Exact, by the second program. Throws only std::bad_alloc.
Interiors interiors(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b);

}  // namespace sunder::solid

// How deep are two placed convex polyhedra in each other: how far does one have to be moved until they do not overlap?
// Also called: penetration depth; minimum translational distance.
//
// The depth of bodies that meet is the least length of a translation of A after which the interior of the difference
// A - B does not hold the origin: the distance from the origin to the boundary of A - B. It is 0 where they only touch,
// and where all of A - B is in one plane. Of bodies that are apart there is none.
//
//   P1. low <= the depth <= high, always, both proved: along `direction`, from A to B, A reaches by no more than `high`
//       beyond where B begins, so that A moved back by that no longer overlaps B; and `proof_of_low`, a closed surface
//       of differences of vertices around the origin, comes nowhere nearer to it than `low`.
//   P2. If `exact` is there, it holds the square of the depth as a fraction; low and high are then neighbouring doubles
//       around the depth, or both equal it.
//   P3. It is exact where the numbers of vertices have a product of at most all_are_exact; of larger bodies where the
//       polytope that grows has a facet of the difference as its nearest one before it has most_corners corners: not
//       where very many facets of A - B are nearly as far away, as of two round bodies with one centre.
//   P4. The depth is the same for bodies that are swapped; scaled by a power of two, it is that much larger.
// What one might assume and does not hold: the direction is not the only one, where several facets of A - B are as far.
// Sources: Cameron, Culley 1986; van den Bergen 2001; Agarwal, Guibas, Har-Peled, Rabinovitch, Sharir 2000.
#pragma once

#include <sunder/certificate/depth_claims.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace sunder::solid {

// What the direction is perpendicular to: a facet of one body, or an edge of each.
struct DepthFeatures {
  // One to three vertices of each body: those of a triangle in the facet of A - B that is nearest to the origin.
  std::vector<std::uint32_t> of_a, of_b;
};

// They meet, and are so deep in each other.
struct PolyhedraOverlap : EnclosedDepth {
  static constexpr std::uint64_t all_are_exact = 4096;  // the product of the numbers of vertices
  static constexpr std::uint32_t most_corners = 2048;

  struct Exact {
    ExactFraction squared;   // of the depth
    DepthFeatures features;  // none where A - B is flat
  };

  CommonVertices common;       // they meet in a point of these
  std::optional<Exact> exact;  // where the depth is known exactly
};

using PolyhedronDepth = Answer<std::variant<Separation, PolyhedraOverlap>>;

// nullptr where they are apart.
inline const PolyhedraOverlap* overlap_of(const PolyhedronDepth& answer) {
  return std::get_if<PolyhedraOverlap>(&answer.evidence);
}

// The front door. Asks first whether they meet. Where they do, a polytope of differences of vertices grows towards the
// boundary of A - B, beyond the facet that is nearest to the origin, until that facet is one of A - B; exactly.
// Cost: that of polyhedron_polyhedron, and, a step, the search for a vertex of each body that is furthest along a
// direction, and the facets of the polytope that the new corner is beyond, some six on average. Steps: mostly some ten
// to hundred. Allocates.
PolyhedronDepth polyhedron_polyhedron_depth(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                            const ConvexPolyhedron& b, const Pose& pose_b);

// positive: deeper than that; zero: exactly so deep; negative: less deep; nothing: between low and high, of what is not
// exact. Requires a finite depth >= 0.
std::optional<Sign> compare_depth(const PolyhedraOverlap& overlap, double than);

}  // namespace sunder::solid

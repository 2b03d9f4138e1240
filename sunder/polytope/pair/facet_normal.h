// Of two bodies of points that the search left with a simplex of differences near the origin: the exact normal of a
// plane through about the origin that has the difference A - B on one side, about. It proposes, and may be wrong.
#pragma once

#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/pair/placed.h>

#include <optional>

namespace sunder::polytope {

// The normal, towards B from A; nothing where none is found, which tells nothing.
//   The plane has the points of the simplex that matter. Where these are fewer than d, as where two edges or two
//   vertices nearly touch, the search goes on in the orthogonal complement of their flat, along directions that have
//   all of the flat at one product: it ends with one that no point is further along, or with more points that are about
//   at the origin of the complement, which are taken into the flat. What is still missing is taken from the directions
//   of floating point, rounded, so that the normal of all is that of the flat exactly, and about the one that was
//   found.
// Cost: some d scans of both bodies a level, where the simplex does not have d points; small determinants.
std::optional<ExactVector> facet_normal(const Placed& a, const Placed& b, const NearestSimplex& simplex, Cost& cost);

}  // namespace sunder::polytope

// Searches in floating point about two bodies of which one or both are of half-spaces: they propose multipliers or a
// common point, which exact numbers dispose of.
//
// Both of half-spaces a . x <= b: the rows (a, -b), with (0, -1), are points of R^(d+1). A direction y = (x, w) along
// which all of them are negative has w > 0, and x / w is inside of all half-spaces; it is searched as the direction
// from the nearest point of their hull to the origin. A simplex of rows that holds the origin is a contradiction. Also
// called: theorem of the alternative (Gordan, Motzkin). Where fewer rows hold it, all common points are on the
// boundaries of these: the search goes on in their orthogonal complement, and determinants make a point of those
// boundaries of what it finds.
//
// Half-spaces and points: by a game (half_space_point_game.h).
//
// Both stop as soon as the proposal is strictly right, so weights need not be solutions of anything: any doubles that
// are near enough do. Only those of a contradiction of half-spaces, and points on boundaries that touch, are
// solutions, by determinants.
#pragma once

#include <sunder/polytope/pair/half_space_point_game.h>

namespace sunder::polytope {

// Requires that one of them is of half-spaces. Cost: a scan of both bodies, or of samples, a step; some 2 d to 4 d
// steps.
HalfSpaceProposal search_half_spaces(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
                                     Cost& cost);

}  // namespace sunder::polytope

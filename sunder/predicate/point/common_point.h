// Do the hulls of a few vertices of one posed body and a few of another have a common point that they alone determine?
// Also called: Radon point, Radon partition; affine dependency.
//
// Let a_0 .. be points of A and b_0 .. points of B, k of them in all, 2 <= k <= 5. Up to a factor, k points that span a
// space of dimension k - 2 have one affine dependency: numbers c_i, not all zero, with sum c_i = 0 and
// sum c_i x_i = 0. Each c_i is, with alternating sign, the orientation (a minor) of the other k - 1 points. When all c
// of A are positive and all c of B negative, or the reverse, then
//   sum over A of c_i a_i / (sum over A of c_i) = sum over B of c_i b_i / (sum over B of c_i)
// is a common point; its weights are unique and positive. By Caratheodory's theorem two polytopes that meet always have
// such a set of vertices with k <= 5.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <span>

namespace sunder {

// True iff the k = a.size() + b.size() points span a space of dimension k - 2 exactly and their dependency separates A
// from B as above, no c_i zero. Exact. Requires both non-empty, k <= 5.
// Cost: four triple products in floating point at k = 5 when filters decide; below, exact arithmetic.
bool have_common_point(std::span<const Posed3> a, std::span<const Posed3> b, StageTally* tally = nullptr);

// The exact weights of the common point: those of A, then those of B, as numerators over one common denominator, all
// positive; the rest zero. Those of A sum up to the denominator, and those of B too. Requires have_common_point(a, b).
std::array<Dyadic, 5> common_point_weights(std::span<const Posed3> a, std::span<const Posed3> b);

}  // namespace sunder

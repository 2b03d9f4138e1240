// What parts two polytopes, as several hyperplanes: half-spaces that hold all of A, and such that hold all of B, whose
// common parts have no common point. A direction alone (evidence.h) is shorter; these are what a walk down the trees
// has found on its way, and name no more of the bodies than it looked at.
// Also called: outer approximation; Farkas certificate.
//
// Of a body of points they are the half-spaces of the shell-simplices along the last path down its tree, that of the
// direction that parts: r . x <= the greatest product of the ray r with a point. Where these alone do not contradict,
// the one whose normal is that direction is added. Of half-spaces they are some of the body's own.
//   Y1. Of a body of points of dimension d, in a tree of depth k, they are at most d k + 1; by H3 that is at most
//       d log n + 1, by log of 1 / share, where every net is verified.
//   Y2. Multipliers of at most d + 1 of them, of both bodies in total, contradict, where both are of points.
// Source: BL15 section 6, the remark after Theorem 6.3. Departures: docs/design/polytope.md.
#pragma once

#include <sunder/polytope/pair/polytope_polytope.h>

#include <cstddef>
#include <vector>

namespace sunder::polytope {

struct HyperplaneEvidence {
  struct Around {
    std::vector<std::vector<Dyadic>> planes{};  // of points: a1, .., ad, b in the frame of the body; of others none
    Weights multipliers{};                      // of planes; of half-spaces, of the body's rows
    bool are_shells = true;                     // all planes are of shell-simplices
  };
  // As in ExactEvidence of `apart`: the normals times multipliers are linear^T times this (of B: its opposite).
  std::vector<Dyadic> direction{};
  Around a{}, b{};

  // How many there are around a body: of half-spaces, those with multipliers.
  static std::size_t count(const Around& around) {
    return around.planes.empty() ? around.multipliers.parts.size() : around.planes.size();
  }
};

// Requires that the answer is of polytope_polytope_by_columns or polytope_polytope_by_tree about these, and apart.
// Cost: a walk for each plane, and a linear program of some pivots in exact arithmetic.
HyperplaneEvidence parting_hyperplanes(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b,
                                       const Pose& pose_b, const PolytopeAnswer& answer);

// Does it prove that the bodies are apart? By the exact numbers alone; nothing of a search is used. Cost: planes times
// points, exact arithmetic.
bool check(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
           const HyperplaneEvidence& evidence);

}  // namespace sunder::polytope

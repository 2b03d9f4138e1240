// Are the bodies of a scene far enough from each other? Which are the nearest?
// Also called: clearance check, minimum distance query, safety margin, tolerance verification.
//
//   C1. A pair is listed as closer iff it is closer than its margin: exactly, for the doubles given; that far apart is
//       far enough. Where one is curved (a cylinder, a cone, an ellipsoid), it may be undecided (round_clearance.h,
//       C2); then it is listed and counted as that.
//       Two parts of which one is the hull of a mesh, and neither has a radius, are asked about as the meshes are, where
//       their hulls are too close (solid/mesh/mesh_distance.h); hulls are no further apart than meshes.
//   C2. Boxes never hide a pair that is too close: they are widened, and that is rounded outwards.
//   C3. Lists are ordered by body_a, body_b, part_a, part_b, and are the same for every compiler and machine.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/number/interval.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/round/round_distance.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::scene {

// How far apart two bodies have to be, in the stead of what all others have to.
struct Margin {
  std::uint32_t body_a = 0, body_b = 0;  // in any order
  double least = 0;                      // not negative, and finite; nothing is closer than 0
};

struct ClearanceQuestion {
  double least = 0;                                   // how far apart parts have to be; not negative, and finite
  std::vector<Margin> margins;                        // of some pairs of bodies; of one pair the last one holds
  std::vector<std::array<std::uint32_t, 2>> allowed;  // pairs of bodies not asked about, in any order
};

// Two parts of different bodies, and how far apart they are.
struct PartDistance {
  std::uint32_t body_a = 0, body_b = 0;  // body_a < body_b
  std::uint32_t part_a = 0, part_b = 0;
  Interval distance{0, 0};                  // encloses it (round_distance.h, D1 to D4); both ends are 0 where they meet
  solid::RoundDistanceEvidence evidence{};  // of meshes that do not meet, features of them (is_of_meshes)

  bool meet() const { return distance.high == 0; }
};

// Two parts that are closer to each other than their margin `least`, or for which that is undecided.
struct CloserParts : PartDistance {
  double least = 0;
};

// Is it the distance of meshes as they are, and not that of the parts' shapes? Of what the functions below list, and find.
// Requires the bodies that it is of.
bool is_of_meshes(const PartDistance& pair, std::span<const Body> bodies);

struct [[nodiscard]] ClearanceAnswer {
  std::vector<CloserParts> closer;     // than their margins
  std::vector<CloserParts> undecided;  // whether they are
  std::uint64_t pairs = 0;             // of parts of different bodies
  std::uint64_t allowed = 0;           // of these, not asked about
  std::uint64_t by_boxes = 0;          // far enough apart by their boxes, or whose margin is 0
  std::uint64_t by_method = 0;         // whose distance was looked at; pairs = allowed + by_boxes + by_method
  std::uint64_t surfaces_alone = 0;  // of these, far enough apart as meshes whose hulls meet, of which one has an open
                                     // piece: what it seems to enclose is not asked about

  bool leaves_some_open() const { return !undecided.empty() || surfaces_alone > 0; }
};

// Requires indices of bodies in range, and margins as they say. Throws Error: bad_pose where a part with a radius is at
// a pose that scales or shears.
// Cost for n parts: n log n, one distance for each pair whose boxes are closer than the greatest margin.
ClearanceAnswer closer_pairs(std::span<const Body> bodies, const ClearanceQuestion& question);

// The nearest two parts of different bodies, but for the pairs allowed; nothing where there are none. Of polyhedra,
// balls, capsules and rounded polyhedra, of pairs that are equally far apart, compared exactly (those that meet are 0
// apart), the first. Curved ones are compared by their bounds: then others may be as near, but `distance` encloses the
// least of all. Throws Error as closer_pairs. Adds to `looks`, where given, how many boxes were looked at in the tree
// (near/box_tree.h). Cost for n parts: three searches in the tree for each, O(n log n) where boxes are spread, and a
// distance for each pair whose boxes are no further apart than the nearest parts.
std::optional<PartDistance> nearest_parts(std::span<const Body> bodies,
                                          std::vector<std::array<std::uint32_t, 2>> allowed = {},
                                          std::uint64_t* looks = nullptr);

// Are the boxes so far apart along an axis? Then the axis (0, 1, 2), and whether A is the lower one. Requires a
// positive `least`.
struct AxisApart {
  std::size_t axis = 0;
  bool a_is_lower = true;
};
std::optional<AxisApart> apart_by_boxes(const Box3& a, const Box3& b, double least);

}  // namespace sunder::scene

// Are the bodies of a scene far enough from each other? Which are the nearest?
// Also called: clearance check, minimum distance query, safety margin, tolerance verification.
//
//   C1. A pair is listed iff it is closer than its margin: exactly, for the doubles given; that far apart is far
//   enough. C2. Boxes never hide a pair that is too close: they are widened, and that is rounded outwards. C3. Lists
//   are ordered by body_a, body_b, part_a, part_b, and are the same for every compiler and machine.
//
// Parts that are polyhedra only: bodies with a radius have no distance here yet (of two: solid/round/round_distance.h).
#pragma once

#include <sunder/scene/scene.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::scene {

// How far apart two bodies have to be, in the stead of what all others have to.
struct Margin {
  std::uint32_t body_a = 0, body_b = 0;  // in any order
  double least = 0;                      // positive and finite
};

struct ClearanceQuestion {
  double least = 0;                                   // how far apart parts have to be; positive and finite
  std::vector<Margin> margins;                        // of some pairs of bodies; of one pair the last one holds
  std::vector<std::array<std::uint32_t, 2>> allowed;  // pairs of bodies not asked about, in any order
};

// Two parts of different bodies, and how far apart they are.
struct PartDistance {
  std::uint32_t body_a = 0, body_b = 0;  // body_a < body_b
  std::uint32_t part_a = 0, part_b = 0;
  double least = 0;  // the margin; meaningless for the nearest pair
  solid::PolyhedronDistance distance;
};

struct [[nodiscard]] ClearanceAnswer {
  std::vector<PartDistance> closer;  // than their margins
  std::uint64_t pairs = 0;           // of parts of different bodies
  std::uint64_t allowed = 0;         // of these, not asked about
  std::uint64_t by_boxes = 0;        // far enough apart by their boxes
  std::uint64_t by_method = 0;       // given to polyhedron_polyhedron_distance; pairs = allowed + by_boxes + by_method
};

// Requires polyhedra, indices of bodies in range, and positive finite margins. Does not throw, but for memory.
// Cost for n parts: n log n, one distance for each pair whose boxes are closer than the greatest margin.
ClearanceAnswer closer_pairs(std::span<const Body> bodies, const ClearanceQuestion& question);

// The nearest two parts of different bodies, but for the pairs allowed; nothing where there are none. Requires
// polyhedra. Of pairs that are
// equally far apart, compared exactly (those that meet are 0 apart), the first.
// Cost for n parts: the boxes of n^2 pairs, and a distance for each pair whose boxes are no further apart than the
// nearest bodies.
std::optional<PartDistance> nearest_parts(std::span<const Body> bodies,
                                          std::vector<std::array<std::uint32_t, 2>> allowed = {});

}  // namespace sunder::scene

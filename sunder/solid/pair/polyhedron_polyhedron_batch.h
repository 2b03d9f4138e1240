// Which of many placed pairs of convex polyhedra meet? Many pairs, or many placements of one pair, in one call.
// Also called: batched collision queries; validity of many configurations.
//
//   B1. Each verdict is that of polyhedron_polyhedron.h (P1) about the same pair: directions are proposed for many
//       pairs at once, what they part surely, by a derived bound, is apart, and the others are asked about one by one.
//   B2. Verdicts and evidence are the same for every number of threads, compiler and vector unit: pairs are taken in
//       chains of 64, and each chain begins cold.
// What one might assume and does not hold: that a batch is always faster than a loop. It is, 1.2 to 4 times, where
// bodies are far apart, or where the same two bodies follow each other and move slowly; near contact at random, or deep
// in each other, it is not, and may be a fifth slower (docs/design/solid-pair.md has the figures).
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace sunder::solid {

// Of things that live as long as the call; none is null.
struct PlacedPair {
  const ConvexPolyhedron* a = nullptr;
  const Pose* pose_a = nullptr;
  const ConvexPolyhedron* b = nullptr;
  const Pose* pose_b = nullptr;
};

struct BatchOptions {
  std::size_t threads = 1;             // at most so many; 0 counts as 1
  std::span<PairAnswer> of_meeting{};  // none, or one for each pair: the answers about those that meet; others stay
};

// meet[k] becomes 1 where pair k meets, else 0. Requires as many as pairs. Allocates only where a pair's question does,
// and for threads. Throws for want of memory alone.
// Cost: for each pair some 100 flops; where that does not tell, and the same two bodies were looked at just before,
// what part_again (kept_partings.h) costs, then polyhedron_polyhedron_warm; else polyhedron_polyhedron.
void polyhedron_polyhedron_batch(std::span<const PlacedPair> pairs, std::span<std::uint8_t> meet,
                                 const BatchOptions& options = {});

}  // namespace sunder::solid

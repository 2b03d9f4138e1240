// Which of many bodies meet at any time, while all of them go straight from where they are to where they will be?
// Also called: continuous collision detection; swept broad phase.
//
// The question of scene.h between two placements of the same bodies, in which all parts move at once, from time 0 to 1.
//   W1. A pair of parts that are both polyhedra and do not turn is asked about all the way, the ends included, as
//       polyhedron_polyhedron_sweep says; boxes never hide one that meets.
//   W2. Any other pair, of which a part turns, changes its size, or has a radius, is asked about at both ends only, and
//       counted as that: what it does between is not known. (One placement and the next do not say how a part turns.)
// Touching is meeting.
#pragma once

#include <sunder/base/error.h>
#include <sunder/number/interval.h>
#include <sunder/scene/scene.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::scene {

struct SweptPair {
  std::uint32_t body_a = 0, body_b = 0;  // body_a < body_b
  std::uint32_t part_a = 0, part_b = 0;
  bool all_the_way = true;  // false: asked at its ends only
  Interval time;            // of neighbouring doubles around the first time; of one asked at its ends, that end
};

struct SweptCounts {
  std::uint64_t pairs = 0;         // of parts of different bodies
  std::uint64_t allowed = 0;       // of these, not asked about
  std::uint64_t by_boxes = 0;      // parted all the way by the boxes of their ways
  std::uint64_t by_method = 0;     // asked about all the way
  std::uint64_t at_ends_only = 0;  // pairs = allowed + by_boxes + by_method + at_ends_only
  std::uint64_t undecided = 0;  // of those at their ends only, undecided there, and meeting at no end (round_round.h)
};

struct [[nodiscard]] SweptAnswer {
  std::vector<SweptPair> pairs;  // those that meet, in the order of S3
  SweptCounts counts;

  bool some_meet() const { return !pairs.empty(); }
  bool none_meet() const { return pairs.empty() && counts.at_ends_only == 0; }  // all are known to be apart, or allowed
};

// question: its method is not looked at, nor what it says of contacts and of lists. Requires the same bodies with the
// same parts in both placements, and indices of bodies in question.allowed to be in range. Throws Error as
// meeting_pairs does. Cost for n parts: n^2 comparisons of boxes, and a sweep for each pair whose boxes meet.
SweptAnswer meeting_on_the_way(std::span<const Body> begin, std::span<const Body> end, const Question& question = {});

}  // namespace sunder::scene

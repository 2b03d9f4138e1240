// Which of many placed bodies are closer than they have to be, placement after placement?
// Also called: continuous clearance monitoring; proximity queries with temporal coherence.
//
// The question of clearance.h, of bodies that move: kept are the boxes, and of each pair of parts that was near the
// directions along which they were far enough apart (solid/pair/kept_partings.h), which are tried first.
//   K1. What is closer, what is undecided, their distances and points are as closer_pairs says of the same placement,
//       whatever was asked before: only what is surely far enough apart is not asked about anew.
//   K2. Of the counts, pairs and allowed are as there; fewer are by_boxes, which are rougher here, and more by_method.
// Memory: 230 bytes a part, and 250 a pair that was near since it was made. Not for several threads at once; a copy is
// a follower of its own.
#pragma once

#include <sunder/base/error.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_clearance.h>
#include <sunder/solid/pair/kept_partings.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace sunder::scene {

class ClearanceFollower {
 public:
  // Of these bodies, wherever they are. Keeps references to their shapes. Requires as closer_pairs.
  ClearanceFollower(std::span<const Body> bodies, const ClearanceQuestion& question);

  // Where the bodies are now. Requires bodies of the same shapes. Throws Error as closer_pairs. Cost for n parts:
  // n log n, or, of up to 1,024 pairs that are asked about, a look at each; for each pair whose boxes are too close a
  // look along what parted them, or else as closer_pairs.
  ClearanceAnswer ask(std::span<const Body> bodies);

  // How often the distance of a pair was asked for, since it was made: where what is kept did not tell.
  std::uint64_t looks() const { return looks_; }

 private:
  // Of so many pairs, all boxes are compared, as in Follower.
  static constexpr std::size_t few = 1024;
  static constexpr std::size_t most_kept = 4;  // partings of a pair

  // Two parts that are, or were, near.
  struct Near {
    std::uint32_t i = 0, j = 0;  // i < j
    double least = 0;            // how far apart they have to be
    double needed = 0;           // and their cores, for that; infinite where these do not tell
    std::array<solid::KeptParting, most_kept> kept{};
  };

  Near near(std::uint32_t i, std::uint32_t j) const;
  void list_few();
  void place(std::span<const Body> bodies);
  void look_at(Near& pair, std::span<const Body> bodies, ClearanceAnswer& answer);

  Members members_;
  Margins margins_;
  std::vector<double> radii_;                // of each part: it is within that of its core
  std::vector<solid::RigidlyPlaced> rigid_;  // of each part its core
  std::vector<Box3> boxes_;                  // of each part, rough
  std::vector<Near> near_;                   // where pairs are few, all that are asked about
  bool is_few_ = false, is_placed_ = false;
  std::unordered_map<std::uint64_t, std::uint32_t> places_;  // where they are many: in near_, by pairs of parts
  std::uint64_t looks_ = 0;
};

}  // namespace sunder::scene

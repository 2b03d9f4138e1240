// Which of many placed bodies meet, placement after placement?
// Also called: continuous monitoring; incremental collision checking; coherence in time.
//
// The question of scene.h, of bodies that move: kept are the boxes, the pairs of parts that are near
// (near/moving_boxes.h), and for each of these what parted them (solid/pair/kept_partings.h), and what the last answer
// was (solid/pair/polyhedron_polyhedron_warm.h); so that a placement costs what has changed since the one before.
//   F1. What meets, what is undecided, what counts, and how many pairs do, is as meeting_pairs says of the same
//       placement. Boxes are rougher here, and warm questions cheap: so fewer pairs are parted by boxes, and more
//       by the method.
//   F2. Listed are the pairs that meet or are undecided, in the order of S3. Each that meets has its certificate, which
//       may depend on the placements before, back to forget(); after forget() answers depend on no placement before.
// Memory: at most 1,100 bytes a part, beyond its shape and its name, and 500 a pair that meets, for 1,000 parts and
// more (tested); none by vertex: parts share their shapes. A part's shape stays; its pose is what moves. Not for
// several threads at once; a copy is a follower of its own.
#pragma once

#include <sunder/base/error.h>
#include <sunder/base/lanes.h>
#include <sunder/near/moving_boxes.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/pair/kept_partings.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace sunder::scene {

class Follower {
 public:
  // The bodies where they are. Requires indices of bodies in question.allowed to be in range; every_pair is not looked
  // at. Cost: as the first answer of meeting_pairs.
  Follower(std::span<const Body> bodies, const Question& question = {});

  // Parts are numbered through, body after body.
  std::uint32_t part_count() const { return members_->size(); }
  std::span<const Body> bodies() const { return bodies_; }  // where they are now

  // The part is there now. Requires part < part_count(). Of a part with a radius, throws Error bad_pose as
  // require_rigid (solid/round/round_body.h) does.
  void place(std::uint32_t part, const solid::Pose& pose);

  // Which meet now? Holds until the next call. Allocates where more pairs come near, or meet, than ever before.
  // Cost: for each part that was placed a rough box, and as MovingBoxes::update says, or, of up to 1,024 pairs that are
  // asked about, a look at each; for each pair whose boxes meet, moved or not, a look along what parted them, or
  // else the warm question.
  const Answer& ask();

  // Starts cold: as if it were made anew with the bodies where they are.
  void forget();

 private:
  // Of so many pairs, of at most twice as many parts, all boxes are compared: that costs less than to follow which are
  // near.
  static constexpr std::size_t few = 1024;
  // Partings that are kept of a pair, of few pairs and of many.
  static constexpr std::size_t most_kept_of_few = 6, most_kept = 2;

  // A box in floats, rounded outwards; its fourth side holds zero.
  struct FlatBox {
    FloatLanes low{}, high{};
  };

  static FlatBox flat_box(const Box3& box);
  static bool have_common_point(const FlatBox& a, const FlatBox& b);
  static bool have_common_point(const Box3& a, const Box3& b);

  void list_few();
  std::span<const MovingBoxes::Pair> follow_near();
  void look_at(const MovingBoxes::Pair& of);
  void list(PartPair&& pair);
  std::span<solid::KeptParting> kept_of(std::uint32_t slot) {
    return std::span(kept_).subspan(slot * kept_of_pair_, kept_of_pair_);
  }

  std::vector<Body> bodies_;
  Question question_;
  bool asks_warmly_;                         // polyhedra: by the front door
  std::shared_ptr<const Members> members_;   // also of those that look for pairs
  std::vector<std::uint32_t> placed_;        // parts since the last answer
  std::vector<bool> is_placed_;              // of each part
  std::vector<Box3> boxes_;                  // of each part, rough
  std::vector<FlatBox> flat_boxes_;          // the same, where pairs are few
  std::vector<solid::RigidlyPlaced> rigid_;  // of each part its core
  std::vector<MovingBoxes::Pair> few_;       // all that are asked about, where these are few; else none
  std::optional<MovingBoxes> near_;          // where they are many
  std::vector<std::uint32_t> meeting_;       // of the pairs that follow_near returns, those whose boxes meet
  std::vector<PairWarmStart> last_;          // by the slots of pairs
  std::vector<solid::KeptParting> kept_;     // kept_of_pair_ of each slot: what parted two polyhedra
  std::size_t kept_of_pair_ = most_kept;
  Answer answer_;
};

}  // namespace sunder::scene

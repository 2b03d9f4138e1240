// The parts of all bodies of a scene, numbered one after the other, and which pairs of them are asked about.
#pragma once

#include <sunder/scene/scene.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::scene {

class Members {
 public:
  using BodyPair = std::array<std::uint32_t, 2>;

  // allowed_alone: asked about are the allowed pairs, and no others. Requires indices of bodies in `allowed` to be in
  // range.
  Members(std::span<const Body> bodies, std::vector<BodyPair> allowed, bool allowed_alone = false);

  std::uint32_t size() const { return static_cast<std::uint32_t>(members_.size()); }
  std::uint32_t body(std::uint32_t member) const { return members_[member].body; }

  std::vector<std::uint32_t> bodies() const;  // of each member

  // Of bodies with as many parts each as those that these members were made of.
  const Part& part(std::span<const Body> bodies, std::uint32_t member) const {
    return bodies[members_[member].body].parts[members_[member].part];
  }
  Part& part(std::span<Body> bodies, std::uint32_t member) const {
    return bodies[members_[member].body].parts[members_[member].part];
  }

  // Are they parts of different bodies, which are asked about? Requires i < j. Cost: O(log k) for k allowed pairs.
  bool are_asked_about(std::uint32_t i, std::uint32_t j) const;

  // Without an answer. Requires i < j.
  PartPair pair(std::uint32_t i, std::uint32_t j) const;

  // Of how many pairs that are asked about are both members marked? Requires a mark for each member, and that
  // the allowed pairs are those that are not asked about.
  std::uint64_t asked_about(const std::vector<bool>& marked) const;

  // How many parts and pairs there are; what is counted as by_method stands there, the rest is by boxes.
  void complete(Counts& counts) const;

 private:
  struct Member {
    std::uint32_t body, part;
  };

  std::vector<Member> members_;
  bool allowed_alone_;
  std::vector<BodyPair> allowed_;                // sorted, each once, lower index first, none of a body with itself
  std::uint64_t pairs_ = 0, allowed_pairs_ = 0;  // of parts
};

}  // namespace sunder::scene

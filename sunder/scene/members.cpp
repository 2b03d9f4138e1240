#include <sunder/base/contract.h>
#include <sunder/scene/members.h>

#include <algorithm>
#include <utility>

namespace sunder::scene {

Members::Members(std::span<const Body> bodies, std::vector<BodyPair> allowed, bool allowed_alone)
    : allowed_alone_(allowed_alone), allowed_(std::move(allowed)) {
  for (BodyPair& pair : allowed_) std::sort(pair.begin(), pair.end());
  std::sort(allowed_.begin(), allowed_.end());
  allowed_.erase(std::unique(allowed_.begin(), allowed_.end()), allowed_.end());
  std::erase_if(allowed_, [](const BodyPair& pair) { return pair[0] == pair[1]; });
  SUNDER_REQUIRE(
      std::all_of(allowed_.begin(), allowed_.end(), [&](const BodyPair& pair) { return pair[1] < bodies.size(); }));
  const auto pairs_of = [](std::uint64_t n) { return n < 2 ? 0 : n * (n - 1) / 2; };
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) members_.push_back({b, p});
  }
  pairs_ = pairs_of(members_.size());
  for (const Body& body : bodies) pairs_ -= pairs_of(body.parts.size());
  for (const auto& [a, b] : allowed_) allowed_pairs_ += std::uint64_t{bodies[a].parts.size()} * bodies[b].parts.size();
}

bool Members::are_asked_about(std::uint32_t i, std::uint32_t j) const {
  const std::uint32_t a = members_[i].body, b = members_[j].body;
  return a != b && std::binary_search(allowed_.begin(), allowed_.end(), BodyPair{a, b}) == allowed_alone_;
}

PartPair Members::pair(std::uint32_t i, std::uint32_t j) const {
  PartPair pair;
  pair.body_a = members_[i].body;
  pair.body_b = members_[j].body;
  pair.part_a = members_[i].part;
  pair.part_b = members_[j].part;
  return pair;
}

std::vector<std::uint32_t> Members::bodies() const {
  std::vector<std::uint32_t> bodies;
  for (const Member& member : members_) bodies.push_back(member.body);
  return bodies;
}

std::uint64_t Members::asked_about(const std::vector<bool>& marked) const {
  SUNDER_REQUIRE(marked.size() == members_.size() && !allowed_alone_);
  std::vector<std::uint64_t> of_body(members_.empty() ? 0 : members_.back().body + std::size_t{1});
  std::uint64_t all = 0, pairs = 0;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (marked[i]) ++all, ++of_body[body(i)];
  }
  for (const std::uint64_t count : of_body) pairs += count * (all - count);
  pairs /= 2;
  for (const auto& [a, b] : allowed_) {
    if (b < of_body.size()) pairs -= of_body[a] * of_body[b];  // bodies beyond have no parts
  }
  return pairs;
}

void Members::complete(Counts& counts) const {
  counts.parts = members_.size();
  counts.pairs = pairs_;
  counts.allowed = allowed_alone_ ? pairs_ - allowed_pairs_ : allowed_pairs_;
  counts.by_boxes = pairs_ - counts.allowed - counts.by_method;
}

}  // namespace sunder::scene

#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/scene_json.h>
#include <sunder/solid/pair/contact_evidence.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder::scene {

namespace {

// Of each part of each body, its number in the file.
using Numbers = std::vector<std::vector<std::uint32_t>>;

template <class Add>  // add(body, part)
Numbers numbers_of(std::span<const Body> bodies, const Add& add) {
  Numbers numbers;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    numbers.emplace_back();
    for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) numbers.back().push_back(add(b, p));
  }
  return numbers;
}

// What was asked about, and what counts, by parts of bodies one after the other.
AllPairs all_pairs(const Answer& answer, const Question& question, const Numbers& numbers) {
  AllPairs result;
  std::vector<std::uint32_t> first;  // of each body, where its parts begin
  for (std::uint32_t b = 0; b < numbers.size(); ++b) {
    first.push_back(static_cast<std::uint32_t>(result.members.size()));
    result.members.insert(result.members.end(), numbers[b].begin(), numbers[b].end());
    result.groups.insert(result.groups.end(), numbers[b].size(), b);
  }
  result.touching_allowed = question.touching_allowed;
  std::set<std::array<std::uint32_t, 2>> allowed;
  for (const auto& [a, b] : question.allowed) {
    if (a != b) allowed.insert({std::min(a, b), std::max(a, b)});
  }
  for (const auto& [a, b] : allowed) {
    for (std::uint32_t i = 0; i < numbers[a].size(); ++i) {
      for (std::uint32_t j = 0; j < numbers[b].size(); ++j) result.besides.push_back({first[a] + i, first[b] + j});
    }
  }
  for (const PartPair& pair : answer.pairs) {
    if (pair.counts) result.contacts.push_back({first[pair.body_a] + pair.part_a, first[pair.body_b] + pair.part_b});
  }
  std::sort(result.besides.begin(), result.besides.end());
  std::sort(result.contacts.begin(), result.contacts.end());
  return result;
}

}  // namespace

void write_certificate(std::span<const Placement> placements, const Question& question, Origin origin,
                       const TextSink& sink) {
  const std::span<const Body> bodies = placements.front().bodies;
  for (const auto& [a, b] : question.allowed) {
    origin.left_out.push_back(bodies[a].name + " and " + bodies[b].name + ", which may meet");
  }
  ClaimsWriter file(sink);
  file.add_origin(origin);
  PairClaims pairs(file);
  const Numbers shapes = numbers_of(bodies, [&](std::uint32_t b, std::uint32_t p) {
    return pairs.add_body(part_name(bodies[b], p), bodies[b].parts[p].shape.vertices());
  });
  std::vector<Numbers> numbers;  // by placement
  for (const Placement& placed : placements) {
    const std::string prefix = placements.size() > 1 ? std::string(placed.title) + ": " : "";
    numbers.push_back(numbers_of(placed.bodies, [&](std::uint32_t b, std::uint32_t p) {
      const Body& body = placed.bodies[b];
      return pairs.add_placed(prefix + part_name(body, p), shapes[b][p], body.parts[p].pose.affine());
    }));
  }
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const auto& [title, placed, answer] = placements[k];
    for (const PartPair& pair : answer.pairs) {
      const Part &a = placed[pair.body_a].parts[pair.part_a], &b = placed[pair.body_b].parts[pair.part_b];
      solid::add_claims(pairs,
                        {numbers[k][pair.body_a][pair.part_a], numbers[k][pair.body_b][pair.part_b], a.shape, a.pose,
                         b.shape, b.pose},
                        pair.answer.certificate(), pair.answer.meet() ? pair.contact : Contact::none);
    }
    pairs.add_all_pairs(all_pairs(answer, question, numbers[k]));
  }
  pairs.end();
}

}  // namespace sunder::scene

#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/sweep_claims.h>
#include <sunder/solid/round/round_claims.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sunder::scene {

namespace {

std::string names_of(std::span<const Body> bodies, const SweptPair& pair) {
  return part_name(bodies[pair.body_a], pair.part_a) + " and " + part_name(bodies[pair.body_b], pair.part_b);
}

// The parts of bodies in a file, where they are in each placement: each once.
class PlacedParts {
 public:
  PlacedParts(ClaimsWriter& file, PairClaims& pairs, std::span<const Body> bodies, const SaidOfScene& said)
      : pairs_(pairs) {
    for (const Body& body : bodies) {
      shapes_.emplace_back();
      for (std::uint32_t p = 0; p < body.parts.size(); ++p) {
        file.say(said.of(shapes_.size() - 1, p));
        shapes_.back().push_back(solid::add_shape(pairs, part_name(body, p), body.parts[p].shape));
      }
    }
  }

  // Adds it, where it is not there yet. Of a placement after the last one all that was before is forgotten, but for the
  // one before it.
  std::uint32_t number_of(std::size_t placement, const Body& placed, std::uint32_t body, std::uint32_t part) {
    while (newest_ < placement) {
      ++newest_;
      known_[0] = std::exchange(known_[1], {});
    }
    const auto [at, is_new] = known_[placement == newest_ ? 1 : 0].try_emplace({body, part}, 0);
    if (is_new) {
      const solid::PlacedRound in_place(placed.parts[part].shape, placed.parts[part].pose);
      at->second = pairs_.add_placed(std::to_string(placement) + ": " + part_name(placed, part), shapes_[body][part],
                                     in_place.pose.affine());
    }
    return at->second;
  }

 private:
  PairClaims& pairs_;
  std::vector<std::vector<std::uint32_t>> shapes_;
  std::array<std::map<std::array<std::uint32_t, 2>, std::uint32_t>, 2> known_;  // of the last but one, and the last
  std::size_t newest_ = 0;
};

void add_at_an_end(PairClaims& pairs, const PartPair& pair, const Part& a, const Part& b, std::uint32_t of_a,
                   std::uint32_t of_b) {
  const solid::PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  add_claims(pairs, of_a, in_a, of_b, in_b, pair.answer.evidence);
}

}  // namespace

void write_motion_certificate(std::span<const Body> bodies, std::size_t count,
                              const std::function<SweptStep(std::size_t k)>& step, const Question& question,
                              Origin origin, const TextSink& sink, const SaidOfScene& said) {
  if (question.every_pair) {
    for (const auto& [a, b] : question.allowed) {
      origin.left_out.push_back(bodies[a].name + " and " + bodies[b].name + ", which may meet");
    }
    origin.left_out.push_back("what turns between two placements, between them");
  } else {
    origin.left_out.push_back("all pairs of bodies that no statement is about");
  }
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (!pair.undecided()) continue;
      origin.left_out.push_back(std::to_string(k) + " to " + std::to_string(k + 1) + ": " + names_of(bodies, pair) +
                                ", undecided whether they meet");
    }
  }
  ClaimsWriter file(sink);
  file.add_origin(origin);
  PairClaims pairs(file);
  PlacedParts parts(file, pairs, bodies, said);
  std::vector<solid::ClaimedMotion> numbers;  // of each pair that is stated; of one at an end both are there
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (pair.undecided()) continue;
      const auto number = [&](bool is_end, std::uint32_t body, std::uint32_t part) {
        return parts.number_of(is_end ? k + 1 : k, (is_end ? at.end : at.begin)[body], body, part);
      };
      const auto* end = std::get_if<MeetAtAnEnd>(&pair.evidence);
      const bool begins = end == nullptr || end->time == 0, ends = end == nullptr || !begins;
      solid::ClaimedMotion& of = numbers.emplace_back();
      of.a = number(!begins, pair.body_a, pair.part_a);
      of.b = number(!begins, pair.body_b, pair.part_b);
      of.to_a = number(ends, pair.body_a, pair.part_a);
      of.to_b = number(ends, pair.body_b, pair.part_b);
    }
  }
  auto next = numbers.begin();
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (pair.undecided()) continue;
      const solid::ClaimedMotion& of = *next++;
      for (const std::size_t placement : {k, k + 1}) {
        if (const auto joints = said.joints_of(placement)) file.note(*joints);
      }
      if (const auto* meet = std::get_if<MeetOnTheWay>(&pair.evidence)) {
        add_claims(pairs, of, *meet->first);
      } else if (const auto* apart = std::get_if<ApartOnTheWay>(&pair.evidence)) {
        pairs.add_motion_apart(of.a, of.b, of.to_a, of.to_b, *apart->direction);
      } else {
        const MeetAtAnEnd& end = std::get<MeetAtAnEnd>(pair.evidence);
        const std::span<const Body> there = end.time == 0 ? at.begin : at.end;
        add_at_an_end(pairs, *end.pair, there[pair.body_a].parts[pair.part_a], there[pair.body_b].parts[pair.part_b],
                      of.a, of.b);
      }
    }
  }
  pairs.end();
}

}  // namespace sunder::scene

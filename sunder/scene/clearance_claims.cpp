#include <sunder/base/contract.h>
#include <sunder/scene/clearance_claims.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace sunder::scene {

namespace {

using BodyPair = std::array<std::uint32_t, 2>;
using MemberPairs = std::vector<std::array<std::uint32_t, 2>>;

class ClearanceClaims {
 public:
  ClearanceClaims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                  const std::vector<BodyPair>& allowed)
      : claims_(claims), bodies_(bodies), members_(bodies, allowed) {
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      first_.push_back(static_cast<std::uint32_t>(all_.members.size()));
      all_.members.insert(all_.members.end(), numbers[b].begin(), numbers[b].end());
      all_.groups.insert(all_.groups.end(), numbers[b].size(), b);
    }
    for (std::uint32_t i = 0; i < members_.size(); ++i) boxes_.push_back(box_of(members_.part(bodies, i)));
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      for (std::uint32_t j = i + 1; j < members_.size(); ++j) {
        if (members_.are_asked_about(i, j)) {
          asked_.push_back({i, j});
        } else if (members_.body(i) != members_.body(j)) {
          all_.besides.push_back({i, j});
        }
      }
    }
  }

  const MemberPairs& asked() const { return asked_; }  // pairs of members, in order
  const AllPairs& all() const { return all_; }         // the same, without contacts
  std::uint32_t body(std::uint32_t member) const { return members_.body(member); }
  std::uint32_t member(std::uint32_t body, std::uint32_t part) const { return first_[body] + part; }

  // Whether they are `least` apart, or more. False, and nothing is stated, where that is undecided and cannot be told
  // from the bounds of their distance either.
  bool state(std::uint32_t i, std::uint32_t j, double least) {
    const std::uint32_t of_i = all_.members[i], of_j = all_.members[j];
    if (const auto apart = apart_by_boxes(boxes_[i], boxes_[j], least)) {
      std::array<Dyadic, 3> direction{};
      direction[apart->axis] = Dyadic(apart->a_is_lower ? 1.0 : -1.0);
      claims_.add_clearance(of_i, of_j, least, direction);
      return true;
    }
    return add_claims(claims_, of_i, members_.part(bodies_, i), of_j, members_.part(bodies_, j), least);
  }

  // Where only these bodies are spoken of, which are asked about.
  AllPairs of_bodies(const BodyPair& bodies) const {
    AllPairs some;
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      if (body(i) != bodies[0] && body(i) != bodies[1]) continue;
      some.members.push_back(all_.members[i]);
      some.groups.push_back(body(i));
    }
    return some;
  }

 private:
  PairClaims& claims_;
  std::span<const Body> bodies_;
  Members members_;
  AllPairs all_;
  std::vector<std::uint32_t> first_;  // of each body, where its parts begin
  std::vector<solid::WorldBox> boxes_;
  MemberPairs asked_;
};

BodyPair in_order(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

bool add_claims(PairClaims& claims, std::uint32_t of_a, const Part& a, std::uint32_t of_b, const Part& b,
                double least) {
  const solid::PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  const solid::RoundClearance found = round_clearance(in_a, in_b, least);
  if (found.undecided()) return false;
  solid::add_claims(claims, of_a, of_b, least, found);
  return true;
}

void add_claims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                const ClearanceQuestion& question, const ClearanceAnswer& answer, const NotePairs& note) {
  ClearanceClaims scene(claims, bodies, numbers, question.allowed);
  std::map<BodyPair, double> margins;
  for (const auto& [a, b, least] : question.margins) margins[in_order(a, b)] = least;
  const auto members_of = [&](const std::vector<CloserParts>& list) {
    std::set<std::array<std::uint32_t, 2>> pairs;
    for (const PartDistance& pair : list) {
      pairs.insert({scene.member(pair.body_a, pair.part_a), scene.member(pair.body_b, pair.part_b)});
    }
    return pairs;
  };
  const auto closer = members_of(answer.closer), undecided = members_of(answer.undecided);

  AllPairs all = scene.all();
  PairReasons others;
  std::map<BodyPair, AllPairs> own;
  for (const auto& pair : scene.asked()) {
    const auto [i, j] = pair;
    const BodyPair of{scene.body(i), scene.body(j)};
    const auto margin = margins.find(of);
    const bool is_own = margin != margins.end();
    const double least = is_own ? margin->second : question.least;
    const bool is_known = !undecided.contains(pair) && (least == 0 || scene.state(i, j, least));
    if (is_own || !is_known) {
      all.besides.push_back(pair);
      others.add(is_own ? "with a margin of its own" : "undecided", 1);
    }
    if (!is_own) {
      if (closer.contains(pair)) all.contacts.push_back(pair);
      continue;
    }
    if (least == 0) continue;
    const auto found = own.find(of);
    AllPairs& those = found != own.end() ? found->second : own.emplace(of, scene.of_bodies(of)).first->second;
    const auto [a, b] = of;
    // Members of the lower body come first.
    const auto count_a = static_cast<std::uint32_t>(bodies[a].parts.size());
    const std::array<std::uint32_t, 2> here{i - scene.member(a, 0), count_a + j - scene.member(b, 0)};
    if (!is_known) those.besides.push_back(here);
    if (closer.contains(pair)) those.contacts.push_back(here);
  }
  std::sort(all.besides.begin(), all.besides.end());
  if (question.least > 0) {
    note(true, others);
    claims.add_all_clearances(all, question.least);
  }
  for (const auto& [of, pairs] : own) {
    PairReasons of_two;
    of_two.add("undecided", pairs.besides.size());
    note(false, of_two);
    claims.add_all_clearances(pairs, margins.at(of));
  }
}

void add_claims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                const std::vector<BodyPair>& allowed, const PartDistance& nearest, const NotePairs& note) {
  if (nearest.meet()) return;
  ClearanceClaims scene(claims, bodies, numbers, allowed);
  if (const double low = nearest.distance.low; low > 0) {
    AllPairs all = scene.all();
    PairReasons others;
    for (const auto& [i, j] : scene.asked()) {
      if (scene.state(i, j, low)) continue;
      all.besides.push_back({i, j});
      others.add("undecided", 1);
    }
    std::sort(all.besides.begin(), all.besides.end());
    note(true, others);
    claims.add_all_clearances(all, low);
  }
  const std::uint32_t of_a = numbers[nearest.body_a][nearest.part_a], of_b = numbers[nearest.body_b][nearest.part_b];
  add_distance(claims, of_a, of_b, nearest.evidence);
}

}  // namespace sunder::scene

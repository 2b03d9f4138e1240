#include <sunder/base/contract.h>
#include <sunder/scene/clearance_claims.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_clearance.h>
#include <sunder/scene/part_questions.h>
#include <sunder/scene/parts_as_meshes.h>
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

// The pairs of a scene's parts that are asked about.
class AskedParts {
 public:
  AskedParts(std::span<const Body> bodies, const std::vector<BodyPair>& allowed)
      : bodies_(bodies), members_(bodies, allowed) {
    for (std::uint32_t i = 0; i < members_.size(); ++i) boxes_.push_back(box_of(members_.part(bodies, i)));
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      for (std::uint32_t j = i + 1; j < members_.size(); ++j) {
        if (members_.are_asked_about(i, j)) {
          asked_.push_back({i, j});
        } else if (members_.body(i) != members_.body(j)) {
          besides_.push_back({i, j});
        }
      }
    }
  }

  const MemberPairs& asked() const { return asked_; }      // pairs of members, in order
  const MemberPairs& besides() const { return besides_; }  // likewise, of different bodies
  std::uint32_t count() const { return members_.size(); }
  std::uint32_t body(std::uint32_t member) const { return members_.body(member); }
  const Part& part(std::uint32_t member) const { return members_.part(bodies_, member); }
  TwoParts parts(std::uint32_t i, std::uint32_t j) const { return TwoParts::of(members_.pair(i, j)); }

  std::optional<AxisApart> axis_between(std::uint32_t i, std::uint32_t j, double least) const {
    return apart_by_boxes(boxes_[i], boxes_[j], least);
  }

  // Are their hulls that far apart, or further?
  bool are_kept_by_hulls(std::uint32_t i, std::uint32_t j, double least) const {
    if (axis_between(i, j, least)) return true;
    const solid::PlacedRound a(part(i).shape, part(i).pose), b(part(j).shape, part(j).pose);
    return solid::is_kept(round_clearance(a, b, least));
  }

 private:
  std::span<const Body> bodies_;
  Members members_;
  std::vector<solid::WorldBox> boxes_;
  MemberPairs asked_, besides_;
};

// alone: the statement is not one of those that tell what is said of all pairs.
enum class Stated : std::uint8_t { no, told, alone };

// The asked pairs that are stated as meshes (clearance_claims.h). least(i, j) is the margin of two members; where it is
// 0, nothing is asked about them.
template <class Least>
std::vector<TwoParts> closer_as_meshes(const AskedParts& parts, std::span<const Body> bodies, const Least& least) {
  std::vector<TwoParts> stated, others;
  for (const auto& [i, j] : parts.asked()) {
    const double c = least(i, j);
    if (c == 0 || parts.are_kept_by_hulls(i, j, c)) continue;
    if (PartsAsMeshes::of(parts.part(i), parts.part(j))) {
      stated.push_back(parts.parts(i, j));
    } else if (parts.part(i).mesh == nullptr && parts.part(j).mesh == nullptr) {
      others.push_back(parts.parts(i, j));
    }
  }
  return spread(std::move(stated), others, bodies);
}

class ClearanceClaims {
 public:
  // as_meshes: the pairs that are stated so.
  ClearanceClaims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                  const std::vector<BodyPair>& allowed, const std::vector<TwoParts>& as_meshes,
                  const StateOfMeshes& of_meshes)
      : claims_(claims),
        parts_(bodies, allowed),
        as_meshes_(as_meshes.begin(), as_meshes.end()),
        of_meshes_(of_meshes) {
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      first_.push_back(static_cast<std::uint32_t>(all_.members.size()));
      all_.members.insert(all_.members.end(), numbers[b].begin(), numbers[b].end());
      all_.groups.insert(all_.groups.end(), numbers[b].size(), b);
    }
    all_.besides = parts_.besides();
  }

  const MemberPairs& asked() const { return parts_.asked(); }
  const AllPairs& all() const { return all_; }  // the same, without contacts
  std::uint32_t body(std::uint32_t member) const { return parts_.body(member); }
  std::uint32_t member(std::uint32_t body, std::uint32_t part) const { return first_[body] + part; }

  // Whether they are `least` apart, or more; told: what the statement about all such pairs has from those about meshes.
  // `no`, and nothing is stated, where that is undecided and cannot be told from the bounds of their distance either.
  Stated state(std::uint32_t i, std::uint32_t j, double least, ToldAsMeshes& told) {
    const std::uint32_t of_i = all_.members[i], of_j = all_.members[j];
    if (const auto apart = parts_.axis_between(i, j, least)) {
      std::array<Dyadic, 3> direction{};
      direction[apart->axis] = Dyadic(apart->a_is_lower ? 1.0 : -1.0);
      claims_.add_clearance(of_i, of_j, least, direction);
      return Stated::told;
    }
    if (const TwoParts pair = parts_.parts(i, j); as_meshes_.contains(pair)) {
      const auto meshes = PartsAsMeshes::of_any(parts_.part(i), parts_.part(j));
      if (!meshes || meshes->clearance(least) == Verdict::undecided) return Stated::no;
      of_meshes_(told, pair, least);
      return told.is_told(pair) == true ? Stated::told : Stated::alone;
    }
    return add_claims(claims_, of_i, parts_.part(i), of_j, parts_.part(j), least) ? Stated::told : Stated::no;
  }

  // The meshes that members stand for: of all of them, or of those of some bodies.
  void name_meshes(AllPairs& pairs, const ToldAsMeshes& told, const BodyPair* of = nullptr) const {
    for (std::uint32_t i = 0; i < parts_.count(); ++i) {
      if (of != nullptr && body(i) != (*of)[0] && body(i) != (*of)[1]) continue;
      pairs.as_meshes.push_back(told.mesh(body(i), i - first_[body(i)]));
    }
  }

  // Where only these bodies are spoken of, which are asked about.
  AllPairs of_bodies(const BodyPair& bodies) const {
    AllPairs some;
    for (std::uint32_t i = 0; i < parts_.count(); ++i) {
      if (body(i) != bodies[0] && body(i) != bodies[1]) continue;
      some.members.push_back(all_.members[i]);
      some.groups.push_back(body(i));
    }
    return some;
  }

 private:
  PairClaims& claims_;
  AskedParts parts_;
  std::set<TwoParts> as_meshes_;
  const StateOfMeshes& of_meshes_;
  AllPairs all_;
  std::vector<std::uint32_t> first_;  // of each body, where its parts begin
};

BodyPair in_order(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// By pairs of bodies, but for those that have no own.
std::map<BodyPair, double> own_margins(const ClearanceQuestion& question) {
  std::map<BodyPair, double> margins;
  for (const auto& [a, b, least] : question.margins) margins[in_order(a, b)] = least;
  return margins;
}

// Adds that a pair, which was stated so or not, is left out of what is said of all pairs.
void add_reason(PairReasons& reasons, Stated stated) {
  if (stated == Stated::alone) reasons.add("meshes as they are, in a statement of their own", 1);
  if (stated == Stated::no) reasons.add("undecided", 1);
}

}  // namespace

std::vector<TwoParts> pairs_as_meshes(std::span<const Body> bodies, const ClearanceQuestion& question) {
  const AskedParts parts(bodies, question.allowed);
  const Margins margins(question);
  return closer_as_meshes(parts, bodies,
                          [&](std::uint32_t i, std::uint32_t j) { return margins.of(parts.body(i), parts.body(j)); });
}

std::vector<TwoParts> pairs_as_meshes(std::span<const Body> bodies, const std::vector<BodyPair>& allowed,
                                      const PartDistance& nearest) {
  std::vector<TwoParts> result;
  if (nearest.meet()) return result;
  if (nearest.distance.low > 0) {
    result = closer_as_meshes(AskedParts(bodies, allowed), bodies,
                              [&](std::uint32_t, std::uint32_t) { return nearest.distance.low; });
  }
  if (is_of_meshes(nearest, bodies)) result.push_back(TwoParts::of(nearest));
  return result;
}

bool add_claims(PairClaims& claims, std::uint32_t of_a, const Part& a, std::uint32_t of_b, const Part& b,
                double least) {
  const solid::PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  const solid::RoundClearance found = round_clearance(in_a, in_b, least);
  if (found.undecided()) return false;
  solid::add_claims(claims, of_a, of_b, least, found);
  return true;
}

void add_claims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                const ClearanceQuestion& question, const ClearanceAnswer& answer, const StateOfMeshes& of_meshes,
                const NotePairs& note) {
  ClearanceClaims scene(claims, bodies, numbers, question.allowed, pairs_as_meshes(bodies, question), of_meshes);
  const std::map<BodyPair, double> margins = own_margins(question);
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
  ToldAsMeshes told;
  std::map<BodyPair, AllPairs> own;
  std::map<BodyPair, PairReasons> own_reasons;
  std::map<BodyPair, ToldAsMeshes> own_told;
  for (const auto& pair : scene.asked()) {
    const auto [i, j] = pair;
    const BodyPair of{scene.body(i), scene.body(j)};
    const auto margin = margins.find(of);
    const bool is_own = margin != margins.end();
    const double least = is_own ? margin->second : question.least;
    const Stated stated = undecided.contains(pair) ? Stated::no
                          : least == 0             ? Stated::told
                                                   : scene.state(i, j, least, is_own ? own_told[of] : told);
    const bool is_told = stated == Stated::told;
    if (is_own || !is_told) all.besides.push_back(pair);
    if (!is_own) {
      add_reason(others, stated);
      if (is_told && closer.contains(pair)) all.contacts.push_back(pair);
      continue;
    }
    others.add("with a margin of its own", 1);
    if (least == 0) continue;
    const auto found = own.find(of);
    AllPairs& those = found != own.end() ? found->second : own.emplace(of, scene.of_bodies(of)).first->second;
    const auto [a, b] = of;
    // Members of the lower body come first.
    const auto count_a = static_cast<std::uint32_t>(bodies[a].parts.size());
    const std::array<std::uint32_t, 2> here{i - scene.member(a, 0), count_a + j - scene.member(b, 0)};
    if (!is_told) those.besides.push_back(here);
    add_reason(own_reasons[of], stated);
    if (is_told && closer.contains(pair)) those.contacts.push_back(here);
  }
  std::sort(all.besides.begin(), all.besides.end());
  if (question.least > 0) {
    scene.name_meshes(all, told);
    note(true, others);
    claims.add_all_clearances(all, question.least);
  }
  for (auto& [of, pairs] : own) {
    scene.name_meshes(pairs, own_told[of], &of);
    note(false, own_reasons[of]);
    claims.add_all_clearances(pairs, margins.at(of));
  }
}

void add_claims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                const std::vector<BodyPair>& allowed, const PartDistance& nearest, const StateOfMeshes& of_meshes,
                const NotePairs& note) {
  if (nearest.meet()) return;
  ToldAsMeshes told;
  ClearanceClaims scene(claims, bodies, numbers, allowed, pairs_as_meshes(bodies, allowed, nearest), of_meshes);
  if (const double low = nearest.distance.low; low > 0) {
    AllPairs all = scene.all();
    PairReasons others;
    for (const auto& [i, j] : scene.asked()) {
      const Stated stated = scene.state(i, j, low, told);
      if (stated == Stated::told) continue;
      all.besides.push_back({i, j});
      add_reason(others, stated);
    }
    std::sort(all.besides.begin(), all.besides.end());
    scene.name_meshes(all, told);
    note(true, others);
    claims.add_all_clearances(all, low);
  }
  if (is_of_meshes(nearest, bodies)) return of_meshes(told, TwoParts::of(nearest), {});
  const std::uint32_t of_a = numbers[nearest.body_a][nearest.part_a], of_b = numbers[nearest.body_b][nearest.part_b];
  add_distance(claims, of_a, of_b, nearest.evidence);
}

}  // namespace sunder::scene

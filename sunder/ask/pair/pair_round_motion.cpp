// sunder pair A B --to-a POSE --to-b POSE where one of the two has a radius.
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_round_sweep.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace sunder::ask {

namespace {

using solid::PlacedRound;
using solid::SweepContact;
using solid::Translation;

class RoundMotionPair : public PairQuestion {
 public:
  RoundMotionPair(const PairCall& asked, const PlacedRoundBody& a, const PlacedRoundBody& b, const PairFiles& files)
      : PairQuestion(asked, a.object_of(), b.object_of(), files),
        round_a_(a),
        round_b_(b),
        of_a_(motion_of(a.pose, asked.a)),
        of_b_(motion_of(b.pose, asked.b)) {
    tell_motion(of_a_, a_);
    tell_motion(of_b_, b_);
  }

  void ask() {
    answer_ = round_round_sweep(round_a_.body, of_a_, round_b_.body, of_b_);
    take(answer_, answer_.undecided()
                      ? "nothing: the least gap on the way, or the depth, is below some 2^-40 of their size"
                      : decided_text(answer_.decided_by));
    if (answer_.undecided()) word_ = "undecided";
    is_yes_ = answer_.verdict() != Verdict::apart;  // what is undecided is not known to be apart
    const bool is_said_of_hulls = is_yes_ && (round_a_.is_hull() || round_b_.is_hull());
    verdict_ = answer_.undecided() ? "undecided whether they meet on the way"
               : !meet_            ? "apart all the way"
               : is_said_of_hulls  ? "meet on the way, as hulls"
                                   : "meet on the way";
    facts_ = {{"said_of", is_said_of_hulls ? "hulls" : "bodies", ""}};
    if (answer_.undecided()) return;
    if (!meet_) return facts_.push_back(told_apart());
    first_ = round_round_first_contact(round_a_.body, of_a_, round_b_.body, of_b_, answer_);
    facts_.push_back(told_point());
    facts_.push_back(told_time());
    const SweepContact& contact = first_->contact;
    const bool is_proved = std::any_of(contact.direction.begin(), contact.direction.end(),
                                       [](const Dyadic& x) { return x.sign() != Sign::zero; });
    if (!is_proved && contact.time.sign() != Sign::zero) not_proved_.emplace_back("that they do not meet before");
  }

  std::string certificate() const {
    if (answer_.undecided()) {
      throw Error(ErrorCode::bad_value, "the pair is undecided, and there is no proof; leave out --certificate",
                  "--certificate");
    }
    return claims_text(origin(), [&](ClaimsWriter& file) {
      PairClaims pairs(file);
      const auto add = [&](const PairObject& object, const PlacedRoundBody& body, const Translation& motion) {
        file.say(object.said);
        const PlacedRound begin(body.body, motion.begin()), end(body.body, motion.end());
        const std::uint32_t index = solid::add_shape(pairs, object.name, body.body);
        const std::uint32_t first = pairs.add_placed(object.name, index, begin.pose.affine());
        return std::pair(first, motion.rests() ? first : pairs.add_placed(object.name, index, end.pose.affine()));
      };
      const auto [a, to_a] = add(a_, round_a_, of_a_);
      const auto [b, to_b] = add(b_, round_b_, of_b_);
      if (first_) return add_claims(pairs, {a, b, to_a, to_b}, *first_);
      add_claims(pairs, {a, b, to_a, to_b}, round_a_.body, of_a_, round_b_.body, of_b_, answer_);
    });
  }

 private:
  Fact told_point() const {
    const Point3 at = nearest(first_->contact.point.at), p{at.x + 0.0, at.y + 0.0, at.z + 0.0};
    return {"evidence", {{"point", to_json(p)}}, fmt::format("a common point then at about {}", about(p))};
  }

  Fact told_time() const {
    const auto [low, high] = first_->time;
    return {"time",
            {{"low", low}, {"high", high}},
            high - low <= 0x1p-40
                ? fmt::format("{}{:.12g} of 0 to 1: they meet then, and not before", low == high ? "" : "about ", high)
                : fmt::format("{:.12g} of 0 to 1: they meet then, and not before {:.12g}", high, low)};
  }

  Fact told_apart() const {
    const auto [x, y, z] = direction_of(round_a_.body, of_a_, round_b_.body, of_b_, answer_);
    const solid::RoundEvidence evidence = solid::separation_along(WorldDirection(Vector3<Dyadic>{x, y, z}));
    const auto gap = [&](bool at_end) {
      const PlacedRound a(round_a_.body, at_end ? of_a_.end() : of_a_.begin());
      const PlacedRound b(round_b_.body, at_end ? of_b_.end() : of_b_.begin());
      return rounded_gap(a, b, evidence).width;
    };
    const PlacedRound begin_a(round_a_.body, of_a_.begin()), begin_b(round_b_.body, of_b_.begin());
    const Point3 direction = rounded_direction(begin_a, begin_b, evidence);
    const double first = gap(false), last = gap(true);
    return {
        "evidence",
        {{"direction_about", to_json(direction)}, {"gap_about", std::min(first, last)}},
        fmt::format("all the way an empty slab across the direction of about {},\nabout {} wide at the beginning and "
                    "{} at the end",
                    about(direction), about(first), about(last))};
  }

  const PlacedRoundBody &round_a_, &round_b_;
  Translation of_a_, of_b_;
  solid::SweepAnswer answer_;
  std::optional<solid::RoundFirstContact> first_;
};

}  // namespace

Report run_round_motion_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  require_pair_fit(call, {pair_kind::moving});
  for (const auto& [input, side] : {std::pair(&a, &call.a), std::pair(&b, &call.b)}) {
    if (input->bounded) require_no_frame(*input->bounded, *side);
    if (input->round && input->round->core) require_no_frame(*input->round->core, *side);
  }
  const PlacedRoundBody of_a = round_of(a), of_b = round_of(b);
  return ask::answer(RoundMotionPair(call, of_a, of_b, files), files.talk);
}

}  // namespace sunder::ask

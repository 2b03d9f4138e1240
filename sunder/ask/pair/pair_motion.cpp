// sunder pair A B --to-a POSE --to-b POSE: do two bodies meet at any time, while they go straight from pose to pose?
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_motion.h>
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

using solid::PlacedRound;
using solid::SweepContact;
using solid::Translation;

Translation motion_of(const solid::Pose& begin, const PlacedBody* body, const PairSide& side) {
  if (side.to.empty()) return Translation(begin);
  if (body != nullptr && body->object && body->object->frame) {
    throw Error(ErrorCode::bad_call, "is not for a polygon in a frame; give its vertices in space", side.option("to"));
  }
  const solid::Pose end = parse_pose(side.to, side.option("to"));
  if (!is_translation(begin, end)) {
    throw Error(ErrorCode::bad_pose,
                fmt::format("the body turns, or changes its size, between {} and this pose; only straight motions "
                            "without a turn are answered: give both the same matrix, or the same rotation",
                            side.option("pose")),
                side.option("to"));
  }
  return {begin, end};
}

void tell_motion(const Translation& motion, PairObject& object) {
  if (motion.rests()) return;
  const auto &from = motion.begin().affine().translation, &to = motion.end().affine().translation;
  object.text +=
      fmt::format("\nmoves straight from ({}, {}, {}) to ({}, {}, {})", from[0], from[1], from[2], to[0], to[1], to[2]);
  object.json["moves"] = {{"from", from}, {"to", to}};
}

Fact told_first_time(const Interval& time) {
  const auto [low, high] = time;
  return {"time",
          {{"low", low}, {"high", high}},
          high - low <= 0x1p-40
              ? fmt::format("{}{:.12g} of 0 to 1: they meet then, and not before", low == high ? "" : "about ", high)
              : fmt::format("{:.12g} of 0 to 1: they meet then, and not before {:.12g}", high, low)};
}

namespace {

const PlacedBody* core_of(const PlacedRoundBody& body) { return body.core ? &*body.core : nullptr; }

class MotionPair : public PairQuestion {
 public:
  MotionPair(const PairCall& asked, const PlacedRoundBody& a, const PlacedRoundBody& b, const PairFiles& files)
      : PairQuestion(asked, a.object_of(), b.object_of(), files),
        round_a_(a),
        round_b_(b),
        of_a_(motion_of(a.pose, core_of(a), asked.a)),
        of_b_(motion_of(b.pose, core_of(b), asked.b)) {
    tell_motion(of_a_, a_);
    tell_motion(of_b_, b_);
  }

  void ask() {
    function_ = "solid::round_round_sweep";
    answer_ = round_round_sweep(round_a_.body, of_a_, round_b_.body, of_b_);
    take(answer_, answer_.undecided()
                      ? "nothing: the least gap on the way, or the depth, is below some 2^-40 of their size"
                      : decided_text(answer_.decided_by));
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
    facts_.push_back(told_first_time(first_->time));
    const SweepContact& contact = first_->contact;
    const bool is_proved = std::any_of(contact.direction.begin(), contact.direction.end(),
                                       [](const Dyadic& x) { return x.sign() != Sign::zero; });
    if (!is_proved && contact.time.numerator.sign() != Sign::zero)
      not_proved_.emplace_back("that they do not meet before");
  }

  std::string certificate() const {
    require_decided();
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

  // The empty slab between the bodies. For two polyhedra it also names the two vertices that bound the slab.
  Fact told_apart() const {
    const auto* of_vertices = std::get_if<solid::SeparationOnTheWay>(&answer_.evidence);
    const auto [x, y, z] = direction_of(round_a_.body, of_a_, round_b_.body, of_b_, answer_);
    const WorldDirection direction(Vector3<Dyadic>{x, y, z});
    const auto gap = [&](bool at_end) {
      const PlacedRound a(round_a_.body, at_end ? of_a_.end() : of_a_.begin());
      const PlacedRound b(round_b_.body, at_end ? of_b_.end() : of_b_.begin());
      if (!of_vertices) return rounded_gap(a, b, solid::separation_along(direction));
      Separation between = of_vertices->separation;
      between.direction = exact_direction({x, y, z});
      return rounded_gap(between, {a.body.points(), a.core.pose, false}, {b.body.points(), b.core.pose, false});
    };
    const RoundedGap first = gap(false), last = gap(true);
    Json json{{"direction_about", to_json(first.direction)}, {"gap_about", std::min(first.width, last.width)}};
    std::string from;
    if (of_vertices) {
      const auto& [along, extreme_a, extreme_b] = of_vertices->separation;
      json["extreme_a"] = extreme_a, json["extreme_b"] = extreme_b;
      from = fmt::format("from vertex {} of A to vertex {} of B, ", extreme_a, extreme_b);
    }
    return {"evidence", std::move(json),
            fmt::format("all the way an empty slab across the direction of about {},\n{}about {} wide at the beginning "
                        "and {} at the end",
                        about(first.direction), from, about(first.width), about(last.width))};
  }

  const PlacedRoundBody &round_a_, &round_b_;
  Translation of_a_, of_b_;
  solid::SweepAnswer answer_;
  std::optional<solid::RoundFirstContact> first_;
};

}  // namespace

Report run_motion_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  require_pair_fit(call, {pair_kind::moving});
  const PlacedRoundBody of_a = round_of(a), of_b = round_of(b);
  return ask::answer(MotionPair(call, of_a, of_b, files), files.talk);
}

}  // namespace sunder::ask

// sunder pair A B --to-a POSE --to-b POSE: do two bodies meet at any time, while they go straight from pose to pose?
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace sunder::ask {

namespace {

using solid::SweepContact;
using solid::Translation;

class MotionPair : public PairQuestion {
 public:
  MotionPair(const PairCall& asked, const PlacedBody& a, const PlacedBody& b, const PairFiles& files)
      : PairQuestion(asked, object_of(a), object_of(b), files),
        body_a_(a),
        body_b_(b),
        of_a_(motion_of(a.pose, asked.a)),
        of_b_(motion_of(b.pose, asked.b)) {
    tell_motion(of_a_, a_);
    tell_motion(of_b_, b_);
  }

  void ask() {
    const solid::ConvexPolyhedron &a = body_a_.mesh.hull, &b = body_b_.mesh.hull;
    const solid::SweepAnswer answer = polyhedron_polyhedron_sweep(a, of_a_, b, of_b_);
    take(answer, decided_text(answer.decided_by));
    const bool is_said_of_hulls = meet_ && (body_a_.is_hull() || body_b_.is_hull());
    verdict_ = !meet_ ? "apart all the way" : is_said_of_hulls ? "meet on the way, as hulls" : "meet on the way";
    facts_ = {{"said_of", is_said_of_hulls ? "hulls" : "bodies", ""}};
    if (meet_) {
      first_ = polyhedron_polyhedron_first_contact(a, of_a_, b, of_b_);
      facts_.push_back(told_point());
      facts_.push_back(told_time());
    } else {
      apart_ = std::get<solid::SeparationOnTheWay>(answer.evidence).separation;
      apart_.direction = exact_direction(parting_direction(answer, a, of_a_, b, of_b_));
      facts_.push_back(told_apart());
    }
  }

  std::string certificate() const {
    return claims_text(origin(), [&](ClaimsWriter& file) {
      PairClaims pairs(file);
      const auto add = [&](const PairObject& object, const Translation& motion) {
        file.say(object.said);
        const std::uint32_t body = pairs.add_body(object.name, object.vertices);
        const std::uint32_t begin = pairs.add_placed(object.name, body, motion.begin().affine());
        return std::pair(begin, motion.rests() ? begin : pairs.add_placed(object.name, body, motion.end().affine()));
      };
      const auto [a, to_a] = add(a_, of_a_);
      const auto [b, to_b] = add(b_, of_b_);
      if (!first_) return pairs.add_motion_apart(a, b, to_a, to_b, *apart_.direction.numbers);
      const bool is_later = first_->time.sign() != Sign::zero;
      pairs.add_motion_meet(a, b, to_a, to_b, first_->time, first_->denominator, first_->point,
                            is_later ? &first_->direction : nullptr);
    });
  }

 private:
  Fact told_point() const {
    const Point3 p = nearest(first_->point.at);
    return {"evidence", {{"point", to_json(p)}}, fmt::format("a common point then at about {}", about(p))};
  }

  Fact told_time() const {
    const auto [low, high] = first_->about();
    return {"time",
            {{"low", low}, {"high", high}},
            fmt::format("{}{:.12g} of 0 to 1: they meet then, and not before", low == high ? "" : "about ", high)};
  }

  Fact told_apart() const {
    const auto gap = [&](bool at_end) {
      const Affine3 &a = (at_end ? of_a_.end() : of_a_.begin()).affine(),
                    &b = (at_end ? of_b_.end() : of_b_.begin()).affine();
      return rounded_gap(apart_, {a_.vertices, a, false}, {b_.vertices, b, false});
    };
    const RoundedGap first = gap(false), last = gap(true);
    return {
        "evidence",
        {{"direction_about", to_json(first.direction)},
         {"gap_about", std::min(first.width, last.width)},
         {"extreme_a", apart_.extreme_a},
         {"extreme_b", apart_.extreme_b}},
        fmt::format("all the way an empty slab across the direction of about {},\nfrom vertex {} of A to vertex {} "
                    "of B, about {} wide at the beginning and {} at the end",
                    about(first.direction), apart_.extreme_a, apart_.extreme_b, about(first.width), about(last.width))};
  }

  const PlacedBody &body_a_, &body_b_;
  Translation of_a_, of_b_;
  Separation apart_;
  std::optional<SweepContact> first_;
};

}  // namespace

solid::Translation motion_of(const solid::Pose& begin, const PairSide& side) {
  if (side.to.empty()) return Translation(begin);
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

void require_no_frame(const PlacedBody& body, const PairSide& side) {
  if (side.to.empty() || !body.object || !body.object->frame) return;
  throw Error(ErrorCode::bad_call, "is not for a polygon in a frame; give its vertices in space", side.option("to"));
}

void tell_motion(const solid::Translation& motion, PairObject& object) {
  if (motion.rests()) return;
  const auto &from = motion.begin().affine().translation, &to = motion.end().affine().translation;
  object.text +=
      fmt::format("\nmoves straight from ({}, {}, {}) to ({}, {}, {})", from[0], from[1], from[2], to[0], to[1], to[2]);
  object.json["moves"] = {{"from", from}, {"to", to}};
}

Report run_motion_pair(const PairCall& call, const PlacedBody& a, const PlacedBody& b, const PairFiles& files) {
  require_pair_fit(call, {pair_kind::moving});
  for (const auto& [body, side] : {std::pair(&a, &call.a), std::pair(&b, &call.b)}) require_no_frame(*body, *side);
  return answer(MotionPair(call, a, b, files), files.talk);
}

}  // namespace sunder::ask

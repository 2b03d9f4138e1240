#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_depth.h>
#include <sunder/solid/round/round_distance.h>

#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace sunder::ask {

namespace {

using solid::PlacedRound;
using solid::RoundBody;
using RoundObjectKind = io::SpaceObject::Kind;

// A body that is bounded, as one with a radius.
PlacedRoundBody rounded(const PlacedBody& body) {
  return {body.mesh.file, body.mesh.name, {}, body, RoundBody::rounded(body.mesh.hull, 0), body.pose, body.said};
}

class RoundPair : public PairQuestion {
 public:
  RoundPair(const PairCall& asked, const PlacedRoundBody& a, const PlacedRoundBody& b, const PairFiles& files)
      : PairQuestion(asked, a.object_of(), b.object_of(), files),
        of_a_(a),
        of_b_(b),
        placed_a_(a.body, a.pose),
        placed_b_(b.body, b.pose),
        least_(least_clearance(asked)) {
    if (asked.method != "automatic") {
      throw Error(ErrorCode::bad_call, "bodies with a radius have one method; leave it out, or give automatic",
                  "--method");
    }
  }

  void ask() {
    answer_ = round_round(placed_a_, placed_b_);
    take(answer_, answer_.undecided() ? "nothing: the gap or the depth is below some 2^-76 of their size"
                                      : decided_text(answer_.decided_by));
    if (answer_.undecided()) verdict_ = word_ = "undecided";
    is_yes_ = answer_.verdict() != Verdict::apart;  // what is undecided is not known to be apart
    if (call.classify && meet_) {
      found_ = round_round_contact(placed_a_, placed_b_, answer_.evidence);
      contact_ = relation_of(found_);
    }
    if (call.distance || least_ > 0) {
      distance_ = round_distance(placed_a_, placed_b_);
      enclosed_ = distance_of(distance_);
    }
    if (least_ > 0) {
      clearance_ = round_clearance(placed_a_, placed_b_, least_);
      is_yes_ = !is_kept(clearance_);
    }
    // That they are apart, and so far, carries over from hulls to the meshes that they stand for.
    const bool is_hull = of_a_.is_hull() || of_b_.is_hull();
    const bool is_said_of_hulls =
        is_hull && (answer_.verdict() != Verdict::apart || call.distance || (least_ > 0 && !is_kept(clearance_)));
    if (meet_ && is_hull) verdict_ = "meet as hulls";
    facts_ = {{"said_of", is_said_of_hulls ? "hulls" : "bodies", ""}, evidence()};
    if (call.classify && meet_ && contact_ == Relation::none) {
      facts_.push_back({"contact_unknown", true, "whether they touch or overlap is undecided"});
    }
    const char* of_hulls = is_hull && !meet_ ? " (of the hulls)" : "";
    if (call.distance) facts_.push_back(distance(of_hulls));
    if (call.depth && meet_) {
      depth_ = *depth_of(round_depth(placed_a_, placed_b_));
      const Point3 way = way_out(depth_->direction);
      facts_.push_back({"depth", depth_report(depth_->depth, to_json(way)), depth_told(depth_->depth, about(way))});
    }
    if (least_ == 0) return;
    facts_.push_back(clearance(least_, is_kept(clearance_), enclosed_));
    Fact& fact = facts_.back();
    if (clearance_.undecided()) {
      fact.json["undecided"] = true;
      fact.text = fmt::format("{}: undecided; {} apart", least_, distance_text());
    }
    if (!is_kept(clearance_)) fact.text += of_hulls;
  }

  std::string certificate() const {
    if (answer_.undecided() || (least_ > 0 && clearance_.undecided())) {
      throw Error(ErrorCode::bad_value, "the pair is undecided, and there is no proof; leave out --certificate",
                  "--certificate");
    }
    return claims_text(origin(), [&](ClaimsWriter& file) {
      PairClaims pairs(file);
      file.say(a_.said);
      const std::uint32_t a = add_round(pairs, a_.name, placed_a_);
      file.say(b_.said);
      const std::uint32_t b = add_round(pairs, b_.name, placed_b_);
      add_claims(pairs, a, placed_a_, b, placed_b_, answer_.evidence, found_);
      if (call.distance && enclosed_.high > 0) solid::add_claims(pairs, a, b, distance_);
      if (depth_) add_depth(file, a, b, *depth_);
      if (least_ > 0) solid::add_claims(pairs, a, b, least_, clearance_);
    });
  }

 private:
  Fact evidence() const {
    const solid::RoundEvidence& evidence = answer_.evidence;
    if (answer_.meet()) {
      const Point3 p = rounded_point_of(placed_a_, placed_b_, evidence);
      return {"evidence", {{"point", to_json(p)}}, fmt::format("a common point at about {}", about(p))};
    }
    const Point3 unit = rounded_direction(placed_a_, placed_b_, evidence);
    if (answer_.undecided()) {
      return {"evidence",
              {{"direction_about", to_json(unit)}},
              fmt::format("they touch, or nearly, across the direction of about {}", about(unit))};
    }
    const double gap = rounded_gap(placed_a_, placed_b_, evidence).width;
    return {"evidence",
            {{"direction_about", to_json(unit)}, {"gap_about", gap}},
            fmt::format("an empty slab about {} wide across the direction of about {}", about(gap), about(unit))};
  }

  std::string distance_text() const {
    const auto [low, high] = enclosed_;
    if (high - low <= 0x1p-40 * high) return high == 0 ? "0" : about_length(enclosed_);
    return fmt::format("between {:.12g} and {:.12g}", low, high);
  }
  Fact distance(const char* of_hulls) const {
    const auto [low, high] = enclosed_;
    return {"distance", {{"low", low}, {"high", high}}, distance_text() + of_hulls};
  }

  const PlacedRoundBody &of_a_, &of_b_;
  PlacedRound placed_a_, placed_b_;
  double least_;  // the clearance that is asked about; 0: none
  solid::RoundAnswer answer_;
  solid::RoundContact found_;
  solid::RoundDistance distance_;
  Interval enclosed_{0, 0};               // the distance, where it is asked for
  std::optional<EnclosedDepth> depth_{};  // where it is asked for, and they meet
  solid::RoundClearance clearance_;
};

}  // namespace

PlacedRoundBody round_of(const SpaceInput& input) { return input.round ? *input.round : rounded(*input.bounded); }

PairObject PlacedRoundBody::object_of() const {
  if (core) {
    PairObject result = ask::object_of(*core);
    result.said = said;
    if (around) {
      result.text += fmt::format("\nand all within {} of it", *around);
      result.json["radius"] = *around;
    }
    return result;
  }
  PairObject result{.file = file, .name = name, .text = {}, .json = {}, .vertices = {}, .said = said};
  const std::string_view kind = io::name_of(object.kind);
  result.json = {{"file", file}, {"name", name}, {"format", object.format}, {"shape", kind}};
  const solid::RoundWords words = words_of(body);
  add_numbers(words, result.json);
  std::string points;
  for (const Point3& p : words.points) points += (points.empty() ? "" : " to ") + exact_text(p);
  result.text = fmt::format("{}: {}", name, kind) + fmt::format(fmt::runtime(words.form), fmt::arg("points", points),
                                                                fmt::arg("sizes", fmt::join(words.sizes, ", ")));
  return result;
}

Report run_round_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  if (a.flat || b.flat) {
    throw Error(ErrorCode::bad_call,
                "a body with a radius is asked about with what is bounded; give no line, ray or plane");
  }
  const PlacedRoundBody of_a = round_of(a), of_b = round_of(b);
  return ask::answer(RoundPair(call, of_a, of_b, files), files.talk);
}

}  // namespace sunder::ask

#include <sunder/ask/pair/pair_bounded.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::ask {

namespace {

std::string length_told(const Interval& length) {
  const auto [low, high] = length;
  if (high == 0) return "0";
  return high - low <= 0x1p-40 * high ? about_length(length) : fmt::format("between {:.12g} and {:.12g}", low, high);
}

Json json_of(const Measure& found) { return {{"low", found.length.low}, {"high", found.length.high}}; }

// The way that A is moved out of B, back along the direction; of length 1, about.
Point3 way_out(const WorldDirection& from_a_to_b) {
  const Vector3<Interval> d = from_a_to_b.enclosure();
  const Point3 middle{(d.x.low + d.x.high) / 2, (d.y.low + d.y.high) / 2, (d.z.low + d.z.high) / 2};
  const double greatest = std::max({std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z)});
  const Point3 e{middle.x / greatest, middle.y / greatest, middle.z / greatest};
  const double length = std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
  return {0.0 - e.x / length, 0.0 - e.y / length, 0.0 - e.z / length};
}

void add_features(const Measure& found, const char* form, Fact& fact) {
  if (!found.between) return;
  const auto& [a, b] = *found.between;
  fact.json["a"] = a.json;
  fact.json["b"] = b.json;
  fact.text += fmt::format(fmt::runtime(form), a.text, b.text);
}

}  // namespace

double least_clearance(const PairCall& call) {
  if (call.clearance.empty()) return 0;
  const std::vector<double> numbers = parse_numbers(call.clearance, "--clearance");
  if (numbers.size() != 1 || !(numbers[0] > 0)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} is not one number above zero", io::quote(call.clearance)),
                "--clearance");
  }
  return numbers[0];
}

BoundedPair::BoundedPair(const PairCall& asked, PairObject a, PairObject b, bool is_hull, const PairFiles& files,
                         Space space)
    : PairQuestion(asked, std::move(a), std::move(b), files, space),
      is_hull_(is_hull),
      least_(least_clearance(asked)) {}

void BoundedPair::ask() {
  decide();
  if (meet_ && is_hull_) verdict_ = "meet as hulls";
  // That they are apart, and so far, carries over from hulls to the meshes that they stand for; that they meet, or are
  // no further apart, does not.
  bool is_of_hulls = is_yes_ || call.distance;
  Measure apart;
  if (call.distance || least_ > 0) apart = distance();
  if (call.distance) facts_.push_back(told_distance(apart, is_hull_ && !meet_));
  if (call.depth && meet_) facts_.push_back(told_depth(depth()));
  if (least_ > 0) {
    const Verdict found = clearance_of(least_);
    is_yes_ = found != Verdict::apart;
    is_undecided_ = is_undecided_ || found == Verdict::undecided;
    is_of_hulls = is_of_hulls || is_yes_;
    facts_.push_back(told_clearance(found, least_, apart.length, is_hull_ && !meet_));
  }
  if (space_ == Space::planar) return;
  facts_.insert(facts_.begin(), {"said_of", is_hull_ && is_of_hulls ? "hulls" : "bodies", ""});
}

Fact told_distance(const Measure& found, bool is_of_hulls) {
  Fact fact{"distance", json_of(found), length_told(found.length)};
  add_features(found, ", from {} to {}", fact);
  if (is_of_hulls) fact.text += " (of the hulls)";
  return fact;
}

Fact BoundedPair::told_depth(const Measure& found) {
  const auto [x, y, z] = way_out(found.direction);
  const bool is_planar = space_ == Space::planar;
  Fact fact{"depth", json_of(found),
            fmt::format("{}, A to be moved along about {}", length_told(found.length),
                        is_planar ? about(Point2{x, y}) : about(Point3{x, y, z}))};
  fact.json["direction_about"] = is_planar ? Json::array({x, y}) : to_json(Point3{x, y, z});
  if (!found.square.empty()) {
    fact.json["square"] = found.square;
    not_proved_.emplace_back("the square of the depth");
  }
  if (found.between) not_proved_.emplace_back("which features touch after that");
  add_features(found, ", {} against {}", fact);
  return fact;
}

Fact told_clearance(Verdict found, double least, const Interval& distance, bool is_of_hulls) {
  const bool is_kept = found == Verdict::apart, is_undecided = found == Verdict::undecided;
  const char* const word = is_undecided ? "undecided" : is_kept ? "kept" : "not kept";
  const std::string apart = is_undecided ? length_told(distance) : about_length(distance);
  Fact fact{"clearance",
            {{"least", least}, {"kept", is_kept}},
            fmt::format("{}: {}; {}", least, word, is_undecided || distance.high > 0 ? apart + " apart" : "they meet")};
  if (is_undecided) fact.json["undecided"] = true;
  if (!is_kept && is_of_hulls) fact.text += " (of the hulls)";
  return fact;
}

}  // namespace sunder::ask

#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_planar.h>
#include <sunder/ask/pair/pair_planar_input.h>
#include <sunder/ask/pair/pair_unbounded.h>
#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>
#include <sunder/picture/pair.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>
#include <sunder/scene/rounded_evidence.h>

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using planar::ConvexPolygon;
using planar::Pose;

using Method = PairAnswer(const ConvexPolygon&, const Pose&, const ConvexPolygon&, const Pose&);
constexpr std::array<Named<Method>, 6> methods{{{"automatic", planar::polygon_polygon},
                                                {"difference", planar::polygon_polygon_by_difference},
                                                {"halving", planar::polygon_polygon_by_halving},
                                                {"triangles", planar::polygon_polygon_by_triangles},
                                                {"gjk", planar::polygon_polygon_by_gjk},
                                                {"scan", planar::polygon_polygon_by_scan}}};

std::string about_2d(const Point3& p) { return about(Point2{p.x, p.y}); }

std::string evidence_text(const PairCertificate& c, const PlanarBody& a, const PlanarBody& b) {
  if (c.verdict == Verdict::meet) {
    return fmt::format("a common point at about {}, made of {} of A and {} of B",
                       about_2d(scene::rounded_common_point(c, a.in_space(), b.in_space())),
                       c.count_a == 1 ? "1 vertex" : fmt::format("{} vertices", c.count_a), c.count_b);
  }
  const scene::RoundedGap gap = scene::rounded_gap(c, a.in_space(), b.in_space());
  return fmt::format(
      "an empty strip about {} wide across the direction of about {},\nfrom vertex {} of A to vertex {} of B",
      about(gap.width), about_2d(gap.direction), c.extreme_a, c.extreme_b);
}

double least_of(const std::string& text) {
  if (text.empty()) return 0;
  const std::vector<double> numbers = parse_numbers(text, "--clearance");
  if (numbers.size() != 1 || !(numbers[0] > 0)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} is not one number above zero", io::quote(text)), "--clearance");
  }
  return numbers[0];
}

Json evidence_json(const PairCertificate& c, const PlanarBody& a, const PlanarBody& b) {
  Json json = ask::evidence_json(c, a.in_space(), b.in_space());
  for (const char* key : {"point", "direction_about"}) {
    if (json.contains(key)) json[key].erase(2);  // z
  }
  return json;
}

class BoundedPair : public PairQuestion {
 public:
  BoundedPair(const PairCall& asked, const PlanarInput& a, const PlanarInput& b, const LeftOutList& left_out,
              Origin origin)
      : PairQuestion(asked, left_out, std::move(origin)),
        method_(method_by(asked.method, methods, " (for planar objects)")),
        a_(planar_body(a, asked)),
        b_(planar_body(b, asked)),
        least_(least_of(asked.clearance)) {}

  std::uint64_t drawn() const { return std::uint64_t{a_.given} + b_.given; }

  void ask() {
    answer_ = method_(a_.polygon, a_.pose, b_.polygon, b_.pose);
    meet_ = answer_.meet();
    decided_by_ = answer_.decided_by;
    cost_ = answer_.cost;
    if (call.classify) contact_ = planar::polygon_polygon_contact(a_.polygon, a_.pose, b_.polygon, b_.pose);
    if (!call.distance && least_ == 0) return;
    distance_ = planar::polygon_polygon_distance(a_.polygon, a_.pose, b_.polygon, b_.pose);
    clear_ = least_ > 0 && compare_distance(distance_, least_) != Sign::negative;
  }
  bool yes() const { return least_ > 0 ? !clear_ : meet_; }

  std::string certificate() const {
    return certificate_of(PairClaims::Space::planar, [this](PairClaims& pairs) {
      const auto add = [&](const PlanarBody& body) {
        return pairs.add_placed(body.name, pairs.add_body(body.name, body.vertices), body.pose_in_space);
      };
      const std::uint32_t index_a = add(a_), index_b = add(b_);
      add_contact(pairs, index_a, index_b);
      add_distance(pairs, index_a, index_b);
    });
  }
  std::string picture() const {
    return picture::pair_svg({a_.polygon, a_.pose, a_.name}, {b_.polygon, b_.pose, b_.name}, distance_.closest,
                             call.title);
  }

  std::string text() const {
    return head(a_.file, b_.file, answer()) + titled("A", text_of(a_, call)) + titled("B", text_of(b_, call)) +
           titled("evidence", evidence_text(answer_.certificate(), a_, b_)) +
           (call.distance ? titled("distance", distance_text()) : "") +
           (least_ > 0 ? titled("clearance", clearance_text()) : "") + titled("decided by", decided_text(decided_by_));
  }
  void add_to(Json& json) const {
    add_head(json, to_json(a_), to_json(b_));
    if (call.distance) {
      const Interval distance = distance_.distance();
      json["distance"] = {{"low", distance.low}, {"high", distance.high}};
      if (const auto& d = distance_.closest) {
        json["distance"]["a"] = feature_json(a_, d->a, d->edge_of_a);
        json["distance"]["b"] = feature_json(b_, d->b, d->edge_of_b);
      }
    }
    if (least_ > 0) json["clearance"] = {{"least", least_}, {"kept", clear_}};
    json["evidence"] = evidence_json(answer_.certificate(), a_, b_);
  }

 private:
  std::string distance_text() const {
    const auto& d = distance_.closest;
    return !d ? "0"
              : fmt::format("about {:.12g}, from {} to {}", d->distance.high, feature_text(a_, "A", d->a, d->edge_of_a),
                            feature_text(b_, "B", d->b, d->edge_of_b));
  }
  std::string clearance_text() const {
    const auto& closest = distance_.closest;
    return fmt::format("{}: {}; {}", least_, clear_ ? "kept" : "not kept",
                       closest ? fmt::format("about {:.12g} apart", closest->distance.high) : "they meet");
  }

  void add_contact(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b) const {
    const PairCertificate& evidence = answer_.certificate();
    if (!call.classify || !meet_) {
      pairs.add_pair(index_a, index_b, evidence);
    } else if (contact_ == Contact::touching) {
      pairs.add_touching(index_a, index_b, pairs.common_point(index_a, index_b, evidence),
                         planar::touching_direction(a_.polygon, a_.pose, b_.polygon, b_.pose, evidence));
    } else {
      pairs.add_overlapping(index_a, index_b, planar::overlapping_point(a_.polygon, a_.pose, b_.polygon, b_.pose));
    }
  }
  void add_distance(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b) const {
    if (const auto& closest = distance_.closest) {
      const auto [of_a, of_b] = planar::closest_points(a_.polygon, a_.pose, b_.polygon, b_.pose, *closest);
      if (call.distance) pairs.add_distance(index_a, index_b, of_a, of_b);
      if (clear_) pairs.add_clearance(index_a, index_b, least_, way_between(of_a, of_b));
      if (least_ > 0 && !clear_) pairs.add_clearance_broken(index_a, index_b, least_, of_a, of_b);
    } else if (least_ > 0) {
      const CommonPoint point = pairs.common_point(index_a, index_b, answer_.certificate());
      pairs.add_clearance_broken(index_a, index_b, least_, {point.coordinates, point.denominator, point.of_a},
                                 {point.coordinates, point.denominator, point.of_b});
    }
  }

  Method* method_;
  PlanarBody a_, b_;
  double least_;  // the clearance that is asked about; 0: none
  PairAnswer answer_;
  planar::PolygonDistance distance_;
  bool clear_ = false;
};

}  // namespace

int run_planar_pair(const PairCall& call) {
  for (const std::string& file : {call.file_a, call.file_b}) {
    if (io::is_planar(file) || file == "-") continue;
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is not planar (WKT, GeoJSON, CSV), the other one is; give two of one kind",
                            io::quote(io::one_line(file))));
  }
  if (call.hull && call.mend) throw Error(ErrorCode::bad_call, "give --mend or --hull, not both", "--mend");
  LeftOutList left_out(call.leave_out);
  Origin origin;
  InputFiles* const inputs = call.proves() ? &origin.inputs : nullptr;
  const PlanarInput a = read_planar_input(call, true, left_out, inputs),
                    b = read_planar_input(call, false, left_out, inputs);
  if (a.object.unbounded() || b.object.unbounded()) return run_unbounded_pair(call, a, b, left_out, std::move(origin));
  BoundedPair question(call, a, b, left_out, std::move(origin));
  return answer(question);
}

}  // namespace sunder::ask

#include <cli/common.h>
#include <cli/evidence.h>
#include <cli/pair_planar.h>
#include <cli/pair_planar_input.h>
#include <cli/pair_unbounded.h>

#include <sunder/base/error.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/io/file.h>
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

namespace sunder::cli {

namespace {

using planar::ConvexPolygon;
using planar::Pose;

using Method = PairAnswer (*)(const ConvexPolygon&, const Pose&, const ConvexPolygon&, const Pose&);

Method method_of(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Method>, 6> methods{
      {{"automatic", planar::polygon_polygon},
       {"difference", planar::polygon_polygon_by_difference},
       {"halving", planar::polygon_polygon_by_halving},
       {"triangles", planar::polygon_polygon_by_triangles},
       {"gjk", planar::polygon_polygon_by_gjk},
       {"scan", planar::polygon_polygon_by_scan}}};
  std::string known;
  for (const auto& [known_name, method] : methods) {
    if (name == known_name) return method;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", known_name);
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no method {} for planar objects; choose one of {}", io::quote(name), known),
              "--method");
}

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

struct Answers {
  PairAnswer pair;
  Contact contact = Contact::none;
  planar::PolygonDistance distance;
  double least = 0;  // the clearance that is asked about; 0: none
  bool clear = false;

  bool yes() const { return least > 0 ? !clear : pair.meet(); }
};

double least_of(const std::string& text) {
  if (text.empty()) return 0;
  const std::vector<double> numbers = parse_numbers(text, "--clearance");
  if (numbers.size() != 1 || !(numbers[0] > 0)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} is not one number above zero", io::quote(text)), "--clearance");
  }
  return numbers[0];
}

std::string clearance_text(const Answers& answers) {
  const auto& closest = answers.distance.closest;
  return fmt::format("{}: {}; {}", answers.least, answers.clear ? "kept" : "not kept",
                     closest ? fmt::format("about {:.12g} apart", closest->distance.high) : "they meet");
}

std::string human_text(const PlanarPairCall& call, const PlanarBody& a, const PlanarBody& b, const Answers& answers,
                       const LeftOutList& left_out) {
  const bool meet = answers.pair.meet();
  std::string text = fmt::format("{} and {}: {}{}{}\n", a.file, b.file, meet ? "meet" : "apart",
                                 meet && call.classify ? fmt::format(" ({})", name_of(answers.contact)) : std::string(),
                                 left_out.clause());
  const auto line = [&](const char* title, std::string value) {
    if (const std::size_t end = value.find('\n'); end != std::string::npos) value.insert(end + 1, 14, ' ');
    text += fmt::format("  {:<10}  {}\n", title, value);
  };
  line("A", text_of(a, call));
  line("B", text_of(b, call));
  line("evidence", evidence_text(answers.pair.certificate(), a, b));
  if (call.distance) {
    const auto& d = answers.distance.closest;
    line("distance",
         !d ? "0"
            : fmt::format("about {}, from {} to {}", fmt::format("{:.12g}", d->distance.high),
                          feature_text(a, "A", d->a, d->edge_of_a), feature_text(b, "B", d->b, d->edge_of_b)));
  }
  if (answers.least > 0) line("clearance", clearance_text(answers));
  line("decided by", decided_text(answers.pair.decided_by));
  const Cost& cost = answers.pair.cost;
  line("cost", fmt::format("{}, {}, {} of exact arithmetic", count_of(cost.probes, "probe"),
                           count_of(cost.iterations, "iteration"), count_of(cost.exact, "use")));
  if (!call.certificate.empty()) line("proof", call.certificate);
  return text;
}

Json evidence_json(const PairCertificate& c, const PlanarBody& a, const PlanarBody& b) {
  Json json = cli::evidence_json(c, a.in_space(), b.in_space());
  for (const char* key : {"point", "direction_about"}) {
    if (json.contains(key)) json[key].erase(2);  // z
  }
  return json;
}

Json report(const PlanarPairCall& call, const PlanarBody& a, const PlanarBody& b, const Answers& answers,
            const LeftOutList& left_out) {
  Json json = envelope("pair", answers.pair.meet() ? "meet" : "apart", call.method);
  json["decided_by"] = name_of(answers.pair.decided_by);
  json["cost"] = to_json(answers.pair.cost);
  json["objects"] = {to_json(a), to_json(b)};
  if (!left_out.empty()) json["left_out"] = left_out.json();
  if (call.classify) json["contact"] = name_of(answers.contact);
  if (call.distance) {
    const Interval distance = answers.distance.distance();
    json["distance"] = {{"low", distance.low}, {"high", distance.high}};
    if (const auto& d = answers.distance.closest) {
      json["distance"]["a"] = feature_json(a, d->a, d->edge_of_a);
      json["distance"]["b"] = feature_json(b, d->b, d->edge_of_b);
    }
  }
  if (answers.least > 0) json["clearance"] = {{"least", answers.least}, {"kept", answers.clear}};
  json["evidence"] = evidence_json(answers.pair.certificate(), a, b);
  return json;
}

// Of touching and overlapping, of the distance and of the clearance, where the caller asks for it.
std::string certificate_text(const PlanarPairCall& call, const PlanarBody& a, const PlanarBody& b,
                             const Answers& answers, const Origin& origin) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  PairClaims pairs(file, PairClaims::Space::planar);
  const auto add = [&](const PlanarBody& body) {
    return pairs.add_placed(body.name, pairs.add_body(body.name, body.vertices), body.pose_in_space);
  };
  const std::uint32_t index_a = add(a), index_b = add(b);
  const PairCertificate& evidence = answers.pair.certificate();
  if (!call.classify || !answers.pair.meet()) {
    pairs.add_pair(index_a, index_b, evidence);
  } else if (answers.contact == Contact::touching) {
    pairs.add_touching(index_a, index_b, pairs.common_point(index_a, index_b, evidence),
                       planar::touching_direction(a.polygon, a.pose, b.polygon, b.pose, evidence));
  } else {
    pairs.add_overlapping(index_a, index_b, planar::overlapping_point(a.polygon, a.pose, b.polygon, b.pose));
  }
  if (const auto& closest = answers.distance.closest) {
    const auto [of_a, of_b] = planar::closest_points(a.polygon, a.pose, b.polygon, b.pose, *closest);
    if (call.distance) pairs.add_distance(index_a, index_b, of_a, of_b);
    if (answers.clear) pairs.add_clearance(index_a, index_b, answers.least, way_between(of_a, of_b));
    if (answers.least > 0 && !answers.clear) pairs.add_clearance_broken(index_a, index_b, answers.least, of_a, of_b);
  } else if (answers.least > 0) {
    const CommonPoint point = pairs.common_point(index_a, index_b, evidence);
    pairs.add_clearance_broken(index_a, index_b, answers.least, {point.coordinates, point.denominator, point.of_a},
                               {point.coordinates, point.denominator, point.of_b});
  }
  pairs.end();
  return text;
}

}  // namespace

int run_planar_pair(const PlanarPairCall& call) {
  for (const std::string& file : {call.file_a, call.file_b}) {
    if (io::is_planar(file) || file == "-") continue;
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is not planar (WKT, GeoJSON, CSV), the other one is; give two of one kind",
                            io::quote(io::one_line(file))));
  }
  if (call.hull && call.mend) throw Error(ErrorCode::bad_call, "give --mend or --hull, not both", "--mend");
  LeftOutList left_out(call.leave_out);
  Origin origin;
  InputFiles* const inputs = call.certificate.empty() ? nullptr : &origin.inputs;
  const PlanarInput input_a = read_planar_input(call, true, left_out, inputs),
                    input_b = read_planar_input(call, false, left_out, inputs);
  origin.left_out = left_out.texts();
  if (!call.svg.empty()) {
    require_drawable(input_a.object.vertices.size() + input_b.object.vertices.size(), "point", 0, call.svg_limit);
  }
  if (input_a.object.unbounded() || input_b.object.unbounded()) {
    return run_unbounded_pair(call, input_a, input_b, left_out, origin);
  }
  const Method method = method_of(call.method);
  const PlanarBody a = planar_body(input_a, call), b = planar_body(input_b, call);
  Answers answers;
  answers.pair = method(a.polygon, a.pose, b.polygon, b.pose);
  if (call.classify) answers.contact = planar::polygon_polygon_contact(a.polygon, a.pose, b.polygon, b.pose);
  answers.least = least_of(call.clearance);
  if (call.distance || answers.least > 0) {
    answers.distance = planar::polygon_polygon_distance(a.polygon, a.pose, b.polygon, b.pose);
    answers.clear = answers.least > 0 && compare_distance(answers.distance, answers.least) != Sign::negative;
  }
  if (!call.certificate.empty()) {
    io::write_file_atomically(call.certificate, certificate_text(call, a, b, answers, origin));
  }
  if (!call.svg.empty()) {
    io::write_file_atomically(call.svg, picture::pair_svg({a.polygon, a.pose, a.name}, {b.polygon, b.pose, b.name},
                                                          answers.distance.closest, call.title));
  }
  call.json ? print(to_text(report(call, a, b, answers, left_out)))
            : print_for_people(human_text(call, a, b, answers, left_out));
  return answers.yes() ? exit_code::yes : exit_code::no;
}

}  // namespace sunder::cli

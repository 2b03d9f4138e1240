#include <sunder/ask/pair/pair_planar.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/pair.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_depth.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::ask {

namespace {

using planar::ConvexPolygon;

using PolygonMethod = PairAnswer(const ConvexPolygon&, const planar::Pose&, const ConvexPolygon&, const planar::Pose&);
constexpr std::array<Named<PolygonMethod>, 6> polygon_methods{{{"automatic", planar::polygon_polygon},
                                                               {"difference", planar::polygon_polygon_by_difference},
                                                               {"halving", planar::polygon_polygon_by_halving},
                                                               {"triangles", planar::polygon_polygon_by_triangles},
                                                               {"gjk", planar::polygon_polygon_by_gjk},
                                                               {"scan", planar::polygon_polygon_by_scan}}};

class BoundedPair : public PairQuestion {
 public:
  BoundedPair(const PairCall& asked, PolygonMethod* method, const PlanarBody& a, const PlanarBody& b, double least,
              const PairFiles& files)
      : PairQuestion(asked, a.object, b.object, files), method_(method), of_a_(a), of_b_(b), least_(least) {
    for (const PlanarBody* body : {&a, &b}) {
      if (!body->remark.empty()) files.talk.note(body->remark);
    }
  }

  std::uint64_t drawn() const { return std::uint64_t{of_a_.given} + of_b_.given; }

  void ask() {
    const ConvexPolygon &a = of_a_.polygon, &b = of_b_.polygon;
    const planar::Pose &pose_a = of_a_.pose, &pose_b = of_b_.pose;
    answer_ = method_(a, pose_a, b, pose_b);
    take(answer_, decided_text(answer_.decided_by));
    if (call.classify) contact_ = planar::polygon_polygon_contact(a, pose_a, b, pose_b);
    if (asks_distance()) distance_ = planar::polygon_polygon_distance(a, pose_a, b, pose_b);
    facts_.push_back(evidence(answer_.evidence, 2));
    if (call.distance) facts_.push_back({"distance", distance_json(), distance_text()});
    if (call.depth && meet_) {
      const planar::PolygonDepthAnswer deep = planar::polygon_polygon_depth(a, pose_a, b, pose_b);
      depth_ = std::get<planar::PolygonDepth>(deep.evidence);
      facts_.push_back(depth());
      not_proved_.emplace_back("the square of the depth");
      if (is_edge_known()) not_proved_.emplace_back("which features touch after that");
    }
    if (least_ == 0) return;
    is_kept_ = compare_distance(distance_, least_) != Sign::negative;
    is_yes_ = !is_kept_;
    facts_.push_back(clearance(least_, is_kept_, distance_of(distance_)));
  }

  std::string certificate() const {
    return certificate_of(PairClaims::Space::planar, a_, b_,
                          [this](PairClaims& pairs, std::uint32_t a, std::uint32_t b) {
                            const planar::ClaimedPair pair{a, b, of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose};
                            add_claims(pairs, pair, answer_.evidence, contact_);
                            if (call.distance) add_distance(pairs, pair, distance_);
                            if (depth_)
                              add_depth(pairs.file(), a, b, pair.a, pair.pose_a, pair.b, pair.pose_b, *depth_);
                            if (least_ > 0) add_clearance(pairs, pair, distance_, least_);
                          });
  }
  std::string picture() const {
    return picture::pair_svg({{of_a_.polygon, of_a_.pose, a_.name, a_.text},
                              {of_b_.polygon, of_b_.pose, b_.name, b_.text},
                              answer_,
                              call.method,
                              asks_distance() ? closest_of(distance_) : nullptr,
                              files_.left_out.clause(),
                              call.title});
  }

 private:
  bool asks_distance() const { return call.distance || least_ > 0; }

  std::string distance_text() const {
    const planar::ClosestFeatures* d = closest_of(distance_);
    return d == nullptr
               ? "0"
               : fmt::format("{}, from {} to {}", about_length(d->distance),
                             of_a_.feature_text("A", d->a, d->edge_of_a), of_b_.feature_text("B", d->b, d->edge_of_b));
  }
  Json distance_json() const {
    const Interval distance = distance_of(distance_);
    Json json{{"low", distance.low}, {"high", distance.high}};
    if (const planar::ClosestFeatures* d = closest_of(distance_)) {
      json["a"] = of_a_.feature_json(d->a, d->edge_of_a);
      json["b"] = of_b_.feature_json(d->b, d->edge_of_b);
    }
    return json;
  }

  bool is_edge_known() const { return depth_->edge_of_a || depth_->edge_of_b; }  // not of two points
  Fact depth() const {
    const auto& [edge_of_a, edge_of_b, a, b, direction, squared, bounds] = *depth_;
    const Point3 out = way_out(WorldDirection({direction[0], direction[1], 0.0}));
    const Point2 way{out.x, out.y};
    Fact fact{"depth", depth_report(bounds, Json::array({way.x, way.y})), depth_told(bounds, about(way))};
    fact.json["square"] = fraction_text(squared[0], squared[1]);
    if (!is_edge_known()) return fact;
    fact.json["a"] = of_a_.feature_json(a, edge_of_a);
    fact.json["b"] = of_b_.feature_json(b, edge_of_b);
    fact.text +=
        fmt::format(", {} against {}", of_a_.feature_text("A", a, edge_of_a), of_b_.feature_text("B", b, edge_of_b));
    return fact;
  }

  PolygonMethod* method_;
  const PlanarBody &of_a_, &of_b_;
  double least_;  // the clearance that is asked about; 0: none
  PairAnswer answer_;
  planar::PolygonDistance distance_;  // where it is asked for
  std::optional<planar::PolygonDepth> depth_;
  bool is_kept_ = false;
};

}  // namespace

Report run_planar_pair(const PairCall& call, Talk& talk) {
  for (const std::string& file : {call.a.file, call.b.file}) {
    if (io::is_planar(file) || file == "-") continue;
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is not planar (WKT, GeoJSON, CSV), the other one is; give two of one kind",
                            io::quote(io::one_line(file))));
  }
  if (call.hull && call.mend) throw Error(ErrorCode::bad_call, "give --mend or --hull, not both", "--mend");
  PairFiles files(call, talk);
  const PlanarInput read_a = read_planar_input(call, call.a, files), read_b = read_planar_input(call, call.b, files);
  for (const PlanarInput* input : {&read_a, &read_b}) {
    const io::PlanarObject& object = input->object;
    files.systems.add(input->path,
                      std::array{io::SystemOfFile{object.system, fmt::format("feature {}", io::quote(object.name))}});
  }
  if (read_a.object.unbounded() || read_b.object.unbounded()) return run_unbounded_pair(call, read_a, read_b, files);
  PolygonMethod* const method = method_by(call.method, polygon_methods, " (for planar objects)");
  const PlanarBody a = planar_body(read_a, call), b = planar_body(read_b, call);
  return answer(BoundedPair(call, method, a, b, least_clearance(call), files), files.talk);
}

std::string planar_method_names() { return method_names(polygon_methods); }

}  // namespace sunder::ask

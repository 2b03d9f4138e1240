#include <sunder/ask/pair/pair_bounded.h>
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

namespace sunder::ask {

namespace {

using planar::ConvexPolygon;

using PolygonMethod = PairAnswer(const ConvexPolygon&, const planar::Pose&, const ConvexPolygon&, const planar::Pose&);
constexpr std::array<Named<PolygonMethod>, 6> polygon_methods{
    {SUNDER_METHOD("automatic", planar::polygon_polygon),
     SUNDER_METHOD("difference", planar::polygon_polygon_by_difference),
     SUNDER_METHOD("halving", planar::polygon_polygon_by_halving),
     SUNDER_METHOD("triangles", planar::polygon_polygon_by_triangles),
     SUNDER_METHOD("gjk", planar::polygon_polygon_by_gjk), SUNDER_METHOD("scan", planar::polygon_polygon_by_scan)}};

class PolygonPair final : public BoundedPair {
 public:
  PolygonPair(const PairCall& asked, const Named<PolygonMethod>& method, const PlanarBody& a, const PlanarBody& b,
              const PairFiles& files)
      : BoundedPair(asked, a.object, b.object, false, files, Space::planar), method_(method), of_a_(a), of_b_(b) {
    for (const PlanarBody* body : {&a, &b}) {
      if (!body->remark.empty()) files.talk.note(body->remark);
    }
  }

  std::uint64_t drawn() const { return std::uint64_t{of_a_.given} + of_b_.given; }

  std::string picture() const {
    return picture::pair_svg({{of_a_.polygon, of_a_.pose, a_.name, a_.text},
                              {of_b_.polygon, of_b_.pose, b_.name, b_.text},
                              answer_,
                              call.method,
                              closest_of(distance_),
                              files_.left_out.clause(),
                              call.title});
  }

 private:
  void decide() override {
    function_ = method_.function;
    answer_ = method_(of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose);
    take(answer_, decided_text(answer_.decided_by));
    if (call.classify) contact_ = polygon_polygon_contact(of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose);
    facts_.push_back(evidence(answer_.evidence));
    state([this](auto& pairs, auto a, auto b) { add_claims(pairs, claimed(a, b), answer_.evidence, contact_); });
  }

  Measure distance() override {
    distance_ = polygon_polygon_distance(of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose);
    if (call.distance) {
      state([this](auto& pairs, auto a, auto b) { add_distance(pairs, claimed(a, b), distance_); });
    }
    const planar::ClosestFeatures* d = closest_of(distance_);
    if (d == nullptr) return {Interval{0, 0}};
    return {d->distance, std::array{of_a_.feature("A", d->a, d->edge_of_a), of_b_.feature("B", d->b, d->edge_of_b)}};
  }

  Measure depth() override {
    const planar::PolygonDepthAnswer deep = polygon_polygon_depth(of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose);
    const planar::PolygonDepth& depth = std::get<planar::PolygonDepth>(deep.evidence);
    state([this, depth](auto& pairs, auto a, auto b) {
      add_depth(pairs.file(), a, b, of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose, depth);
    });
    Measure found{depth.depth, std::nullopt, depth.squared.text(),
                  WorldDirection({depth.direction[0], depth.direction[1], 0.0})};
    if (depth.edge_of_a || depth.edge_of_b) {  // not of two points
      found.between = {of_a_.feature("A", depth.a, depth.edge_of_a), of_b_.feature("B", depth.b, depth.edge_of_b)};
    }
    return found;
  }

  Verdict clearance_of(double least) override {
    state([this, least](auto& pairs, auto a, auto b) { add_clearance(pairs, claimed(a, b), distance_, least); });
    return compare_distance(distance_, least) == Sign::negative ? Verdict::meet : Verdict::apart;
  }

  planar::ClaimedPair claimed(std::uint32_t a, std::uint32_t b) const {
    return {a, b, of_a_.polygon, of_a_.pose, of_b_.polygon, of_b_.pose};
  }

  Named<PolygonMethod> method_;
  const PlanarBody &of_a_, &of_b_;
  PairAnswer answer_;
  planar::PolygonDistance distance_;  // where it is asked for
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
  const Named<PolygonMethod> method = method_by(call.method, polygon_methods, " (for planar objects)");
  const PlanarBody a = planar_body(read_a, call), b = planar_body(read_b, call);
  PolygonPair question(call, method, a, b, files);
  files.talk.note_all(files.systems.remarks());
  return answer(std::move(question), files.talk);
}

std::string planar_method_names() { return method_names(polygon_methods); }

}  // namespace sunder::ask

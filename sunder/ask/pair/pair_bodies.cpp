// sunder pair where A and B are bounded, and in space: with a radius, or polyhedra.
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_bounded.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/number/dyadic.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>
#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_depth.h>
#include <sunder/solid/round/round_distance.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using solid::ConvexPolyhedron;
using solid::PlacedRound;
using solid::RoundBody;

// A body that is bounded, as one with a radius.
PlacedRoundBody rounded(const PlacedBody& body) {
  return {body.mesh.file, body.mesh.name, {}, body, RoundBody::rounded(body.mesh.hull, 0), body.pose, body.said};
}

class BodyPair final : public BoundedPair {
 public:
  // The method is for polyhedra; it is null where one of the two is none.
  BodyPair(const PairCall& asked, PairMethod method, const PlacedRoundBody& a, const PlacedRoundBody& b,
           const PairFiles& files)
      : BoundedPair(asked, a.object_of(), b.object_of(), a.is_hull() || b.is_hull(), files, Space::solid),
        method_(method),
        of_a_(a),
        of_b_(b),
        placed_a_(a.body, a.pose),
        placed_b_(b.body, b.pose) {
    for (const auto& [object, placed] : {std::pair(&a_, &placed_a_), std::pair(&b_, &placed_b_)}) {
      object->vertices = placed->body.points();
      object->pose = placed->pose.affine();
      object->round = &placed->body;
    }
  }

 private:
  bool is_of_polyhedra() const { return method_.method != nullptr; }
  const ConvexPolyhedron& core_a() const { return of_a_.body.core(); }
  const ConvexPolyhedron& core_b() const { return of_b_.body.core(); }

  void decide() override {
    function_ = method_.function;
    answer_ = is_of_polyhedra() ? solid::round_answer(method_(core_a(), of_a_.pose, core_b(), of_b_.pose))
                                : round_round(placed_a_, placed_b_);
    take(answer_, answer_.undecided() ? "nothing: the gap or the depth is below some 2^-76 of their size"
                                      : decided_text(answer_.decided_by));
    if (call.classify && meet_) contact_ = round_round_relation(placed_a_, placed_b_, answer_.evidence);
    facts_.push_back(evidence());
    if (call.classify && meet_ && contact_ == Relation::none) {
      facts_.push_back({"contact_unknown", true, "whether they touch or overlap is undecided"});
    }
    state([this](auto& pairs, auto a, auto b) {
      solid::RoundContact contact;
      if (call.classify) contact = round_round_contact(placed_a_, placed_b_, answer_.evidence);
      add_claims(pairs, a, placed_a_, b, placed_b_, answer_.evidence, contact);
    });
    if (is_of_polyhedra() && of_a_.core && of_b_.core) cut(*of_a_.core, *of_b_.core);
  }

  Fact evidence() const {
    const solid::RoundEvidence& evidence = answer_.evidence;
    if (const auto* apart = std::get_if<Separation>(&evidence)) return PairQuestion::evidence(*apart);
    if (const auto* common = std::get_if<CommonVertices>(&evidence)) return PairQuestion::evidence(*common);
    Fact fact{"evidence", evidence_json(evidence, placed_a_, placed_b_), ""};
    if (answer_.meet()) {
      fact.text = fmt::format("a common point at about {}", about(rounded_point_of(placed_a_, placed_b_, evidence)));
    } else {
      const std::string along = about(rounded_direction(placed_a_, placed_b_, evidence));
      fact.text = answer_.undecided() ? fmt::format("they touch, or nearly, across the direction of about {}", along)
                                      : fmt::format("an empty slab about {} wide across the direction of about {}",
                                                    about(rounded_gap(placed_a_, placed_b_, evidence).width), along);
    }
    return fact;
  }

  // What a segment has in common with the other one.
  void cut(const PlacedBody& a, const PlacedBody& b) {
    const bool is_a = a.object && a.object->kind == io::SpaceObject::Kind::segment;  // is A the segment?
    const PlacedBody& body = is_a ? b : a;
    const std::optional<SegmentCut> found = segment_cut(body, is_a ? "B" : "A", is_a ? a : b);
    if (!found) return;
    facts_.push_back(fact_of("cut", found->told));
    if (!found->cut.meet()) return;
    state([is_a, &body, segment = found->segment, cut = found->cut](auto& pairs, auto of_a, auto of_b) {
      add_common_part(pairs, is_a ? of_b : of_a, is_a ? of_a : of_b, body.mesh.hull, body.pose, segment, cut);
    });
  }

  Measure distance() override {
    distance_ = round_distance(placed_a_, placed_b_);
    Measure found{distance_of(distance_)};
    const auto* closest = std::get_if<solid::ClosestFeatures>(&distance_.evidence);
    if (closest != nullptr) {
      const solid::FeatureVertices& f = closest->features();
      const std::span<const std::uint32_t> all(f.vertices);
      found.between = {surface_part(core_a(), all.first(f.count_a), "A"),
                       surface_part(core_b(), all.subspan(f.count_a, f.count_b), "B")};
    }
    if (call.distance && found.length.high > 0) {
      state([this, is_exact = closest != nullptr](auto& pairs, auto a, auto b) {
        if (is_exact) return solid::add_distance(pairs, a, b, distance_.evidence);
        solid::add_claims(pairs, a, b, distance_);
      });
    }
    return found;
  }

  Measure depth() override {
    Measure found;
    const auto take_depth = [&](const EnclosedDepth& depth) {
      found.length = depth.depth;
      found.direction = depth.direction;
      state([depth](auto& pairs, auto a, auto b) { add_depth(pairs.file(), a, b, depth); });
    };
    if (!is_of_polyhedra()) {
      take_depth(*depth_of(round_depth(placed_a_, placed_b_)));
      return found;
    }
    const solid::PolyhedronDepth deep = polyhedron_polyhedron_depth(core_a(), of_a_.pose, core_b(), of_b_.pose);
    const solid::PolyhedraOverlap& overlap = std::get<solid::PolyhedraOverlap>(deep.evidence);
    take_depth(overlap);
    if (!overlap.exact) return found;
    found.square = overlap.exact->squared.text();
    const auto& [of_a, of_b] = overlap.exact->features;  // none where the difference is flat
    if (!of_a.empty()) found.between = {surface_part(core_a(), of_a, "A"), surface_part(core_b(), of_b, "B")};
    return found;
  }

  Verdict clearance_of(double least) override {
    clearance_ = is_of_polyhedra() ? clearance_of_polyhedra(least) : round_clearance(placed_a_, placed_b_, least);
    state([this, least](auto& pairs, auto a, auto b) { solid::add_claims(pairs, a, b, least, clearance_); });
    return clearance_.verdict();
  }

  // As their nearest points tell.
  solid::RoundClearance clearance_of_polyhedra(double least) const {
    solid::RoundClearance found;
    std::array<PointOf, 2> points = nearest_of(placed_a_, placed_b_, distance_.evidence);
    const auto* closest = std::get_if<solid::ClosestFeatures>(&distance_.evidence);
    if (closest != nullptr && compare_distance(solid::PolyhedronDistance{*closest}, least) != Sign::negative) {
      const std::array<Dyadic, 3> way = way_between(points[0], points[1]);
      found.evidence = solid::ClearanceKept{WorldDirection(Vector3<Dyadic>{way[0], way[1], way[2]})};
    } else {
      found.evidence = solid::ClearanceBroken{std::make_shared<const std::array<PointOf, 2>>(std::move(points))};
    }
    return found;
  }

  PairMethod method_;
  const PlacedRoundBody &of_a_, &of_b_;
  PlacedRound placed_a_, placed_b_;
  solid::RoundAnswer answer_;
  solid::RoundDistance distance_;  // where it is asked for; so below
  solid::RoundClearance clearance_;
};

// Instead of polyhedron_polygon_by_drums where the polygon is A.
solid::PairAnswer polygon_polyhedron_by_drums(const ConvexPolyhedron& polygon, const solid::Pose& pose,
                                              const ConvexPolyhedron& body, const solid::Pose& pose_of_body) {
  return exchanged(solid::polyhedron_polygon_by_drums(body, pose_of_body, polygon, pose));
}

// Its method is null where one of them is no polyhedron.
PairMethod body_method(const std::string& name, const RoundBody& a, const RoundBody& b) {
  if (!a.is_polyhedron() || !b.is_polyhedron()) {
    if (name == "automatic") return {"automatic", nullptr, "solid::round_round"};
    throw Error(ErrorCode::bad_call, "bodies with a radius have one method; leave it out, or give automatic",
                "--method");
  }
  if (name != "drums") return pair_method(name, ", drums");
  const int of_a = a.core().dimension(), of_b = b.core().dimension();
  if (of_a == 3 && of_b == 3) return SUNDER_METHOD("drums", solid::polyhedron_polyhedron_by_drums);
  if (of_a == 3 && of_b == 2) return SUNDER_METHOD("drums", solid::polyhedron_polygon_by_drums);
  if (of_a == 2 && of_b == 3) return {"drums", polygon_polyhedron_by_drums, "solid::polyhedron_polygon_by_drums"};
  throw Error(ErrorCode::bad_call,
              "drums is for a body and a body, a plane, a line, a ray or a flat polygon; give these", "--method");
}

}  // namespace

Told surface_part(const ConvexPolyhedron& body, std::span<const std::uint32_t> vertices, const char* letter) {
  if (vertices.size() == 1) return {{{"vertex", vertices[0]}}, fmt::format("vertex {} of {}", vertices[0], letter)};
  const auto beside = body.neighbours(vertices[0]);
  const bool is_edge = vertices.size() == 2 && std::find(beside.begin(), beside.end(), vertices[1]) != beside.end();
  const char* kind = is_edge ? "edge" : "facet";
  return {{{kind, Json(std::vector<std::uint32_t>(vertices.begin(), vertices.end()))}},
          fmt::format("{} {} of {}", kind, fmt::join(vertices, "-"), letter)};
}

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

Report run_body_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  if (a.flat || b.flat) {
    throw Error(ErrorCode::bad_call,
                "a body with a radius is asked about with what is bounded; give no line, ray or plane");
  }
  const PlacedRoundBody of_a = round_of(a), of_b = round_of(b);
  return ask::answer(BodyPair(call, body_method(call.method, of_a.body, of_b.body), of_a, of_b, files), files.talk);
}

}  // namespace sunder::ask

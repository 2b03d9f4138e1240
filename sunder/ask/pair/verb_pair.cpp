// sunder pair A B: do two convex objects meet?
#include <sunder/ask/objects.h>
#include <sunder/ask/pair/pair_planar.h>
#include <sunder/ask/pair/pair_polytopes.h>
#include <sunder/ask/pair/pair_space.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

namespace {

// Few vertices of a body that span a part of its surface: a vertex, an edge, or a part of a facet.
struct SurfacePart {
  const solid::ConvexPolyhedron& body;
  std::span<const std::uint32_t> vertices;

  const char* kind() const {
    if (vertices.size() == 1) return "vertex";
    if (vertices.size() > 2) return "facet";
    const auto beside = body.neighbours(vertices[0]);
    return std::find(beside.begin(), beside.end(), vertices[1]) == beside.end() ? "facet" : "edge";
  }
  Json json() const {
    if (vertices.size() == 1) return {{"vertex", vertices[0]}};
    return {{kind(), Json(std::vector<std::uint32_t>(vertices.begin(), vertices.end()))}};
  }
  std::string text(const char* letter) const {
    return fmt::format("{} {} of {}", kind(), fmt::join(vertices, "-"), letter);
  }
};

class SolidPair : public PairQuestion {
 public:
  SolidPair(const PairCall& asked, PairMethod method, const PlacedBody& a, const PlacedBody& b, const PairFiles& files)
      : PairQuestion(asked, object_of(a), object_of(b), files),
        method_(method),
        of_a_(a),
        of_b_(b),
        least_(least_clearance(asked)) {}

  void ask() {
    const solid::ConvexPolyhedron &a = of_a_.mesh.hull, &b = of_b_.mesh.hull;
    answer_ = method_(a, of_a_.pose, b, of_b_.pose);
    take(answer_, decided_text(answer_.decided_by));
    if (call.classify && meet_) contact_ = solid::polyhedron_polyhedron_contact(a, of_a_.pose, b, of_b_.pose);
    if (call.distance || least_ > 0) {
      distance_ = solid::polyhedron_polyhedron_distance(a, of_a_.pose, b, of_b_.pose);
      if (least_ > 0) {
        is_kept_ = compare_distance(distance_, least_) != Sign::negative;
        is_yes_ = !is_kept_;
      }
    }
    // That they are apart, and so far, carries over from hulls to the meshes that they stand for; that they meet, or
    // are no further apart, does not.
    const bool is_hull = of_a_.is_hull() || of_b_.is_hull();
    const bool is_said_of_hulls = is_hull && (meet_ || call.distance || (least_ > 0 && !is_kept_));
    if (meet_ && is_hull) verdict_ = "meet as hulls";
    facts_ = {{"said_of", is_said_of_hulls ? "hulls" : "bodies", ""}, evidence(answer_.evidence, 3)};
    const char* of_hulls = is_hull && !meet_ ? " (of the hulls)" : "";
    const bool is_of_a = of_a_.object && of_a_.object->kind == io::SpaceObject::Kind::segment;
    cut_ = is_of_a ? segment_cut(of_b_, "B", of_a_) : segment_cut(of_a_, "A", of_b_);
    cuts_b_ = is_of_a;
    if (cut_) facts_.push_back({"cut", cut_->told.json, cut_->told.text});
    if (call.distance) facts_.push_back({"distance", distance_json(), distance_text() + of_hulls});
    if (call.depth && meet_) {
      const solid::PolyhedronDepth found = solid::polyhedron_polyhedron_depth(a, of_a_.pose, b, of_b_.pose);
      depth_ = std::get<solid::PolyhedraOverlap>(found.evidence);
      facts_.push_back({"depth", depth_json(), depth_text()});
      if (depth_->exact) not_proved_.emplace_back("the square of the depth");
      if (deepest()) not_proved_.emplace_back("which features touch after that");
    }
    if (least_ == 0) return;
    facts_.push_back(clearance(least_, is_kept_, distance_of(distance_)));
    if (!is_kept_) facts_.back().text += of_hulls;
  }

  std::string certificate() const {
    return claims_text(origin(), [this](ClaimsWriter& file) {
      PairClaims pairs(file);
      const auto add = [&](const PairObject& object) {
        file.say(object.said);
        return pairs.add_placed(object.name, pairs.add_body(object.name, object.vertices), object.pose);
      };
      const std::uint32_t a = add(a_), b = add(b_);
      const solid::ClaimedPair pair{a, b, of_a_.mesh.hull, of_a_.pose, of_b_.mesh.hull, of_b_.pose};
      add_claims(pairs, pair, answer_.evidence, contact_);
      if (cut_ && cut_->cut.meet()) {
        const PlacedBody& body = cuts_b_ ? of_b_ : of_a_;
        add_common_part(pairs, cuts_b_ ? b : a, cuts_b_ ? a : b, body.mesh.hull, body.pose, cut_->segment, cut_->cut);
      }
      if (call.distance) add_distance(pairs, pair, distance_);
      if (depth_) add_depth(file, a, b, *depth_);
      if (least_ > 0) add_clearance(pairs, pair, distance_, least_);
    });
  }

 private:
  std::array<SurfacePart, 2> closest() const {
    const solid::FeatureVertices& f = closest_of(distance_)->features();
    const std::span<const std::uint32_t> all(f.vertices);
    return {SurfacePart{of_a_.mesh.hull, all.first(f.count_a)},
            SurfacePart{of_b_.mesh.hull, all.subspan(f.count_a, f.count_b)}};
  }
  std::string distance_text() const {
    if (meet_) return "0";
    const auto [a, b] = closest();
    return fmt::format("{}, from {} to {}", about_length(distance_of(distance_)), a.text("A"), b.text("B"));
  }
  Json distance_json() const {
    const Interval distance = distance_of(distance_);
    Json json{{"low", distance.low}, {"high", distance.high}};
    if (meet_) return json;
    const auto [a, b] = closest();
    json["a"] = a.json();
    json["b"] = b.json();
    return json;
  }

  // Of A and of B, at the nearest facet of their difference; none where that is flat.
  std::optional<std::array<SurfacePart, 2>> deepest() const {
    if (!depth_->exact || depth_->exact->features.of_a.empty()) return std::nullopt;
    const auto& [a, b] = depth_->exact->features;
    return std::array{SurfacePart{of_a_.mesh.hull, a}, SurfacePart{of_b_.mesh.hull, b}};
  }
  std::string depth_text() const {
    const auto parts = deepest();
    return depth_told(depth_->depth, about(way_out(depth_->direction))) +
           (parts ? fmt::format(", {} against {}", (*parts)[0].text("A"), (*parts)[1].text("B")) : "");
  }
  Json depth_json() const {
    Json json = depth_report(depth_->depth, to_json(way_out(depth_->direction)));
    if (depth_->exact) json["square"] = fraction_text(depth_->exact->squared[0], depth_->exact->squared[1]);
    if (const auto parts = deepest()) {
      json["a"] = (*parts)[0].json();
      json["b"] = (*parts)[1].json();
    }
    return json;
  }

  PairMethod method_;
  const PlacedBody &of_a_, &of_b_;
  double least_;  // the clearance that is asked about; 0: none
  solid::PairAnswer answer_;
  std::optional<SegmentCut> cut_;
  bool cuts_b_ = false;  // A is the segment
  solid::PolyhedronDistance distance_;
  std::optional<solid::PolyhedraOverlap> depth_;  // where it is asked for, and they meet
  bool is_kept_ = false;
};

solid::PairAnswer polygon_polyhedron_by_drums(const solid::ConvexPolyhedron& polygon, const solid::Pose& pose,
                                              const solid::ConvexPolyhedron& body, const solid::Pose& pose_of_body) {
  return exchanged(solid::polyhedron_polygon_by_drums(body, pose_of_body, polygon, pose));
}

PairMethod solid_method(const PairCall& call, const PlacedBody& a, const PlacedBody& b) {
  if (call.method != "drums") return pair_method(call.method, ", drums");
  if (a.mesh.hull.dimension() == 3 && b.mesh.hull.dimension() == 3) return solid::polyhedron_polyhedron_by_drums;
  if (a.mesh.hull.dimension() == 3 && b.mesh.hull.dimension() == 2) return solid::polyhedron_polygon_by_drums;
  if (a.mesh.hull.dimension() == 2 && b.mesh.hull.dimension() == 3) return polygon_polyhedron_by_drums;
  throw Error(ErrorCode::bad_call,
              "drums is for a body and a body, a plane, a line, a ray or a flat polygon; give these", "--method");
}

// Of standard input, the other one tells.
Report run(const PairCall& call, Talk& talk) {
  if (are_polytopes(call)) {
    require_pair_fit(call, {pair_kind::polytopes});
    return run_polytope_pair(call, talk);
  }
  const bool space_a = is_space_input(call, call.a.file), space_b = is_space_input(call, call.b.file);
  const bool planar_a = io::is_planar(call.a.file) && !space_a, planar_b = io::is_planar(call.b.file) && !space_b;
  if (planar_a || planar_b) {
    if (space_a || space_b) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("{} is an object of space, the other one is planar, and these are not asked about "
                              "together; give the planar one in space (JSON, or WKT POLYGON Z), or two planar ones "
                              "(of WKT Z, --drop-z ignores third coordinates)",
                              io::quote(io::one_line(space_a ? call.a.file : call.b.file))));
    }
    require_pair_fit(call, {pair_kind::planar, pair_kind::planar_lines});
    return run_planar_pair(call, talk);
  }
  require_pair_fit(call, {pair_kind::bodies, pair_kind::flats, pair_kind::round, pair_kind::moving});
  if (!space_a && !space_b && call.method != "drums")
    pair_method(call.method, ", drums");  // before what takes time is read
  PairFiles files(call, talk);
  const SpaceInput a = read_space_input(call, call.a, files), b = read_space_input(call, call.b, files);
  require_projected(call, a, b);
  std::vector<const MeshBody*> bodies;
  for (const SpaceInput* input : {&a, &b}) {
    if (input->bounded) bodies.push_back(&input->bounded->mesh);
    if (input->round && input->round->core) bodies.push_back(&input->round->core->mesh);
  }
  note_hulls(talk, bodies);
  const bool is_motion = !call.a.to.empty() || !call.b.to.empty();
  const bool is_flat = a.flat || b.flat;
  if (is_motion && !is_flat) return run_motion_pair(call, a, b, files);
  if (a.round || b.round) return run_round_pair(call, a, b, files);
  if (is_flat) return run_flat_pair(call, a, b, files);
  return answer(SolidPair(call, solid_method(call, *a.bounded, *b.bounded), *a.bounded, *b.bounded, files), files.talk);
}

// The table of this call.
std::vector<Option> pair_options(PairCall& call) {
  namespace kind = pair_kind;
  std::vector<Option> options{
      {"A", &call.a.file,
       "the first object: a mesh or a set of points (OBJ, STL, PLY, OFF, DAE, glTF, WRL); a point, segment, flat "
       "polygon, line, ray or plane in space (JSON, WKT Z); a box, ball, capsule, cylinder, cone or ellipsoid (JSON); "
       "a "
       "planar object (WKT, GeoJSON, CSV); or a polytope of 2 to 6 dimensions (CSV, NPY). A planar line is "
       "line,x1,y1,x2,y2 in CSV and LINE (x1 y1, x2 y2) in WKT; for a ray or a half-plane write ray or half-plane "
       "in CSV, RAY or HALFPLANE in WKT",
       "", true},
      {"B", &call.b.file, "the second object, in a space of the same dimension; in the plane, A or B must be bounded",
       "", true},
      {"--pose-a", &call.a.pose,
       fmt::format("the pose of A (default: as in its file): {}; in the plane {}", pose_forms, planar_pose_forms),
       "POSE"},
      {"--pose-b", &call.b.pose, "the pose of B, in the same form", "POSE"},
      {"--to-a", &call.a.to,
       "move A along a straight line from --pose-a to this pose, without turning: do A and B meet at any time? Both "
       "must be bounded and in space",
       "POSE"},
      {"--to-b", &call.b.to, "the same for B, during the same time; an object without an end pose does not move",
       "POSE"},
      {"--radius-a", &call.a.radius,
       "enlarge A to all points within this distance of it (default 0; bounded objects in space)", "NUMBER"},
      {"--radius-b", &call.b.radius, "the same for B", "NUMBER"},
      {"--method", &call.method,
       fmt::format(
           "for two bodies in space: {}, drums; with a plane: {}; with a line or ray in space: {}; for two planar "
           "objects: {}; with a planar line, ray or half-plane: {}; for polytopes: {}",
           pair_method_names(), plane_method_names(), line_method_names(), planar_method_names(),
           planar_line_method_names(), polytope_method_names()),
       "NAME"},
      {"--classify", &call.classify, "also tell whether the objects only touch or their interiors overlap"},
      {"--require-convex", &call.require_convex,
       "refuse a mesh that is not exactly convex (default: replace it by its convex hull)"},
      {"--leave-out", &call.leave_out, leave_out_help},
      certificate_option(call.certificate),
      json_option(call.json),
      {"--distance", &call.distance,
       "if both are bounded: also compute their exact distance and their closest features"},
      {"--depth", &call.depth,
       "if bounded objects of the plane or space meet: also compute how far A must move, and in which direction, "
       "until they no longer overlap; they may then still touch"},
      {"--clearance", &call.clearance,
       "if both are bounded: are they at least this far apart? Exit code 0 if they are, 1 if not", "NUMBER"},
      {"--feature-a", &call.a.feature, "planar: use this object of file A, given by its name or its number in the file",
       "NAME"},
      {"--feature-b", &call.b.feature, "the same for file B", "NAME"},
      {"--body-a", &call.a.body,
       "A is a scene (JSON): use this body of it, NAME, or NAME/PART for one of several parts", "NAME"},
      {"--body-b", &call.b.body, "the same for B", "NAME"},
      {"--mend", &call.mend, "planar: remove repeated and collinear vertices"},
      {"--hull", &call.hull, "planar: replace each object by the convex hull of its vertices"},
      {"--project", &call.project,
       "project polygons in space onto a plane; nine numbers: a point of the plane and two vectors in it. The answer "
       "says how far the vertices moved",
       "FRAME"},
      {"--drop-z", &call.drop_z, "planar: ignore the third coordinate of each point"},
      {"--mixed-crs", &call.mixed_crs, fmt::format("planar: {}", mixed_crs_help)},
      {"--polytopes", &call.polytopes,
       "read CSV files as polytopes of 2 to 6 dimensions, one point in each row. Not needed for NPY files, and for "
       "CSV files whose first line is x1,..,xd (points) or a1,..,ad,b (half-spaces a1 x1 + .. + ad xd <= b)"},
      {"--half-spaces-a", &call.a.half_spaces,
       "polytopes: each row of A (CSV without column names, or NPY) is a half-space a1,..,ad,b, not a point"},
      {"--half-spaces-b", &call.b.half_spaces, "the same for the rows of B"},
      {"--hyperplanes", &call.hyperplanes,
       "polytopes, with --method tree: prove that A and B are apart by several half-spaces that contain A and several "
       "that contain B"},
      {"--svg", &call.svg, "planar: draw the objects and the evidence to FILE", "FILE"},
      title_option(call.title),
      svg_limit_option(call.svg_limit)};
  using Kinds = std::vector<std::string>;
  const Kinds plane{kind::planar, kind::planar_lines}, solid{kind::bodies, kind::round, kind::moving},
      space{kind::bodies, kind::flats, kind::round, kind::moving}, bounded{kind::planar, kind::bodies, kind::round},
      resting{kind::planar, kind::planar_lines, kind::bodies, kind::flats, kind::round}, polytopes{kind::polytopes};
  Kinds any_at_rest = resting;
  any_at_rest.push_back(kind::polytopes);
  const std::map<std::string_view, const Kinds&> of{{"--to-a", solid},
                                                    {"--to-b", solid},
                                                    {"--radius-a", solid},
                                                    {"--radius-b", solid},
                                                    {"--classify", resting},
                                                    {"--require-convex", space},
                                                    {"--distance", bounded},
                                                    {"--depth", bounded},
                                                    {"--clearance", bounded},
                                                    {"--feature-a", plane},
                                                    {"--feature-b", plane},
                                                    {"--mend", plane},
                                                    {"--hull", plane},
                                                    {"--project", space},
                                                    {"--drop-z", plane},
                                                    {"--mixed-crs", plane},
                                                    {"--half-spaces-a", polytopes},
                                                    {"--half-spaces-b", polytopes},
                                                    {"--hyperplanes", polytopes},
                                                    {"--svg", plane},
                                                    {"--body-a", space},
                                                    {"--body-b", space},
                                                    {"--method", any_at_rest}};
  for (Option& option : options) {
    if (const auto found = of.find(option.name); found != of.end()) option.of = found->second;
  }
  return options;
}

}  // namespace

void require_pair_fit(const PairCall& call, const std::vector<std::string>& kinds) {
  PairCall given = call, unless_given;
  require_fit(pair_options(given), pair_options(unless_given), kinds);
}

Verb pair_verb() {
  const auto call = std::make_shared<PairCall>();
  return {"pair", "Do two convex objects meet? Finds a common point, or a direction that separates them.",
          "0 apart, or with --clearance that far apart; 1 meet, or not that far apart", pair_options(*call),
          [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask

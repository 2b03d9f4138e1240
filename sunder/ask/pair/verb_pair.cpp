// sunder pair A B: do two convex objects meet?
#include <sunder/ask/objects.h>
#include <sunder/ask/pair/pair_planar.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/planar_objects.h>

#include <fmt/format.h>

#include <memory>

namespace sunder::ask {

namespace {

struct Placed {
  MeshBody object;
  solid::Pose pose;

  PlacedVertices vertices() const { return placed_vertices(object.hull, pose); }
  bool is_hull() const { return object.shape == io::BodyShape::hull; }
};

class SolidPair : public PairQuestion {
 public:
  SolidPair(const PairCall& asked, PairMethod method, const Placed& a, const Placed& b, const LeftOutList& left_out,
            Origin origin)
      : PairQuestion(asked, left_out, std::move(origin)), method_(method), a_(a), b_(b) {}

  static std::uint64_t drawn() { return 0; }
  static std::string picture() { return ""; }  // of planar pairs only

  void ask() {
    answer_ = method_(a_.object.hull, a_.pose, b_.object.hull, b_.pose);
    meet_ = answer_.meet();
    decided_by_ = answer_.decided_by;
    cost_ = answer_.cost;
    if (call.classify && meet_) {
      contact_ = solid::polyhedron_polyhedron_contact(a_.object.hull, a_.pose, b_.object.hull, b_.pose);
    }
  }
  bool yes() const { return meet_; }

  std::string certificate() const {
    return certificate_of(PairClaims::Space::solid, [this](PairClaims& pairs) {
      const auto add = [&](const Placed& p) {
        return pairs.add_placed(p.object.name, pairs.add_body(p.object.name, p.object.hull.vertices()),
                                p.pose.affine());
      };
      const std::uint32_t index_a = add(a_), index_b = add(b_);
      add_solid_pair(pairs, {index_a, index_b, a_.object.hull, b_.object.hull, a_.pose, b_.pose}, answer_.certificate(),
                     contact_);
    });
  }

  std::string text() const {
    return head(a_.object.file, b_.object.file, is_said_of_hulls() ? "meet as hulls" : answer()) +
           titled("A", text_of(a_.object)) + titled("B", text_of(b_.object)) +
           titled("evidence", evidence_text(answer_.certificate(), a_.vertices(), b_.vertices(), "A", "B")) +
           titled("decided by", decided_text(decided_by_));
  }
  void add_to(Json& json) const {
    add_head(json, to_json(a_.object), to_json(b_.object));
    json["said_of"] = is_said_of_hulls() ? "hulls" : "bodies";
    json["evidence"] = evidence_json(answer_.certificate(), a_.vertices(), b_.vertices());
  }

 private:
  // Apart carries over from hulls to the meshes that they stand for; meet does not.
  bool is_said_of_hulls() const { return meet_ && (a_.is_hull() || b_.is_hull()); }

  static std::string text_of(const MeshBody& object) {
    const solid::ConvexPolyhedron& hull = object.hull;
    const char* shape = object.shape == io::BodyShape::convex ? ""
                        : object.shape == io::BodyShape::hull ? ", hull of the mesh"
                                                              : ", hull of the points";
    const std::string departure = departure_text(object);
    return fmt::format("{}: {}, {}, {}{}{}{}", object.name, dimension_name(hull.dimension()),
                       hull.vertices().size() == 1 ? "1 vertex" : fmt::format("{} vertices", hull.vertices().size()),
                       count_of(hull.facet_count(), "facet"), shape, departure.empty() ? "" : "\n", departure);
  }

  PairMethod method_;
  const Placed &a_, &b_;
  solid::PairAnswer answer_;
};

Placed read(const PairCall& call, bool is_a, LeftOutList& left_out, InputFiles* inputs) {
  const std::string& pose = is_a ? call.pose_a : call.pose_b;
  return {io::read_body(is_a ? call.file_a : call.file_b, call.require_convex, left_out, inputs),
          pose.empty() ? solid::Pose() : parse_pose(pose, is_a ? "--pose-a" : "--pose-b")};
}

// Of standard input, the other one tells.
int run(const PairCall& call) {
  if (io::is_planar(call.file_a) || io::is_planar(call.file_b)) {
    if (call.require_convex) {
      throw Error(ErrorCode::bad_call, "polygons are always required to be convex; leave it out", "--require-convex");
    }
    return run_planar_pair(call);
  }
  for (const auto& [is_given, option] : {std::pair(!call.svg.empty(), "--svg"),
                                         {call.distance, "--distance"},
                                         {!call.clearance.empty(), "--clearance"},
                                         {call.mend, "--mend"},
                                         {call.hull, "--hull"},
                                         {call.drop_z, "--drop-z"},
                                         {!call.feature_a.empty(), "--feature-a"},
                                         {!call.feature_b.empty(), "--feature-b"}}) {
    if (is_given) throw Error(ErrorCode::bad_call, "is for planar objects only; leave it out", option);
  }
  const PairMethod method = pair_method(call.method);
  LeftOutList left_out(call.leave_out);
  Origin origin;
  InputFiles* const inputs = call.proves() ? &origin.inputs : nullptr;
  const Placed a = read(call, true, left_out, inputs), b = read(call, false, left_out, inputs);
  note_hulls({&a.object, &b.object});
  SolidPair question(call, method, a, b, left_out, std::move(origin));
  return answer(question);
}

}  // namespace

Verb pair_verb() {
  const auto call = std::make_shared<PairCall>();
  return {
      "pair",
      "Do two convex objects meet? A common point, or what parts them.",
      "0 apart, or with --clearance that far apart; 1 meet, or not that far apart",
      {{"A", &call->file_a,
        "a mesh or a set of points: OBJ, STL, PLY, OFF; or a planar object: WKT, GeoJSON, CSV. Lines, rays, "
        "half-planes: in CSV line,x1,y1,x2,y2 (ray, half-plane), in WKT LINE (x1 y1, x2 y2) (RAY, HALFPLANE)",
        "", true},
       {"B", &call->file_b, "the other, of the same kind; in the plane, one of the two is bounded", "", true},
       {"--pose-a", &call->pose_a, fmt::format("where A is: {}; in the plane {}", pose_forms, planar_pose_forms),
        "POSE"},
       {"--pose-b", &call->pose_b, "where B is", "POSE"},
       {"--method", &call->method,
        "automatic, scan, gjk (both bounded), hierarchy (of bodies), difference, halving, triangles (both bounded, in "
        "the plane), or fibonacci (with a line)",
        "NAME"},
       {"--classify", &call->classify, "tell touching from overlapping"},
       {"--require-convex", &call->require_convex, "a mesh that is not exactly convex is an error"},
       {"--leave-out", &call->leave_out, leave_out_help},
       certificate_option(call->certificate),
       json_option(call->json),
       {"--distance", &call->distance, "planar, both bounded: tell how far apart they are, and the closest features"},
       {"--clearance", &call->clearance,
        "planar, both bounded: are they so far apart, or further? If not, the exit code is 1", "NUMBER"},
       {"--feature-a", &call->feature_a, "planar: which object of the file A is", "NAME"},
       {"--feature-b", &call->feature_b, "planar: which object of the file B is", "NAME"},
       {"--mend", &call->mend, "planar: leave out repeated and collinear vertices, turn clockwise ones round"},
       {"--hull", &call->hull, "planar: take the convex hull"},
       {"--drop-z", &call->drop_z, "planar: ignore third coordinates"},
       {"--svg", &call->svg, "planar: draw the objects and the evidence here", "FILE"},
       title_option(call->title),
       svg_limit_option(call->svg_limit)},
      [call] { return run(*call); }};
}

}  // namespace sunder::ask

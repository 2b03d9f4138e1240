// sunder pair A B: do two convex objects meet?
#include <sunder/ask/evidence.h>
#include <sunder/ask/objects.h>
#include <sunder/ask/pair/pair_planar.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/io/file.h>
#include <sunder/io/planar_objects.h>

#include <fmt/format.h>

#include <memory>

namespace sunder::ask {

namespace {

// The options of both kinds of pairs.
struct Call : PlanarPairCall {
  bool require_convex = false;
};

struct Placed {
  Object object;
  solid::Pose pose;

  PlacedVertices vertices() const { return placed_vertices(object.hull, pose); }
};

Placed read(const std::string& file, const std::string& pose, const char* option, bool require_convex,
            LeftOutList& left_out, InputFiles* inputs) {
  return {read_object(file, require_convex, left_out, inputs), pose.empty() ? solid::Pose() : parse_pose(pose, option)};
}

// Apart carries over from hulls to the meshes that they stand for; meet does not.
bool is_said_of_hulls(const Placed& a, const Placed& b, const solid::PairAnswer& answer) {
  return answer.meet() && (a.object.shape == Shape::hull || b.object.shape == Shape::hull);
}

std::string certificate_text(const Placed& a, const Placed& b, const PairCertificate& evidence, Contact contact,
                             const Origin& origin) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  PairClaims pairs(file);
  const auto add = [&](const Placed& p) {
    return pairs.add_placed(p.object.name, pairs.add_body(p.object.name, p.object.hull.vertices()), p.pose.affine());
  };
  const std::uint32_t index_a = add(a), index_b = add(b);
  add_solid_pair(pairs, {index_a, index_b, a.object.hull, b.object.hull, a.pose, b.pose}, evidence, contact);
  pairs.end();
  return text;
}

std::string human_text(const Call& call, const Placed& a, const Placed& b, const solid::PairAnswer& answer,
                       Contact contact, const LeftOutList& left_out) {
  std::string answer_text = !answer.meet() ? "apart" : is_said_of_hulls(a, b, answer) ? "meet as hulls" : "meet";
  if (call.classify && answer.meet()) answer_text += fmt::format(" ({})", name_of(contact));
  std::string text = fmt::format("{} and {}: {}{}\n", a.object.file, b.object.file, answer_text, left_out.clause());
  const auto line = [&](const char* title, std::string value) {
    if (const std::size_t end = value.find('\n'); end != std::string::npos) value.insert(end + 1, 14, ' ');
    text += fmt::format("  {:<10}  {}\n", title, value);
  };
  for (const Placed* p : {&a, &b}) {
    const solid::ConvexPolyhedron& hull = p->object.hull;
    const char* shape = p->object.shape == Shape::convex ? ""
                        : p->object.shape == Shape::hull ? ", hull of the mesh"
                                                         : ", hull of the points";
    line(p == &a ? "A" : "B",
         fmt::format("{}: {}, {}, {}{}", p->object.name, dimension_name(hull.dimension()),
                     hull.vertices().size() == 1 ? "1 vertex" : fmt::format("{} vertices", hull.vertices().size()),
                     count_of(hull.facet_count(), "facet"), shape));
    if (const std::string departure = departure_text(p->object); !departure.empty()) line("", departure);
  }
  line("evidence", evidence_text(answer.certificate(), a.vertices(), b.vertices(), "A", "B"));
  line("decided by", decided_text(answer.decided_by));
  line("cost", fmt::format("{}, {}, {} of exact arithmetic", count_of(answer.cost.probes, "probe"),
                           count_of(answer.cost.iterations, "iteration"), count_of(answer.cost.exact, "use")));
  if (!call.certificate.empty()) line("proof", call.certificate);
  return text;
}

Json report(const Call& call, const Placed& a, const Placed& b, const solid::PairAnswer& answer, Contact contact,
            const LeftOutList& left_out) {
  Json json = envelope("pair", answer.meet() ? "meet" : "apart", call.method);
  json["decided_by"] = name_of(answer.decided_by);
  json["cost"] = to_json(answer.cost);
  json["objects"] = {to_json(a.object), to_json(b.object)};
  json["said_of"] = is_said_of_hulls(a, b, answer) ? "hulls" : "bodies";
  if (!left_out.empty()) json["left_out"] = left_out.json();
  if (call.classify) json["contact"] = name_of(contact);
  json["evidence"] = evidence_json(answer.certificate(), a.vertices(), b.vertices());
  return json;
}

// Of standard input, the other one tells.
int run(const Call& call) {
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
  InputFiles files;
  InputFiles* const inputs = call.certificate.empty() ? nullptr : &files;
  const Placed a = read(call.file_a, call.pose_a, "--pose-a", call.require_convex, left_out, inputs);
  const Placed b = read(call.file_b, call.pose_b, "--pose-b", call.require_convex, left_out, inputs);

  const solid::PairAnswer answer = method(a.object.hull, a.pose, b.object.hull, b.pose);
  const Contact contact = call.classify && answer.meet()
                              ? solid::polyhedron_polyhedron_contact(a.object.hull, a.pose, b.object.hull, b.pose)
                              : Contact::none;
  if (!call.certificate.empty()) {
    io::write_file_atomically(call.certificate,
                              certificate_text(a, b, answer.certificate(), contact, {files, left_out.texts()}));
  }
  note_hulls({&a.object, &b.object});
  call.json ? print(to_text(report(call, a, b, answer, contact, left_out)))
            : print_for_people(human_text(call, a, b, answer, contact, left_out));
  return answer.meet() ? exit_code::yes : exit_code::no;
}

}  // namespace

Verb pair_verb() {
  const auto call = std::make_shared<Call>();
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
        "automatic, scan, gjk (both bounded), difference, halving, triangles (both bounded, in the plane), or "
        "fibonacci (with a line)",
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

// sunder pair A B: do two convex objects meet?
#include <sunder/ask/mesh_memory_option.h>
#include <sunder/ask/objects.h>
#include <sunder/ask/pair/pair_planar.h>
#include <sunder/ask/pair/pair_polytopes.h>
#include <sunder/ask/pair/pair_space.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

namespace {

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
  require_pair_fit(call, {pair_kind::bodies, pair_kind::flats, pair_kind::round, pair_kind::moving, pair_kind::meshes,
                          pair_kind::moving_meshes});
  if (!space_a && !space_b && call.method != "drums")
    pair_method(call.method, ", drums");  // before what takes time is read
  const io::MeshMemory limit = limit_of(call);
  PairFiles files(call, talk);
  const SpaceInput a = read_space_input(call, call.a, files), b = read_space_input(call, call.b, files);
  require_projected(call, a, b);
  std::vector<const MeshBody*> bodies;
  for (const SpaceInput* input : {&a, &b}) {
    if (input->bounded) bodies.push_back(&input->bounded->mesh);
    if (input->round && input->round->core) bodies.push_back(&input->round->core->mesh);
  }
  if (!call.hull && mesh_that_is_not_convex(a, b) != nullptr) {
    note_remarks(talk, bodies);
    return run_mesh_pair(call, a, b, files);
  }
  note_hulls(talk, bodies);
  const bool is_motion = !call.a.to.empty() || !call.b.to.empty();
  const bool is_flat = a.flat || b.flat;
  if (call.support && !is_flat) require_pair_fit(call, {pair_kind::bodies});
  if (is_motion && !is_flat) return run_motion_pair(call, a, b, files);
  if (is_flat && !a.round && !b.round) return run_flat_pair(call, a, b, files);
  return run_body_pair(call, a, b, files);
}

// The table of this call.
std::vector<Option> pair_options(PairCall& call) {
  namespace kind = pair_kind;
  std::vector<Option> options{
      {"A", &call.a.file,
       "the first object: a mesh or a set of points (OBJ, STL, PLY, OFF, DAE, glTF, WRL, 3MF); a point, segment, flat "
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
       fmt::format("for two bodies in space: {}, drums; for meshes that are not convex: {}; with a plane: {}; with a "
                   "line or ray in space: {}; for two planar "
                   "objects: {}; with a planar line, ray or half-plane: {}; for polytopes: {}",
                   pair_method_names(), mesh_method_names(), plane_method_names(), line_method_names(),
                   planar_method_names(), planar_line_method_names(), polytope_method_names()),
       "NAME"},
      {"--classify", &call.classify, "also tell whether the objects only touch or their interiors overlap"},
      {"--require-convex", &call.require_convex,
       "refuse a mesh that is not exactly convex (default: it is asked about as it is)"},
      {"--leave-out", &call.leave_out, leave_out_help},
      certificate_option(call.certificate),
      json_option(call.json),
      {"--distance", &call.distance,
       "if both are bounded: also compute their exact distance and their closest features"},
      {"--depth", &call.depth,
       "if bounded objects of the plane or space meet: also compute how far A must move, and in which direction, "
       "until they no longer overlap; they may then still touch"},
      {"--support", &call.support,
       "of a body with an inside and a line in space: also find the planes through the line that touch the body and do "
       "not cut it, and what they touch; --method: " +
           support_method_names()},
      {"--clearance", &call.clearance,
       "if both are bounded: are they at least this far apart? Exit code 0 if they are, 1 if not", "NUMBER"},
      {"--feature-a", &call.a.feature, "planar: use this object of file A, given by its name or its number in the file",
       "NAME"},
      {"--feature-b", &call.b.feature, "the same for file B", "NAME"},
      {"--body-a", &call.a.body,
       "A is a scene (JSON): use this body of it, NAME, or NAME/PART for one of several parts", "NAME"},
      {"--body-b", &call.b.body, "the same for B", "NAME"},
      {"--mend", &call.mend, "planar: remove repeated and collinear vertices"},
      {"--hull", &call.hull, "replace each object that is not convex by the convex hull of its vertices"},
      {"--surface", &call.surface,
       "of meshes that are not closed: ask about the surfaces alone, so that the exit code is 0 if these are apart, "
       "whatever an open one seems to enclose"},
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
      {"--poses-b", &call.b.poses,
       "polytopes: do A and B meet, with B at each pose of this file (CSV or NPY, a pose in each row, as in --pose-b)? "
       "--method columns or tree prepares A and B once, for all poses. Exit code 1 if they meet at any",
       "FILE"},
      {"--hyperplanes", &call.hyperplanes,
       "polytopes, with --method tree or columns: prove that A and B are apart by several half-spaces that contain A "
       "and several that contain B"},
      {"--svg", &call.svg, "planar: draw the objects and the evidence to FILE", "FILE"},
      title_option(call.title),
      svg_limit_option(call.svg_limit),
      memory_option(call.memory)};
  using Kinds = std::vector<std::string>;
  const Kinds plane{kind::planar, kind::planar_lines}, solid{kind::bodies, kind::round, kind::moving},
      space{kind::bodies, kind::flats, kind::round, kind::moving}, bounded{kind::planar, kind::bodies, kind::round},
      resting{kind::planar, kind::planar_lines, kind::bodies, kind::flats, kind::round}, polytopes{kind::polytopes},
      flats{kind::flats}, meshes{kind::meshes, kind::moving_meshes},
      read{kind::bodies, kind::flats, kind::round, kind::moving, kind::meshes, kind::moving_meshes},
      measured{kind::planar, kind::bodies, kind::round, kind::meshes};
  Kinds any_shape = plane;
  any_shape.insert(any_shape.end(), space.begin(), space.end());
  Kinds any_at_rest = resting;
  any_at_rest.push_back(kind::polytopes);
  any_at_rest.push_back(kind::moving_meshes);
  const std::map<std::string_view, const Kinds&> of{{"--to-a", solid},
                                                    {"--to-b", solid},
                                                    {"--radius-a", solid},
                                                    {"--radius-b", solid},
                                                    {"--classify", resting},
                                                    {"--require-convex", space},
                                                    {"--distance", measured},
                                                    {"--depth", bounded},
                                                    {"--support", flats},
                                                    {"--clearance", measured},
                                                    {"--feature-a", plane},
                                                    {"--feature-b", plane},
                                                    {"--mend", plane},
                                                    {"--hull", any_shape},
                                                    {"--surface", meshes},
                                                    {"--memory", read},
                                                    {"--project", space},
                                                    {"--drop-z", plane},
                                                    {"--mixed-crs", plane},
                                                    {"--half-spaces-a", polytopes},
                                                    {"--half-spaces-b", polytopes},
                                                    {"--poses-b", polytopes},
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
  return {"pair", "Do two objects meet? Finds a common point, or a direction that separates them.",
          "0 apart, or with --clearance that far apart; 1 meet, or not that far apart, or not known to be apart",
          pair_options(*call), [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask

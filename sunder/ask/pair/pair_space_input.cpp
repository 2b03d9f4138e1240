#include <sunder/ask/outputs.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/predicate/coordinates.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace sunder::ask {

std::string exact_text(const Point3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

namespace {

using io::SpaceObject;
using solid::Exact3;
using SpaceKind = SpaceObject::Kind;

solid::Frame parse_frame(const std::string& text) {
  const std::vector<double> n = parse_numbers(text, "--project");
  if (n.size() != 9) {
    throw Error(ErrorCode::bad_call,
                fmt::format("a frame of {}; give nine: its origin, u and v", count_of(n.size(), "number")),
                "--project");
  }
  try {
    return solid::Frame::of({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), "--project");
  }
}

// The point of doubles that it is, if it is one.
std::optional<Point3> in_doubles(const Exact3& x) {
  Point3 p{x.x.nearest(), x.y.nearest(), x.z.nearest()};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(p[k]) || !(Dyadic(p[k]) == (k == 0 ? x.x : k == 1 ? x.y : x.z))) return std::nullopt;
    p[k] += 0.0;
  }
  return p;
}

}  // namespace

std::optional<Point3> exact_image(const solid::Pose& pose, const Point3& p) {
  return in_doubles(coordinates<Dyadic>(Posed3{p, &pose.affine(), false}));
}

namespace {

// The pose that applies `inner` first, if its numbers are doubles.
std::optional<solid::Pose> exactly_composed(const solid::Pose& outer, const solid::Pose& inner) {
  const auto& m = inner.affine().linear;
  const auto& t = inner.affine().translation;
  const auto origin = exact_image(outer, {t[0], t[1], t[2]});
  if (!origin) return std::nullopt;
  Affine3 turned = outer.affine();
  turned.translation = {};
  std::array<double, 9> linear;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto column = in_doubles(coordinates<Dyadic>(Posed3{{m[j], m[3 + j], m[6 + j]}, &turned, false}));
    if (!column) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) linear[3 * i + j] = (*column)[i];
  }
  return solid::Pose::from_matrix(linear, {origin->x, origin->y, origin->z});
}

// The normal of the image of a plane: the cofactors of the linear part times its normal, up to a power of two.
std::optional<Point3> exact_normal(const solid::Pose& pose, const Point3& normal) {
  const auto& m = pose.affine().linear;
  const auto column = [&](std::size_t j) { return coordinates<Dyadic>(Point3{m[j], m[3 + j], m[6 + j]}); };
  const Exact3 n = coordinates<Dyadic>(normal), x = column(0), y = column(1), z = column(2);
  const Exact3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const auto row = [&](const Dyadic& p, const Dyadic& q, const Dyadic& r) { return p * n.x + q * n.y + r * n.z; };
  Exact3 image{row(yz.x, zx.x, xy.x), row(yz.y, zx.y, xy.y), row(yz.z, zx.z, xy.z)};
  if (determinant_sign(pose.affine()) == Sign::negative) image = {-image.x, -image.y, -image.z};
  std::int64_t top = -100000;
  for (const Dyadic* part : {&image.x, &image.y, &image.z}) {
    if (part->sign() != Sign::zero) top = std::max(top, part->top());
  }
  return in_doubles({image.x.scaled(-top), image.y.scaled(-top), image.z.scaled(-top)});
}

[[noreturn]] void refuse_image(SpaceKind kind, const std::string& what, const PairSide& side) {
  throw Error(
      ErrorCode::bad_pose,
      fmt::format("the image of the {1}'s {0} is not of doubles, and is not rounded; give the {1} in its place, "
                  "or a pose for the other object",
                  what, io::name_of(kind)),
      side.option("pose"));
}

// The object in its place.
SpaceObject placed(SpaceObject object, const solid::Pose& pose, const PairSide& side) {
  if (pose.affine() == Affine3()) return object;
  for (Point3& p : object.points) {
    const auto image = exact_image(pose, p);
    if (!image) refuse_image(object.kind, fmt::format("point {}", exact_text(p)), side);
    p = *image;
  }
  if (object.kind != SpaceKind::plane) return object;
  solid::Plane& plane = object.plane;
  const auto on = solid::exact_point_of(plane);
  const auto normal = exact_normal(pose, plane.normal);
  if (!normal) refuse_image(object.kind, fmt::format("normal {}", exact_text(plane.normal)), side);
  const auto point = on ? exact_image(pose, *on) : std::nullopt;
  if (!point) refuse_image(object.kind, "points", side);
  plane = solid::Plane::through(*point, *normal);
  return object;
}

solid::Flat flat_of(const SpaceObject& object) {
  if (object.kind == SpaceKind::plane) return object.plane;
  if (object.kind == SpaceKind::ray) return solid::Ray::from(object.points[0], object.points[1]);
  return solid::Line::through(object.points[0], object.points[1]);
}

// A polygon is convex where its mesh is; a point and a segment always are.
PlacedBody bounded(SpaceObject object, const solid::Pose& pose, const PairCall& call, const PairSide& side) {
  PlacedBody result{io::body_of_mesh(io::mesh_of(object), side.file, call.require_convex), pose, {}};
  if (object.kind != SpaceKind::polygon) result.mesh.shape = io::BodyShape::convex;
  if (object.frame) {
    const auto in_world = exactly_composed(pose, object.frame->pose());
    if (!in_world) {
      throw Error(
          ErrorCode::bad_pose,
          "the frame of the polygon is not of doubles under this pose, and is not rounded; give the frame in its "
          "place, or a pose for the other object",
          side.option("pose"));
    }
    result.pose = *in_world;
  }
  result.object = std::move(object);
  return result;
}

SpaceInput parse_input(std::string_view text, const solid::Pose& pose, const PairCall& call, const PairSide& side) {
  const std::optional<solid::Frame> frame =
      call.project.empty() ? std::nullopt : std::optional(parse_frame(call.project));
  SpaceObject object = io::parse_space_object(text, side.file, frame ? &*frame : nullptr);
  if (object.round) {
    const solid::RoundBody body = *object.round;
    return {{},
            {},
            PlacedRoundBody{io::one_line(side.file),
                            io::one_line(std::filesystem::path(side.file).stem().string()),
                            std::move(object),
                            {},
                            body,
                            pose}};
  }
  if (!object.unbounded()) return {bounded(std::move(object), pose, call, side), {}};
  object = placed(std::move(object), pose, side);
  const solid::Flat flat = flat_of(object);
  return {{},
          PlacedFlat{io::one_line(side.file), io::one_line(std::filesystem::path(side.file).stem().string()),
                     std::move(object), flat, solid::body_of(flat)}};
}

}  // namespace

bool is_space_input(const PairCall& call, const std::string& file) { return !call.drop_z && io::is_space_file(file); }

namespace {

// What is said of it, where a proof is written. (Of the body of a scene that is known.)
void say(const PairSide& side, const PairFiles& files, SpaceInput& input) {
  if (!side.body.empty()) return;
  if (!input.bounded) {
    const Said said = said_of_file(Said::Source::shape, files.read, side.file);
    if (input.flat) input.flat->said = said;
    if (input.round) input.round->said = said;
    return;
  }
  PlacedBody& body = *input.bounded;
  body.said = said_of_mesh(body.mesh, files.read, files.left_out);
  body.said_as_it_is = said_of_triangles(body.mesh, files.read, files.left_out);
  const bool is_projected = body.object && body.object->moved && body.object->frame;
  if (!is_projected || body.said.empty()) return;
  const auto& [o, u, v] = *body.object->frame;
  for (Said* said : {&body.said, &body.said_as_it_is}) {
    *said = said->projected({o.x, o.y, o.z, u.x, u.y, u.z, v.x, v.y, v.z});
  }
}

// The one of these names, or an error that tells them all.
template <class Named>
const Named& named_in(const std::vector<Named>& all, const std::string& name, const std::string& what,
                      const PairSide& side) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
  if (found != all.end()) return *found;
  std::string names;
  for (const Named& each : all) names += (names.empty() ? "" : ", ") + each.name;
  throw Error(ErrorCode::bad_call, fmt::format("{} has no {}; it has {}", what, io::quote(name), names),
              side.option("body"));
}

// A ball, a cylinder and so on as if it were the only object of its file; others have a core.
PlacedRoundBody round_part(const io::BodyPart& part, const std::string& name, const solid::Pose& pose) {
  PlacedRoundBody round{part.body.file, name, {}, {}, *part.round, pose};
  round.object.format = "JSON";
  using enum SpaceKind;
  for (const SpaceKind kind : {ball, capsule, cylinder, cone, ellipsoid}) {
    if (io::name_of(kind) != part.body.format) continue;
    round.object.kind = kind;
    return round;
  }
  round.core = PlacedBody{part.body, pose, {}};
  round.core->mesh.name = name;
  round.around = part.round->radius();
  return round;
}

// Other bodies of the scene are not read.
SpaceInput read_scene_body(const PairCall& call, const PairSide& side, const solid::Pose& pose, PairFiles& files) {
  io::SceneFile scene = io::read_scene_file(side.file, files.inputs());
  const std::string shown = io::one_line(side.file);
  const std::size_t slash = side.body.rfind('/');
  const auto is_whole = [&](const io::SceneFile::Body& body) { return body.name == side.body; };
  const bool has_part = slash != std::string::npos && std::none_of(scene.bodies.begin(), scene.bodies.end(), is_whole);
  const std::string name = has_part ? side.body.substr(0, slash) : side.body;
  scene.bodies = {named_in(scene.bodies, name, shown, side)};
  std::vector<std::filesystem::path> meshes;
  const std::vector<io::BodyPart> parts =
      io::read_scene_parts(scene, side.file, call.require_convex, files.left_out, files.inputs(), &meshes)[0];
  std::vector<NamedFile> read;
  for (const std::filesystem::path& mesh : meshes) read.push_back({"", mesh});
  if (call.proves()) require_apart(files.talk, read, {{"--certificate", call.certificate}});
  if (!has_part && parts.size() > 1) {
    throw Error(
        ErrorCode::bad_call,
        fmt::format("{} has {} parts, and sunder pair takes one: give {}/{} or another one, or ask sunder scene",
                    io::quote(name), parts.size(), name, parts[0].name),
        side.option("body"));
  }
  const io::BodyPart& part = has_part ? named_in(parts, side.body.substr(slash + 1), name, side) : parts[0];
  const auto place = exactly_composed(pose, part.pose);
  if (!place) {
    throw Error(ErrorCode::bad_pose,
                "the place of the body in its scene is not of doubles under this pose, and is not rounded; give a pose "
                "for the other object",
                side.option("pose"));
  }
  if (!side.to.empty() && !(part.pose.affine() == Affine3())) {
    throw Error(ErrorCode::bad_call, "is not for a body that its scene places; move the other object",
                side.option("to"));
  }
  SpaceInput input;
  if (part.round) {
    input.round = round_part(part, side.body, *place);
  } else {
    input.bounded = PlacedBody{part.body, *place, {}};
    input.bounded->mesh.name = side.body;
  }
  const bool is_mesh = !part.round && part.body.file != shown;
  Said said = is_mesh ? said_of_mesh(part.body, files.read, files.left_out)
                      : said_of_file(Said::Source::shape, files.read, side.file, side.body);
  Said as_it_is = is_mesh ? said_of_triangles(part.body, files.read, files.left_out) : said;
  for (Said* each : {&said, &as_it_is}) {
    if (!each->empty() && !part.unit.empty()) *each = each->unit(part.unit);
  }
  if (input.bounded) input.bounded->said_as_it_is = as_it_is;
  (part.round ? input.round->said : input.bounded->said) = said;
  return input;
}

SpaceInput read_without_radius(const PairCall& call, const PairSide& side, PairFiles& files) {
  const solid::Pose pose = side.pose.empty() ? solid::Pose() : parse_pose(side.pose, side.option("pose"));
  if (!side.body.empty()) {
    if (is_space_input(call, side.file)) return read_scene_body(call, side, pose, files);
    throw Error(ErrorCode::bad_call, "is for scenes, JSON files; leave it out", side.option("body"));
  }
  if (is_space_input(call, side.file)) return parse_input(io::read_file(side.file, files.inputs()), pose, call, side);
  if (side.file != "-") {
    return {PlacedBody{io::read_body(side.file, call.require_convex, files.left_out, files.inputs()), pose, {}}, {}};
  }
  const std::string text = io::read_file(side.file, files.inputs());
  if (io::is_space_text(text)) return parse_input(text, pose, call, side);
  io::Mesh mesh = io::parse_mesh(text, side.file, io::mesh_format(text, side.file));
  const std::uint64_t inner_vertices = io::drop_inner_vertices(mesh);
  files.left_out.add(side.file, mesh.left_out, "mend the file");
  PlacedBody body{io::body_of_mesh(std::move(mesh), side.file, call.require_convex), pose, {}};
  body.mesh.inner_vertices = inner_vertices;
  return {std::move(body), {}};
}

}  // namespace

SpaceInput read_space_input(const PairCall& call, const PairSide& side, PairFiles& files) {
  SpaceInput input = read_without_radius(call, side, files);
  say(side, files, input);
  if (side.radius.empty()) return input;
  const std::vector<double> numbers = parse_numbers(side.radius, side.option("radius"));
  if (numbers.size() != 1 || !(numbers[0] >= 0)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} is not one number that is not negative", io::quote(side.radius)),
                side.option("radius"));
  }
  if (!input.bounded) {
    throw Error(ErrorCode::bad_call, "is for meshes, sets of points, points, segments and polygons; leave it out",
                side.option("radius"));
  }
  const MeshBody& mesh = input.bounded->mesh;
  const solid::RoundBody body = solid::RoundBody::rounded(mesh.hull, numbers[0]);
  PlacedRoundBody round{mesh.file, mesh.name, {}, {}, body, input.bounded->pose};
  round.said = input.bounded->said;
  if (numbers[0] > 0) {
    round.around = numbers[0];
    if (!round.said.empty()) round.said = round.said.with_radius();
  }
  round.core = std::move(input.bounded);
  return {{}, {}, std::move(round)};
}

void require_projected(const PairCall& call, const SpaceInput& a, const SpaceInput& b) {
  if (call.project.empty()) return;
  for (const SpaceInput* input : {&a, &b}) {
    if (input->bounded && input->bounded->object && input->bounded->object->moved) return;
  }
  throw Error(ErrorCode::bad_call, "neither is a polygon given by points of space; leave it out", "--project");
}

PairObject object_of(const PlacedBody& placed) {
  const MeshBody& mesh = placed.mesh;
  const bool is_polygon = placed.object && placed.object->kind == SpaceKind::polygon;
  const char* shape = mesh.shape == io::BodyShape::convex ? ""
                      : placed.is_hull()                  ? is_polygon ? ", hull of the polygon" : ", hull of the mesh"
                                                          : ", hull of the points";
  const std::size_t n = mesh.hull.vertices().size();
  std::string text = fmt::format("{}: {}, {}, {}{}", mesh.name, dimension_name(mesh.hull.dimension()),
                                 n == 1 ? "1 vertex" : fmt::format("{} vertices", n),
                                 count_of(mesh.hull.facet_count(), "facet"), shape);
  Json json = to_json(mesh);
  if (placed.object && placed.object->frame) {
    const solid::Frame& frame = *placed.object->frame;
    json["frame"] = {{"origin", to_json(frame.origin)}, {"u", to_json(frame.u)}, {"v", to_json(frame.v)}};
    if (const auto& moved = placed.object->moved) {
      json["moved_about"] = *moved;
      text += fmt::format("\nprojected on the frame, no vertex by more than about {}", about(*moved));
    }
  }
  const std::string departure = departure_text(mesh);
  if (!departure.empty()) text += "\n" + departure;
  return {.file = mesh.file,
          .name = mesh.name,
          .text = std::move(text),
          .json = std::move(json),
          .vertices = mesh.hull.vertices(),
          .pose = placed.pose.affine(),
          .said = placed.said};
}

PairObject PlacedFlat::object_of(const PairCall& call) const {
  if (call.proves() && !body) {
    throw Error(
        ErrorCode::bad_value,
        fmt::format("no point of the plane was found that is three doubles, which a proof needs; give the plane "
                    "by one, or leave out --certificate"),
        file);
  }
  PairObject result{
      .file = file,
      .name = name,
      .text = {},
      .json = {{"file", file}, {"name", name}, {"format", object.format}, {"shape", io::name_of(object.kind)}},
      .vertices = {},
      .said = said};
  if (const auto* plane = std::get_if<solid::Plane>(&flat)) {
    result.json["normal"] = to_json(plane->normal);
    if (plane->offset == 0) {
      result.json["point"] = to_json(plane->point);
      result.text =
          fmt::format("{}: plane through {}, normal {}", name, exact_text(plane->point), exact_text(plane->normal));
    } else {
      result.json["offset"] = plane->offset;
      result.text = fmt::format("{}: plane, normal {}, offset {}", name, exact_text(plane->normal), plane->offset);
    }
  } else {
    const Point3 &p = object.points[0], &q = object.points[1];
    result.json["points"] = {to_json(p), to_json(q)};
    result.text = object.kind == SpaceKind::ray
                      ? fmt::format("{}: ray from {} through {}", name, exact_text(p), exact_text(q))
                      : fmt::format("{}: line through {} and {}", name, exact_text(p), exact_text(q));
  }
  if (body) {
    result.vertices = body->points;
    result.ways = body->ways;
  }
  return result;
}

}  // namespace sunder::ask

#include <sunder/ask/pair/pair_planar.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/planar/object/convex_either_way.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace sunder::ask {

const char* const planar_pose_forms =
    "tx,ty; or x=..,y=..,angle=.. (radians); or the 6 or 9 numbers of a matrix, row by row";

namespace {

using io::PlanarObject;
using planar::ConvexPolygon;

// "x=1,y=2,angle=0.5", in any order; what is missing is 0.
planar::Pose parse_named_pose(std::string_view text, const std::string& place) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "angle"};
  std::array<std::optional<double>, 3> values;
  const auto refuse = [&](std::string_view part, const char* why) {
    throw Error(ErrorCode::bad_call, fmt::format("{} {}; write x=..,y=..,angle=.. (radians)", io::quote(part), why),
                place);
  };
  for (bool more = true; more;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    more = comma < text.size();
    const std::string_view part = io::trimmed(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
    const std::size_t equals = std::min(part.find('='), part.size());
    const auto name = std::find(names.begin(), names.end(), io::trimmed(part.substr(0, equals)));
    if (equals == part.size() || name == names.end()) refuse(part, "is none of x=.., y=.. and angle=..");
    std::optional<double>& value = values.at(static_cast<std::size_t>(name - names.begin()));
    if (value) refuse(part, "is given a second time");
    value = 0;
    const char* const problem = io::parse_number(io::trimmed(part.substr(equals + 1)), *value);
    if (problem != nullptr) refuse(part, problem);
  }
  return planar::Pose::from_angle(values[2].value_or(0), {values[0].value_or(0), values[1].value_or(0)});
}

planar::Pose parse_planar_pose(const std::string& text, const std::string& place) {
  if (text.empty()) return {};
  if (text.find('=') != std::string::npos) return parse_named_pose(text, place);
  const std::vector<double> n = parse_numbers(text, place);
  try {
    switch (n.size()) {
      case 2: return planar::Pose::from_matrix({1, 0, 0, 1}, {n[0], n[1]});
      case 3:
        throw Error(ErrorCode::bad_call,
                    "three numbers do not say which is the angle; write x=..,y=..,angle=.. (radians)");
      case 9:
        if (n[6] != 0 || n[7] != 0 || n[8] != 1) {
          throw Error(ErrorCode::bad_pose, "the last row of the 3 x 3 matrix is not 0 0 1; give rows, not columns");
        }
        [[fallthrough]];
      case 6: return planar::Pose::from_matrix({n[0], n[1], n[3], n[4]}, {n[2], n[5]});
      default: break;
    }
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), place);
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("a pose of {}; give {}", count_of(n.size(), "number"), planar_pose_forms), place);
}

const PlanarObject& chosen(const io::PlanarFile& file, const PairSide& side, LeftOutList& left_out) {
  const std::string option = side.option("feature");
  const std::string first = io::quote(file.objects.front().name);
  if (side.feature.empty()) {
    left_out.add(side.file, file.left_out, fmt::format("name the object that is asked about by {}", option));
    if (file.objects.size() == 1) return file.objects.front();
    io::fail_file(side.file,
                  fmt::format("has {} objects, {} first; name one by {}", file.objects.size(), first, option));
  }
  const auto found = std::find_if(file.objects.begin(), file.objects.end(),
                                  [&](const PlanarObject& object) { return object.name == side.feature; });
  if (found != file.objects.end()) return *found;
  throw Error(
      ErrorCode::bad_call,
      fmt::format("{} has no feature {}; the first one is {}", io::one_line(side.file), io::quote(side.feature), first),
      option);
}

planar::EitherWay shape_of(const PlanarObject& object, const std::string& path, const PairCall& call) {
  try {
    if (call.hull) return {ConvexPolygon::hull_of(object.vertices)};
    if (call.mend) return {ConvexPolygon::mended(object.vertices)};
    return planar::convex_either_way(object.vertices);
  } catch (const Error& error) {
    const std::string what =
        fmt::format("{}; {}", error.what(), call.mend ? "or give --hull" : "or give --mend, or --hull");
    if (object.line > 0) io::fail_line(path, object.line, what);
    io::fail_file(path, fmt::format("feature {}: {}", io::quote(object.name), what));
  }
}

}  // namespace

PlanarInput read_planar_input(const PairCall& call, const PairSide& side, PairFiles& files) {
  const io::PlanarFile file = io::read_planar_objects(side.file, call.drop_z, files.inputs());
  const std::string shown = io::one_line(side.file);
  for (const std::string& remark : file.remarks) files.talk.note(fmt::format("{}: {}", shown, remark));
  const PlanarObject& object = chosen(file, side, files.left_out);
  io::require_object(object, side.file);
  // What the file does not name is called as the file is.
  const bool unnamed = file.objects.size() == 1 && object.name == "1";
  Said said = said_of_file(object.unbounded() ? Said::Source::shape : Said::Source::vertices, files.read, side.file,
                           file.objects.size() == 1 ? "" : object.name);
  said = said_in(std::array{io::SystemOfFile{object.system, {}}}, std::move(said));
  if (call.drop_z && !said.empty()) said = said.dropped("z");
  const std::string name = unnamed ? io::one_line(std::filesystem::path(side.file).stem().string()) : object.name;
  return {side.file,      shown, name, file.format, object, parse_planar_pose(side.pose, side.option("pose")),
          std::move(said)};
}

PlanarBody planar_body(const PlanarInput& input, const PairCall& call) {
  auto [polygon, reversed] = shape_of(input.object, input.path, call);
  PlanarBody body{std::move(polygon), input.pose, static_cast<std::uint32_t>(input.object.vertices.size()), {}};
  if (reversed) {
    body.remark = fmt::format(
        "{}: the vertices of {} are clockwise and are taken in reverse: vertex k is vertex {} - k of the file",
        input.file, io::quote(input.name), body.given - 1);
  }
  for (const Point2& p : body.polygon.vertices()) body.vertices.push_back({p.x, p.y, 0});
  const std::uint32_t n = body.polygon.size();
  Said said = input.said;
  if (n != body.given && !said.empty()) {
    const std::uint32_t fewer = body.given - n;
    said = call.hull ? said.hull()
                     : said.mended({fewer == 1 ? "1 vertex left out" : fmt::format("{} vertices left out", fewer)});
  }
  const char* const shape = n == 1 ? "point" : n == 2 ? "segment" : "polygon";
  body.object = {
      .file = input.file,
      .name = input.name,
      .text = fmt::format(
          "{}: {}, {}{}", input.name, shape, n == 1 ? "1 vertex" : fmt::format("{} vertices", n),
          n == body.given ? "" : fmt::format(" of {} given ({})", body.given, call.hull ? "hull" : "mended")),
      .json = {{"file", input.file},
               {"name", input.name},
               {"format", input.format},
               {"shape", shape},
               {"vertices", n},
               {"given_vertices", body.given}},
      .vertices = body.vertices,
      .pose = planar::in_space(input.pose.affine()),
      .said = std::move(said)};
  return body;
}

Told PlanarBody::feature(const char* letter, std::uint32_t v, bool is_edge) const {
  if (!is_edge) return {{{"vertex", v}}, fmt::format("vertex {} of {}", v, letter)};
  return {{{"edge", {v, polygon.next(v)}}}, fmt::format("edge {}-{} of {}", v, polygon.next(v), letter)};
}

}  // namespace sunder::ask

#include <sunder/ask/pair/pair_planar_input.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace sunder::ask {

const char* const planar_pose_forms = "tx,ty; or angle,tx,ty (radians); or 6 or 9 numbers of a matrix row by row";

namespace {

using io::PlanarObject;
using planar::ConvexPolygon;
using planar::Pose;

Pose parse_planar_pose(const std::string& text, const std::string& place) {
  if (text.empty()) return {};
  const std::vector<double> n = parse_numbers(text, place);
  try {
    switch (n.size()) {
      case 2: return Pose::from_matrix({1, 0, 0, 1}, {n[0], n[1]});
      case 3: return Pose::from_angle(n[0], {n[1], n[2]});
      case 9:
        if (n[6] != 0 || n[7] != 0 || n[8] != 1) {
          throw Error(ErrorCode::bad_pose, "the last row of the 3 x 3 matrix is not 0 0 1; give rows, not columns");
        }
        [[fallthrough]];
      case 6: return Pose::from_matrix({n[0], n[1], n[3], n[4]}, {n[2], n[5]});
      default: break;
    }
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), place);
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("a pose of {}; give {}", count_of(n.size(), "number"), planar_pose_forms), place);
}

const PlanarObject& chosen(const io::PlanarFile& file, const std::string& path, const std::string& feature,
                           const char* option, LeftOutList& left_out) {
  if (feature.empty()) {
    left_out.add(path, file.left_out, fmt::format("name the object that is asked about by {}", option));
    if (file.objects.size() == 1) return file.objects.front();
    io::fail_file(path, fmt::format("has {} objects, {} first; name one by {}", file.objects.size(),
                                    io::quote(file.objects.front().name), option));
  }
  const auto found =
      std::find_if(file.objects.begin(), file.objects.end(), [&](const PlanarObject& o) { return o.name == feature; });
  if (found != file.objects.end()) return *found;
  throw Error(ErrorCode::bad_call,
              fmt::format("{} has no feature {}; the first one is {}", io::one_line(path), io::quote(feature),
                          io::quote(file.objects.front().name)),
              option);
}

ConvexPolygon shape_of(const PlanarObject& object, const std::string& path, const PairCall& call) {
  try {
    if (call.hull) return ConvexPolygon::hull_of(object.vertices);
    if (call.mend) return ConvexPolygon::mended(object.vertices);
    return ConvexPolygon::from_vertices(object.vertices);
  } catch (const Error& error) {
    const std::string what =
        fmt::format("{}; {}", error.what(), call.mend ? "or give --hull" : "or give --mend, or --hull");
    if (object.line > 0) io::fail_line(path, object.line, what);
    io::fail_file(path, fmt::format("feature {}: {}", io::quote(object.name), what));
  }
}

}  // namespace

PlanarInput read_planar_input(const PairCall& call, bool is_a, LeftOutList& left_out, InputFiles* inputs) {
  const std::string& path = is_a ? call.file_a : call.file_b;
  const io::PlanarFile file = io::read_planar_objects(path, call.drop_z, inputs);
  for (const std::string& remark : file.remarks) note(fmt::format("{}: {}", io::one_line(path), remark));
  PlanarInput out;
  out.path = path;
  out.file = io::one_line(path);
  out.format = file.format;
  out.object =
      chosen(file, path, is_a ? call.feature_a : call.feature_b, is_a ? "--feature-a" : "--feature-b", left_out);
  // What the file does not name is called as the file is.
  const bool unnamed = file.objects.size() == 1 && out.object.name == "1";
  out.name = unnamed ? io::one_line(std::filesystem::path(path).stem().string()) : out.object.name;
  out.pose = parse_planar_pose(is_a ? call.pose_a : call.pose_b, is_a ? "--pose-a" : "--pose-b");
  return out;
}

PlanarBody planar_body(const PlanarInput& input, const PairCall& call) {
  PlanarBody out{input.file,
                 input.name,
                 input.format,
                 static_cast<std::uint32_t>(input.object.vertices.size()),
                 shape_of(input.object, input.path, call),
                 input.pose,
                 {},
                 planar::in_space(input.pose.affine())};
  for (const Point2& p : out.polygon.vertices()) out.vertices.push_back({p.x, p.y, 0});
  return out;
}

std::string text_of(const PlanarBody& body, const PairCall& call) {
  const std::uint32_t n = body.polygon.size();
  return fmt::format(
      "{}: {}, {}{}", body.name, body.shape(), n == 1 ? "1 vertex" : fmt::format("{} vertices", n),
      n == body.given ? "" : fmt::format(" of {} given ({})", body.given, call.hull ? "hull" : "mended"));
}

Json to_json(const PlanarBody& body) {
  return {{"file", body.file},
          {"name", body.name},
          {"format", body.format},
          {"shape", body.shape()},
          {"vertices", body.polygon.size()},
          {"given_vertices", body.given}};
}

std::string about(const Point2& p) { return fmt::format("({}, {})", about(p.x), about(p.y)); }

std::string feature_text(const PlanarBody& body, const char* letter, std::uint32_t v, bool edge) {
  return edge ? fmt::format("edge {}-{} of {}", v, (v + 1) % body.polygon.size(), letter)
              : fmt::format("vertex {} of {}", v, letter);
}

Json feature_json(const PlanarBody& body, std::uint32_t v, bool edge) {
  return edge ? Json{{"edge", {v, (v + 1) % body.polygon.size()}}} : Json{{"vertex", v}};
}

}  // namespace sunder::ask

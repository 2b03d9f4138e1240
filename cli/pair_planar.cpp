#include <cli/common.h>
#include <cli/evidence.h>
#include <cli/pair_picture.h>
#include <cli/pair_planar.h>

#include <sunder/base/error.h>
#include <sunder/certificate/json.h>
#include <sunder/io/file.h>
#include <sunder/io/planar_objects.h>
#include <sunder/io/text.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>
#include <sunder/scene/rounded_evidence.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

namespace sunder::cli {

const char* const planar_pose_forms = "tx,ty; or angle,tx,ty (radians); or 6 or 9 numbers of a matrix row by row";

namespace {

using io::PlanarObject;
using planar::ConvexPolygon;
using planar::Pose;

struct Object {
  std::string file, name, format;
  std::uint32_t given = 0;  // vertices in the file
  ConvexPolygon polygon;
  Pose pose;
  std::vector<Point3> vertices;  // in the plane z = 0, for certificates
  Affine3 pose_in_space;

  PlacedVertices in_space() const { return {vertices, pose_in_space, false}; }
};

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
                           const char* option) {
  if (feature.empty()) {
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

ConvexPolygon shape_of(const PlanarObject& object, const std::string& path, const PlanarPairCall& call) {
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

Object read(const PlanarPairCall& call, bool is_a) {
  const std::string& path = is_a ? call.file_a : call.file_b;
  const io::PlanarFile file = io::read_planar_objects(path, call.drop_z);
  for (const std::string& remark : file.remarks) note(fmt::format("{}: {}", io::one_line(path), remark));
  const PlanarObject& object = chosen(file, path, is_a ? call.feature_a : call.feature_b,  //
                                      is_a ? "--feature-a" : "--feature-b");
  // What the file does not name is called as the file is.
  const bool unnamed = file.objects.size() == 1 && object.name == "1";
  Object out{io::one_line(path),
             unnamed ? io::one_line(std::filesystem::path(path).stem().string()) : object.name,
             file.format,
             static_cast<std::uint32_t>(object.vertices.size()),
             shape_of(object, path, call),
             parse_planar_pose(is_a ? call.pose_a : call.pose_b, is_a ? "--pose-a" : "--pose-b"),
             {},
             {}};
  for (const Point2& p : out.polygon.vertices()) out.vertices.push_back({p.x, p.y, 0});
  out.pose_in_space = planar::in_space(out.pose.affine());
  return out;
}

using Method = PairAnswer (*)(const ConvexPolygon&, const Pose&, const ConvexPolygon&, const Pose&);

Method method_of(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Method>, 6> methods{
      {{"automatic", planar::polygon_polygon},
       {"difference", planar::polygon_polygon_by_difference},
       {"halving", planar::polygon_polygon_by_halving},
       {"triangles", planar::polygon_polygon_by_triangles},
       {"gjk", planar::polygon_polygon_by_gjk},
       {"scan", planar::polygon_polygon_by_scan}}};
  std::string known;
  for (const auto& [known_name, method] : methods) {
    if (name == known_name) return method;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", known_name);
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no method {} for planar objects; choose one of {}", io::quote(name), known),
              "--method");
}

std::string about_2d(const Point3& p) { return fmt::format("({}, {})", about(p.x), about(p.y)); }

const char* kind_name(const ConvexPolygon& p) {
  return p.size() == 1 ? "point" : p.size() == 2 ? "segment" : "polygon";
}

std::string feature_text(const Object& object, const char* letter, std::uint32_t v, bool edge) {
  return edge ? fmt::format("edge {}-{} of {}", v, (v + 1) % object.polygon.size(), letter)
              : fmt::format("vertex {} of {}", v, letter);
}

std::string evidence_text(const PairCertificate& c, const Object& a, const Object& b) {
  if (c.verdict == Verdict::meet) {
    return fmt::format("a common point at about {}, made of {} of A and {} of B",
                       about_2d(scene::rounded_common_point(c, a.in_space(), b.in_space())),
                       c.count_a == 1 ? "1 vertex" : fmt::format("{} vertices", c.count_a), c.count_b);
  }
  const scene::RoundedGap gap = scene::rounded_gap(c, a.in_space(), b.in_space());
  return fmt::format(
      "an empty strip about {} wide across the direction of about {},\nfrom vertex {} of A to vertex {} of B",
      about(gap.width), about_2d(gap.direction), c.extreme_a, c.extreme_b);
}

struct Answers {
  PairAnswer pair;
  Contact contact = Contact::none;
  planar::PolygonDistance distance;
};

std::string human_text(const PlanarPairCall& call, const Object& a, const Object& b, const Answers& answers) {
  const bool meet = answers.pair.meet();
  std::string text =
      fmt::format("{} and {}: {}{}\n", a.file, b.file, meet ? "meet" : "apart",
                  meet && call.classify ? fmt::format(" ({})", name_of(answers.contact)) : std::string());
  const auto line = [&](const char* title, std::string value) {
    if (const std::size_t end = value.find('\n'); end != std::string::npos) value.insert(end + 1, 14, ' ');
    text += fmt::format("  {:<10}  {}\n", title, value);
  };
  for (const Object* o : {&a, &b}) {
    const std::uint32_t n = o->polygon.size();
    line(
        o == &a ? "A" : "B",
        fmt::format("{}: {}, {}{}", o->name, kind_name(o->polygon), n == 1 ? "1 vertex" : fmt::format("{} vertices", n),
                    n == o->given ? "" : fmt::format(" of {} given ({})", o->given, call.hull ? "hull" : "mended")));
  }
  line("evidence", evidence_text(answers.pair.certificate(), a, b));
  if (call.distance) {
    const planar::PolygonDistance& d = answers.distance;
    line("distance", meet
                         ? "0"
                         : fmt::format("about {}, from {} to {}", fmt::format("{:.12g}", d.distance.high),
                                       feature_text(a, "A", d.a, d.edge_of_a), feature_text(b, "B", d.b, d.edge_of_b)));
  }
  line("decided by", decided_text(answers.pair.decided_by));
  const Cost& cost = answers.pair.cost;
  line("cost", fmt::format("{}, {}, {} of exact arithmetic", count_of(cost.probes, "probe"),
                           count_of(cost.iterations, "iteration"), count_of(cost.exact, "use")));
  if (!call.certificate.empty()) line("proof", call.certificate);
  return text;
}

Json evidence_json(const PairCertificate& c, const Object& a, const Object& b) {
  Json json = cli::evidence_json(c, a.in_space(), b.in_space());
  for (const char* key : {"point_about", "direction_about"}) {
    if (json.contains(key)) json[key].erase(2);  // z
  }
  return json;
}

Json report(const PlanarPairCall& call, const Object& a, const Object& b, const Answers& answers) {
  Json json = envelope("pair", answers.pair.meet() ? "meet" : "apart", call.method);
  json["decided_by"] = name_of(answers.pair.decided_by);
  json["cost"] = to_json(answers.pair.cost);
  for (const Object* o : {&a, &b}) {
    json["objects"].push_back({{"file", o->file},
                               {"name", o->name},
                               {"format", o->format},
                               {"shape", kind_name(o->polygon)},
                               {"vertices", o->polygon.size()},
                               {"given_vertices", o->given}});
  }
  if (call.classify) json["contact"] = name_of(answers.contact);
  if (call.distance) {
    const planar::PolygonDistance& d = answers.distance;
    json["distance"] = {{"low", d.distance.low}, {"high", d.distance.high}};
    if (!d.meet()) {
      const auto feature = [](const Object& o, std::uint32_t v, bool edge) {
        return edge ? Json{{"edge", {v, (v + 1) % o.polygon.size()}}} : Json{{"vertex", v}};
      };
      json["distance"]["a"] = feature(a, d.a, d.edge_of_a);
      json["distance"]["b"] = feature(b, d.b, d.edge_of_b);
    }
  }
  json["evidence"] = evidence_json(answers.pair.certificate(), a, b);
  return json;
}

std::string certificate_text(const Object& a, const Object& b, const PairCertificate& evidence) {
  CertificateWriter writer;
  const std::uint32_t body_a = writer.add_body(a.name, a.vertices), body_b = writer.add_body(b.name, b.vertices);
  const std::uint32_t placed_a = writer.add_placed(a.name, body_a, a.pose_in_space);
  const std::uint32_t placed_b = writer.add_placed(b.name, body_b, b.pose_in_space);
  writer.add_pair(placed_a, placed_b, evidence);
  return writer.text();
}

}  // namespace

int run_planar_pair(const PlanarPairCall& call) {
  for (const std::string& file : {call.file_a, call.file_b}) {
    if (io::is_planar(file)) continue;
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is not planar (WKT, GeoJSON, CSV), the other one is; give two of one kind",
                            io::quote(io::one_line(file))));
  }
  if (call.hull && call.mend) throw Error(ErrorCode::bad_call, "give --mend or --hull, not both", "--mend");
  const Method method = method_of(call.method);
  const Object a = read(call, true), b = read(call, false);
  Answers answers;
  answers.pair = method(a.polygon, a.pose, b.polygon, b.pose);
  if (call.classify) answers.contact = planar::polygon_polygon_contact(a.polygon, a.pose, b.polygon, b.pose);
  if (call.distance) answers.distance = planar::polygon_polygon_distance(a.polygon, a.pose, b.polygon, b.pose);
  if (!call.certificate.empty()) {
    io::write_file_atomically(call.certificate, certificate_text(a, b, answers.pair.certificate()));
  }
  if (!call.svg.empty()) {
    io::write_file_atomically(call.svg, pair_svg({a.polygon, a.pose, a.name}, {b.polygon, b.pose, b.name}, call.title));
  }
  print(call.json ? to_text(report(call, a, b, answers)) : human_text(call, a, b, answers));
  return answers.pair.meet() ? exit_code::yes : exit_code::no;
}

}  // namespace sunder::cli

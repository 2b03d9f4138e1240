#include <sunder/base/names.h>
#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/json_internal.h>
#include <sunder/io/text/json_shapes_internal.h>
#include <sunder/io/text/text.h>
#include <sunder/solid/object/flatness.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sunder::io {

namespace {

using nlohmann::json;
using SpaceKind = SpaceObject::Kind;

constexpr std::array kinds{SpaceKind::point,   SpaceKind::segment,  SpaceKind::polygon, SpaceKind::box,
                           SpaceKind::line,    SpaceKind::ray,      SpaceKind::plane,   SpaceKind::ball,
                           SpaceKind::capsule, SpaceKind::cylinder, SpaceKind::cone,    SpaceKind::ellipsoid};

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::string_view without_mark(std::string_view text) {
  return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

// -0 is 0.
Point3 point_of(double x, double y, double z) { return {x + 0.0, y + 0.0, z + 0.0}; }

// ---- What is the same in all formats.

// Each vertex to the point of the plane nearest to it: by the normal equations, in doubles.
void project_on(const solid::Frame& frame, SpaceObject& polygon) {
  const auto dot = [](const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
  const auto &u = frame.u, &v = frame.v;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  double most = 0;
  for (Point3& p : polygon.points) {
    const Point3 d{p.x - frame.origin.x, p.y - frame.origin.y, p.z - frame.origin.z};
    const double s = (dot(d, u) * vv - dot(d, v) * uv) / determinant;
    const double t = (dot(d, v) * uu - dot(d, u) * uv) / determinant;
    const Point3 off{d.x - (s * u.x + t * v.x), d.y - (s * u.y + t * v.y), d.z - (s * u.z + t * v.z)};
    most = std::max(most, std::sqrt(dot(off, off)));
    p = point_of(s, t, 0);
  }
  polygon.frame = frame;
  polygon.moved = most;
}

// What is read, and where: fail(what) throws Error bad_file with that place.
template <class Fail>
SpaceObject checked(SpaceKind kind, std::vector<Point3> points, const solid::Frame* project, const Fail& fail) {
  SpaceObject object{kind, {}, std::move(points), {}, {}, {}, {}};
  if ((kind == SpaceKind::line || kind == SpaceKind::ray) && object.points[0] == object.points[1]) {
    fail(fmt::format("the two points of this {} are equal; give two different ones", name_of(kind)));
  }
  if (kind == SpaceKind::segment && object.points[0] == object.points[1]) {
    object.kind = SpaceKind::point;
    object.points.pop_back();
  }
  if (kind != SpaceKind::polygon) return object;
  if (object.points.size() > 1 && object.points.front() == object.points.back()) object.points.pop_back();
  if (object.points.size() < 3) {
    fail(fmt::format("a polygon has three vertices or more; this one has {}; give a point or a segment",
                     object.points.size()));
  }
  if (project != nullptr) {
    project_on(*project, object);
    for (const Point3& p : object.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) fail("projected on the frame it is too large for doubles");
    }
    return object;
  }
  const solid::Flatness flat = solid::flatness(object.points);
  if (flat.is_flat) return object;
  const auto& [i, j, k] = flat.plane;
  fail(
      fmt::format("the polygon is not exactly planar: vertex {} is about {:.3g} off the plane of vertices {}, {} and "
                  "{} (counted from 0); give it in a frame, by origin, u, v and vertices, or give --project",
                  flat.off, flat.distance, i, j, k));
  return object;
}

// ---- JSON.

class JsonObject : JsonShapes {
 public:
  JsonObject(std::string_view place, const solid::Frame* project)
      : JsonShapes(place), place_(place), project_(project) {}

  SpaceObject read(std::string_view text) const {
    const json top = parse_json(text, place_);
    if (!top.is_object()) fail_file(place_, fmt::format("is no object of space: {}", expected()));
    for (const std::string_view of_scene : {"bodies", "rounded", "points", "mesh"}) {
      if (!top.contains(std::string(of_scene))) continue;
      fail_file(place_, of_scene == "bodies"
                            ? "this is a scene of several bodies, and sunder pair takes one; name it by --body-a or "
                              "--body-b, or ask sunder scene"
                            : fmt::format("{} is a shape of scene files, which sunder pair does not read; give the "
                                          "body as a mesh, or put both into a scene file and ask sunder scene",
                                          quote(of_scene)));
    }
    if (top.size() != 1) {
      fail_file(place_,
                fmt::format("has {} keys; {}", top.size(), top.empty() ? expected() : "give one object a file"));
    }
    const auto [key, value] = *top.items().begin();
    for (const SpaceKind kind : kinds) {
      if (key != name_of(kind)) continue;
      SpaceObject object = read(kind, value);
      object.format = "JSON";
      return object;
    }
    fail_file(place_, fmt::format("{} is no object of space: {}", quote(key), expected()));
  }

 private:
  static std::string expected() {
    return "give one of {\"plane\": ..}, line, ray, segment, point, polygon, box, ball, capsule, cylinder, cone and "
           "ellipsoid (GeoJSON has a \"type\")";
  }

  SpaceObject read(SpaceKind kind, const json& value) const {
    const std::string where(name_of(kind));
    if (kind == SpaceKind::plane) return plane(value);
    if (kind > SpaceKind::plane) return round(kind, value);
    if (kind == SpaceKind::box) {
      const std::array<Point3, 8> corners = box_corners(box_size(value, where));
      return {kind, {}, {corners.begin(), corners.end()}, {}, {}, {}, {}};
    }
    if (kind == SpaceKind::polygon && value.is_object()) return framed(value);
    const std::size_t least = kind == SpaceKind::point ? 1 : kind == SpaceKind::polygon ? 0 : 2;
    std::vector<Point3> found;
    if (kind == SpaceKind::point) {
      found.push_back(point(value, where));
    } else {
      if (least > 0 && value.is_array() && value.size() != least) {
        fail(where, fmt::format("has {}; give two, each [x, y, z]", count_of(value.size(), "point")));
      }
      found = points(value, where);
    }
    return checked(kind, std::move(found), project_, [&](const std::string& what) { fail(where, what); });
  }

  SpaceObject plane(const json& value) const {
    const json& normal = member(value, "plane", "normal", {"normal", "point", "offset"});
    const bool has_point = value.contains("point");
    if (has_point == value.contains("offset")) {
      fail("plane", has_point ? "has both \"point\" and \"offset\"; leave one out"
                              : "has neither \"point\", one of its points, nor \"offset\"; give one");
    }
    SpaceObject object{SpaceKind::plane, {}, {}, {}, {}, {}, {}};
    const Point3 across = point(normal, "plane.normal");
    if (across == Point3{}) fail("plane.normal", "is zero; give a direction across the plane");
    object.plane = has_point ? solid::Plane::through(point(value["point"], "plane.point"), across)
                             : solid::Plane::at(across, number(value["offset"], "plane.offset"));
    return object;
  }

  SpaceObject round(SpaceKind kind, const json& value) const {
    SpaceObject object{kind, {}, {}, {}, {}, {}, {}};
    object.round = round_body(name_of(kind), value, std::string(name_of(kind)));
    return object;
  }

  SpaceObject framed(const json& value) const {
    const Keys keys{"origin", "u", "v", "vertices"};
    std::array<Point3, 3> frame;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string key(*(keys.begin() + k));
      frame[k] = point(member(value, "polygon", key, keys), "polygon." + key);
    }
    const json& list = member(value, "polygon", "vertices", keys);
    if (!list.is_array()) fail("polygon.vertices", "is no list of vertices, each [s, t]");
    std::vector<Point3> vertices;
    for (const json& p : list) {
      const std::string where = fmt::format("polygon.vertices[{}]", vertices.size());
      const std::array<double, 2> st = numbers<2>(p, where, "[s, t]");
      vertices.push_back(point_of(st[0], st[1], 0));
    }
    SpaceObject object = checked(SpaceKind::polygon, std::move(vertices), nullptr,
                                 [&](const std::string& what) { fail("polygon.vertices", what); });
    try {
      object.frame = solid::Frame::of(frame[0], frame[1], frame[2]);
    } catch (const Error& error) {
      fail("polygon", error.what());
    }
    return object;
  }

  std::string_view place_;
  const solid::Frame* project_;
};

// ---- WKT.

class WktText {
 public:
  explicit WktText(std::string_view text) : text_(text) {}

  // The next parenthesis, comma or word; empty at the end.
  std::string_view next() {
    skip_blanks();
    if (at_ == text_.size()) return {};
    const std::size_t begin = at_;
    if (is_mark(text_[at_])) {
      ++at_;
    } else {
      while (at_ < text_.size() && !is_mark(text_[at_]) && !is_blank(text_[at_])) ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }
  std::size_t line() const { return line_; }  // of what next() gave

 private:
  static bool is_mark(char c) { return c == '(' || c == ')' || c == ','; }
  static bool is_blank(char c) { return c == '\n' || blanks.find(c) != std::string_view::npos; }
  void skip_blanks() {
    for (; at_ < text_.size() && is_blank(text_[at_]); ++at_) {
      const bool is_break = text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_, 2) != "\r\n");
      if (is_break) ++line_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

// What the first words name, in small letters: "polygon", "z"; without a second word "" where points follow at once.
std::pair<std::string, std::string> kind_and_dimension(WktText& text) {
  std::string kind = in_small_letters(text.next().substr(0, 40));
  for (const std::string_view joined : {"pointz", "linestringz", "polygonz"}) {
    if (kind == joined) return {kind.substr(0, kind.size() - 1), "z"};
  }
  const std::string_view second = text.next();
  return {kind, second == "(" ? "" : in_small_letters(second.substr(0, 40))};
}

class Wkt {
 public:
  Wkt(std::string_view text, std::string_view place, const solid::Frame* project)
      : text_(text), place_(place), project_(project) {}

  SpaceObject read() {
    const auto [word, dimension] = kind_and_dimension(text_);
    const std::size_t line = text_.line();
    if (dimension != "z") fail(fmt::format("{} stands where Z is expected", quote(dimension)));
    const bool is_point = word == "point", is_polygon = word == "polygon";
    if (!is_point && !is_polygon && word != "linestring") {
      fail(fmt::format("{} is not read here; give POINT Z, LINESTRING Z of two points, or POLYGON Z", quote(word)));
    }
    if (is_polygon) expect("(");
    std::vector<Point3> points = points_of();
    if (is_polygon) {
      const std::string_view end = text_.next();
      if (end == ",") fail("the polygon has holes, or several rings; give one ring");
      if (end != ")") fail_expected(")", end);
      if (points.size() < 2 || points.front() != points.back()) {
        fail("the ring is not closed; repeat its first point at its end");
      }
    } else if (points.size() != (is_point ? 1 : 2)) {
      fail(is_point ? "a point has one position" : "a LINESTRING Z has two points here; give a segment");
    }
    if (const std::string_view more = text_.next(); !more.empty()) {
      fail(fmt::format("{} stands behind the first object; give one a file", quote(more)));
    }
    const SpaceKind kind = is_point ? SpaceKind::point : is_polygon ? SpaceKind::polygon : SpaceKind::segment;
    SpaceObject object =
        checked(kind, std::move(points), project_, [&](const std::string& what) { fail_line(place_, line, what); });
    object.format = "WKT";
    return object;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail_line(place_, text_.line(), what); }
  [[noreturn]] void fail_expected(std::string_view mark, std::string_view found) const {
    fail(found.empty() ? fmt::format("ends where {} is expected", quote(mark))
                       : fmt::format("{} stands where {} is expected", quote(found), quote(mark)));
  }
  void expect(std::string_view mark) {
    const std::string_view found = text_.next();
    if (found != mark) fail_expected(mark, found);
  }

  // The points between parentheses.
  std::vector<Point3> points_of() {
    expect("(");
    std::vector<Point3> points;
    std::vector<double> x;
    while (true) {
      const std::string_view word = text_.next();
      if (word == "," || word == ")") {
        if (x.size() != 3) fail(fmt::format("a point of {}; give three, x y z", count_of(x.size(), "number")));
        points.push_back(point_of(x[0], x[1], x[2]));
        x.clear();
        if (word == ")") return points;
        continue;
      }
      if (word.empty() || word == "(") fail_expected(")", word);
      double value = 0;
      if (const char* problem = parse_number(word, value)) fail(fmt::format("{} {}", quote(word), problem));
      x.push_back(value);
    }
  }

  WktText text_;
  std::string_view place_;
  const solid::Frame* project_;
};

bool is_json(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\f\v\n");
  return begin != std::string_view::npos && text[begin] == '{';
}

}  // namespace

std::string_view name_of(SpaceObject::Kind kind) {
  return name_in<SpaceKind::ellipsoid>({"point", "segment", "polygon", "box", "line", "ray", "plane", "ball", "capsule",
                                        "cylinder", "cone", "ellipsoid"},
                                       kind);
}

std::array<Point3, 8> box_corners(const std::array<double, 3>& size) {
  std::array<Point3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = {(i & 1 ? 0.5 : -0.5) * size[0] + 0.0, (i & 2 ? 0.5 : -0.5) * size[1] + 0.0,
                  (i & 4 ? 0.5 : -0.5) * size[2] + 0.0};
  }
  return corners;
}

bool is_space_text(std::string_view text) {
  text = without_mark(text);
  if (is_json(text)) return text.find("\"type\"") == std::string_view::npos;
  WktText words(text);
  const auto [kind, dimension] = kind_and_dimension(words);
  return dimension == "z";
}

bool is_space_file(const std::filesystem::path& path) {
  const std::string ending = ending_of(path.string());
  if ((ending != ".json" && ending != ".wkt") || !is_file(path)) return false;
  return is_space_text(read_file(path));
}

SpaceObject parse_space_object(std::string_view text, std::string_view place, const solid::Frame* project) {
  text = without_mark(text);
  return is_json(text) ? JsonObject(place, project).read(text) : Wkt(text, place, project).read();
}

Mesh mesh_of(const SpaceObject& object) {
  Mesh mesh;
  mesh.vertices = object.points;
  mesh.format = object.format;
  mesh.parts.push_back({});
  if (object.kind != SpaceKind::polygon) return mesh;
  for (std::uint32_t k = 0; k < object.points.size(); ++k) mesh.polygon_vertices.push_back(k);
  mesh.polygon_begin.push_back(static_cast<std::uint32_t>(object.points.size()));
  return mesh;
}

}  // namespace sunder::io

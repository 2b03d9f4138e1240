// sunder section FILE --plane P: what a body and planes have in common, as polygons.
#include <sunder/ask/objects.h>
#include <sunder/ask/question.h>
#include <sunder/ask/said_of.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/plane_text.h>
#include <sunder/io/mesh/section_text.h>
#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/text/file.h>
#include <sunder/picture/plane.h>
#include <sunder/solid/section/polyhedron_plane_section.h>
#include <sunder/solid/section/section_area.h>
#include <sunder/solid/section/section_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using solid::Plane;
using solid::PlaneSection;
using solid::SectionCorner;
using solid::SectionKind;

struct SectionCall : QuestionCall {
  std::string file, pose, out;
  std::vector<std::string> planes;
  bool require_convex = false, leave_out = false;
};

void sections_by_scan(const solid::ConvexPolyhedron& body, const solid::Pose& pose, const Plane& plane,
                      std::span<const double> offsets, const solid::SectionVisitor& visit) {
  Plane at = plane;
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    at.offset = offsets[k];
    visit(k, polyhedron_plane_section_by_scan(body, pose, at));
  }
}

using SectionMethod = void(const solid::ConvexPolyhedron&, const solid::Pose&, const Plane&, std::span<const double>,
                           const solid::SectionVisitor&);
constexpr std::array<Named<SectionMethod>, 2> section_methods{
    {SUNDER_METHOD("automatic", solid::polyhedron_plane_sections),
     {"scan", sections_by_scan, "solid::polyhedron_plane_section_by_scan"}}};

struct Planes {
  io::PlaneStack stack;
  std::string file;  // that has the plane; empty: none
};

// Twice the vector of the area.
Point3 area_vector(const std::vector<Point3>& corners) {
  Point3 sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Point3 &o = corners[0], &a = corners[k], &b = corners[k + 1];
    const Point3 u{a.x - o.x, a.y - o.y, a.z - o.z}, v{b.x - o.x, b.y - o.y, b.z - o.z};
    sum = {sum.x + u.y * v.z - u.z * v.y, sum.y + u.z * v.x - u.x * v.z, sum.z + u.x * v.y - u.y * v.x};
  }
  return sum;
}

double length_of(const Point3& v) { return std::hypot(v.x, v.y, v.z); }

double area_of(const std::vector<Point3>& corners) { return length_of(area_vector(corners)) / 2; }

struct SectionResult {
  Plane plane;
  std::string name;  // "z = 0.5"
  PlaneSection section;
  std::vector<Point3> corners;            // rounded
  std::optional<solid::AreaBounds> area;  // of a proof

  double area_about() const { return is_measured() ? area->middle() : area_of(corners); }
  bool is_polygon() const { return section.kind == SectionKind::polygon; }
  bool is_measured() const { return is_polygon() && area && std::isfinite(area->high); }
};

// Two directions along a plane, of length 1, counter-clockwise seen from where the normal points to.
std::array<Point3, 2> along(const Point3& normal) {
  const double most = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  Point3 n{normal.x / most, normal.y / most, normal.z / most};
  const double length = length_of(n);
  n = {n.x / length, n.y / length, n.z / length};
  const double size_x = std::fabs(n.x), size_y = std::fabs(n.y), size_z = std::fabs(n.z);
  // Of a normal along an axis they are the next two axes.
  Point3 u = size_z >= size_x && size_z >= size_y ? Point3{1, 0, 0}
             : size_x >= size_y                   ? Point3{0, 1, 0}
                                                  : Point3{0, 0, 1};
  const double part = u.x * n.x + u.y * n.y + u.z * n.z;
  u = {u.x - part * n.x, u.y - part * n.y, u.z - part * n.z};
  const double size = length_of(u);
  u = {u.x / size, u.y / size, u.z / size};
  return {u, {n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x}};
}

class SectionQuestion {
 public:
  static constexpr const char *verb = "section", *drawn_noun = "plane";

  SectionQuestion(const SectionCall& asked, Talk& told)
      : call(asked), talk(told), method_(method_by(asked.method, section_methods)) {
    if (!call.out.empty()) format_ = io::section_format_of_name(call.out);
    for (const std::string& text : call.planes) add_planes(text);
    if (!call.pose.empty()) pose_ = parse_pose(call.pose, "--pose");
    body_ = io::read_body(call.file, call.require_convex, left_out_, call.proves() ? &inputs_ : nullptr);
    note_hulls(talk, {&*body_});
  }

  std::uint64_t drawn() const {
    std::uint64_t sum = 0;
    for (const Planes& planes : stacks_) sum += planes.stack.offsets.size();
    return sum;
  }

  void ask() {
    for (const Planes& planes : stacks_) {
      const io::PlaneStack& stack = planes.stack;
      solid::SectionPoints points(body_->hull, pose_, stack.plane);
      method_(body_->hull, pose_, stack.plane, stack.offsets, [&](std::size_t k, const PlaneSection& section) {
        const double offset = stack.offsets[k];
        Plane plane = stack.plane;
        plane.offset = offset;
        SectionResult result{plane, title_of(planes, offset), section, {}, {}};
        points.set_offset(offset);
        for (const SectionCorner& corner : section.corners) result.corners.push_back(points.nearest(corner));
        if (call.proves()) result.area = section_area(section, points, plane.normal);
        cost_.probes += section.cost.probes;
        cost_.exact += section.cost.exact;
        results_.push_back(std::move(result));
      });
    }
    if (!call.out.empty()) talk.write_file(call.out, text_of_sections());
  }

  std::string certificate() const {
    return claims_text(origin_of(talk, inputs_, left_out_.texts()), [&](ClaimsWriter& file) {
      file.say(said_of_mesh(*body_, inputs_, left_out_));
      solid::SectionClaims claims(file, body_->name, body_->hull, pose_);
      for (const SectionResult& result : results_) claims.add(result.plane, result.section);
    });
  }

  // Each seen from where its normal points to.
  std::string picture() const {
    std::vector<std::vector<Point2>> shapes;
    std::vector<Point2> seen;
    for (const SectionResult& result : results_) {
      const auto [u, v] = along(result.plane.normal);
      shapes.emplace_back();
      for (const Point3& p : result.corners) {
        shapes.back().push_back({p.x * u.x + p.y * u.y + p.z * u.z, p.x * v.x + p.y * v.y + p.z * v.z});
        seen.push_back(shapes.back().back());
      }
    }
    if (seen.empty()) seen.push_back({0, 0});
    picture::PlanePicture drawing(seen);
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      drawing.named(results_[k].name, [&] {
        if (shapes[k].size() == 2) drawing.segment(shapes[k][0], shapes[k][1], picture::Ink::bold);
        if (shapes[k].size() == 1 || shapes[k].size() > 2) drawing.polygon(shapes[k], picture::Ink::bold);
      });
    }
    const std::string what = io::one_line(body_->name);
    return drawing.text(
        call.title_or("What do " + what + " and " + count_of(results_.size(), "plane") + " have in common?"),
        answer_text() + left_out_.clause() + (is_of_hull() ? fmt::format("; said of {}", hull_text) : ""));
  }

  Report report() const {
    Report report{.answer = met() > 0 ? "some" : "none", .code = met() > 0 ? exit_code::yes : exit_code::no};
    report.function = method_.function;
    report.cost = cost_;
    report.cost_text = fmt::format("{}, {}", count_of(cost_.probes, "probe"), count_of(cost_.exact, "exact sign"));
    report.objects.push_back(to_json(*body_));
    const auto is_too_great = [](const SectionResult& result) {
      return result.is_polygon() && result.area && !result.is_measured();
    };
    if (std::any_of(results_.begin(), results_.end(), is_too_great)) {
      report.not_proved = {"the area, which is beyond doubles"};
    }
    report.tell(fmt::format("{}: {}{}\n", body_->file, answer_text(), left_out_.clause()));
    report.add("said_of", is_of_hull() ? "hulls" : "bodies");
    report.add(facts_of(left_out_));
    report.add("count", met());
    Json sections = Json::array();
    for (const SectionResult& result : results_) sections.push_back(section_json(result));
    report.add("sections", std::move(sections), first_of(results_.size(), 10, [&](std::size_t k) {
                 return titled(results_[k].name, told(results_[k]));
               }));
    if (is_of_hull()) report.tell(titled("said of", hull_text));
    report.add("out", call.out.empty() ? Json(nullptr) : Json(call.out), file_line("written", call.out));
    return report;
  }

  const SectionCall& call;
  Talk& talk;

 private:
  static constexpr const char* hull_text = "the hull of the mesh, which is not convex";

  bool is_of_hull() const { return body_->shape == io::BodyShape::hull; }

  // As parse_planes has it, or a file with a plane.
  void add_planes(const std::string& text) {
    if (!std::string_view(text).ends_with(".json")) {
      stacks_.push_back({io::parse_planes(text, "--plane"), ""});
      return;
    }
    const io::SpaceObject object =
        io::parse_space_object(io::read_file(text, call.proves() ? &inputs_ : nullptr), text);
    if (object.kind != io::SpaceObject::Kind::plane) {
      throw Error(ErrorCode::bad_file, fmt::format("is a {}; give a plane", name_of(object.kind)), io::one_line(text));
    }
    stacks_.push_back({{object.plane, {object.plane.offset}, ""}, io::one_line(text)});
  }

  static std::string title_of(const Planes& planes, double offset) {
    if (!planes.file.empty()) return planes.file;
    if (planes.stack.name.size() == 1) return fmt::format("{} = {}", planes.stack.name, offset);
    const Point3& n = planes.stack.plane.normal;
    return fmt::format("{} x + {} y + {} z = {}", n.x, n.y, n.z, offset);
  }

  std::size_t met() const {
    return static_cast<std::size_t>(std::count_if(results_.begin(), results_.end(), [](const SectionResult& result) {
      return result.section.kind != SectionKind::nothing;
    }));
  }

  std::string answer_text() const {
    return results_.size() == 1 ? std::string(met() > 0 ? "the plane meets it" : "the plane does not meet it")
                                : fmt::format("{} of {} meet it", met(), count_of(results_.size(), "plane"));
  }

  static std::string told(const SectionResult& result) {
    const PlaneSection& section = result.section;
    switch (section.kind) {
      case SectionKind::nothing:
        return fmt::format("nothing: all is {} the plane", section.side == Sign::positive ? "above" : "below");
      case SectionKind::point: return "a point, " + about(result.corners[0]);
      case SectionKind::segment:
        return fmt::format("a segment, {} to {}", about(result.corners[0]), about(result.corners[1]));
      case SectionKind::polygon: break;
    }
    return fmt::format("a polygon of {} corners, area about {}", section.corners.size(), about(result.area_about()));
  }

  static Json section_json(const SectionResult& result) {
    const PlaneSection& section = result.section;
    Json json = {{"normal", to_json(result.plane.normal)},
                 {"offset", result.plane.offset},
                 {"kind", name_of(section.kind)},
                 {"side", section.kind != SectionKind::nothing ? Json(nullptr)
                          : section.side == Sign::positive     ? Json("above")
                                                               : Json("below")},
                 {"area_about", result.area_about()},
                 {"corners", Json::array()}};
    if (result.is_measured()) json["area_bounds"] = Json::array({result.area->low, result.area->high});
    if (result.plane.point != Point3{}) json["through"] = to_json(result.plane.point);
    for (std::size_t k = 0; k < section.corners.size(); ++k) {
      const SectionCorner& corner = section.corners[k];
      Json told;
      if (corner.is_vertex()) {
        told["vertex"] = corner.above;
      } else {
        told["edge"] = Json::array({corner.above, corner.below});
      }
      told["point"] = to_json(result.corners[k]);
      json["corners"].push_back(std::move(told));
    }
    return json;
  }

  std::string text_of_sections() const {
    std::vector<io::SectionText> texts;
    for (const SectionResult& result : results_) texts.push_back({result.name, result.corners});
    return io::to_text(format_, texts);
  }

  Named<SectionMethod> method_;
  io::SectionFormat format_ = io::SectionFormat::obj;
  std::vector<Planes> stacks_;
  solid::Pose pose_;
  LeftOutList left_out_{call.leave_out};
  InputFiles inputs_;
  std::optional<MeshBody> body_;

  std::vector<SectionResult> results_;
  Cost cost_;
};

Report run(const SectionCall& call, Talk& talk) { return answer(SectionQuestion(call, talk), talk); }

}  // namespace

Verb section_verb() {
  const auto call = std::make_shared<SectionCall>();
  return {
      "section",
      "Cut a convex body with planes: each section is a point, a segment or a convex polygon.",
      "0 no plane meets the body; 1 some do",
      {{"FILE", &call->file, "a mesh or a set of points: OBJ, STL, PLY, OFF, DAE, glTF, WRL, 3MF", "", true},
       {.name = "--plane",
        .value = &call->planes,
        .help = fmt::format("{}; or a .json file with a plane, as for sunder pair", io::plane_forms),
        .type = "PLANES",
        .required = true},
       {"--pose", &call->pose, fmt::format("the pose of the body (default: as in its file): {}", pose_forms), "POSE"},
       {"-o,--out", &call->out, "write the sections to FILE: .obj or .wkt", "FILE"},
       {"--method", &call->method, method_names(section_methods), "NAME"},
       {"--require-convex", &call->require_convex,
        "refuse a mesh that is not exactly convex (default: replace it by its convex hull)"},
       {"--leave-out", &call->leave_out, leave_out_help},
       {"--svg", &call->svg, "draw the sections to FILE, each seen against the direction of its plane's normal",
        "FILE"},
       title_option(call->title),
       svg_limit_option(call->svg_limit),
       certificate_option(call->certificate),
       json_option(call->json)},
      [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask

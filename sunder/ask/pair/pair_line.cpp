#include <sunder/ask/pair/pair_mixed.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>

#include <fmt/format.h>

#include <array>
#include <string>
#include <variant>

namespace sunder::ask {

namespace {

using solid::ConvexPolyhedron;
using solid::CutAlong;
using solid::CutEnd;
using solid::CutFeature;
using solid::CutPlace;
using solid::LineLike;
using solid::PolyhedronCut;
using solid::Pose;

Told feature_told(const CutFeature& at, const ConvexPolyhedron& body, const char* letter) {
  switch (at.place) {
    case CutPlace::vertex: return surface_part(body, std::array{at.feature}, letter);
    case CutPlace::edge: return surface_part(body, std::array{at.feature, at.other}, letter);
    case CutPlace::facet: return surface_part(body, body.facet(at.feature).first(3), letter);  // told by three vertices
    case CutPlace::inside: break;
  }
  return {{{"inside", true}}, fmt::format("inside {}", letter)};
}

// What a line, a ray or a segment through a and b has in common with the body.
Told cut_told(const PolyhedronCut& cut, const PlacedBody& body, const char* letter, const Point3& a, const Point3& b) {
  const ConvexPolyhedron& hull = body.mesh.hull;
  const CutKind kind = kind_of(cut);
  Told told{{{"kind", name_of(kind)}},
            kind == CutKind::nothing ? "nothing"
            : kind == CutKind::point ? "one point, "
                                     : "a segment, "};
  if (const auto* along = std::get_if<CutAlong>(&cut.evidence)) {
    const Told surface = feature_told(along->surface, hull, letter);
    told.json["surface"] = surface.json;
    told.text = fmt::format("a part of {}, ", surface.text);
  }
  const auto ends = ends_of(cut.evidence);
  if (!ends) return told;
  const auto end = [&](const CutEnd& at) {
    const solid::ExactEnd exact = exact_end(hull, body.pose, a, b, at);
    const Point3 p = exact.rounded();
    return end_told(feature_told(at.at, hull, letter), to_json(p), about(p), exact.along_line, at.own, "its");
  };
  add_ends(end(ends->first), end(ends->last), kind, told);
  return told;
}

using LineMethod = PolyhedronCut(const ConvexPolyhedron&, const Pose&, const LineLike&);

template <class Like, PolyhedronCut (*method)(const ConvexPolyhedron&, const Pose&, const Like&)>
PolyhedronCut of(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other) {
  return method(body, pose, std::get<Like>(other));
}

constexpr std::array<Named<LineMethod>, 3> line_methods{
    {{"automatic", of<solid::Line, solid::polyhedron_line>, "solid::polyhedron_line"},
     {"drums", of<solid::Line, solid::polyhedron_line_by_drums>, "solid::polyhedron_line_by_drums"},
     {"scan", of<solid::Line, solid::polyhedron_line_by_scan>, "solid::polyhedron_line_by_scan"}}};
constexpr std::array<Named<LineMethod>, 3> ray_methods{
    {{"automatic", of<solid::Ray, solid::polyhedron_ray>, "solid::polyhedron_ray"},
     {"drums", of<solid::Ray, solid::polyhedron_ray_by_drums>, "solid::polyhedron_ray_by_drums"},
     {"scan", of<solid::Ray, solid::polyhedron_ray_by_scan>, "solid::polyhedron_ray_by_scan"}}};

// The methods that option --support can name.
using SupportMethod = solid::LineSupport(const ConvexPolyhedron&, const Pose&, const solid::Line&);
constexpr std::array<Named<SupportMethod>, 4> support_methods{
    {SUNDER_METHOD("automatic", solid::polyhedron_line_support),
     SUNDER_METHOD("drums", solid::polyhedron_line_support_by_drums),
     SUNDER_METHOD("hierarchy", solid::polyhedron_line_support_by_hierarchy),
     SUNDER_METHOD("scan", solid::polyhedron_line_support_by_scan)}};

LineLike line_like(const solid::Flat& flat) {
  if (const auto* ray = std::get_if<solid::Ray>(&flat)) return *ray;
  return std::get<solid::Line>(flat);
}

class LinePair : public MixedPair {
 public:
  LinePair(const PairCall& asked, const PlacedBody& body, const PlacedFlat& line, bool body_is_a,
           const PairFiles& files)
      : MixedPair(asked, object_of(body), line.object_of(asked), body_is_a, files),
        body_(body),
        line_(line),
        other_(line_like(line.flat)),
        method_(asked.support
                    ? line_methods[0]
                    : method_by(asked.method, std::holds_alternative<solid::Ray>(other_) ? ray_methods : line_methods,
                                " (with a line or a ray)")) {
    if (!asked.support) return;
    support_method_ = method_by(asked.method, support_methods, " (with --support)");
    require_support();
  }

  void ask() {
    function_ = method_.function;
    cut_ = method_(body_.mesh.hull, body_.pose, other_);
    const bool is_by_signs = cut_.decided_by != DecidedBy::scan && cut_.decided_by != DecidedBy::finishing;
    take(cut_, is_by_signs ? signs_text(cut_.decided_by) : decided_text(cut_.decided_by));
    contact_ = contact_of(body_.mesh.hull, other_, cut_);
    tell_said_of(body_.is_hull());
    const auto& points = line_.object.points;
    facts_.push_back(fact_of("common", cut_told(cut_, body_, letter(), points[0], points[1])));
    state([this](auto& pairs, auto body, auto line) {
      const bool is_own = call.method != "automatic";  // only the front door names evidence
      const PolyhedronCut proved = is_own ? polyhedron_line_like(body_.mesh.hull, body_.pose, other_) : cut_;
      add_claims(pairs, body, line, body_.mesh.hull, body_.pose, other_, proved, call.classify);
    });
    if (call.support) ask_support();
  }

 private:
  void require_support() const {
    if (!std::holds_alternative<solid::Line>(other_)) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("{} is a ray; give a line, by two of its points", io::quote(io::one_line(line_.file))),
                  "--support");
    }
    const int dimension = body_.mesh.hull.dimension();
    if (dimension == 3) return;
    constexpr std::array kinds{"a point", "a segment", "a flat polygon"};
    throw Error(ErrorCode::bad_shape,
                fmt::format("{} is {}, without an inside; give a body with an inside",
                            io::quote(io::one_line(body_.mesh.file)), kinds[static_cast<std::size_t>(dimension)]),
                "--support");
  }

  void ask_support() {
    const solid::Line& line = std::get<solid::Line>(other_);
    function_ = support_method_.function;
    support_ = support_method_(body_.mesh.hull, body_.pose, line);
    const solid::LineSupport::Evidence& evidence = support_.evidence;
    Told told{{{"kind", name_of(evidence)}, {"planes", Json::array()}}, std::string(name_of(evidence))};
    if (const auto* range = std::get_if<solid::SupportRange>(&evidence)) {
      const Told at = feature_told(range->at, body_.mesh.hull, letter());
      told.json["at"] = at.json;
      told.text += ", around " + at.text;
    }
    for (const solid::SupportPlane& plane : planes_of(evidence)) {
      const Told touched = feature_told(plane.touches, body_.mesh.hull, letter());
      told.json["planes"].push_back(touched.json);
      told.json["planes"].back()["through"] = plane.through;
      told.text += fmt::format("\n{} {}", "touching", touched.text);
    }
    told.json["decided_by"] = name_of(support_.decided_by);
    facts_.push_back(fact_of("support", std::move(told)));
    cost_.probes += support_.cost.probes;
    cost_.iterations += support_.cost.iterations;
    cost_.exact += support_.cost.exact;
    state([this, &line](auto& pairs, auto body, auto of_line) {
      const bool is_scan = support_.decided_by == DecidedBy::scan;  // which names no cut
      const solid::LineSupport proved = is_scan ? polyhedron_line_support(body_.mesh.hull, body_.pose, line) : support_;
      add_support(pairs, body, of_line, body_.mesh.hull, body_.pose, line, proved);
    });
  }

  const PlacedBody& body_;
  const PlacedFlat& line_;
  LineLike other_;
  Named<LineMethod> method_;
  Named<SupportMethod> support_method_{};
  PolyhedronCut cut_;
  solid::LineSupport support_;
};

}  // namespace

std::optional<SegmentCut> segment_cut(const PlacedBody& body, const char* letter, const PlacedBody& segment) {
  if (!segment.object || segment.object->kind != io::SpaceObject::Kind::segment) return std::nullopt;
  const auto a = exact_image(segment.pose, segment.object->points[0]);
  const auto b = exact_image(segment.pose, segment.object->points[1]);
  if (!a || !b) return std::nullopt;
  const solid::Segment placed = solid::Segment::between(*a, *b);
  PolyhedronCut cut = polyhedron_segment(body.mesh.hull, body.pose, placed);
  return SegmentCut{placed, cut, cut_told(cut, body, letter, *a, *b)};
}

Report run_line_pair(const PairCall& call, const PlacedBody& body, const PlacedFlat& line, bool body_is_a,
                     const PairFiles& files) {
  return answer(LinePair(call, body, line, body_is_a, files), files.talk);
}

std::string line_method_names() { return method_names(line_methods); }
std::string support_method_names() { return method_names(support_methods); }

}  // namespace sunder::ask

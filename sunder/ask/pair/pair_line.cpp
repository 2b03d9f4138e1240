#include <sunder/ask/pair/pair_space.h>

#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

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

// As a fraction where that is short.
std::string short_text(const ExactFraction& t) {
  const std::string text = fraction_text(t.numerator, t.denominator);
  return text.size() <= 20 ? text : "about " + about(t.nearest());
}

// What is told of the ends of a common part.
class CutTeller {
 public:
  CutTeller(const PolyhedronCut& cut, const PlacedBody& body, const char* letter, const Point3& a, const Point3& b)
      : cut_(cut), body_(body), letter_(letter), a_(a), b_(b) {}

  Json json() const {
    Json json{{"kind", name_of(kind_of(cut_))}};
    const auto ends = ends_of(cut_.evidence);
    if (!ends) return json;
    if (const auto* along = std::get_if<CutAlong>(&cut_.evidence)) json["surface"] = feature_json(along->surface);
    json["first"] = end_json(ends->first);
    json["last"] = end_json(ends->last);
    return json;
  }

  std::string text() const {
    const auto ends = ends_of(cut_.evidence);
    if (!ends) return "nothing";
    if (kind_of(cut_) == CutKind::point) return "one point, " + end_text(ends->first);
    const auto* along = std::get_if<CutAlong>(&cut_.evidence);
    const std::string what = along != nullptr ? "a part of " + feature_text(along->surface) : "a segment";
    return fmt::format("{}, from {}\nto {}", what, end_text(ends->first), end_text(ends->last));
  }

 private:
  solid::ExactEnd exact(const CutEnd& end) const { return exact_end(body_.mesh.hull, body_.pose, a_, b_, end); }

  // A facet is told by three of its vertices.
  std::array<std::uint32_t, 3> corners(std::uint32_t facet) const {
    const auto cycle = body_.mesh.hull.facet(facet);
    return {cycle[0], cycle[1], cycle[2]};
  }

  Json feature_json(const CutFeature& at) const {
    switch (at.place) {
      case CutPlace::vertex: return {{"vertex", at.feature}};
      case CutPlace::edge: return {{"edge", {at.feature, at.other}}};
      case CutPlace::facet: return {{"facet", corners(at.feature)}};
      case CutPlace::inside: break;
    }
    return {{"inside", true}};
  }
  std::string feature_text(const CutFeature& at) const {
    switch (at.place) {
      case CutPlace::vertex: return fmt::format("vertex {} of {}", at.feature, letter_);
      case CutPlace::edge: return fmt::format("edge {}-{} of {}", at.feature, at.other, letter_);
      case CutPlace::facet: {
        const auto [i, j, k] = corners(at.feature);
        return fmt::format("facet {}-{}-{} of {}", i, j, k, letter_);
      }
      case CutPlace::inside: break;
    }
    return fmt::format("inside {}", letter_);
  }

  Json end_json(const CutEnd& end) const {
    const solid::ExactEnd e = exact(end);
    Json json{{"point", to_json(e.rounded())},
              {"along_line", fraction_text(e.along_line.numerator, e.along_line.denominator)}};
    json.update(feature_json(end.at));
    if (end.own == OwnEnd::a) json["beginning"] = true;
    if (end.own == OwnEnd::b) json["end"] = true;
    return json;
  }
  std::string end_text(const CutEnd& end) const {
    const solid::ExactEnd e = exact(end);
    const char* own = end.own == OwnEnd::a ? "its beginning at " : end.own == OwnEnd::b ? "its end at " : "";
    std::string text = fmt::format("{}about {}, {}", own, about(e.rounded()), feature_text(end.at));
    return end.own == OwnEnd::none ? text + ", t = " + short_text(e.along_line) : text;
  }

  const PolyhedronCut& cut_;
  const PlacedBody& body_;
  const char* letter_;
  const Point3 &a_, &b_;
};

using LineMethod = PolyhedronCut(const ConvexPolyhedron&, const Pose&, const LineLike&);

PolyhedronCut by_scan(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other) {
  if (const auto* ray = std::get_if<solid::Ray>(&other)) return solid::polyhedron_ray_by_scan(body, pose, *ray);
  return solid::polyhedron_line_by_scan(body, pose, std::get<solid::Line>(other));
}

PolyhedronCut by_drums(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other) {
  if (const auto* ray = std::get_if<solid::Ray>(&other)) return solid::polyhedron_ray_by_drums(body, pose, *ray);
  return solid::polyhedron_line_by_drums(body, pose, std::get<solid::Line>(other));
}

constexpr std::array<Named<LineMethod>, 3> line_methods{
    {{"automatic", solid::polyhedron_line_like}, {"drums", by_drums}, {"scan", by_scan}}};

LineLike line_like(const solid::Flat& flat) {
  if (const auto* ray = std::get_if<solid::Ray>(&flat)) return *ray;
  return std::get<solid::Line>(flat);
}

class LinePair : public PairQuestion {
 public:
  LinePair(const PairCall& asked, const PlacedBody& body, const PlacedFlat& line, bool body_is_a,
           const PairFiles& files)
      : PairQuestion(asked, body_is_a ? object_of(body) : line.object_of(asked),
                     body_is_a ? line.object_of(asked) : object_of(body), files),
        method_(method_by(asked.method, line_methods, " (with a line or a ray)")),
        body_(body),
        line_(line),
        other_(line_like(line.flat)),
        body_is_a_(body_is_a) {
    is_b_first_ = !body_is_a;  // the body is the first of the file
  }

  void ask() {
    cut_ = method_(body_.mesh.hull, body_.pose, other_);
    take(cut_, cut_.decided_by == DecidedBy::scan        ? decided_text(DecidedBy::scan)
               : cut_.decided_by == DecidedBy::finishing ? decided_text(DecidedBy::finishing)
               : cut_.decided_by == DecidedBy::filter    ? "signs, by floating-point filters alone"
                                                         : "signs, with the help of exact arithmetic");
    contact_ = contact_of(body_.mesh.hull, other_, cut_);
    if (meet_ && body_.is_hull()) verdict_ = "meet as hulls";
    CutTold told = cut_told(cut_, body_, body_is_a_ ? "A" : "B", line_.object.points[0], line_.object.points[1]);
    facts_ = {{"said_of", meet_ && body_.is_hull() ? "hulls" : "bodies", ""},
              {"common", std::move(told.json), std::move(told.text)}};
    state([this](auto& pairs, auto body, auto line) {
      const bool is_own = call.method != "automatic";  // only the front door names evidence
      const PolyhedronCut proved = is_own ? polyhedron_line_like(body_.mesh.hull, body_.pose, other_) : cut_;
      add_claims(pairs, body, line, body_.mesh.hull, body_.pose, other_, proved, call.classify);
    });
  }

 private:
  LineMethod* method_;
  const PlacedBody& body_;
  const PlacedFlat& line_;
  LineLike other_;
  bool body_is_a_;
  PolyhedronCut cut_;
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

CutTold cut_told(const PolyhedronCut& cut, const PlacedBody& body, const char* letter, const Point3& a,
                 const Point3& b) {
  const CutTeller teller(cut, body, letter, a, b);
  return {teller.json(), teller.text()};
}

Report run_line_pair(const PairCall& call, const PlacedBody& body, const PlacedFlat& line, bool body_is_a,
                     const PairFiles& files) {
  return answer(LinePair(call, body, line, body_is_a, files), files.talk);
}

std::string line_method_names() { return method_names(line_methods); }

}  // namespace sunder::ask

#include <sunder/ask/pair/pair_mixed.h>
#include <sunder/ask/pair/pair_planar.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/pair.h>
#include <sunder/planar/pair/polygon_unbounded.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

using planar::Place;
using Ends = CutEnds<planar::CutEnd>;
using PlanarKind = io::PlanarObject::Kind;

using UnboundedMethod = planar::PolygonCommon(const planar::ConvexPolygon&, const planar::Pose&,
                                              const planar::Unbounded&);

// The functions that planar::polygon_unbounded asks, of each kind.
constexpr std::array<Named<UnboundedMethod>, 3> planar_line_methods{
    {{"automatic", planar::polygon_unbounded, "planar::polygon_line"},
     {"scan", planar::polygon_unbounded_by_scan, "planar::polygon_line_by_scan"},
     {"fibonacci", planar::polygon_unbounded_by_fibonacci, "planar::polygon_line_by_fibonacci"}}};
constexpr std::array<Named<UnboundedMethod>, 2> planar_ray_methods{
    {{"automatic", planar::polygon_unbounded, "planar::polygon_ray"},
     {"scan", planar::polygon_unbounded_by_scan, "planar::polygon_ray_by_scan"}}};
constexpr std::array<Named<UnboundedMethod>, 2> half_plane_methods{
    {{"automatic", planar::polygon_unbounded, "planar::polygon_half_plane"},
     {"scan", planar::polygon_unbounded_by_scan, "planar::polygon_half_plane_by_scan"}}};

Named<UnboundedMethod> method_of(const std::string& name, PlanarKind kind) {
  const std::span<const Named<UnboundedMethod>> all =
      kind == PlanarKind::line  ? std::span<const Named<UnboundedMethod>>(planar_line_methods)
      : kind == PlanarKind::ray ? std::span<const Named<UnboundedMethod>>(planar_ray_methods)
                                : std::span<const Named<UnboundedMethod>>(half_plane_methods);
  return method_by(name, all, fmt::format(", with a {}", io::name_of(kind)));
}

// In the world, exactly.
planar::Line placed(const PlanarInput& input, const PairSide& side) {
  planar::Line line{input.object.vertices[0], input.object.vertices[1]};
  if (input.pose.is_identity()) return line;
  const std::string_view kind = io::name_of(input.object.kind);
  for (Point2* p : {&line.a, &line.b}) {
    const std::optional<Point2> image = planar::exact_image(input.pose, *p);
    if (!image) {
      throw Error(
          ErrorCode::bad_pose,
          fmt::format("the image of the point ({}, {}) of the {} is no pair of doubles, and is not rounded; give "
                      "the {} in its place, or a pose for the other object",
                      p->x, p->y, kind, kind),
          side.option("pose"));
    }
    *p = *image;
  }
  if (input.object.kind == PlanarKind::half_plane && input.pose.reflects()) std::swap(line.a, line.b);
  return line;
}

planar::Unbounded unbounded_of(PlanarKind kind, const planar::Line& line) {
  if (kind == PlanarKind::line) return planar::Line::through(line.a, line.b);
  if (kind == PlanarKind::ray) return planar::Ray::from(line.a, line.b);
  return planar::HalfPlane::left_of(line.a, line.b);
}

PairObject object_of(const PlanarInput& input, const planar::Line& line, const planar::UnboundedBody& body) {
  const auto point = [](const Point2& p) { return fmt::format("({}, {})", p.x, p.y); };
  const PlanarKind kind = input.object.kind;
  const char* form = kind == PlanarKind::line  ? "{}: line through {} and {}"
                     : kind == PlanarKind::ray ? "{}: ray from {} through {}"
                                               : "{}: half-plane to the left of the way from {} to {}";
  return {.file = input.file,
          .name = input.name,
          .text = fmt::format(fmt::runtime(form), input.name, point(line.a), point(line.b)),
          .json = {{"file", input.file},
                   {"name", input.name},
                   {"format", input.format},
                   {"shape", io::name_of(kind)},
                   {"points", {{line.a.x, line.a.y}, {line.b.x, line.b.y}}}},
          .vertices = body.points,
          .ways = body.ways,
          .said = input.said};
}

// A bounded object and an unbounded one, of which either is A.
struct Mixed {
  Mixed(const PairCall& call, const PlanarInput& a, const PlanarInput& b)
      : body_is_a(!a.object.unbounded()),
        other(body_is_a ? b : a),
        method(method_of(call.method, other.object.kind)),
        body(planar_body(body_is_a ? a : b, call)),
        line(placed(other, body_is_a ? call.b : call.a)),
        unbounded(unbounded_of(other.object.kind, line)),
        in_space(planar::body_of(unbounded)),
        object(object_of(other, line, in_space)) {}

  bool body_is_a;
  const PlanarInput& other;
  Named<UnboundedMethod> method;
  PlanarBody body;
  planar::Line line;
  planar::Unbounded unbounded;
  planar::UnboundedBody in_space;
  PairObject object;
};

class UnboundedPair : public MixedPair {
 public:
  UnboundedPair(const PairCall& asked, const Mixed& mixed, const PairFiles& files)
      : MixedPair(asked, mixed.body.object, mixed.object, mixed.body_is_a, files, Space::planar), mixed_(mixed) {
    if (!body_.remark.empty()) files.talk.note(body_.remark);
  }

  std::uint64_t drawn() const { return std::uint64_t{body_.given} + 2; }

  void ask() {
    function_ = mixed_.method.function;
    common_ = mixed_.method(body_.polygon, body_.pose, mixed_.unbounded);
    take(common_, signs_text(common_.decided_by));
    contact_ = contact_of(body_.polygon, mixed_.unbounded, common_);
    told_ = told();
    facts_.push_back(fact_of("common", told_));
    if (meet_ && kind_ == PlanarKind::half_plane) not_proved_.emplace_back("the common part");
    state([this](auto& pairs, auto body, auto other) {
      add_claims(pairs, body, other, body_.polygon, body_.pose, mixed_.unbounded, common_, call.classify);
    });
  }

  std::string picture() const {
    const auto& [a, b] = mixed_.line;
    picture::CutPicture picture{{body_.polygon, body_.pose, body_.object.name, body_.object.text},
                                kind_,
                                a,
                                b,
                                mixed_.object.name,
                                mixed_.body_is_a,
                                {},
                                told_.text,
                                call.title,
                                files_.left_out.clause()};
    if (const std::optional<Ends> ends = ends_of(common_.evidence)) {
      picture.marks = {exact(ends->first).rounded(), exact(ends->last).rounded()};
    }
    return picture::cut_svg(picture);
  }

 private:
  std::string vertex(std::uint32_t v) const { return body_.feature(letter(), v, false).text; }
  planar::ExactEnd exact(const planar::CutEnd& end) const {
    return planar::exact_end(body_.polygon, body_.pose, mixed_.line.a, mixed_.line.b, end);
  }

  Told end(const planar::CutEnd& at) const {
    const planar::ExactEnd e = exact(at);
    const Point2 p = e.rounded();
    Told place{{{"inside", true}}, fmt::format("inside {}", letter())};
    if (at.place != Place::inside) place = body_.feature(letter(), at.feature, at.place == Place::edge);
    if (at.place == Place::edge) {
      place.json["along_edge"] = e.along_edge.text();
    }
    return end_told(std::move(place), {p.x, p.y}, about(p), e.along_line, at.own, "the ray's");
  }

  // What it is; where it has ends, before these.
  std::string words(const planar::BesideLine& beside) const {
    return kind_ == PlanarKind::line ? fmt::format("nothing; {} is nearest to the line", vertex(beside.nearest))
                                     : "nothing";
  }
  std::string words(const planar::BeyondEnd&) const { return "nothing"; }
  std::string words(const planar::BesideHalfPlane& beside) const {
    return fmt::format("nothing; {} is nearest to it", vertex(beside.nearest));
  }
  std::string words(const planar::CutPoint&) const { return "one point, "; }
  std::string words(const planar::CutAlong& along) const {
    const bool all = along.first.place == Place::vertex && along.last.place == Place::vertex;
    return fmt::format("{}{}, ", all ? "" : "a part of ", body_.feature(letter(), along.edge, true).text);
  }
  std::string words(const planar::CutAcross&) const { return "a segment, "; }
  std::string words(const planar::PartWithin&) const {
    return body_.polygon.size() > 2 ? "a part, cut off " : "a part, ";
  }
  std::string words(const planar::WholeWithin& whole) const {
    return fmt::format("all of {}; {} is furthest within", letter(), vertex(whole.furthest));
  }

  Told told() const {
    const planar::PolygonCommon::Evidence& evidence = common_.evidence;
    Told told{{{"kind", name_of(kind_of(common_))}},
              std::visit([this](const auto& common) { return words(common); }, evidence)};
    if (kind_ == PlanarKind::half_plane) {
      told.json[meet_ ? "furthest" : "nearest"] = furthest_of(common_);
    } else if (const auto* beside = std::get_if<planar::BesideLine>(&evidence); beside && kind_ == PlanarKind::line) {
      told.json["nearest"] = beside->nearest;
    }
    const std::optional<Ends> ends = ends_of(evidence);
    if (!ends) return told;
    if (const auto* along = std::get_if<planar::CutAlong>(&evidence)) {
      told.json.update(body_.feature(letter(), along->edge, true).json);
    }
    const Told first = end(ends->first);
    Told last = end(ends->last);
    const auto* part = std::get_if<planar::PartWithin>(&evidence);
    if (part != nullptr && body_.polygon.size() == 2) last.text = vertex(part->furthest);
    add_ends(first, last, kind_of(common_), told);
    return told;
  }

  const Mixed& mixed_;
  const PlanarBody& body_ = mixed_.body;
  const PlanarKind kind_ = mixed_.other.object.kind;
  planar::PolygonCommon common_;
  Told told_;
};

}  // namespace

Report run_unbounded_pair(const PairCall& call, const PlanarInput& a, const PlanarInput& b, const PairFiles& files) {
  if (a.object.unbounded() && b.object.unbounded()) {
    throw Error(ErrorCode::bad_call,
                fmt::format("A is a {} and B a {}; one of them must be bounded: give a point, a segment or a polygon",
                            io::name_of(a.object.kind), io::name_of(b.object.kind)));
  }
  require_pair_fit(call, {pair_kind::planar_lines});
  const Mixed mixed(call, a, b);
  files.talk.note_all(files.systems.remarks());
  return answer(UnboundedPair(call, mixed, files), files.talk);
}

std::string planar_line_method_names() { return method_names(planar_line_methods); }

}  // namespace sunder::ask

#include <sunder/ask/pair/pair_unbounded.h>
#include <sunder/ask/pair/unbounded_certificate.h>
#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>
#include <sunder/picture/pair.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_ray.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

using io::PlanarObject;
using planar::CutEnd;
using planar::CutKind;
using planar::OwnEnd;
using planar::Place;
using planar::PolygonCut;
using planar::Pose;
using Kind = PlanarObject::Kind;

// What the body has in common with the unbounded object.
enum class CommonKind : std::uint8_t {
  nothing,
  point,
  along,   // a part of an edge
  across,  // a segment through the inside
  part,    // of a half-plane: what its line cuts off
  whole,   // of a half-plane: all of the body
};

static_assert(static_cast<int>(CommonKind::across) == static_cast<int>(CutKind::across));

std::string_view name_of(CommonKind kind) {
  static constexpr std::array<std::string_view, 6> names{"nothing", "point", "along", "across", "part", "whole"};
  return names[static_cast<std::size_t>(kind)];
}

struct Common {
  CommonKind kind = CommonKind::nothing;
  PolygonCut cut;             // by the line or ray; by the half-plane's line
  std::uint32_t witness = 0;  // of a half-plane: the vertex furthest into it, or nearest to it
  Contact contact = Contact::none;
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;

  bool meet() const { return kind != CommonKind::nothing; }
};

struct Question {
  const PlanarBody& body;
  const Unbounded& unbounded;
  bool body_is_a = true;

  const char* letter() const { return body_is_a ? "A" : "B"; }
};

enum class Method : std::uint8_t { automatic, fibonacci, scan };

Method method_of(const std::string& name, Kind kind) {
  if (name == "automatic") return Method::automatic;
  if (name == "scan") return Method::scan;
  if (name == "fibonacci" && kind == Kind::line) return Method::fibonacci;
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no method {} where one object is a {}; choose one of automatic, {}scan",
                          io::quote(name), io::name_of(kind), kind == Kind::line ? "fibonacci, " : ""),
              "--method");
}

PolygonCut cut_by_line(const PlanarBody& body, const Unbounded& u, Method method) {
  const planar::Line line = planar::Line::through(u.a, u.b);
  switch (method) {
    case Method::automatic: return planar::polygon_line(body.polygon, body.pose, line);
    case Method::fibonacci: return planar::polygon_line_by_fibonacci(body.polygon, body.pose, line);
    case Method::scan: return planar::polygon_line_by_scan(body.polygon, body.pose, line);
  }
  return {};
}

Common common_with_half_plane(const PlanarBody& body, const Unbounded& u, Method method) {
  const planar::HalfPlane half_plane = planar::HalfPlane::left_of(u.a, u.b);
  const planar::PolygonHalfPlane half = method == Method::scan
                                            ? planar::polygon_half_plane_by_scan(body.polygon, body.pose, half_plane)
                                            : planar::polygon_half_plane(body.polygon, body.pose, half_plane);
  Common common;
  common.cut = cut_by_line(body, u, method);
  common.witness = half.witness;
  if (half.touching) {
    common.kind = common.cut.kind == CutKind::along ? CommonKind::along : CommonKind::point;
  } else if (half.meet) {
    // The line goes through the body's inside, where it is not all on one side.
    const bool cut_off =
        common.cut.kind == CutKind::across || (common.cut.meet() && common.cut.first.place == Place::edge);
    common.kind = cut_off ? CommonKind::part : CommonKind::whole;
  }
  common.contact = !half.meet ? Contact::none : half.touching ? Contact::touching : Contact::overlapping;
  common.decided_by = std::max(half.decided_by, common.cut.decided_by);
  common.cost = common.cut.cost;
  common.cost.probes += half.cost.probes;
  common.cost.iterations += half.cost.iterations;
  common.cost.exact += half.cost.exact;
  return common;
}

Common common_of(const PlanarBody& body, const Unbounded& u, Method method) {
  if (u.kind == Kind::half_plane) return common_with_half_plane(body, u, method);
  Common common;
  if (u.kind == Kind::line) {
    common.cut = cut_by_line(body, u, method);
  } else {
    const planar::Ray ray = planar::Ray::from(u.a, u.b);
    common.cut = method == Method::scan ? planar::polygon_ray_by_scan(body.polygon, body.pose, ray)
                                        : planar::polygon_ray(body.polygon, body.pose, ray);
  }
  common.kind = static_cast<CommonKind>(common.cut.kind);  // the first four are the same
  common.contact = contact_of(common.cut, body.polygon.size());
  common.decided_by = common.cut.decided_by;
  common.cost = common.cut.cost;
  return common;
}

planar::ExactEnd exact_end(const Question& q, const CutEnd& end) {
  return planar::exact_end(q.body.polygon, q.body.pose, q.unbounded.a, q.unbounded.b, end);
}

std::string exact_text(const planar::ExactFraction& t) { return fraction_text(t.numerator, t.denominator); }

// As a fraction where that is short.
std::string short_text(const planar::ExactFraction& t) {
  const std::string text = exact_text(t);
  return text.size() <= 20 ? text : "about " + about(t.nearest());
}

std::string end_text(const Question& q, const CutEnd& end) {
  const planar::ExactEnd e = exact_end(q, end);
  const std::string place = end.place == Place::inside
                                ? fmt::format("inside {}", q.letter())
                                : feature_text(q.body, q.letter(), end.feature, end.place == Place::edge);
  if (end.own == OwnEnd::a) return fmt::format("the ray's beginning at about {}, {}", about(e.rounded()), place);
  return fmt::format("about {}, {}, t = {}", about(e.rounded()), place, short_text(e.along_line));
}

std::string common_text(const Question& q, const Common& common) {
  const PolygonCut& cut = common.cut;
  const std::uint32_t n = q.body.polygon.size();
  const auto vertex = [&](std::uint32_t v) { return feature_text(q.body, q.letter(), v, false); };
  const auto ends = [&] { return fmt::format("from {}\nto {}", end_text(q, cut.first), end_text(q, cut.last)); };
  switch (common.kind) {
    case CommonKind::nothing:
      return q.unbounded.kind == Kind::line ? fmt::format("nothing; {} is nearest to the line", vertex(cut.nearest))
             : q.unbounded.kind == Kind::half_plane
                 ? fmt::format("nothing; {} is nearest to it", vertex(common.witness))
                 : "nothing";
    case CommonKind::point: return "one point, " + end_text(q, cut.first);
    case CommonKind::along: {
      const bool all = cut.first.place == Place::vertex && cut.last.place == Place::vertex;
      return fmt::format("{}{}, {}", all ? "" : "a part of ", feature_text(q.body, q.letter(), cut.edge, true), ends());
    }
    case CommonKind::across: return "a segment, " + ends();
    case CommonKind::part:
      return n == 2 ? fmt::format("a part, from {}\nto {}", end_text(q, cut.first), vertex(common.witness))
                    : fmt::format("a part, cut off {}", ends());
    case CommonKind::whole: return fmt::format("all of {}; {} is furthest within", q.letter(), vertex(common.witness));
  }
  return "";
}

std::string text_of(const Unbounded& u) {
  const auto point = [](const Point2& p) { return fmt::format("({}, {})", p.x, p.y); };
  const char* form = u.kind == Kind::line  ? "{}: line through {} and {}"
                     : u.kind == Kind::ray ? "{}: ray from {} through {}"
                                           : "{}: half-plane to the left of the way from {} to {}";
  return fmt::format(fmt::runtime(form), u.name, point(u.a), point(u.b));
}

Json end_json(const Question& q, const CutEnd& end) {
  const planar::ExactEnd e = exact_end(q, end);
  const Point2 p = e.rounded();
  Json json{{"point", {p.x, p.y}}, {"along_line", exact_text(e.along_line)}};
  if (end.place == Place::inside) {
    json["inside"] = true;
  } else {
    json.update(feature_json(q.body, end.feature, end.place == Place::edge));
    if (end.place == Place::edge) json["along_edge"] = exact_text(e.along_edge);
  }
  if (end.own == OwnEnd::a) json["beginning"] = true;
  return json;
}

Json common_json(const Question& q, const Common& common) {
  Json json{{"kind", name_of(common.kind)}};
  if (q.unbounded.kind == Kind::half_plane) {
    json[common.meet() ? "furthest" : "nearest"] = common.witness;
  } else if (q.unbounded.kind == Kind::line && !common.meet()) {
    json["nearest"] = common.cut.nearest;
  }
  if (common.kind == CommonKind::nothing || common.kind == CommonKind::whole) return json;
  if (common.kind == CommonKind::along) json.update(feature_json(q.body, common.cut.edge, true));
  json["first"] = end_json(q, common.cut.first);
  json["last"] = end_json(q, common.cut.last);
  return json;
}

// In the world, exactly.
Unbounded placed(const PlanarInput& input, const char* option) {
  Unbounded out{input.object.kind, input.object.vertices[0], input.object.vertices[1], input.name};
  if (input.pose.is_identity()) return out;
  for (Point2* p : {&out.a, &out.b}) {
    const std::optional<Point2> image = exact_image(input.pose, *p);
    if (!image) {
      throw Error(
          ErrorCode::bad_pose,
          fmt::format("the image of the point ({}, {}) of the {} is no pair of doubles, and is not rounded; give "
                      "the {} in its place, or a pose for the other object",
                      p->x, p->y, io::name_of(out.kind), io::name_of(out.kind)),
          option);
    }
    *p = *image;
  }
  if (out.kind == Kind::half_plane && input.pose.reflects()) std::swap(out.a, out.b);
  return out;
}

class UnboundedPair : public PairQuestion {
 public:
  UnboundedPair(const PairCall& asked, const PlanarInput& a, const PlanarInput& b, const LeftOutList& left_out,
                Origin origin)
      : PairQuestion(asked, left_out, std::move(origin)),
        a_(a),
        b_(b),
        body_is_a_(!a.object.unbounded()),
        method_(method_of(asked.method, other().object.kind)),
        body_(planar_body(body_is_a_ ? a : b, asked)),
        unbounded_(placed(other(), body_is_a_ ? "--pose-b" : "--pose-a")) {}

  std::uint64_t drawn() const { return std::uint64_t{body_.given} + 2; }

  void ask() {
    common_ = common_of(body_, unbounded_, method_);
    meet_ = common_.meet();
    contact_ = common_.contact;
    decided_by_ = common_.decided_by;
    cost_ = common_.cost;
  }
  bool yes() const { return meet_; }

  std::string certificate() const {
    const bool is_ray = unbounded_.kind == Kind::ray;
    const PolygonCut line = is_ray ? cut_by_line(body_, unbounded_, Method::automatic) : common_.cut;
    return certificate_of_unbounded(body_, unbounded_,
                                    {common_.contact, call.classify, common_.cut, line, common_.witness}, origin_);
  }
  std::string picture() const {
    const auto& [kind, a, b, name] = unbounded_;
    picture::CutPicture picture{
        {body_.polygon, body_.pose, body_.name}, kind, a, b, name, body_is_a_, {}, {}, call.title};
    if (common_.cut.meet() && common_.kind != CommonKind::whole) {
      picture.marks = {exact_end(question(), common_.cut.first).rounded(),
                       exact_end(question(), common_.cut.last).rounded()};
    }
    picture.said = common_text(question(), common_);
    return picture::cut_svg(picture);
  }

  std::string text() const {
    const std::string body = ask::text_of(body_, call), unbounded = text_of(unbounded_);
    return head(a_.file, b_.file, answer()) + titled("A", body_is_a_ ? body : unbounded) +
           titled("B", body_is_a_ ? unbounded : body) + titled("common", common_text(question(), common_)) +
           titled("decided by", decided_by_ == DecidedBy::filter ? "signs, by floating-point filters alone"
                                                                 : "signs, with the help of exact arithmetic");
  }
  void add_to(Json& json) const {
    const Json body = to_json(body_),
               unbounded{{"file", other().file},
                         {"name", unbounded_.name},
                         {"format", other().format},
                         {"shape", io::name_of(unbounded_.kind)},
                         {"points", {{unbounded_.a.x, unbounded_.a.y}, {unbounded_.b.x, unbounded_.b.y}}}};
    add_head(json, body_is_a_ ? body : unbounded, body_is_a_ ? unbounded : body);
    json["common"] = common_json(question(), common_);
  }

 private:
  const PlanarInput& other() const { return body_is_a_ ? b_ : a_; }
  Question question() const { return {body_, unbounded_, body_is_a_}; }

  const PlanarInput &a_, &b_;
  bool body_is_a_;
  Method method_;
  PlanarBody body_;
  Unbounded unbounded_;
  Common common_;
};

}  // namespace

int run_unbounded_pair(const PairCall& call, const PlanarInput& a, const PlanarInput& b, const LeftOutList& left_out,
                       Origin origin) {
  if (a.object.unbounded() && b.object.unbounded()) {
    throw Error(ErrorCode::bad_call,
                fmt::format("A is a {} and B a {}; one of them must be bounded: give a point, a segment or a polygon",
                            io::name_of(a.object.kind), io::name_of(b.object.kind)));
  }
  if (call.distance || !call.clearance.empty()) {
    throw Error(ErrorCode::bad_call, "is for points, segments and polygons; leave it out, or give a segment",
                call.distance ? "--distance" : "--clearance");
  }
  UnboundedPair question(call, a, b, left_out, std::move(origin));
  return answer(question);
}

}  // namespace sunder::ask

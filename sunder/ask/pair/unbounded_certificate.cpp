#include <sunder/ask/pair/unbounded_certificate.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/predicate/stages.h>

#include <array>
#include <cmath>
#include <vector>

namespace sunder::ask {

namespace {

using Kind = io::PlanarObject::Kind;
using planar::CutEnd;
using planar::CutKind;
using planar::ExactEnd;
using planar::OwnEnd;
using planar::Place;
using planar::Pose;
using Exact = Vector2<Dyadic>;

Exact along(const Unbounded& u) { return lift<ExactStage>(u.b) - lift<ExactStage>(u.a); }

Exact left_of(const Exact& d) { return {-d.y, d.x}; }

// ---- Directions: no point of the body is further along than any of the other.

// The body is on one side of the line, and not all on it.
Exact across_line(const PlanarBody& body, const Unbounded& u) {
  Exact left = left_of(along(u));
  const Exact a = lift<ExactStage>(u.a);
  for (std::uint32_t v = 0; v < body.polygon.size(); ++v) {
    const ExactPoint2 p = planar::exact_vertex(body.polygon, body.pose, v);
    const Sign side = dot(left, Exact{p.x, p.y} - a).sign();
    if (side != Sign::zero) return side == Sign::negative ? left : Exact{-left.x, -left.y};
  }
  return left;
}

// Where the line leaves the body, seen along it: across an edge that it passes to the outside, and of its two edges at
// a vertex it passes one. A segment that the line runs along, and a point, it leaves along itself.
Exact out_of_body(const PlanarBody& body, const Unbounded& u, const CutEnd& last) {
  const std::uint32_t n = body.polygon.size(), v = last.feature;
  Exact way = along(u);
  for (const std::uint32_t e : {v, (v + n - 1) % n}) {
    if (n == 1 || (last.place == Place::edge && e != v)) continue;
    const auto [x, y] = planar::outward_normal(body.polygon, body.pose, e);
    const Sign further = dot(Exact{x, y}, way).sign();
    if (further == Sign::positive) return {x, y};
    if (n == 2 && further == Sign::negative) return {-x, -y};
  }
  return way;
}

Exact parting(const PlanarBody& body, const Unbounded& u, const UnboundedAnswer& answer) {
  if (u.kind == Kind::half_plane) return left_of(along(u));
  const bool is_behind = answer.contact == Contact::none
                             ? answer.of_line.meet()
                             : contact_of(answer.of_line, body.polygon.size()) == Contact::overlapping;
  return is_behind ? out_of_body(body, u, answer.of_line.last) : across_line(body, u);
}

// ---- Points.

// How the unbounded object makes a point of it. Its rows: a; the way to b; the way back (not of a ray); the way to the
// left (of a half-plane). Inside: with weights that span all of it.
Combination combination_of(const Unbounded& u, const ExactPoint2& p, bool is_inside) {
  const Exact way = along(u), a = lift<ExactStage>(u.a);
  const Exact d = Exact{p.x, p.y} - Exact{a.x * p.denominator, a.y * p.denominator};
  const Dyadic whole = dot(way, way) * p.denominator, forth = dot(way, d), zero;
  const Dyadic both = is_inside && u.kind != Kind::ray ? whole : zero;
  const bool is_back = forth.sign() == Sign::negative;
  Combination sum{{{0, whole}}, whole};
  const auto add = [&](std::uint32_t entry, const Dyadic& weight) {
    if (weight.sign() != Sign::zero) sum.parts.push_back({entry, weight});
  };
  add(1, is_back ? both : both + forth);
  if (u.kind != Kind::ray) add(2, is_back ? both - forth : both);
  if (u.kind == Kind::half_plane) add(3, cross(way, d));
  return sum;
}

ExactPoint2 between(const ExactPoint2& p, const ExactPoint2& q) {
  return {p.x * q.denominator + q.x * p.denominator, p.y * q.denominator + q.y * p.denominator,
          Dyadic(2.0) * p.denominator * q.denominator};
}

// Strictly inside the half-plane, as the witness is, and inside the body: on the way from there to its middle.
ExactPoint2 inside_half_plane(const PlanarBody& body, const Unbounded& u, std::uint32_t witness) {
  const ExactPoint2 start = planar::exact_vertex(body.polygon, body.pose, witness);
  const Exact way = along(u), a = lift<ExactStage>(u.a);
  ExactPoint2 p = planar::exact_middle(body.polygon, body.pose);
  while (cross(way, Exact{p.x, p.y} - Exact{a.x * p.denominator, a.y * p.denominator}).sign() != Sign::positive) {
    p = between(start, p);
  }
  return p;
}

ExactPoint2 point_inside(const PlanarBody& body, const Unbounded& u, const UnboundedAnswer& answer) {
  if (u.kind == Kind::half_plane) return inside_half_plane(body, u, answer.witness);
  const auto end = [&](const CutEnd& e) { return planar::exact_end(body.polygon, body.pose, u.a, u.b, e).point; };
  return answer.cut.kind == CutKind::point ? end(answer.cut.last)
                                           : between(end(answer.cut.first), end(answer.cut.last));
}

CommonPoint overlapping_point(const PlanarBody& body, const Unbounded& u, const UnboundedAnswer& answer) {
  const ExactPoint2 p = point_inside(body, u, answer);
  return {{p.x, p.y, Dyadic()},
          p.denominator,
          planar::inner_combination(body.polygon, body.pose, p),
          combination_of(u, p, true)};
}

// A vertex, or a point of an edge: the last one along the line is never the beginning of a ray inside the body.
CommonPoint some_point(const PlanarBody& body, const Unbounded& u, const UnboundedAnswer& answer) {
  ExactPoint2 p;
  Combination of_body{{{answer.witness, 1.0}}, 1.0};
  if (u.kind == Kind::half_plane) {
    p = planar::exact_vertex(body.polygon, body.pose, answer.witness);
  } else {
    const CutEnd& last = answer.cut.last;
    const ExactEnd end = planar::exact_end(body.polygon, body.pose, u.a, u.b, last);
    p = end.point;
    of_body.parts = {{last.feature, 1.0}};
    if (last.place == Place::edge) {
      const auto& [part, whole] = end.along_edge;
      of_body = {{{last.feature, whole - part}, {(last.feature + 1) % body.polygon.size(), part}}, whole};
    }
  }
  return {{p.x, p.y, Dyadic()}, p.denominator, std::move(of_body), combination_of(u, p, false)};
}

std::vector<Way3> ways_of(const Unbounded& u) {
  const Point3 a{u.a.x, u.a.y, 0}, b{u.b.x, u.b.y, 0};
  std::vector<Way3> ways{{a, b}};
  if (u.kind != Kind::ray) ways.push_back({b, a});
  if (u.kind == Kind::half_plane) ways.push_back({{-u.a.y, u.a.x, 0}, {-u.b.y, u.b.x, 0}});
  return ways;
}

}  // namespace

Contact contact_of(const planar::PolygonCut& cut, std::uint32_t vertices) {
  if (!cut.meet()) return Contact::none;
  const bool inner_of_body = vertices == 1 ||
                             (vertices == 2 && (cut.kind == CutKind::along || cut.first.place == Place::edge)) ||
                             cut.kind == CutKind::across;
  const bool inner_of_ray = cut.kind != CutKind::point || cut.first.own == OwnEnd::none;
  return inner_of_body && inner_of_ray ? Contact::overlapping : Contact::touching;
}

std::optional<Point2> exact_image(const Pose& pose, const Point2& p) {
  const auto& [m, t] = pose.affine();
  const Dyadic x = Dyadic(m[0]) * Dyadic(p.x) + Dyadic(m[1]) * Dyadic(p.y) + Dyadic(t[0]);
  const Dyadic y = Dyadic(m[2]) * Dyadic(p.x) + Dyadic(m[3]) * Dyadic(p.y) + Dyadic(t[1]);
  const Point2 image{x.nearest(), y.nearest()};
  if (!std::isfinite(image.x) || !std::isfinite(image.y)) return std::nullopt;
  if (!(Dyadic(image.x) == x) || !(Dyadic(image.y) == y)) return std::nullopt;
  return image;
}

std::string certificate_of_unbounded(const PlanarBody& body, const Unbounded& unbounded, const UnboundedAnswer& answer,
                                     const Origin& origin) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  PairClaims pairs(file, PairClaims::Space::planar);
  const std::uint32_t a = pairs.add_placed(body.name, pairs.add_body(body.name, body.vertices), body.pose_in_space);
  const std::array<Point3, 1> start{{{unbounded.a.x, unbounded.a.y, 0}}};
  const std::uint32_t b = pairs.add_body(unbounded.name, start, ways_of(unbounded));
  const auto direction = [&]() -> std::array<Dyadic, 3> {
    const Exact d = parting(body, unbounded, answer);
    return {d.x, d.y, Dyadic()};
  };
  if (answer.contact == Contact::none) {
    pairs.add_apart(a, b, direction());
  } else if (!answer.tells_contact) {
    pairs.add_meet(a, b, some_point(body, unbounded, answer));
  } else if (answer.contact == Contact::touching) {
    pairs.add_touching(a, b, some_point(body, unbounded, answer), direction());
  } else {
    pairs.add_overlapping(a, b, overlapping_point(body, unbounded, answer));
  }
  pairs.end();
  return text;
}

}  // namespace sunder::ask

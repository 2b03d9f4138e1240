#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_half_plane.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_ray.h>
#include <sunder/planar/pair/polygon_unbounded.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::planar {

namespace {

using Exact = Vector2<Dyadic>;

// The relation of a polygon with this number of vertices and a line or ray, from the ends of their common part.
Relation contact_of_ends(CutKind kind, const CutEnds<CutEnd>& ends, std::uint32_t vertices) {
  const bool inner_of_body = vertices == 1 ||
                             (vertices == 2 && (kind == CutKind::along || ends.first.place == Place::edge)) ||
                             kind == CutKind::across;
  const bool inner_of_ray = kind != CutKind::point || ends.first.own == OwnEnd::none;
  return inner_of_body && inner_of_ray ? Relation::overlapping : Relation::touching;
}

// The same as what more may be held.
PolygonCommon::Evidence widened(const PolygonCut::Evidence& cut) {
  return std::visit([](const auto& held) { return PolygonCommon::Evidence(held); }, cut);
}

PolygonCommon common_of(const PolygonCut& cut) { return {widened(cut.evidence), cut.decided_by, cut.cost}; }

PolygonCommon::Evidence in_half_plane(const PolygonHalfPlane& half, const PolygonCut::Evidence& by_line) {
  if (!half.meet) return BesideHalfPlane{half.witness};
  if (half.touching) return widened(by_line);
  // The line goes through the body's inside, where it is not all on one side.
  const std::optional<CutEnds<CutEnd>> ends = ends_of(by_line);
  const bool cuts_off = ends && (kind_of(by_line) == CutKind::across || ends->first.place == Place::edge);
  if (!cuts_off) return WholeWithin{half.witness};
  return PartWithin{ends->first, ends->last, half.witness};
}

PolygonCommon common_of(const PolygonHalfPlane& half, const PolygonCut& by_line) {
  Cost cost = by_line.cost;
  cost.probes += half.cost.probes;
  cost.iterations += half.cost.iterations;
  cost.exact += half.cost.exact;
  return {in_half_plane(half, by_line.evidence), std::max(half.decided_by, by_line.decided_by), cost};
}

// ---- Directions: no point of the polygon is further along than any of the other.

Exact along(const Unbounded& other) {
  const Line line = line_of(other);
  return coordinates<Dyadic>(line.b) - coordinates<Dyadic>(line.a);
}

Exact left_of(const Exact& d) { return {-d.y, d.x}; }

// From the point a to p, times p's denominator.
Exact way_to(const ExactPoint2& p, const Unbounded& other) {
  const Exact a = coordinates<Dyadic>(line_of(other).a);
  return Exact{p.x, p.y} - Exact{a.x * p.denominator, a.y * p.denominator};
}

// The polygon is on one side of the line, and not all on it: which side, a vertex tells that is not on the line.
Exact across_line(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other,
                  const PolygonCut::Evidence& by_line) {
  const auto* beside = std::get_if<BesideLine>(&by_line);
  const auto* along_edge = std::get_if<CutAlong>(&by_line);
  const std::uint32_t v = beside != nullptr       ? beside->nearest
                          : along_edge != nullptr ? polygon.next(polygon.next(along_edge->edge))
                                                  : polygon.next(std::get<CutPoint>(by_line).at.feature);
  const Exact left = left_of(along(other));
  const bool is_left = dot(left, way_to(exact_vertex(polygon, pose, v), other)).sign() == Sign::positive;
  return is_left ? -left : left;
}

// Where the line leaves the polygon, seen along it: across an edge that it passes to the outside, and of its two edges
// at a vertex it passes one. A segment that the line runs along, and a point, it leaves along itself.
Exact out_of_polygon(const ConvexPolygon& polygon, const Pose& pose, const Exact& way, const CutEnd& last) {
  const std::uint32_t n = polygon.size(), v = last.feature;
  for (const std::uint32_t e : {v, polygon.previous(v)}) {
    if (n == 1 || (last.place == Place::edge && e != v)) continue;
    const auto [x, y] = outward_normal(polygon, pose, e);
    const Sign further = dot(Exact{x, y}, way).sign();
    if (further == Sign::positive) return {x, y};
    if (n == 2 && further == Sign::negative) return {-x, -y};
  }
  return way;
}

// Requires that they are apart, or touch. A ray is parted from the polygon as its line is; where the line has a point
// in the polygon's relative interior, or meets it and the ray does not, the polygon is behind the ray's beginning.
std::array<Dyadic, 3> parting(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other, bool meet) {
  const auto way_in_space = [](const Exact& d) { return std::array<Dyadic, 3>{d.x, d.y, Dyadic()}; };
  if (std::holds_alternative<HalfPlane>(other)) return way_in_space(left_of(along(other)));
  const PolygonCut::Evidence by_line = polygon_line(polygon, pose, line_of(other)).evidence;
  const std::optional<CutEnds<CutEnd>> ends = ends_of(by_line);
  const bool is_behind =
      ends && (!meet || contact_of_ends(kind_of(by_line), *ends, polygon.size()) == Relation::overlapping);
  return way_in_space(is_behind ? out_of_polygon(polygon, pose, along(other), ends->last)
                                : across_line(polygon, pose, other, by_line));
}

// ---- Points.

// How the unbounded object makes a point of it. Its rows: a; the way to b; the way back (not of a ray); the way to the
// left (of a half-plane). Inside: with weights that span all of it.
Combination combination_of(const Unbounded& other, const ExactPoint2& p, bool is_inside) {
  const bool is_ray = std::holds_alternative<Ray>(other);
  const Exact way = along(other), d = way_to(p, other);
  const Dyadic whole = dot(way, way) * p.denominator, forth = dot(way, d), zero;
  const Dyadic both = is_inside && !is_ray ? whole : zero;
  const bool is_back = forth.sign() == Sign::negative;
  Combination sum{{{0, whole}}, whole};
  const auto add = [&](std::uint32_t entry, const Dyadic& weight) {
    if (weight.sign() != Sign::zero) sum.parts.push_back({entry, weight});
  };
  add(1, is_back ? both : both + forth);
  if (!is_ray) add(2, is_back ? both - forth : both);
  if (std::holds_alternative<HalfPlane>(other)) add(3, cross(way, d));
  return sum;
}

ExactPoint2 between(const ExactPoint2& p, const ExactPoint2& q) {
  return {p.x * q.denominator + q.x * p.denominator, p.y * q.denominator + q.y * p.denominator,
          Dyadic(2.0) * p.denominator * q.denominator};
}

// Strictly inside the half-plane, as the witness is, and inside the polygon: on the way from there to its middle.
ExactPoint2 inside_half_plane(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other,
                              std::uint32_t witness) {
  const ExactPoint2 start = exact_vertex(polygon, pose, witness);
  const Exact way = along(other);
  ExactPoint2 p = exact_middle(polygon, pose);
  while (cross(way, way_to(p, other)).sign() != Sign::positive) p = between(start, p);
  return p;
}

// Of both relative interiors.
CommonPoint overlapping_point(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other,
                              const PolygonCommon& common) {
  const auto inner_point = [&] {
    if (std::holds_alternative<HalfPlane>(other)) {
      return inside_half_plane(polygon, pose, other, furthest_of(common));
    }
    const Line line = line_of(other);
    const auto end = [&](const CutEnd& e) { return exact_end(polygon, pose, line.a, line.b, e).point; };
    if (const auto* point = std::get_if<CutPoint>(&common.evidence)) return end(point->at);
    const CutEnds<CutEnd> ends = ends_of(common.evidence).value();
    return between(end(ends.first), end(ends.last));
  };
  const ExactPoint2 p = inner_point();
  return {in_space(p), inner_combination(polygon, pose, p), combination_of(other, p, true)};
}

// At a vertex, an edge or, of the beginning of a ray, inside.
CommonPoint point_at(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other, const CutEnd& at) {
  const Line line = line_of(other);
  const ExactEnd end = exact_end(polygon, pose, line.a, line.b, at);
  Combination of_polygon{{{at.feature, 1.0}}};
  if (at.place == Place::inside) of_polygon = inner_combination(polygon, pose, end.point);
  if (at.place == Place::edge) {
    const auto& [part, whole] = end.along_edge;
    of_polygon = {{{at.feature, whole - part}, {polygon.next(at.feature), part}}, whole};
  }
  return {in_space(end.point), std::move(of_polygon), combination_of(other, end.point, false)};
}

// A vertex, or a point of an edge: the last one along the line is never the beginning of a ray inside the polygon.
CommonPoint some_point(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other,
                       const PolygonCommon& common) {
  if (std::holds_alternative<HalfPlane>(other)) {
    return point_at(polygon, pose, other, {Place::vertex, furthest_of(common)});
  }
  return point_at(polygon, pose, other, ends_of(common.evidence).value().last);
}

// Of those that meet.
void add_common_part(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolygon& polygon,
                     const Pose& pose, const Unbounded& other, const CutEnds<CutEnd>& ends) {
  // Back from its beginning a ray ends itself, forth never.
  const auto out = [&](const CutEnd& end, const Exact& way, OwnEnd own) {
    const Exact d = end.own == own ? way : out_of_polygon(polygon, pose, way, end);
    return std::array<Dyadic, 3>{d.x, d.y, Dyadic()};
  };
  const auto at = [&](const CutEnd& end) { return point_at(polygon, pose, other, end); };
  const Exact way = along(other);
  pairs.add_common_part(a, b, at(ends.first), at(ends.last), out(ends.first, -way, OwnEnd::a),
                        out(ends.last, way, OwnEnd::b));
}

}  // namespace

Line line_of(const Unbounded& other) {
  return std::visit([](const auto& u) { return Line{u.a, u.b}; }, other);
}

Relation contact_of(const ConvexPolygon& polygon, const Unbounded& other, const PolygonCommon& common) {
  if (!common.meet()) return Relation::none;
  if (std::holds_alternative<PartWithin>(common.evidence) || std::holds_alternative<WholeWithin>(common.evidence)) {
    return Relation::overlapping;
  }
  if (std::holds_alternative<HalfPlane>(other)) return Relation::touching;
  return contact_of_ends(kind_of(common), ends_of(common.evidence).value(), polygon.size());
}

std::uint32_t furthest_of(const PolygonCommon& common) {
  if (const auto* beside = std::get_if<BesideHalfPlane>(&common.evidence)) return beside->nearest;
  if (const auto* part = std::get_if<PartWithin>(&common.evidence)) return part->furthest;
  if (const auto* whole = std::get_if<WholeWithin>(&common.evidence)) return whole->furthest;
  return ends_of(common.evidence).value().last.feature;  // on its line, where they touch
}

PolygonCommon polygon_unbounded(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other) {
  if (const auto* ray = std::get_if<Ray>(&other)) return common_of(polygon_ray(polygon, pose, *ray));
  const PolygonCut by_line = polygon_line(polygon, pose, line_of(other));
  const auto* half_plane = std::get_if<HalfPlane>(&other);
  return half_plane != nullptr ? common_of(polygon_half_plane(polygon, pose, *half_plane), by_line)
                               : common_of(by_line);
}

PolygonCommon polygon_unbounded_by_fibonacci(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other) {
  return common_of(polygon_line_by_fibonacci(polygon, pose, std::get<Line>(other)));
}

PolygonCommon polygon_unbounded_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other) {
  if (const auto* ray = std::get_if<Ray>(&other)) return common_of(polygon_ray_by_scan(polygon, pose, *ray));
  const PolygonCut by_line = polygon_line_by_scan(polygon, pose, line_of(other));
  const auto* half_plane = std::get_if<HalfPlane>(&other);
  return half_plane != nullptr ? common_of(polygon_half_plane_by_scan(polygon, pose, *half_plane), by_line)
                               : common_of(by_line);
}

UnboundedBody body_of(const Unbounded& other) {
  const Line line = line_of(other);
  const Point3 a{line.a.x, line.a.y, 0}, b{line.b.x, line.b.y, 0};
  UnboundedBody body{{a}, {{a, b}}};
  if (!std::holds_alternative<Ray>(other)) body.ways.push_back({b, a});
  if (std::holds_alternative<HalfPlane>(other)) body.ways.push_back({{-a.y, a.x, 0}, {-b.y, b.x, 0}});
  return body;
}

void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolygon& polygon, const Pose& pose,
                const Unbounded& other, const PolygonCommon& common, bool tells_contact) {
  const Relation contact = contact_of(polygon, other, common);
  if (contact == Relation::none) {
    pairs.add_apart(a, b, parting(polygon, pose, other, false));
  } else if (!tells_contact) {
    pairs.add_meet(a, b, some_point(polygon, pose, other, common));
  } else if (contact == Relation::touching) {
    pairs.add_touching(a, b, some_point(polygon, pose, other, common), parting(polygon, pose, other, true));
  } else {
    pairs.add_overlapping(a, b, overlapping_point(polygon, pose, other, common));
  }
  if (std::holds_alternative<HalfPlane>(other)) {
    const Exact out = -left_of(along(other));
    pairs.add_nearest(a, b, furthest_of(common), {out.x, out.y, Dyadic()});
  } else if (common.meet()) {
    add_common_part(pairs, a, b, polygon, pose, other, ends_of(common.evidence).value());
  } else if (std::holds_alternative<Line>(other)) {
    const auto& beside = std::get<BesideLine>(common.evidence);
    const Exact out = -across_line(polygon, pose, other, beside);
    pairs.add_nearest(a, b, beside.nearest, {out.x, out.y, Dyadic()});
  }
}

std::optional<Point2> exact_image(const Pose& pose, const Point2& p) {
  const Exact exact = coordinates<Dyadic>(Posed2{p, &pose.affine(), false});
  const Point2 image{exact.x.nearest(), exact.y.nearest()};
  if (!std::isfinite(image.x) || !std::isfinite(image.y)) return std::nullopt;
  if (!(Dyadic(image.x) == exact.x) || !(Dyadic(image.y) == exact.y)) return std::nullopt;
  return image;
}

}  // namespace sunder::planar

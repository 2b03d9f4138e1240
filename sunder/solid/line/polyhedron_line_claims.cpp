#include <sunder/base/contract.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/line/line_in_body.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/radial_walk.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <array>
#include <utility>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

Exact operator*(const Exact& v, const Dyadic& by) { return {v.x * by, v.y * by, v.z * by}; }
Exact operator+(const Exact& v, const Exact& w) { return {v.x + w.x, v.y + w.y, v.z + w.z}; }
Exact operator-(const Exact& v) { return {-v.x, -v.y, -v.z}; }
Dyadic exact_determinant(const Exact& u, const Exact& v, const Exact& w) { return dot(cross(u, v), w); }

struct Ends {
  Point3 a, b;
  bool is_line, is_segment;
  bool is_point() const { return is_segment && a == b; }
};
Ends points_of(const LineLike& other) {
  return std::visit(
      [&](const auto& o) {
        return Ends{o.a, o.b, std::holds_alternative<Line>(other), std::holds_alternative<Segment>(other)};
      },
      other);
}

class Claims {
 public:
  Claims(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other, const PolyhedronCut& cut)
      : placed_(body, pose),
        body_(body),
        pose_(pose),
        ends_(points_of(other)),
        line_(line_through(ends_.a, ends_.b)),
        a_(coordinates<Dyadic>(ends_.a)),
        b_(coordinates<Dyadic>(ends_.b)),
        way_(coordinates<Dyadic>(line_.b) - a_),
        cut_(cut) {}

  // Requires that they are apart.
  std::array<Dyadic, 3> parting() {
    const auto& p = std::get<CutParting>(cut_.evidence);
    const Exact& beyond = p.beyond == OwnEnd::b ? b_ : a_;
    const auto arrow = [&] { return vertex(p.j) - vertex(p.i); };
    const auto towards = [&](const Exact& direction, std::uint32_t v) {
      return dot(direction, beyond - vertex(v)).sign() == Sign::negative ? -direction : direction;
    };
    using enum CutParting::By;
    switch (p.by) {
      case facets: return numbers(mixed(p.i, p.j));
      case facet: return numbers(towards(normal(p.i), body_.facet(p.i)[0]));
      case edge_and_line: return numbers(towards(cross(arrow(), way_), p.i));
      case edge_in_plane: return numbers(towards(cross(arrow(), normal(0)), p.i));
      case edge: return numbers(towards(out_of_edge(arrow()), p.i));
      case perpendicular: return numbers(across_line(a_ - vertex(p.i)));
      case line: return numbers(towards(way_, p.i));
      case untold: break;
    }
    SUNDER_REQUIRE(false);
    return {};
  }

  CommonPoint some_point() { return point_at(ends().last); }

  // Requires that they meet.
  void add_common_part(PairClaims& pairs, std::uint32_t a, std::uint32_t b) {
    if (ends_.is_point()) return;
    const auto& [first, last] = ends();
    pairs.add_common_part(a, b, point_at(first), point_at(last), direction_out(first, -way_, OwnEnd::a),
                          direction_out(last, way_, OwnEnd::b));
  }

  // Requires that they overlap.
  CommonPoint overlapping_point() {
    const ExactFraction t =
        middle(exact_end(placed_, line_, ends().first).along_line, exact_end(placed_, line_, ends().last).along_line);
    const Exact p = a_ * t.denominator + way_ * t.numerator;
    return common_point({p.x, p.y, p.z, t.denominator}, t, true);
  }

  // Requires that they touch. A plane through the common part parts them weakly: one of a facet or of an edge there
  // does, or the one between two facets that holds the line.
  std::array<Dyadic, 3> touching_direction() {
    const ExactPoint3 p = exact_end(placed_, line_, ends().last).point;
    for (const Exact& direction : candidates()) {
      for (const Exact& d : {direction, -direction}) {
        if (supports(d, p)) return numbers(d);
      }
    }
    SUNDER_REQUIRE(false);
    return {};
  }

 private:
  // Requires that they meet; so below.
  CutEnds<CutEnd> ends() const { return ends_of(cut_.evidence).value(); }

  // Of the whole line, which meets the body, and this has an inside.
  LineFacets facets_of_line() const { return facets_of(polyhedron_line(body_, pose_, line_).evidence).value(); }

  CommonPoint point_at(const CutEnd& at) {
    const ExactEnd end = exact_end(placed_, line_, at);
    return common_point(end.point, end.along_line, false);
  }

  // A direction along which the body, or the other, ends at that end, which is so along that way. The other does at its
  // own end, if it goes on from there the other way.
  std::array<Dyadic, 3> direction_out(const CutEnd& end, const Exact& way, OwnEnd own) {
    if (end.own == own) return numbers(way);
    const ExactPoint3 p = exact_end(placed_, line_, end).point;
    for (const Exact& d : outward(end.at)) {
      const Sign sign = dot(d, way).sign();
      const Exact along = sign == Sign::negative ? -d : d;
      if (sign != Sign::zero && beside(along, p, extreme(along, End::greatest)) != Sign::positive)
        return numbers(along);
    }
    SUNDER_REQUIRE(false);
    return {};
  }

  // What is perpendicular to facets or edges there, or to all of the body but along a line of it.
  std::vector<Exact> outward(const CutFeature& at) {
    std::vector<Exact> found;
    switch (body_.dimension()) {
      case 3: {
        const LineFacets of_line = facets_of_line();
        return {normal(of_line.leaves), normal(of_line.enters)};
      }
      case 2:
        found.push_back(normal(0));
        for (const auto& [v, w] : edges_at(at)) found.push_back(cross(vertex(w) - vertex(v), normal(0)));
        return found;
      case 1: {
        const Exact edge = vertex(1) - vertex(0);
        return {out_of_edge(edge), edge};
      }
      default: return {way_};
    }
  }

  // Of a flat body: an edge, or those at a vertex.
  std::vector<std::array<std::uint32_t, 2>> edges_at(const CutFeature& at) const {
    std::vector<std::array<std::uint32_t, 2>> edges;
    if (at.place == CutPlace::edge) edges.push_back({at.feature, at.other});
    if (at.place != CutPlace::vertex) return edges;
    for (const std::uint32_t w : body_.neighbours(at.feature)) edges.push_back({at.feature, w});
    return edges;
  }

  Sign beside(const Exact& d, const ExactPoint3& p, std::uint32_t v) const {
    return dot(d, vertex(v) * p.denominator - p.numerators()).sign();
  }
  std::uint32_t extreme(const Exact& d, End end) {
    const WorldDirection direction(d);
    Along along(direction, placed_.pose, placed_.tame);
    StageTally tally;
    Cost cost;
    return extreme_vertex_from(placed_, along, end, 0, cost, tally);
  }

  static std::array<Dyadic, 3> numbers(const Exact& d) { return {d.x, d.y, d.z}; }
  Exact vertex(std::uint32_t v) const { return coordinates<Dyadic>(placed_[v]); }
  Exact normal(std::uint32_t f) const {
    const std::span<const std::uint32_t> v = body_.facet(f);
    const Exact from = vertex(v[0]);
    return cross(vertex(v[1]) - from, vertex(v[2]) - from);
  }
  // Of the facet that the line enters through, and of the one it leaves through: perpendicular to the line.
  Exact mixed(std::uint32_t enters, std::uint32_t leaves) const {
    const Exact in = normal(enters), out = normal(leaves);
    return in * dot(out, way_) - out * dot(in, way_);
  }
  Exact across_line(const Exact& v) const { return v * dot(way_, way_) - way_ * dot(way_, v); }
  Exact out_of_edge(const Exact& edge) const { return way_ * dot(edge, edge) - edge * dot(edge, way_); }

  std::vector<Exact> candidates() const {
    std::vector<Exact> found;
    switch (body_.dimension()) {
      case 3: {
        const PolyhedronCut of_line = polyhedron_line(body_, pose_, line_);
        if (const auto* along = std::get_if<CutAlong>(&of_line.evidence)) {
          for (const CutFeature& at : {along->surface, ends().last.at}) {
            if (at.place == CutPlace::facet) found.push_back(normal(at.feature));
            if (at.place != CutPlace::edge) continue;
            found.push_back(normal(represent::of<FacetGraph>(body_).edge(at.feature, at.other)->facet));
          }
        }
        const LineFacets facets = facets_of(of_line.evidence).value();
        found.push_back(mixed(facets.enters, facets.leaves));
        for (const std::uint32_t f : {facets.leaves, facets.enters}) found.push_back(normal(f));
        break;
      }
      case 2:
        found.push_back(cross(normal(0), way_));
        // The edges that hold the common part, or of which it is an end.
        for (const auto& [v, w] : edges_at(held_by())) {
          found.push_back(cross(vertex(w) - vertex(v), way_));
          found.push_back(cross(vertex(w) - vertex(v), normal(0)));
        }
        found.push_back(normal(0));
        break;
      case 1: {
        const Exact edge = vertex(1) - vertex(0);
        found = {across_line(edge), out_of_edge(edge), edge, way_};
        break;
      }
      default: found = {way_};
    }
    return found;
  }

  // What holds all of the common part but its ends; of one point, what holds that.
  CutFeature held_by() const {
    const auto* along = std::get_if<CutAlong>(&cut_.evidence);
    return along != nullptr ? along->surface : ends().last.at;
  }

  // Is p furthest of the body along the direction, and first of the other, and are not all of both as far?
  bool supports(const Exact& d, const ExactPoint3& p) {
    const auto beside_p = [&](const Exact& x) { return dot(d, x * p.denominator - Exact{p.x, p.y, p.z}).sign(); };
    const Sign forth = dot(d, way_).sign(), of_a = beside_p(a_), of_b = ends_.is_segment ? beside_p(b_) : of_a;
    if (of_a == Sign::negative || of_b == Sign::negative) return false;
    if (!ends_.is_segment && (ends_.is_line ? forth != Sign::zero : forth == Sign::negative)) return false;
    if (beside(d, p, extreme(d, End::greatest)) == Sign::positive) return false;
    const bool is_beyond =
        of_a == Sign::positive || of_b == Sign::positive || (!ends_.is_segment && forth == Sign::positive);
    return is_beyond || beside(d, p, extreme(d, End::least)) == Sign::negative;
  }

  // ---- Points.

  CommonPoint common_point(const ExactPoint3& p, const ExactFraction& t, bool is_inside) {
    return {p, of_body(p, t, is_inside), of_other(t, is_inside)};
  }

  // Rows: a segment's points; else a, the way to b, the way back. Inside: with weights that span all of it.
  Combination of_other(const ExactFraction& t, bool is_inside) const {
    const auto& [n, m] = t;
    if (ends_.is_point()) return {{{0, 1.0}}};
    if (ends_.is_segment) return made_of({{0, m - n}, {1, n}}, m);
    const bool is_back = n.sign() == Sign::negative;
    const Dyadic both = is_inside && ends_.is_line ? m : Dyadic();
    std::vector<Weights::Part> parts{{0, m}, {1, is_back ? both : both + n}};
    if (ends_.is_line) parts.push_back({2, is_back ? both - n : both});
    return made_of(std::move(parts), m);
  }

  // Without zeros, each entry once, over a positive denominator.
  static Combination made_of(std::vector<Weights::Part> parts, const Dyadic& denominator) {
    Combination sum;
    const bool is_turned = denominator.sign() == Sign::negative;
    sum.denominator = is_turned ? -denominator : denominator;
    for (const auto& [index, weight] : parts) {
      if (weight.sign() != Sign::zero) sum.add(index, is_turned ? -weight : weight);
    }
    return sum;
  }

  Combination of_body(const ExactPoint3& p, const ExactFraction& t, bool is_inside) {
    const Exact at = p.numerators();
    switch (body_.dimension()) {
      case 3: return of_solid(at, p.denominator, t);
      case 2: return of_polygon(at, p.denominator, is_inside);
      case 1: {
        const Exact from = vertex(0), edge = vertex(1) - from;
        const Dyadic whole = dot(edge, edge) * p.denominator, part = dot(edge, at - from * p.denominator);
        return made_of({{0, whole - part}, {1, part}}, whole);
      }
      default: return {{{0, 1.0}}};
    }
  }

  // From the mean o of four vertices: p - o is in the cone of a triangle of the surface, and what is left is o's.
  Combination of_solid(const Exact& p, const Dyadic& whole, const ExactFraction& t) {
    const Hierarchy& hierarchy = represent::of<Hierarchy>(body_);
    const auto& nodes = hierarchy.nodes;
    const WayFromMiddle way({nodes[0].at, nodes[1].at, nodes[2].at, nodes[3].at},
                            LineInBody(line_.a, line_.b, placed_.pose).at(t));
    std::uint64_t probes = 0;
    const auto turn = [&](std::uint32_t i, std::uint32_t j) { return way.turn(nodes[i].at, nodes[j].at); };
    const RankTriangle ranks = triangle_on_ray(hierarchy, turn, probes);
    Exact sum = vertex(nodes[0].vertex);
    for (std::size_t k = 1; k < 4; ++k) sum = sum + vertex(nodes[k].vertex);
    const auto corner = [&](std::size_t k) { return vertex(nodes[ranks[k]].vertex) * 4.0 - sum; };
    const Exact u = corner(0), v = corner(1), w = corner(2), to = p * 4.0 - sum * whole;
    const Dyadic of_u = exact_determinant(to, v, w), of_v = exact_determinant(u, to, w),
                 of_w = exact_determinant(u, v, to);
    const Dyadic all = exact_determinant(u, v, w) * whole, rest = all - of_u - of_v - of_w;
    std::vector<Weights::Part> parts{{nodes[ranks[0]].vertex, of_u.scaled(2)},
                                     {nodes[ranks[1]].vertex, of_v.scaled(2)},
                                     {nodes[ranks[2]].vertex, of_w.scaled(2)}};
    for (std::size_t k = 0; k < 4; ++k) parts.push_back({nodes[k].vertex, rest});
    return made_of(std::move(parts), all.scaled(2));
  }

  // In the fan of the polygon's first corner. Inside: a part of the middle of three corners, and of a point beyond.
  Combination of_polygon(const Exact& p, const Dyadic& whole, bool is_inside) const {
    if (!is_inside) return of_fan(p, whole);
    const std::span<const std::uint32_t> cycle = body_.facet(0);
    const std::array<std::uint32_t, 3> base{cycle[0], cycle[cycle.size() / 3], cycle[2 * cycle.size() / 3]};
    const Exact sum = vertex(base[0]) + vertex(base[1]) + vertex(base[2]);
    for (std::int64_t k = 1;; ++k) {
      // p = 2^-k middle + (1 - 2^-k) q, so q = (2^k 3 p - sum) / (3 (2^k - 1)).
      const Dyadic power = Dyadic::power_of_two(k), others = power - Dyadic(1.0);
      const Dyadic three_whole = whole * 3.0;
      Combination of_q = of_fan(p * (power * 3.0) - sum * whole, three_whole * others);
      if (std::any_of(of_q.parts.begin(), of_q.parts.end(),
                      [](const Weights::Part& part) { return part.numerator.sign() == Sign::negative; })) {
        continue;
      }
      for (Weights::Part& part : of_q.parts) part.numerator = part.numerator * others * 3.0;
      for (const std::uint32_t v : base) of_q.parts.push_back({v, of_q.denominator});
      return made_of(std::move(of_q.parts), of_q.denominator * power * 3.0);
    }
  }

  // A point p / whole of the polygon's plane; outside of the polygon with a negative weight.
  Combination of_fan(const Exact& p, const Dyadic& whole) const {
    const std::span<const std::uint32_t> cycle = body_.facet(0);
    const Exact from = vertex(cycle[0]), n = normal(0), to = p - from * whole;
    const auto arrow = [&](std::size_t k) { return vertex(cycle[k]) - from; };
    std::size_t low = 1, high = cycle.size() - 1;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (exact_determinant(n, arrow(middle), to).sign() == Sign::negative ? high : low) = middle;
    }
    const Exact u = arrow(low), v = arrow(high);
    const Dyadic all = exact_determinant(n, u, v) * whole, of_u = exact_determinant(n, to, v),
                 of_v = exact_determinant(n, u, to);
    return made_of({{cycle[0], all - of_u - of_v}, {cycle[low], of_u}, {cycle[high], of_v}}, all);
  }

  const Placed placed_;
  const ConvexPolyhedron& body_;
  const Pose& pose_;
  const Ends ends_;
  const Line line_;
  const Exact a_, b_, way_;
  const PolyhedronCut& cut_;
};

}  // namespace

std::array<Dyadic, 3> parting_direction(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other,
                                        const PolyhedronCut& cut) {
  return Claims(body, pose, other, cut).parting();
}

CommonPoint common_point_of(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other,
                            const PolyhedronCut& cut) {
  return Claims(body, pose, other, cut).some_point();
}

PolyhedronCut polyhedron_line_like(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other) {
  if (const auto* line = std::get_if<Line>(&other)) return polyhedron_line(body, pose, *line);
  if (const auto* ray = std::get_if<Ray>(&other)) return polyhedron_ray(body, pose, *ray);
  return polyhedron_segment(body, pose, std::get<Segment>(other));
}

Relation contact_of(const ConvexPolyhedron& body, const LineLike& other, const PolyhedronCut& cut) {
  if (!cut.meet()) return Relation::none;
  const auto* point = std::get_if<CutPoint>(&cut.evidence);
  const auto* along = std::get_if<CutAlong>(&cut.evidence);
  const CutPlace at = point != nullptr   ? point->at.at.place
                      : along != nullptr ? along->surface.place
                                         : CutPlace::inside;
  const bool inner_of_body = static_cast<int>(at) == body.dimension();
  const bool inner_of_other = point == nullptr || point->at.own == OwnEnd::none || points_of(other).is_point();
  return inner_of_body && inner_of_other ? Relation::overlapping : Relation::touching;
}

LineBody body_of(const LineLike& other) {
  const auto [a, b, is_line, is_segment] = points_of(other);
  if (is_segment) return {a == b ? std::vector{a} : std::vector{a, b}, {}};
  LineBody body{{a}, {{a, b}}};
  if (is_line) body.ways.push_back({b, a});
  return body;
}

void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body, const Pose& pose,
                const LineLike& other, const PolyhedronCut& cut, bool tells_contact) {
  Claims claims(body, pose, other, cut);
  const Relation contact = contact_of(body, other, cut);
  if (contact == Relation::none) {
    pairs.add_apart(a, b, claims.parting());
  } else if (!tells_contact) {
    pairs.add_meet(a, b, claims.some_point());
  } else if (contact == Relation::touching) {
    pairs.add_touching(a, b, claims.some_point(), claims.touching_direction());
  } else {
    pairs.add_overlapping(a, b, claims.overlapping_point());
  }
  if (contact != Relation::none) claims.add_common_part(pairs, a, b);
}

void add_common_part(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body,
                     const Pose& pose, const LineLike& other, const PolyhedronCut& cut) {
  Claims(body, pose, other, cut).add_common_part(pairs, a, b);
}

void add_support(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body, const Pose& pose,
                 const Line& line, const LineSupport& support) {
  if (const auto* none = std::get_if<SupportNone>(&support.evidence)) {
    const PolyhedronCut cut{none->cut, support.decided_by, {}};
    const auto& nodes = represent::of<Hierarchy>(body).nodes;
    pairs.add_no_support(a, b, Claims(body, pose, line, cut).overlapping_point(),
                         {nodes[0].vertex, nodes[1].vertex, nodes[2].vertex, nodes[3].vertex});
    return;
  }
  const Placed placed(body, pose);
  const Exact from = coordinates<Dyadic>(line.a), way = coordinates<Dyadic>(line.b) - from;
  const auto out_of = [&](const SupportPlane& plane) -> std::array<Dyadic, 3> {
    const Exact normal = cross(way, coordinates<Dyadic>(placed[plane.through]) - from);
    const Exact out = plane.side == Sign::positive ? -normal : normal;
    return {out.x, out.y, out.z};
  };
  const std::vector<SupportPlane> planes = planes_of(support.evidence);
  if (planes.size() == 1) {
    pairs.add_one_support(a, b, vertices_of(body, planes[0].touches), out_of(planes[0]));
  } else {
    pairs.add_two_supports(a, b, vertices_of(body, planes[0].touches), vertices_of(body, planes[1].touches),
                           out_of(planes[0]), out_of(planes[1]));
  }
}

}  // namespace sunder::solid

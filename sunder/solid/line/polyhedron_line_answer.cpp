#include <sunder/predicate/line/line_in_body.h>
#include <sunder/predicate/line/line_planes.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/radial_walk.h>

#include <algorithm>
#include <array>

namespace sunder::solid {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

CutFeature vertex_feature(std::uint32_t v) { return {CutPlace::vertex, v, 0}; }
CutFeature edge_feature(std::uint32_t v, std::uint32_t w) { return {CutPlace::edge, std::min(v, w), std::max(v, w)}; }
CutFeature facet_feature(std::uint32_t f) { return {CutPlace::facet, f, 0}; }

constexpr int most_moves = 8;  // of a proposal to neighbours

}  // namespace

LineAnswer::LineAnswer(const Placed& body, const Line& line)
    : body_(body), line_(line), orientation_(determinant_sign(body.pose)) {}

// ---- Signs, about the world.

// Positive where a line that goes in this sense through a facet has the facet's edge from p to q on the left.
Sign LineAnswer::turn(std::uint32_t p, std::uint32_t q, Sense sense) {
  const Sign s = orient_3d(line_.a, line_.b, body_[p], body_[q], &tally_);
  const Sign outward = s * orientation_;
  return sense == Sense::entering ? -outward : outward;
}

std::array<Posed3, 3> LineAnswer::corners(std::uint32_t facet) const {
  const std::span<const std::uint32_t> cycle = body_.body.facet(facet);
  const std::size_t k = cycle.size();
  return {body_[cycle[0]], body_[cycle[k / 3]], body_[cycle[2 * k / 3]]};
}

Sign LineAnswer::facing(std::uint32_t facet) {
  return orientation_ * sunder::facing(line_.a, line_.b, corners(facet), &tally_);
}

Sign LineAnswer::beyond(const Point3& x, std::uint32_t facet) {
  const auto [u, v, w] = corners(facet);
  return orientation_ * orient_3d(u, v, w, x, &tally_);
}

// The facets' triangles from the first corner: the line goes through the fan between two corners. Seen along the line
// the facet is convex, and counter-clockwise in the sense.
LineAnswer::Pierced LineAnswer::pierce(std::uint32_t facet, Sense sense) {
  const std::span<const std::uint32_t> v = body_.body.facet(facet);
  const std::size_t last = v.size() - 1;
  std::size_t low = 1, high = last;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    ++cost_.probes;
    (turn(v[0], v[middle], sense) == Sign::negative ? high : low) = middle;
  }
  cost_.probes += 3;
  const std::uint32_t p = v[0], q = v[low], r = v[high];
  const bool is_turned = (orientation_ == Sign::positive) == (sense == Sense::entering);
  std::array<Sign, 3> turns = turns_about_line(line_.a, line_.b, {body_[p], body_[q], body_[r]}, &tally_);
  if (is_turned) turns = {-turns[0], -turns[1], -turns[2]};
  const auto [pq, qr, rp] = turns;
  if (qr == Sign::negative) return {false, {}, {q, r}};
  if (pq == Sign::negative) return {false, {}, {p, q}};
  if (rp == Sign::negative) return {false, {}, {r, p}};
  const bool on_pq = pq == Sign::zero, on_qr = qr == Sign::zero, on_rp = rp == Sign::zero;
  if (on_pq && on_qr && on_rp) return {};
  if (on_pq && on_rp) return {true, vertex_feature(p), {}};
  if (on_pq && on_qr) return {true, vertex_feature(q), {}};
  if (on_qr && on_rp) return {true, vertex_feature(r), {}};
  if (on_qr) return {true, edge_feature(q, r), {}};
  if (on_pq && low == 1) return {true, edge_feature(p, q), {}};
  if (on_rp && high == last) return {true, edge_feature(r, p), {}};
  return {true, facet_feature(facet), {}};
}

// ---- Proposals.

bool LineAnswer::dispose(const LineProposal& proposal) {
  if (std::max(proposal.enters, proposal.leaves) >= body_.body.facet_count()) return false;
  switch (proposal.claim) {
    case LineProposal::Claim::through: return through(proposal.enters, proposal.leaves);
    case LineProposal::Claim::apart: return apart(proposal.enters, proposal.leaves);
  }
  return false;
}

bool LineAnswer::through(std::uint32_t enters, std::uint32_t leaves) {
  const FacetGraph* graph = nullptr;
  // From facet to facet, across an edge that the line passes outside of.
  const auto follow = [&](std::uint32_t& facet, Sense sense, CutEnd& end) {
    for (int moves = 0;; ++moves) {
      const Pierced pierced = pierce(facet, sense);
      if (pierced.is_pierced) {
        end = {pierced.at, OwnEnd::none};
        return true;
      }
      const auto [p, q] = pierced.across;
      if (p == q || moves == most_moves) return false;
      if (graph == nullptr) graph = &represent::of<FacetGraph>(body_.body);
      const auto next = graph->edge(q, p);
      if (!next) return false;  // no edge: the line is not in the facet's fan at all
      facet = next->facet;
    }
  };
  if (!follow(enters, Sense::entering, first_) || !follow(leaves, Sense::leaving, last_)) return false;
  facets_.enters = enters;
  facets_.leaves = leaves;
  decide_kind();
  return true;
}

bool LineAnswer::apart(std::uint32_t enters, std::uint32_t leaves) {
  cost_.probes += 6;
  const auto [of_enters, of_leaves, beyond] =
      line_and_planes(line_.a, line_.b, corners(enters), corners(leaves), &tally_);
  // Where the pose reflects, both normals turn around, and their product does not.
  if (of_enters * orientation_ != Sign::negative || of_leaves * orientation_ == Sign::negative) return false;
  if (beyond != Sign::positive) return false;
  set_apart({CutParting::By::facets, enters, leaves, OwnEnd::a});
  return true;
}

void LineAnswer::set_apart(CutParting parting) {
  kind_ = CutKind::nothing;
  parting_ = parting;
}

void LineAnswer::set_point(const CutEnd& at) {
  kind_ = CutKind::point;
  first_ = last_ = at;
}

// Of a line that comes in and goes out at known features: it goes through the inside where one of them is no edge and
// no vertex, as it goes through that facet's plane there.
void LineAnswer::decide_kind() {
  kind_ = CutKind::across;
  if (first_.at == last_.at) {
    kind_ = CutKind::point;
  } else if (first_.at.place != CutPlace::facet && last_.at.place != CutPlace::facet && !is_across()) {
    kind_ = CutKind::along;
  }
}

// ---- Exactly.

std::array<Point3, 4> LineAnswer::top() const {
  const auto& nodes = represent::of<Hierarchy>(body_.body).nodes;
  return {nodes[0].at, nodes[1].at, nodes[2].at, nodes[3].at};
}

Triangle LineAnswer::triangle_towards(const WayFromMiddle& way) {
  const Hierarchy& hierarchy = represent::of<Hierarchy>(body_.body);
  const auto turn_of = [&](std::uint32_t i, std::uint32_t j) {
    return way.turn(hierarchy.nodes[i].at, hierarchy.nodes[j].at, &tally_);
  };
  const RankTriangle ranks = triangle_on_ray(hierarchy, turn_of, cost_.probes);
  return {hierarchy.nodes[ranks[0]].vertex, hierarchy.nodes[ranks[1]].vertex, hierarchy.nodes[ranks[2]].vertex};
}

// Of a point of the surface, in this closed triangle of a facet.
CutFeature LineAnswer::feature_at(const Triangle& triangle, const WayFromMiddle& way) {
  const auto& points = body_.graph.vertices;
  const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
  std::array<bool, 3> on{};  // the edge from corner k on
  for (std::size_t k = 0; k < 3; ++k) {
    on[k] = way.turn(points[triangle[k]], points[triangle[(k + 1) % 3]], &tally_) == Sign::zero;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (on[k] && on[(k + 2) % 3]) return vertex_feature(triangle[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = triangle[k], w = triangle[(k + 1) % 3];
    if (on[k] && graph.edge(v, w)) return edge_feature(v, w);
  }
  return facet_feature(graph.facet_of(triangle[0], triangle[1], triangle[2]));
}

// The body is where g(x) <= 1, g(x) the greatest n.(x - o) / h of its facets. Along the line g is convex, and Newton's
// method comes to the first point where it is 1 from before, never beyond it: each step goes to the plane of the facet
// that the ray from o through the last point goes through. Where g grows and is still above 1, there is no such point.
void LineAnswer::finish() {
  const LineInBody line(line_.a, line_.b, body_.pose);
  const auto& points = body_.graph.vertices;
  const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
  const std::array<Point3, 4> middle = top();
  const auto corner = [&](const Triangle& t, std::size_t k) -> const Point3& { return points[t[k]]; };
  const auto number = [&](const Triangle& t) { return graph.facet_of(t[0], t[1], t[2]); };
  const auto search = [&](Sense sense, std::uint32_t& facet, CutEnd& end) {
    ExactPoint3 place = line.from_afar();
    if (sense == Sense::leaving) place = {-place.x, -place.y, -place.z, place.denominator};
    Triangle at = triangle_towards(WayFromMiddle(middle, place));
    for (;;) {
      ++cost_.iterations;
      place = line.at_plane(corner(at, 0), corner(at, 1), corner(at, 2));
      const WayFromMiddle way(middle, place);
      const Triangle next = triangle_towards(way);
      const Sign outside = side_of_plane(corner(next, 0), corner(next, 1), corner(next, 2), place, &tally_);
      if (outside != Sign::positive) {
        facet = number(at);
        end = {feature_at(next, way), OwnEnd::none};
        return true;
      }
      const Sign facing_of = line.facing(corner(next, 0), corner(next, 1), corner(next, 2), &tally_);
      if (facing_of != (sense == Sense::entering ? Sign::negative : Sign::positive)) {
        set_apart({CutParting::By::facets, number(at), number(next), OwnEnd::a});
        return false;
      }
      at = next;
    }
  };
  if (search(Sense::entering, facets_.enters, first_) && search(Sense::leaving, facets_.leaves, last_)) {
    decide_kind();
  }
}

// Is the middle of the common part inside the body? Where it is not, that tells which edge or facet holds it.
bool LineAnswer::is_across() {
  ++tally_.exact;
  const LineInBody line(line_.a, line_.b, body_.pose);
  const auto& points = body_.graph.vertices;
  const auto place_of = [&](std::uint32_t facet) {
    const std::span<const std::uint32_t> v = body_.body.facet(facet);
    return line.at_plane(points[v[0]], points[v[1]], points[v[2]]);
  };
  const ExactPoint3 middle = LineInBody::between(place_of(facets_.enters), place_of(facets_.leaves));
  const WayFromMiddle way(top(), middle);
  const Triangle at = triangle_towards(way);
  if (side_of_plane(points[at[0]], points[at[1]], points[at[2]], middle, &tally_) != Sign::zero) return true;
  surface_ = feature_at(at, way);
  return false;
}

// ---- Own ends.

void LineAnswer::clip(OwnEnds ends, bool is_point) {
  if (kind_ == CutKind::nothing || !ends.a) return;
  const auto facet = [&](bool at_last) { return at_last ? facets_.leaves : facets_.enters; };
  clip_by(
      ends, is_point,
      [&](bool at_last, OwnEnd own) { return beyond(own == OwnEnd::a ? line_.a : line_.b, facet(at_last)); },
      [&](bool at_last, OwnEnd own) { return CutParting{CutParting::By::facet, facet(at_last), 0, own}; });
}

PolyhedronCut::Evidence LineAnswer::evidence() const {
  if (kind_ == CutKind::nothing) return parting_;
  if (kind_ == CutKind::across) return CutAcross{first_, last_, facets_};
  const bool has_inside = body_.body.dimension() == 3;
  const std::optional<LineFacets> facets = has_inside ? std::optional(facets_) : std::nullopt;
  if (kind_ == CutKind::point) return CutPoint{first_, facets};
  return CutAlong{first_, last_, surface_, facets};
}

PolyhedronCut LineAnswer::conclude(bool finished) const {
  PolyhedronCut cut{evidence(), {}, cost_};
  sunder::conclude(cut, tally_.exact, finished);
  return cut;
}

}  // namespace sunder::solid

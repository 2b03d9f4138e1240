// How every method but the scan answers which planes through a line support a body: what a line and a body have in
// common is known (polyhedron_cut.h), a search proposes vertices, signs dispose, and where none holds an exact method
// decides.
//
// If the line misses the body, the sign of orient_3d(a, b, v, w) tells whether a half-plane that turns around the line
// comes to w after v. The body takes up less than half a turn, so this orders the vertices. If no neighbour of a
// vertex comes after it, no vertex does: the plane through the line and the vertex has all edges at the vertex on one
// side or on it, and so it has their cone, which contains the body.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/predicate/line/line_planes.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/line/line_search.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/search_vector.h>

#include <cstdint>
#include <optional>
#include <span>

namespace sunder::solid {

class LineSupportSearch {
 public:
  // Keeps references.
  LineSupportSearch(const Placed& body, const Line& line) : body_(body), line_(line) {}

  // Lemma 12.
  LineSupport::Evidence at_known(const CutFeature& at);

  // Is no vertex beyond the plane of the line, which misses the body, and of vertex v? side: as of SupportPlane.
  bool holds(Sign side, std::uint32_t v);

  // The vertex where that is so: Newton's method by exact steps, from vertex v on.
  std::uint32_t finished_from(Sign side, std::uint32_t v);

  // The plane of support through the line and v. Requires a vertex v for which holds() is true.
  SupportPlane plane_at(Sign side, std::uint32_t v) { return {v, touched_at(v), side}; }

  LineSupport conclude(LineSupport::Evidence evidence, const PolyhedronCut* cut, bool finished) const;

  Sign past(std::uint32_t v, std::uint32_t w);  // positive: w is past v, as the half-plane turns

  Cost& cost() { return cost_; }
  const Placed& body() const { return body_; }
  const Line& line() const { return line_; }

 private:
  Sign turn(std::uint32_t v, std::uint32_t u, std::uint32_t w);  // seen along the line, from u to w around v
  bool is_on_line(std::uint32_t v);
  std::uint32_t further(Sign side, std::uint32_t v);  // exactly: the vertex furthest beyond the plane, or v
  CutFeature touched_at(std::uint32_t v);
  CutFeature facet_between(std::uint32_t v, std::uint32_t u, std::uint32_t w) const;
  LineSupport::Evidence at_vertex(std::uint32_t v);
  LineSupport::Evidence along_edge(std::uint32_t v, std::uint32_t w);
  LineSupport::Evidence in_facet(std::uint32_t facet);

  // Seen along the line, the edges around v turn one way and then back. Returns the number of the last one (where
  // `side` is positive: of the first one), or of one for which is_found() is true. Cost: O(log degree) signs.
  template <class IsFound>
  std::uint32_t extreme_edge(std::uint32_t v, Sign side, const IsFound& is_found);

  const Placed& body_;
  const Line& line_;
  Cost cost_;
  StageTally tally_;
};

// Newton's method in floating point, from the body's middle, or from a vertex: from each vertex to the one furthest
// beyond the plane through the line and it, as long as a sign says that this is past the one before.
// furthest(direction, v): of the body's frame, a vertex about furthest, of which the last one found is v. False where
// the line is out of range; else v is the last.
template <class Real, class Furthest>
bool newton_around_line(LineSupportSearch& search, Sign side, const Furthest& furthest,
                        std::optional<std::uint32_t>& v) {
  constexpr int most_newton_steps = 64;
  const Placed& body = search.body();
  const FacetGraph& graph = represent::of<FacetGraph>(body.body);
  const LineInFrame<Real> frame(body, graph, search.line());
  if (!frame.is_finite) return false;
  using Vector = VectorOf<Real>;
  const bool is_turned = (determinant_sign(body.pose) == Sign::positive) == (side == Sign::positive);
  const auto furthest_beyond = [&](const Vector& p) {
    ++search.cost().iterations;
    const Vector n = cross(frame.way, minus(p, frame.nearest));
    const Vector seen{n.x * Real(graph.to_one.x), n.y * Real(graph.to_one.y), n.z * Real(graph.to_one.z)};
    return furthest(is_turned ? negated(seen) : seen, v.value_or(0));
  };
  if (!v) v = furthest_beyond(Vector{});
  for (int step = 0; step < most_newton_steps; ++step) {
    const Point3 &p = body.body.vertices()[*v], &o = graph.center, &by = graph.to_one;
    const std::uint32_t w =
        furthest_beyond({difference<Real>(p.x, o.x) * Real(by.x), difference<Real>(p.y, o.y) * Real(by.y),
                         difference<Real>(p.z, o.z) * Real(by.z)});
    if (w == *v || search.past(*v, w) != -side) break;
    v = w;
  }
  return true;
}

inline std::optional<std::uint32_t> from_the_middle(LineSupportSearch&, Sign) { return std::nullopt; }

// furthest.template along<Real>(direction, v, cost): as above. first(search, side): the vertex to begin with, if any.
template <class Furthest, class First>
LineSupport line_support_by(const ConvexPolyhedron& body, const Pose& pose, const Line& line, const PolyhedronCut& cut,
                            const Furthest& furthest, const First& first) {
  SUNDER_REQUIRE(body.dimension() == 3);
  const Placed placed(body, pose);
  LineSupportSearch search(placed, line);
  if (const auto* point = std::get_if<CutPoint>(&cut.evidence)) {
    return search.conclude(search.at_known(point->at.at), &cut, false);
  }
  if (const auto* along = std::get_if<CutAlong>(&cut.evidence)) {
    return search.conclude(search.at_known(along->surface), &cut, false);
  }
  if (const auto* across = std::get_if<CutAcross>(&cut.evidence)) {
    return search.conclude(SupportNone{*across}, &cut, false);
  }
  bool finished = false;
  const auto to_side = [&](Sign side) {
    std::optional<std::uint32_t> last = first(search, side);
    const auto try_it = [&]<class Real>(Real) {
      const auto along = [&](const VectorOf<Real>& d, std::uint32_t v) {
        return furthest.template along<Real>(placed, d, v, search.cost());
      };
      if (!newton_around_line<Real>(search, side, along, last)) return false;
      ++search.cost().proposals;
      return search.holds(side, *last);
    };
    if (!try_it(double{}) && !try_it(DoubleDouble{})) {
      finished = true;
      last = search.finished_from(side, last.value_or(0));
    }
    return search.plane_at(side, *last);
  };
  const SupportPlane from = to_side(Sign::positive), to = to_side(Sign::negative);
  return search.conclude(SupportApart{from, to}, &cut, finished);
}

}  // namespace sunder::solid

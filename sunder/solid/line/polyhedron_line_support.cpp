#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/line/line_support_search.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/search/extreme_vertex.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <utility>

namespace sunder::solid {

namespace {

using ExactWay = Vector3<Dyadic>;

CutFeature edge_between(std::uint32_t v, std::uint32_t w) { return {CutPlace::edge, std::min(v, w), std::max(v, w)}; }

// Over the vertex graph, or where that is slow down the hierarchy.
struct FurthestByGraph {
  template <class Real>
  static std::uint32_t along(const Placed& body, const VectorOf<Real>& d, std::uint32_t v, Cost& cost) {
    if constexpr (std::is_same_v<Real, double>) {
      return support(body.body, d, cost.probes);
    } else {
      return support_in_double_doubles(body.body, d, v, cost.probes);
    }
  }
};

struct FurthestByHierarchy {
  template <class Real>
  static std::uint32_t along(const Placed& body, const VectorOf<Real>& d, std::uint32_t, Cost& cost) {
    return support_by_hierarchy<Real>(body.body, d, cost.probes);
  }
};

}  // namespace

std::string_view name_of(const LineSupport::Evidence& evidence) {
  return std::visit([](const auto& outcome) { return outcome.name; }, evidence);
}

std::vector<SupportPlane> planes_of(const LineSupport::Evidence& evidence) {
  if (const auto* apart = std::get_if<SupportApart>(&evidence)) return {apart->first, apart->last};
  if (const auto* range = std::get_if<SupportRange>(&evidence)) return {range->first, range->last};
  if (const auto* only = std::get_if<SupportOnly>(&evidence)) return {only->plane};
  return {};
}

std::vector<std::uint32_t> vertices_of(const ConvexPolyhedron& body, const CutFeature& feature) {
  switch (feature.place) {
    case CutPlace::vertex: return {feature.feature};
    case CutPlace::edge: return {feature.feature, feature.other};
    case CutPlace::facet: {
      const std::span<const std::uint32_t> cycle = body.facet(feature.feature);
      std::vector<std::uint32_t> vertices(cycle.begin(), cycle.end());
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }
    case CutPlace::inside: break;
  }
  return {};
}

// ---- Signs.

Sign LineSupportSearch::past(std::uint32_t v, std::uint32_t w) {
  ++cost_.probes;
  return orient_3d(line_.a, line_.b, body_[v], body_[w], &tally_);
}

Sign LineSupportSearch::turn(std::uint32_t v, std::uint32_t u, std::uint32_t w) {
  ++cost_.probes;
  return facing(line_.a, line_.b, {body_[v], body_[u], body_[w]}, &tally_);
}

bool LineSupportSearch::is_on_line(std::uint32_t v) {
  ++cost_.probes;
  return are_collinear(line_.a, line_.b, body_[v], &tally_);
}

// ---- Lemma 12.

// Edge k is beyond edge j where a turn leads from j to k. What is equal is beside each other at the top or the bottom,
// or is the edge along the line, between both.
template <class IsFound>
std::uint32_t LineSupportSearch::extreme_edge(std::uint32_t v, Sign side, const IsFound& is_found) {
  const std::span<const std::uint32_t> around = body_.body.neighbours(v);
  const auto n = static_cast<std::uint32_t>(around.size());
  const Sign wanted = -side;
  const auto is_beyond = [&](std::uint32_t j, std::uint32_t k) {
    return turn(v, around[j % n], around[k % n]) == wanted;
  };
  bool rises = is_beyond(0, 1);
  if (is_found(0) || (!rises && !is_beyond(0, n - 1))) return 0;
  std::uint32_t low = 0, high = n;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    const bool rises_there = is_beyond(middle, middle + 1);
    if (is_found(middle) || (!rises_there && !is_beyond(middle, middle - 1))) return middle;
    const bool is_before = rises ? !rises_there || is_beyond(middle, low) : !rises_there && is_beyond(low, middle);
    if (is_before) {
      high = middle;
    } else {
      low = middle;
      rises = rises_there;
    }
  }
  return low;
}

CutFeature LineSupportSearch::facet_between(std::uint32_t v, std::uint32_t u, std::uint32_t w) const {
  const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
  const FacetGraph::Edge edge = *graph.edge(v, u);
  const std::span<const std::uint32_t> cycle = body_.body.facet(edge.facet);
  const std::uint32_t before = cycle[(edge.position + cycle.size() - 1) % cycle.size()];
  return {CutPlace::facet, before == w ? edge.facet : graph.edge(v, w)->facet, 0};
}

LineSupport::Evidence LineSupportSearch::at_known(const CutFeature& at) {
  switch (at.place) {
    case CutPlace::vertex: return at_vertex(at.feature);
    case CutPlace::edge: {
      const std::uint32_t v = at.feature, w = at.other;
      const bool v_is_on = is_on_line(v), w_is_on = is_on_line(w);
      if (v_is_on && w_is_on) return along_edge(v, w);
      if (v_is_on || w_is_on) return at_vertex(v_is_on ? v : w);
      const FacetGraph::Edge edge = *represent::of<FacetGraph>(body_.body).edge(v, w);
      const std::span<const std::uint32_t> cycle = body_.body.facet(edge.facet);
      // Across the edge the line is in no facet's plane, where it is a line of support and not in the facet itself.
      const Sign side = past(v, cycle[(edge.position + 2) % cycle.size()]);
      if (side == Sign::zero) return in_facet(edge.facet);
      const FacetGraph::Edge back = *represent::of<FacetGraph>(body_.body).edge(w, v);
      const std::span<const std::uint32_t> other = body_.body.facet(back.facet);
      if (past(v, other[(back.position + 2) % other.size()]) == Sign::zero) return in_facet(back.facet);
      return SupportOnly{{v, at, side}};
    }
    default: return in_facet(at.feature);
  }
}

LineSupport::Evidence LineSupportSearch::in_facet(std::uint32_t facet) {
  const std::span<const std::uint32_t> cycle = body_.body.facet(facet);
  std::size_t k = 0;
  while (k < 2 && is_on_line(cycle[k])) ++k;
  // At most two neighbours of a vertex are in the plane of a facet: one of any three is not.
  const std::span<const std::uint32_t> around = body_.body.neighbours(cycle[k]);
  Sign side = Sign::zero;
  for (std::size_t j = 0; j < 3 && side == Sign::zero; ++j) side = past(cycle[k], around[j]);
  return SupportOnly{{cycle[k], {CutPlace::facet, facet, 0}, side}};
}

LineSupport::Evidence LineSupportSearch::along_edge(std::uint32_t v, std::uint32_t w) {
  const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
  const auto beside = [&](std::uint32_t from, std::uint32_t to) {
    const FacetGraph::Edge edge = *graph.edge(from, to);
    const std::span<const std::uint32_t> cycle = body_.body.facet(edge.facet);
    return SupportPlane{cycle[(edge.position + 2) % cycle.size()], {CutPlace::facet, edge.facet, 0}, Sign::positive};
  };
  SupportPlane first = beside(v, w), last = beside(w, v);
  if (past(first.through, last.through) == Sign::negative) std::swap(first, last);
  last.side = Sign::negative;
  return SupportRange{first, last, edge_between(v, w)};
}

LineSupport::Evidence LineSupportSearch::at_vertex(std::uint32_t v) {
  const std::span<const std::uint32_t> around = body_.body.neighbours(v);
  const auto n = static_cast<std::uint32_t>(around.size());
  const auto none = [](std::uint32_t) { return false; };
  const std::uint32_t first = extreme_edge(v, Sign::positive, none), last = extreme_edge(v, Sign::negative, none);
  for (const std::uint32_t k : {first, first + 1, first + n - 1, last, last + 1, last + n - 1}) {
    if (is_on_line(around[k % n])) return along_edge(v, around[k % n]);
  }
  // Half a turn apart: the line goes on in the facet between them.
  if (turn(v, around[first], around[last]) == Sign::zero) {
    return in_facet(facet_between(v, around[first], around[last]).feature);
  }
  const auto plane = [&](std::uint32_t k, Sign side) -> SupportPlane {
    const std::uint32_t w = around[k];
    for (const std::uint32_t u : {around[(k + 1) % n], around[(k + n - 1) % n]}) {
      if (turn(v, u, w) == Sign::zero) return {w, facet_between(v, u, w), side};
    }
    return {w, edge_between(v, w), side};
  };
  return SupportRange{plane(first, Sign::positive), plane(last, Sign::negative), {CutPlace::vertex, v, 0}};
}

LineSupport planes_of_support_at(const ConvexPolyhedron& body, const Pose& pose, const Line& line,
                                 const CutFeature& at) {
  SUNDER_REQUIRE(body.dimension() == 3 && at.place != CutPlace::inside);
  const Placed placed(body, pose);
  LineSupportSearch search(placed, line);
  return search.conclude(search.at_known(at), nullptr, false);
}

// ---- Of a line that misses the body.

bool LineSupportSearch::holds(Sign side, std::uint32_t v) {
  const std::span<const std::uint32_t> around = body_.body.neighbours(v);
  if (around.size() > most_around) return further(side, v) == v;
  return std::all_of(around.begin(), around.end(), [&](std::uint32_t w) { return past(v, w) != -side; });
}

std::uint32_t LineSupportSearch::further(Sign side, std::uint32_t v) {
  const auto from = coordinates<Dyadic>(line_.a);
  ExactWay normal = cross(coordinates<Dyadic>(line_.b) - from, coordinates<Dyadic>(body_[v]) - from);
  const WorldDirection direction(std::move(normal));
  Along along(direction, body_.pose, body_.tame);
  const End end = side == Sign::positive ? End::least : End::greatest;
  return extreme_vertex_from(body_, along, end, v, cost_, tally_);
}

std::uint32_t LineSupportSearch::finished_from(Sign side, std::uint32_t v) {
  for (;;) {
    ++cost_.iterations;
    const std::uint32_t w = further(side, v);
    if (w == v) return v;
    v = w;
  }
}

// What the plane touches has v, and is one of its edges, or a facet between two that follow each other. Seen from v
// along the line, such edges are the first, the last, or beside these, as all of the body is on one side of the plane.
CutFeature LineSupportSearch::touched_at(std::uint32_t v) {
  const std::span<const std::uint32_t> around = body_.body.neighbours(v);
  const auto n = static_cast<std::uint32_t>(around.size());
  const auto is_touched = [&](std::uint32_t k) { return past(v, around[k % n]) == Sign::zero; };
  std::optional<std::uint32_t> found;
  if (n <= most_around) {
    for (std::uint32_t k = 0; k < n && !found; ++k) {
      if (is_touched(k)) found = k;
    }
  } else {
    for (const Sign side : {Sign::positive, Sign::negative}) {
      const std::uint32_t k = extreme_edge(v, side, is_touched);
      for (const std::uint32_t j : {k, k + 1, k + n - 1}) {
        if (!found && is_touched(j)) found = j % n;
      }
    }
  }
  if (!found) return {CutPlace::vertex, v, 0};
  for (const std::uint32_t j : {*found + 1, *found + n - 1}) {
    if (is_touched(j)) return facet_between(v, around[*found], around[j % n]);
  }
  return edge_between(v, around[*found]);
}

LineSupport LineSupportSearch::conclude(LineSupport::Evidence evidence, const PolyhedronCut* cut, bool finished) const {
  LineSupport answer{evidence, {}, cost_};
  std::uint32_t exact = tally_.exact;
  if (cut != nullptr) {
    answer.cost.probes += cut->cost.probes;
    answer.cost.iterations += cut->cost.iterations;
    answer.cost.proposals += cut->cost.proposals;
    exact += cut->cost.exact;
    finished = finished || cut->decided_by == DecidedBy::finishing;
  }
  sunder::conclude(answer, exact, finished);
  return answer;
}

// ---- Methods.

LineSupport polyhedron_line_support(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return line_support_by(body, pose, line, polyhedron_line(body, pose, line), FurthestByGraph{}, from_the_middle);
}

LineSupport polyhedron_line_support_by_hierarchy(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  const PolyhedronCut cut =
      cut_by(body, pose, line.a, line.b, {}, [](const Placed& placed, const Line& of, const auto& holds, Cost& cost) {
        return propose_by_hierarchy(placed, of, holds, cost);
      });
  return line_support_by(body, pose, line, cut, FurthestByHierarchy{}, from_the_middle);
}

}  // namespace sunder::solid

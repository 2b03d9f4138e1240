// Points, segments and flat polygons of space, and a line, a ray or a segment: by signs of the vertices, and where the
// line is in one plane with the body by exact numbers.
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <utility>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;
using By = CutParting::By;

CutEnd at_vertex(std::uint32_t v) { return {{CutPlace::vertex, v, 0}, OwnEnd::none}; }
CutEnd at_edge(std::uint32_t v, std::uint32_t w) {
  return {{CutPlace::edge, std::min(v, w), std::max(v, w)}, OwnEnd::none};
}
CutEnd at_facet() { return {{CutPlace::facet, 0, 0}, OwnEnd::none}; }

}  // namespace

void LineAnswer::decide_flat(OwnEnds ends, bool is_point) {
  cost_.probes += std::min<std::size_t>(body_.graph.vertices.size(), 3);
  switch (body_.body.dimension()) {
    case 0: decide_point(); break;
    case 1: decide_segment(); break;
    default: decide_polygon(); break;
  }
  clip_flat(ends, is_point);
}

void LineAnswer::decide_point() {
  if (!are_collinear(line_.a, line_.b, body_[0], &tally_)) return set_apart({By::perpendicular, 0, 0, OwnEnd::a});
  set_point(at_vertex(0));
}

void LineAnswer::decide_segment() {
  if (orient_3d(line_.a, line_.b, body_[0], body_[1], &tally_) != Sign::zero) {
    return set_apart({By::edge_and_line, 0, 1, OwnEnd::a});
  }
  ++tally_.exact;
  const Exact a = coordinates<Dyadic>(line_.a), way = coordinates<Dyadic>(line_.b) - a;
  const Exact p = coordinates<Dyadic>(body_[0]), edge = coordinates<Dyadic>(body_[1]) - p;
  const Exact normal = cross(way, edge);
  if (is_zero(normal)) {
    if (!is_zero(cross(way, p - a))) return set_apart({By::perpendicular, 0, 0, OwnEnd::a});
    const bool forward = dot(way, edge).sign() == Sign::positive;
    kind_ = CutKind::along;
    first_ = at_vertex(forward ? 0 : 1);
    last_ = at_vertex(forward ? 1 : 0);
    surface_ = {CutPlace::edge, 0, 1};
    return;
  }
  // At p + s edge: way x (p + s edge - a) is zero.
  const Dyadic s = dot(cross(way, a - p), normal), whole = dot(normal, normal);
  const Sign before = s.sign(), after = (s - whole).sign();
  if (before == Sign::negative) return set_apart({By::perpendicular, 0, 0, OwnEnd::a});
  if (after == Sign::positive) return set_apart({By::perpendicular, 1, 0, OwnEnd::a});
  set_point(before == Sign::zero ? at_vertex(0) : after == Sign::zero ? at_vertex(1) : at_edge(0, 1));
}

void LineAnswer::decide_polygon() {
  const Sign of_line = facing(0);
  if (of_line != Sign::zero) {
    const Pierced pierced = pierce(0, of_line == Sign::negative ? Sense::entering : Sense::leaving);
    if (!pierced.is_pierced) {
      return set_apart({By::edge_and_line, pierced.across[0], pierced.across[1], OwnEnd::a});
    }
    return set_point({pierced.at, OwnEnd::none});
  }
  if (beyond(line_.a, 0) != Sign::zero) return set_apart({By::facet, 0, 0, OwnEnd::a});
  decide_in_plane();
}

// As Chazelle & Dobkin 1987, Theorem 3: heights over the line, to its left as the polygon is counter-clockwise, change
// their sign once from the lowest vertex to the highest, and once back.
void LineAnswer::decide_in_plane() {
  const std::span<const std::uint32_t> cycle = body_.body.facet(0);
  const std::uint32_t n = static_cast<std::uint32_t>(cycle.size());
  const Exact a = coordinates<Dyadic>(line_.a), way = coordinates<Dyadic>(line_.b) - a;
  const auto [u, v, w] = corners(0);
  const Exact from = coordinates<Dyadic>(u);
  const Exact left = cross(cross(coordinates<Dyadic>(v) - from, coordinates<Dyadic>(w) - from), way);
  const WorldDirection direction(left);
  Along along(direction, body_.pose, body_.tame);
  const auto height = [&](std::uint32_t vertex) {
    ++cost_.probes;
    ++tally_.exact;
    return dot(left, coordinates<Dyadic>(body_[vertex]) - a).sign();
  };
  const std::uint32_t highest = extreme_vertex_from(body_, along, End::greatest, 0, cost_, tally_),
                      lowest = extreme_vertex_from(body_, along, End::least, 0, cost_, tally_);
  const Sign of_highest = height(highest), of_lowest = height(lowest);
  if (of_highest == Sign::negative) return set_apart({By::perpendicular, highest, 0, OwnEnd::a});
  if (of_lowest == Sign::positive) return set_apart({By::perpendicular, lowest, 0, OwnEnd::a});
  const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
  const auto position = [&](std::uint32_t vertex) {
    std::uint32_t k = graph.begin[vertex];
    while (graph.edges[k].facet != 0) ++k;
    return graph.edges[k].position;
  };
  const auto at = [&](std::uint32_t k) { return cycle[k < n ? k : k - n]; };
  if (of_highest == Sign::zero || of_lowest == Sign::zero) {
    const std::uint32_t k = position(of_highest == Sign::zero ? highest : lowest), vertex = at(k);
    set_point(at_vertex(vertex));
    for (const std::uint32_t other : {at(k + 1), at(k + n - 1)}) {
      if (height(other) != Sign::zero) continue;
      const Exact edge = coordinates<Dyadic>(body_[other]) - coordinates<Dyadic>(body_[vertex]);
      kind_ = CutKind::along;
      surface_ = at_edge(vertex, other).at;
      (dot(edge, way).sign() == Sign::positive ? last_ : first_) = at_vertex(other);
    }
    return;
  }
  // The first vertex after position `begin` that is not on its side, or the edge that leads to it.
  const auto crossing = [&](std::uint32_t begin, std::uint32_t end, Sign of_begin) {
    if (end < begin) end += n;
    Sign of_high = -of_begin;
    std::uint32_t low = begin, high = end;
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      const Sign s = height(at(middle));
      if (s == of_begin) {
        low = middle;
      } else {
        high = middle;
        of_high = s;
      }
    }
    return of_high == Sign::zero ? at_vertex(at(high)) : at_edge(at(low), at(high));
  };
  const std::uint32_t top = position(highest), bottom = position(lowest);
  kind_ = CutKind::along;
  surface_ = at_facet().at;
  last_ = crossing(bottom, top, of_lowest);
  first_ = crossing(top, bottom, of_highest);
}

// What parts the body from an own end: beyond this end of the common part (sense positive), or before it (negative).
CutParting LineAnswer::parting_at(const CutEnd& end, Sign sense, OwnEnd beyond) {
  const int dimension = body_.body.dimension();
  if (dimension == 0) return {By::line, 0, 0, beyond};
  if (dimension == 1) {
    return {kind_ == CutKind::along ? By::line : By::edge, end.at.feature, 1 - end.at.feature, beyond};
  }
  if (facing(0) != Sign::zero) return {By::facet, 0, 0, beyond};
  if (end.at.place == CutPlace::edge) return {By::edge_in_plane, end.at.feature, end.at.other, beyond};
  // One of the vertex's edges, across which the line goes out.
  const auto [u, v, w] = corners(0);
  const Exact from = coordinates<Dyadic>(u);
  const Exact normal = cross(coordinates<Dyadic>(v) - from, coordinates<Dyadic>(w) - from);
  const Exact way = coordinates<Dyadic>(line_.b) - coordinates<Dyadic>(line_.a);
  const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
  const std::uint32_t at = end.at.feature;
  for (std::uint32_t k = graph.begin[at]; k < graph.begin[at + 1]; ++k) {
    const auto& [to, facet, position] = graph.edges[k];
    const Exact edge = coordinates<Dyadic>(body_[to]) - coordinates<Dyadic>(body_[at]);
    const Sign outward = facet == 0 ? Sign::positive : Sign::negative;  // of facet 0's edge from `at`, or to it
    if (dot(cross(edge, normal), way).sign() * outward == sense) return {By::edge_in_plane, at, to, beyond};
  }
  return {};
}

void LineAnswer::clip_flat(OwnEnds ends, bool is_point) {
  if (kind_ == CutKind::nothing || !ends.a) return;
  ++tally_.exact;
  const ExactFraction first = exact_end(body_, line_, first_).along_line,
                      last = exact_end(body_, line_, last_).along_line;
  clip_by(
      ends, is_point,
      [&](bool at_last, OwnEnd own) {
        const ExactFraction at{Dyadic(own == OwnEnd::a ? 0.0 : 1.0)};
        return at_last ? compare(at, last) : compare(first, at);
      },
      [&](bool at_last, OwnEnd own) {
        return parting_at(at_last ? last_ : first_, at_last ? Sign::positive : Sign::negative, own);
      });
}

}  // namespace sunder::solid

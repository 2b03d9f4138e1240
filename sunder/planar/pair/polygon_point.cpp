#include <sunder/base/contract.h>
#include <sunder/base/names.h>
#include <sunder/planar/pair/evidence.h>
#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/in_world.h>
#include <sunder/planar/pair/polygon_point.h>

#include <array>
#include <cmath>
#include <utility>

namespace sunder::planar {

namespace {

struct Located {
  Place place = Place::outside;
  // The position of the vertex, or that at which the edge begins; outside, that of an edge that has the point strictly
  // to its right, or, where `in_line`, of the vertex next to the point. Inside, the point is in the triangle of
  // vertices 0, at, at + 1, and not on its last edge, nor where the other two are edges of the polygon.
  std::uint32_t at = 0;
  bool in_line = false;  // outside a point, or outside a segment and in its line
};

// Cost: at most log2 n + 4 probes, one sign each.
template <class Sequence>
Located locate(const Sequence& p, const typename Sequence::Vertex& x, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  const auto side = [&](std::uint32_t i, std::uint32_t j) {  // of the line from i to j
    ++cost.probes;
    return cross_2d(p[i], p[j], p[i], x, &tally);
  };
  if (n == 1) {
    ++cost.probes;
    if (evidence::equal(p[0], x, tally)) return {Place::vertex, 0};
    return {Place::outside, 0, true};
  }
  const Sign of_first = side(0, 1);
  if (n == 2) {
    if (of_first != Sign::zero) return {Place::outside, of_first == Sign::negative ? 0u : 1u};
    const Sign beyond = dot_2d(p[0], x, p[1], x, &tally);
    if (beyond == Sign::negative) return {Place::edge, 0};
    const std::uint32_t near = dot_2d(p[0], p[1], p[0], x, &tally) == Sign::positive ? 1 : 0;
    if (beyond == Sign::zero) return {Place::vertex, near};
    return {Place::outside, near, true};
  }
  // Not in the cone of vertex 0, or its apex?
  if (of_first == Sign::negative) return {Place::outside, 0};
  const Sign of_last = side(0, n - 1);
  if (of_last == Sign::positive) return {Place::outside, n - 1};
  if (of_first == Sign::zero && of_last == Sign::zero) return {Place::vertex, 0};
  // Between which two of the lines from vertex 0?
  const std::uint32_t i = first_where(2, n - 1,
                                      [&](std::uint32_t k) {
                                        ++cost.iterations;
                                        return side(0, k) == Sign::negative;
                                      }) -
                          1;
  const Sign of_edge = side(i, i + 1);
  if (of_edge == Sign::negative) return {Place::outside, i};
  if (of_edge == Sign::zero) {
    for (const std::uint32_t k : {i, i + 1}) {
      if (evidence::equal(p[k], x, tally)) return {Place::vertex, k};
    }
    return {Place::edge, i};
  }
  if (of_first == Sign::zero) return {Place::edge, 0};
  if (of_last == Sign::zero) return {Place::edge, n - 1};
  return {Place::inside, i};
}

// The evidence for the place that was found: its numbers, and what proves it.
template <class Sequence>
PolygonPoint::Evidence explain(const Sequence& p, const typename Sequence::Vertex& x, const Located& found,
                               StageTally& tally) {
  const OnePoint<typename Sequence::Vertex> point(x);
  const std::array<std::uint32_t, 1> only{0};
  const std::uint32_t at = found.at, next = position(p, at + 1);
  const auto common = [&](Corners corners) {
    PairCertificate proof;
    check_meet(p, corners, point, only, proof, tally);
    return std::get<CommonVertices>(proof);
  };
  switch (found.place) {
    case Place::outside: break;
    case Place::vertex: return AtVertex{p.number(at), common(std::array{at})};
    case Place::edge: return InEdge{edge_number(p, at), common(std::array{at, next})};
    case Place::inside: return InsidePolygon{common(std::array{0u, at, next})};
  }
  if (found.in_line) {
    return OutsidePolygon{{{.kind = Direction::Kind::difference, .index = {p.number(at), 0}}, p.number(at), 0}};
  }
  return OutsidePolygon{apart_by_edge_of_a(p, at, point, 0)};
}

// The tangents from x, outside p, as positions: .left and .right as in TangentVertices.
template <class Sequence>
Extremes find_tangents(const Sequence& p, const typename Sequence::Vertex& x, const Located& found, Cost& cost,
                       StageTally& tally) {
  const std::uint32_t n = p.size();
  if (found.in_line) return {found.at, found.at};
  const std::uint32_t near = found.at;
  if (n == 2) return {near, 1 - near};
  // The edges that have x strictly to their right stand together, and `near` is one of them. Of the two at the vertex
  // furthest from its line, one at least has not: x, to the right of both, would be on that vertex's far side.
  const auto sees = [&](std::uint32_t k) {
    ++cost.probes;
    ++cost.iterations;
    return cross_2d(vertex_at(p, k), vertex_at(p, position(p, k) + 1), vertex_at(p, k), x, &tally) == Sign::negative;
  };
  const std::uint32_t top = extreme_vertex_by_bisection(p, p[near], vertex_at(p, near + 1), cost, tally);
  std::uint32_t hidden = sees(top) ? position(p, top + n - 1) : top;
  if (hidden < near) hidden += n;
  const std::uint32_t end = first_where(near + 1, hidden, [&](std::uint32_t k) { return !sees(k); });
  const std::uint32_t begin = first_where(hidden + 1, near + n, sees);
  return {begin % n, end % n};
}

// The answer whose evidence method(p, x, cost, tally) gives.
template <class Answer, class Method>
Answer ask(const ConvexPolygon& polygon, const Pose& pose, const Point2& point, const Method& method) {
  return with_placed(polygon, pose, [&](const auto& p) {
    Cost cost;
    StageTally tally;
    const auto x = in_world<typename std::remove_cvref_t<decltype(p)>::Vertex>(point);
    Answer answer{method(p, x, cost, tally), {}, cost};
    conclude(answer, tally.exact);
    return answer;
  });
}

// Without any search: an edge that has x beyond it, or in its line; else the first of the triangles of vertex 0 that
// does not have x beyond its last side.
template <class Sequence>
Located locate_by_scan(const Sequence& p, const typename Sequence::Vertex& x, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  for (std::uint32_t k = 0; k < n; ++k) {
    ++cost.probes;
    if (evidence::equal(p[k], x, tally)) return {Place::vertex, k};
  }
  for (std::uint32_t k = 0; n > 1 && k < n; ++k) {
    ++cost.probes;
    const auto &a = p[k], &b = p[(k + 1) % n];
    if (cross_2d(a, b, a, x, &tally) == Sign::negative) return {Place::outside, k};
    if (evidence::on_segment(x, a, b, tally)) return {Place::edge, k};
  }
  if (n < 3) {  // in line with a segment, or beside a point
    return {Place::outside, n == 2 && dot_2d(p[0], p[1], p[0], x, &tally) == Sign::positive ? 1u : 0u, true};
  }
  for (std::uint32_t k = 1; k + 2 < n; ++k) {
    ++cost.probes;
    if (cross_2d(p[0], p[k + 1], p[0], x, &tally) != Sign::positive) return {Place::inside, k};
  }
  return {Place::inside, n - 2};
}

}  // namespace

std::string_view name_of(Place place) { return name_in<Place::inside>({"outside", "vertex", "edge", "inside"}, place); }

Place place_of(const PolygonPoint& answer) {
  return std::visit([](const auto& found) { return found.place; }, answer.evidence);
}

PairCertificate pair_certificate(const PolygonPoint& answer) {
  return std::visit(
      [](const auto& found) -> PairCertificate {
        if constexpr (requires { found.parting; })
          return found.parting;
        else
          return found.common;
      },
      answer.evidence);
}

PolygonPoint polygon_point(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  SUNDER_REQUIRE(std::isfinite(point.x) && std::isfinite(point.y));
  return ask<PolygonPoint>(polygon, pose, point, [](const auto& p, const auto& x, Cost& cost, StageTally& tally) {
    return explain(p, x, locate(p, x, cost, tally), tally);
  });
}

PolygonPoint polygon_point_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  return ask<PolygonPoint>(polygon, pose, point, [](const auto& p, const auto& x, Cost& cost, StageTally& tally) {
    return explain(p, x, locate_by_scan(p, x, cost, tally), tally);
  });
}

Tangents tangents(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  return ask<Tangents>(polygon, pose, point,
                       [](const auto& p, const auto& x, Cost& cost, StageTally& tally) -> Tangents::Evidence {
                         const Located found = locate(p, x, cost, tally);
                         if (found.place != Place::outside) return NoTangents{found.place};
                         const Extremes e = find_tangents(p, x, found, cost, tally);
                         return TangentVertices{p.number(e.left), p.number(e.right)};
                       });
}

Tangents tangents_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  return ask<Tangents>(
      polygon, pose, point, [](const auto& p, const auto& x, Cost& cost, StageTally& tally) -> Tangents::Evidence {
        const Place place = locate_by_scan(p, x, cost, tally).place;
        if (place != Place::outside) return NoTangents{place};
        Extremes best;
        for (std::uint32_t k = 1; k < p.size(); ++k) {
          ++cost.probes;
          const auto beats = [&](std::uint32_t champion, Sign side) {
            const Sign turn = cross_2d(x, p[champion], x, p[k], &tally);
            return turn == side ||
                   (turn == Sign::zero && dot_2d(x, p[champion], p[champion], p[k], &tally) == Sign::negative);
          };
          if (beats(best.left, Sign::positive)) best.left = k;
          if (beats(best.right, Sign::negative)) best.right = k;
        }
        return TangentVertices{p.number(best.left), p.number(best.right)};
      });
}

}  // namespace sunder::planar

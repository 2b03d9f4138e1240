#include <sunder/base/contract.h>
#include <sunder/base/names.h>
#include <sunder/planar/pair/point_search.h>
#include <sunder/planar/pair/polygon_point.h>

#include <cmath>

namespace sunder::planar {

namespace {

// Calls method(p, x, answer, tally) and returns the answer.
template <class Answer, class Method>
Answer ask(const ConvexPolygon& polygon, const Pose& pose, const Point2& point, const Method& method) {
  return with_placed(polygon, pose, [&](const auto& p) {
    Answer answer;
    StageTally tally;
    const auto x = in_world<typename std::remove_cvref_t<decltype(p)>::Vertex>(point);
    method(p, x, answer, tally);
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

PolygonPoint polygon_point(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  SUNDER_REQUIRE(std::isfinite(point.x) && std::isfinite(point.y));
  return ask<PolygonPoint>(polygon, pose, point, [](const auto& p, const auto& x, PolygonPoint& a, StageTally& tally) {
    explain(p, x, locate(p, x, a.cost, tally), a, tally);
  });
}

PolygonPoint polygon_point_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  return ask<PolygonPoint>(polygon, pose, point, [](const auto& p, const auto& x, PolygonPoint& a, StageTally& tally) {
    explain(p, x, locate_by_scan(p, x, a.cost, tally), a, tally);
  });
}

Tangents tangents(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  return ask<Tangents>(polygon, pose, point, [](const auto& p, const auto& x, Tangents& a, StageTally& tally) {
    const Located found = locate(p, x, a.cost, tally);
    a.place = found.place;
    if (found.place != Place::outside) return;
    const Extremes e = find_tangents(p, x, found, a.cost, tally);
    a.vertices = TangentVertices{p.number(e.left), p.number(e.right)};
  });
}

Tangents tangents_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  return ask<Tangents>(polygon, pose, point, [](const auto& p, const auto& x, Tangents& a, StageTally& tally) {
    a.place = locate_by_scan(p, x, a.cost, tally).place;
    if (a.place != Place::outside) return;
    Extremes best;
    for (std::uint32_t k = 1; k < p.size(); ++k) {
      ++a.cost.probes;
      const auto beats = [&](std::uint32_t champion, Sign side) {
        const Sign turn = cross_2d(x, p[champion], x, p[k], &tally);
        return turn == side ||
               (turn == Sign::zero && dot_2d(x, p[champion], p[champion], p[k], &tally) == Sign::negative);
      };
      if (beats(best.left, Sign::positive)) best.left = k;
      if (beats(best.right, Sign::negative)) best.right = k;
    }
    a.vertices = TangentVertices{p.number(best.left), p.number(best.right)};
  });
}

}  // namespace sunder::planar

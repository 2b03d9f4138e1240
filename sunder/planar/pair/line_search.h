// Where a line cuts a convex sequence of vertices, and what a ray or a segment leaves of that. For questions and ties
// see polygon_cut.h; while here, features are positions.
// Also called: line clipping by binary search; stabbing.
//
// As in Chazelle & Dobkin 1987, Theorem 3: a vertex z off the line; the vertex w furthest to the other side; from one
// to the other, either way round, heights over the line change their sign once.
#pragma once

#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/in_world.h>
#include <sunder/planar/pair/polygon_cut.h>

#include <optional>

namespace sunder::planar {

// furthest_left(from, to, cost, tally) gives the position of the vertex furthest to the left of an arrow, of two the
// one further along. Cost: that search, and two of at most log2 n + 1 probes each.
template <class Sequence, class FurthestLeft>
PolygonCut::Evidence cut_by_line(const Sequence& p, const typename Sequence::Vertex& a,
                                 const typename Sequence::Vertex& b, const FurthestLeft& furthest_left, Cost& cost,
                                 StageTally& tally) {
  const std::uint32_t n = p.size();
  const auto side = [&](std::uint32_t k) {
    ++cost.probes;
    return cross_2d(a, b, a, vertex_at(p, k), &tally);
  };
  const auto vertex = [](std::uint32_t k) { return CutEnd{Place::vertex, k}; };
  std::uint32_t z = 0;  // among three vertices, one is off the line
  Sign of_z = side(0);
  while (of_z == Sign::zero && z + 1 < n) of_z = side(++z);
  if (of_z == Sign::zero) {
    if (n == 1) return CutPoint{vertex(0)};
    const bool forward = dot_2d(a, b, p[0], p[1], &tally) == Sign::positive;
    return CutAlong{vertex(forward ? 0 : 1), vertex(forward ? 1 : 0), 0};
  }
  // Let z be to the right of the line, for now.
  const bool turned = of_z == Sign::positive;
  const std::uint32_t w = furthest_left(turned ? b : a, turned ? a : b, cost, tally);
  const Sign of_w = side(w);
  if (of_w == of_z) return BesideLine{w};
  if (of_w == Sign::zero) {  // the line touches
    const std::uint32_t next = position(p, w + 1);
    if (n == 2 || side(next) != Sign::zero) return CutPoint{vertex(w)};
    return CutAlong{vertex(turned ? w : next), vertex(turned ? next : w), w};  // the edge runs against the line
  }
  if (n == 2) return CutPoint{{Place::edge, 0}};
  // The end of the chain from `begin` to `end` that is not on the side of `begin`: the first vertex that is not.
  const auto crossing = [&](std::uint32_t begin, std::uint32_t end, Sign of_begin) {
    if (end < begin) end += n;
    Sign last_seen = of_begin;  // of the first vertex found that is not on the side of `begin`
    const std::uint32_t k = first_where(begin + 1, end, [&](std::uint32_t i) {
      ++cost.iterations;
      const Sign s = side(i);
      if (s != of_begin) last_seen = s;
      return s != of_begin;
    });
    // Where no vertex was seen on the line or beyond it, it is the chain's end, which is beyond.
    if (last_seen == Sign::zero) return CutEnd{Place::vertex, position(p, k)};
    return CutEnd{Place::edge, position(p, k - 1)};
  };
  const CutEnd from_z = crossing(z, w, of_z), from_w = crossing(w, z, of_w);
  return turned ? CutAcross{from_z, from_w} : CutAcross{from_w, from_z};
}

// From what the line has in common with p to what the ray from a, or the segment from a to b (`ends`), has. Requires
// two different points.
template <class Sequence>
PolygonCut::Evidence clip(const Sequence& p, const typename Sequence::Vertex& a, const typename Sequence::Vertex& b,
                          bool ends, const PolygonCut::Evidence& of_line, StageTally& tally) {
  std::optional<CutEnds<CutEnd>> common = ends_of(of_line);
  if (!common) return of_line;
  // Where a point x of the line is, seen from an end of the common part: positive for beyond it.
  const auto beyond = [&](const auto& x, const CutEnd& end) {
    const auto& v = p[end.feature];
    if (end.place == Place::vertex) return dot_2d(a, b, v, x, &tally);
    const auto& w = vertex_at(p, end.feature + 1);
    return cross_2d(v, w, v, x, &tally) * cross_2d(v, w, a, b, &tally);
  };
  CutEnd &first = common->first, &last = common->last;
  const bool one = kind_of(of_line) == CutKind::point;
  const Sign a_first = beyond(a, first), a_last = one ? a_first : beyond(a, last);
  const Sign b_first = ends ? beyond(b, first) : Sign::positive;
  if (a_last == Sign::positive) return BeyondEnd{OwnEnd::a};
  if (b_first == Sign::negative) return BeyondEnd{OwnEnd::b};
  if (a_last == Sign::zero) return CutPoint{{last.place, last.feature, OwnEnd::a}};
  if (b_first == Sign::zero) return CutPoint{{first.place, first.feature, OwnEnd::b}};
  if (one) return of_line;
  const auto* along = std::get_if<CutAlong>(&of_line);
  const CutEnd between = along != nullptr ? CutEnd{Place::edge, along->edge} : CutEnd{Place::inside, 0};
  const auto shorten = [&](Sign outward, CutEnd& end, OwnEnd own) {
    if (outward == Sign::positive) return;
    if (outward == Sign::negative) end = between;
    end.own = own;
  };
  const Sign b_last = ends ? beyond(b, last) : Sign::positive;
  shorten(-a_first, first, OwnEnd::a);
  shorten(b_last, last, OwnEnd::b);
  if (along != nullptr) return CutAlong{first, last, along->edge};
  return CutAcross{first, last};
}

// From positions to numbers.
template <class Sequence>
void renumber(const Sequence& p, PolygonCut::Evidence& cut) {
  const auto number = [&p](CutEnd& end) {
    end.feature = end.place == Place::vertex ? p.number(end.feature)
                  : end.place == Place::edge ? edge_number(p, end.feature)
                                             : 0;
  };
  std::visit(
      [&](auto& held) {
        if constexpr (requires { held.nearest; }) held.nearest = p.number(held.nearest);
        if constexpr (requires { held.at; }) number(held.at);
        if constexpr (requires { held.first; }) {
          number(held.first);
          number(held.last);
        }
        if constexpr (requires { held.edge; }) held.edge = edge_number(p, held.edge);
      },
      cut);
}

// The answer with the polygon's own numbers, of what find(cost, tally) gives.
template <class Sequence, class Find>
PolygonCut conclude_cut(const Sequence& p, const Find& find) {
  PolygonCut answer;
  StageTally tally;
  answer.evidence = find(answer.cost, tally);
  renumber(p, answer.evidence);
  conclude(answer, tally.exact);
  return answer;
}

// What the ray from a through b, or the segment where it `ends` at b, has in common with the polygon. Requires two
// different points.
inline PolygonCut cut_and_clip(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b,
                               bool ends) {
  return with_placed(polygon, pose, [&](const auto& p) {
    using Vertex = typename std::remove_cvref_t<decltype(p)>::Vertex;
    return conclude_cut(p, [&](Cost& cost, StageTally& tally) {
      const Vertex from = in_world<Vertex>(a), to = in_world<Vertex>(b);
      const auto furthest_left = [&p](const Vertex& u, const Vertex& v, Cost& c, StageTally& t) {
        return extreme_vertex_by_bisection(p, u, v, c, t);
      };
      return clip(p, from, to, ends, cut_by_line(p, from, to, furthest_left, cost, tally), tally);
    });
  });
}

}  // namespace sunder::planar

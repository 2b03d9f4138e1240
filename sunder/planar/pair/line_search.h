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

#include <algorithm>
#include <utility>

namespace sunder::planar {

// furthest_left(from, to, cost, tally) gives the position of the vertex furthest to the left of an arrow, of two the
// one further along. Fills in all but decided_by. Cost: that search, and two of at most log2 n + 1 probes each.
template <class Sequence, class FurthestLeft>
void cut_by_line(const Sequence& p, const typename Sequence::Vertex& a, const typename Sequence::Vertex& b,
                 const FurthestLeft& furthest_left, PolygonCut& answer, StageTally& tally) {
  const std::uint32_t n = p.size();
  const auto side = [&](std::uint32_t k) {
    ++answer.cost.probes;
    return cross_2d(a, b, a, vertex_at(p, k), &tally);
  };
  std::uint32_t z = 0;  // among three vertices, one is off the line
  Sign of_z = side(0);
  while (of_z == Sign::zero && z + 1 < n) of_z = side(++z);
  if (of_z == Sign::zero) {
    if (n == 1) {
      answer.kind = CutKind::point;
      return;
    }
    answer.kind = CutKind::along;
    const bool forward = dot_2d(a, b, p[0], p[1], &tally) == Sign::positive;
    answer.first.feature = forward ? 0 : 1;
    answer.last.feature = forward ? 1 : 0;
    return;
  }
  // Let z be to the right of the line, for now.
  const bool turned = of_z == Sign::positive;
  const std::uint32_t w = furthest_left(turned ? b : a, turned ? a : b, answer.cost, tally);
  const Sign of_w = side(w);
  if (of_w == of_z) {
    answer.nearest = w;
    return;
  }
  if (of_w == Sign::zero) {  // the line touches
    const std::uint32_t next = position(p, w + 1);
    answer.first.feature = answer.last.feature = w;
    answer.kind = CutKind::point;
    if (n == 2 || side(next) != Sign::zero) return;
    answer.kind = CutKind::along;  // the edge from w to next runs against the line
    answer.edge = w;
    (turned ? answer.last : answer.first).feature = next;
    return;
  }
  if (n == 2) {
    answer.kind = CutKind::point;
    answer.first = answer.last = CutEnd{Place::edge, 0};
    return;
  }
  // The end of the chain from `begin` to `end` that is not on the side of `begin`: the first vertex that is not.
  const auto crossing = [&](std::uint32_t begin, std::uint32_t end, Sign of_begin) {
    if (end < begin) end += n;
    Sign last_seen = of_begin;  // of the first vertex found that is not on the side of `begin`
    const std::uint32_t k = first_where(begin + 1, end, [&](std::uint32_t i) {
      ++answer.cost.iterations;
      const Sign s = side(i);
      if (s != of_begin) last_seen = s;
      return s != of_begin;
    });
    // Where no vertex was seen on the line or beyond it, it is the chain's end, which is beyond.
    if (last_seen == Sign::zero) return CutEnd{Place::vertex, position(p, k)};
    return CutEnd{Place::edge, position(p, k - 1)};
  };
  answer.kind = CutKind::across;
  answer.last = crossing(z, w, of_z);
  answer.first = crossing(w, z, of_w);
  if (turned) std::swap(answer.first, answer.last);
}

// From what the line has in common with p to what the ray from a, or the segment from a to b (`ends`), has. Requires
// two different points.
template <class Sequence>
void clip(const Sequence& p, const typename Sequence::Vertex& a, const typename Sequence::Vertex& b, bool ends,
          PolygonCut& cut, StageTally& tally) {
  if (cut.kind == CutKind::nothing) return;
  // Where a point x of the line is, seen from an end of the common part: positive for beyond it.
  const auto beyond = [&](const auto& x, const CutEnd& end) {
    const auto& v = p[end.feature];
    if (end.place == Place::vertex) return dot_2d(a, b, v, x, &tally);
    const auto& w = vertex_at(p, end.feature + 1);
    return cross_2d(v, w, v, x, &tally) * cross_2d(v, w, a, b, &tally);
  };
  const bool one = cut.kind == CutKind::point;
  const Sign a_first = beyond(a, cut.first), a_last = one ? a_first : beyond(a, cut.last);
  const Sign b_first = ends ? beyond(b, cut.first) : Sign::positive;
  if (a_last == Sign::positive || b_first == Sign::negative) {
    cut.kind = CutKind::nothing;
    return;
  }
  if (a_last == Sign::zero || b_first == Sign::zero) {
    cut.kind = CutKind::point;
    if (a_last == Sign::zero) {
      cut.last.own = OwnEnd::a;
      cut.first = cut.last;
    } else {
      cut.first.own = OwnEnd::b;
      cut.last = cut.first;
    }
    return;
  }
  if (one) return;
  const CutEnd between{cut.kind == CutKind::along ? Place::edge : Place::inside, cut.edge};
  const auto shorten = [&](Sign outward, CutEnd& end, OwnEnd own) {
    if (outward == Sign::positive) return;
    if (outward == Sign::negative) end = between;
    end.own = own;
  };
  const Sign b_last = ends ? beyond(b, cut.last) : Sign::positive;
  shorten(-a_first, cut.first, OwnEnd::a);
  shorten(b_last, cut.last, OwnEnd::b);
}

// From positions to numbers.
template <class Sequence>
void renumber(const Sequence& p, PolygonCut& cut) {
  for (CutEnd* end : {&cut.first, &cut.last}) {
    if (end->place == Place::vertex) {
      end->feature = p.number(end->feature);
    } else {
      end->feature = end->place == Place::edge ? edge_number(p, end->feature) : 0;
    }
  }
  cut.edge = cut.kind == CutKind::along ? edge_number(p, cut.edge) : 0;
  cut.nearest = p.number(cut.nearest);
}

// Calls fill(answer, tally), and gives the answer with the polygon's own numbers.
template <class Sequence, class Fill>
PolygonCut conclude_cut(const Sequence& p, const Fill& fill) {
  PolygonCut answer;
  StageTally tally;
  fill(answer, tally);
  renumber(p, answer);
  conclude(answer, tally.exact);
  return answer;
}

// What the ray from a through b, or the segment where it `ends` at b, has in common with the polygon. Requires two
// different points.
inline PolygonCut cut_and_clip(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b,
                               bool ends) {
  return with_placed(polygon, pose, [&](const auto& p) {
    using Vertex = typename std::remove_cvref_t<decltype(p)>::Vertex;
    return conclude_cut(p, [&](PolygonCut& answer, StageTally& tally) {
      const Vertex from = in_world<Vertex>(a), to = in_world<Vertex>(b);
      const auto furthest_left = [&p](const Vertex& u, const Vertex& v, Cost& cost, StageTally& t) {
        return extreme_vertex_by_bisection(p, u, v, cost, t);
      };
      cut_by_line(p, from, to, furthest_left, answer, tally);
      clip(p, from, to, ends, answer, tally);
    });
  });
}

}  // namespace sunder::planar

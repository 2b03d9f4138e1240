// Which vertices of a convex polygon are furthest to the left and to the right of an arrow?
// Also called: support point, support mapping; extreme point query.
//
// Of two such vertices, the ends of an edge parallel to the arrow, it is the one further along the arrow. All methods
// return the same vertices.
// Templates over sequences of vertices (placed.h): strictly convex, counter-clockwise; one vertex and two are allowed.
// What one might assume and does not hold: that vertices may repeat or be in line with their neighbours. The searches
// would end, but the height of vertex k is then not bimodal in k.
// Requires two different ends of the arrow. `cost` and `tally` are added to. None throws, but for want of memory.
// Source: Chazelle & Dobkin 1987, section 2.2, Lemmas 1 and 2, and the conclusion for the search by bisection.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/pair/edge_runs.h>
#include <sunder/predicate/line/chord.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder::planar {

struct Extremes {
  std::uint32_t left = 0, right = 0;  // positions
};

// Looks at every vertex: the oracle of the others.
template <class Sequence>
Extremes extreme_vertices_by_scan(const Sequence& p, const typename Sequence::Vertex& from,
                                  const typename Sequence::Vertex& to, Cost& cost, StageTally& tally) {
  Extremes best;
  for (std::uint32_t k = 1; k < p.size(); ++k) {
    ++cost.probes;
    const auto beats = [&](std::uint32_t champion, Sign side) {
      const Sign higher = cross_2d(from, to, p[champion], p[k], &tally);
      return higher == side || (higher == Sign::zero && dot_2d(from, to, p[champion], p[k], &tally) == Sign::positive);
    };
    if (beats(best.left, Sign::positive)) best.left = k;
    if (beats(best.right, Sign::negative)) best.right = k;
  }
  return best;
}

// By the directions of edges. Cost: at most log2 n + 1 probes of an edge, one sign each, for the vertex furthest to the
// left; both take one such search in each half of the polygon, at most 2 log2 n. (For the vertex furthest to the right
// alone, give the ends of the arrow in the other order; of two it is then the one less far along.)
template <class Sequence>
std::uint32_t extreme_vertex_by_bisection(const Sequence& p, const typename Sequence::Vertex& from,
                                          const typename Sequence::Vertex& to, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  if (n == 1) return 0;
  const auto [below, above] = p.up();
  Sign upward = cross_2d(from, to, below, above, &tally);
  if (upward == Sign::zero) upward = dot_2d(from, to, below, above, &tally);
  // As in edges_to_left: the run of edges that point to the left ends in the half whose end points to the right.
  const std::uint32_t begin = upward == Sign::positive ? p.second() : p.first();
  std::uint32_t end = upward == Sign::positive ? p.first() : p.second();
  if (end < begin) end += n;
  return position(p, first_where(begin, end, [&](std::uint32_t k) {
                    ++cost.probes;
                    return cross_2d(from, to, vertex_at(p, k), vertex_at(p, position(p, k) + 1), &tally) !=
                           Sign::positive;
                  }));
}

// Both vertices. Cost: at most 2 log2 n probes of an edge, one sign each.
template <class Sequence>
Extremes extreme_vertices_by_bisection(const Sequence& p, const typename Sequence::Vertex& from,
                                       const typename Sequence::Vertex& to, Cost& cost, StageTally& tally) {
  const EdgeRun run = edges_to_left(p, from, to, cost, tally);
  return {position(p, run.end), position(p, run.begin)};
}

namespace extreme_vertex {

// The position in low .. high, not empty, at which a sequence that first rises and then falls, both strictly, is
// greatest; of two neighbours, equal and greatest, either. is_greater(x, y) for x < y: is it greater at y than at x?
// Each step asks about one position not asked about before, but for the first, which asks about two; for c positions
// there are at most 1.4405 log2 c + 0.7 of them. Source: Kiefer 1953, as cited in section 2.2.
template <class IsGreater>
std::uint32_t fibonacci_search(std::uint32_t low, std::uint32_t high, const IsGreater& is_greater, Cost& cost) {
  const std::uint64_t count = std::uint64_t{high - low} + 1;
  std::uint64_t smaller = 1, larger = 2;  // two Fibonacci numbers in a row
  while (larger <= count) {
    larger += smaller;
    smaller = larger - smaller;
  }
  // The candidates are low .. low + larger - 2; what is beyond `high` counts as less than all, and falling.
  while (larger > 2) {
    ++cost.iterations;
    const std::uint64_t step = larger - smaller, y = low + smaller - 1;
    if (y <= high && is_greater(static_cast<std::uint32_t>(low + step - 1), static_cast<std::uint32_t>(y))) {
      low += static_cast<std::uint32_t>(step);
    }
    larger = smaller;
    smaller = step;
  }
  return low;
}

// The function f of section 2.2: the height of vertex k to the left of an arrow. Its values are compared, never
// computed. Evaluating it at a position counts once.
template <class Sequence>
class Heights {
 public:
  using Vertex = typename Sequence::Vertex;

  Heights(const Sequence& p, const Vertex& from, const Vertex& to, Cost& cost, StageTally& tally)
      : p_(p), from_(from), to_(to), cost_(cost), tally_(tally) {}

  // The sign of f(j) - f(i).
  Sign rise(std::uint32_t i, std::uint32_t j) {
    look(i);
    look(j);
    return cross_2d(from_, to_, p_[i], p_[j], &tally_);
  }

  // The sign of f(k) - T(k), where T is the line through the first and the last value.
  Sign above_chord(std::uint32_t k) {
    const std::uint32_t last = p_.size() - 1;
    look(k);
    return chord_order(from_, to_, last, p_[0], p_[k], k, p_[0], p_[last], &tally_);
  }

 private:
  void look(std::uint32_t k) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (seen_[i] == k) return;
    }
    ++cost_.probes;
    if (count_ < seen_.size()) seen_[count_++] = k;
  }

  const Sequence& p_;
  const Vertex &from_, &to_;
  Cost& cost_;
  StageTally& tally_;
  std::array<std::uint32_t, 128> seen_{};  // two searches among fewer than 2^32 positions need fewer than 100
  std::size_t count_ = 0;
};

}  // namespace extreme_vertex

// By Fibonacci search, as in Lemma 2. Cost: at most 2.8808 log2 n + 7 evaluations of f for both vertices together, a
// probe each; values that are known are not evaluated again. Up to three signs a step.
// Departures: f is not computed but compared, so that T, the line between f(0) and f(n - 1), is a sign of products
// (predicate/line/chord.h). Where f(x) is not below T(x), g rises from x on: f(y) need not be known. Polygons of one and two
// vertices, and the choice between two extreme vertices, are added.
template <class Sequence>
Extremes extreme_vertices_by_fibonacci(const Sequence& p, const typename Sequence::Vertex& from,
                                       const typename Sequence::Vertex& to, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  if (n == 1) return {};
  extreme_vertex::Heights<Sequence> f(p, from, to, cost, tally);
  const Sign ends = f.rise(0, n - 1);
  if (n == 2) {
    if (ends == Sign::positive) return {1, 0};
    if (ends == Sign::negative) return {0, 1};
    const std::uint32_t further = dot_2d(from, to, p[0], p[1], &tally) == Sign::positive ? 1 : 0;
    return {further, further};
  }
  // Where f(0) > f(n - 1), it is turned upside down. Where they are equal, T is level, and needs no case of its own.
  const bool turned = ends == Sign::negative;
  const Sign up = turned ? Sign::negative : Sign::positive;
  std::uint32_t lowest = 0;
  if (f.rise(0, 1) == -up) {  // g = min(f, T) falls, then rises
    const auto is_less = [&](std::uint32_t x, std::uint32_t y) {
      return f.above_chord(x) == -up && f.above_chord(y) == -up && f.rise(x, y) == -up;
    };
    lowest = extreme_vertex::fibonacci_search(1, n - 1, is_less, cost);
  }
  const auto is_greater = [&](std::uint32_t x, std::uint32_t y) { return f.rise(x, y) == up; };
  const std::uint32_t highest = extreme_vertex::fibonacci_search(lowest + 1, n - 1, is_greater, cost);
  Extremes found{turned ? lowest : highest, turned ? highest : lowest};
  // An edge parallel to the arrow points against it on the left, and along it on the right.
  const std::uint32_t before = position(p, found.left + n - 1), after = position(p, found.right + 1);
  if (f.rise(found.left, before) == Sign::zero) found.left = before;
  if (f.rise(found.right, after) == Sign::zero) found.right = after;
  return found;
}

}  // namespace sunder::planar

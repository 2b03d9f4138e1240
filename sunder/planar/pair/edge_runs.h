// Where does the run of edges that point to the left of an arrow begin and end? One look at an edge a step.
// Also called: extreme points by binary search; tangents of a given direction.
//
// The directions of a convex polygon's edges turn once about, so those to the left of an arrow stand together; where
// the run begins and ends are the polygon's extreme vertices to the right and to the left of the arrow: the binary
// search that the conclusion of Chazelle & Dobkin 1987 asks for. The two halves in which a polygon is stored (the edges
// up to the rightmost vertex, and those back) lie in half-turns that are known beforehand: so one of them has the
// beginning, the other one the end, and a search needs one sign a step.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/pair/placed.h>

#include <cstdint>

namespace sunder::planar {

// Edges begin .. end - 1, modulo n; begin <= end < begin + n. Position k, taken modulo n, is where edge k begins.
struct EdgeRun {
  std::uint32_t begin = 0, end = 0;
  bool empty() const { return begin == end; }
  std::uint32_t size() const { return end - begin; }
};

// k or k - n, whichever is a position.
template <class Sequence>
std::uint32_t position(const Sequence& p, std::uint32_t k) {
  return k < p.size() ? k : k - p.size();
}
template <class Sequence>
auto vertex_at(const Sequence& p, std::uint32_t k) -> decltype(p[k]) {
  return p[position(p, k)];
}

// The first of low .. high of which `holds` is true, or high. Requires that it stays true from there on.
template <class Predicate>
std::uint32_t first_where(std::uint32_t low, std::uint32_t high, const Predicate& holds) {
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

// The edges of p that point to the left of the arrow from `from` to `to`, two different points. vertex_at(p, begin) is
// then furthest to its right, and of two such the one further along; vertex_at(p, end) is furthest to its left.
// Cost: at most 2 log2 n probes, one sign each: about log2 n for each end.
template <class Sequence>
EdgeRun edges_to_left(const Sequence& p, const typename Sequence::Vertex& from, const typename Sequence::Vertex& to,
                      Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  if (n == 1) return {0, 0};
  const auto points_left = [&](std::uint32_t k) {
    ++cost.probes;
    return cross_2d(from, to, vertex_at(p, k), vertex_at(p, position(p, k) + 1), &tally) == Sign::positive;
  };
  const auto [below, above] = p.up();
  Sign upward = cross_2d(from, to, below, above, &tally);
  if (upward == Sign::zero) upward = dot_2d(from, to, below, above, &tally);
  // The run begins in the half whose end points to the left of the arrow, at the end of that half at the latest.
  std::uint32_t first = upward == Sign::positive ? p.first() : p.second();
  std::uint32_t second = upward == Sign::positive ? p.second() : p.first();
  if (second < first) second += n;
  const std::uint32_t begin = first_where(first, second, points_left);
  const std::uint32_t end = first_where(second, first + n, [&](std::uint32_t k) { return !points_left(k); });
  return begin < n ? EdgeRun{begin, end} : EdgeRun{begin - n, end - n};
}

}  // namespace sunder::planar

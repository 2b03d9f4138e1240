// Where is a point against a ring of a polygon? By the number of edges below it.
//
// A point is inside of a ring iff an odd number of its edges is below the point. Everything is lexicographic: the
// vertical line is tilted a little, so an edge is below p iff its first end is not after p, its last end is after p,
// and p is to its left.
#pragma once

#include <sunder/planar/object/polygon.h>
#include <sunder/predicate/point/orient.h>

#include <cstdint>

namespace sunder::planar {

// positive: p is inside of the ring; zero: on it; negative: outside. Cost: linear.
inline Sign where_in_ring(const Polygon& polygon, std::uint32_t ring, const Point2& p) {
  bool inside = false;
  const std::vector<Point2>& v = polygon.vertices();
  const std::uint32_t end = polygon.ring_begin(ring + 1);
  const Point2* previous = &v[end - 1];
  bool was_after = lexicographically_less(p, *previous);
  for (std::uint32_t k = polygon.ring_begin(ring); k < end; ++k) {
    const Point2* const vertex = &v[k];
    if (*vertex == p) return Sign::zero;
    const bool is_after = lexicographically_less(p, *vertex);
    if (was_after != is_after) {
      const Sign side = is_after ? orient_2d(*previous, *vertex, p) : orient_2d(*vertex, *previous, p);
      if (side == Sign::zero) return Sign::zero;
      inside ^= side == Sign::positive;
    }
    previous = vertex;
    was_after = is_after;
  }
  return inside ? Sign::positive : Sign::negative;
}

// Is the beginning of the way from v to another point w inside of the ring? Requires that it is not on it, as it may be
// only where rings overlap; then any answer is given. Cost: linear.
inline bool begins_inside_ring(const Polygon& polygon, std::uint32_t ring, const Point2& v, const Point2& w) {
  bool inside = false;
  const bool forward = lexicographically_less(v, w);
  const auto is_after = [&](const Point2& p) { return p == v ? !forward : lexicographically_less(v, p); };
  for (std::uint32_t k = polygon.ring_begin(ring); k < polygon.ring_begin(ring + 1); ++k) {
    const Segment edge = sorted(polygon.edge(k));
    if (is_after(edge.a) || !is_after(edge.b)) continue;
    const Sign side = orient_2d(edge.a, edge.b, v);
    inside ^= (side == Sign::zero ? orient_2d(edge.a, edge.b, w) : side) == Sign::positive;
  }
  return inside;
}

// Does the ring run counter-clockwise? Of its edges at its first vertex the lowest one has the ring's inside above it.
// Requires that no two edges of the ring cross or overlap. Cost: linear.
inline bool is_counter_clockwise(const Polygon& polygon, std::uint32_t ring) {
  const std::vector<Point2>& v = polygon.vertices();
  Point2 first = v[polygon.ring_begin(ring)];
  for (std::uint32_t k = polygon.ring_begin(ring); k < polygon.ring_begin(ring + 1); ++k) {
    if (lexicographically_less(v[k], first)) first = v[k];
  }
  Point2 lowest = first;
  bool forward = true;
  for (std::uint32_t k = polygon.ring_begin(ring); k < polygon.ring_begin(ring + 1); ++k) {
    const Segment edge = polygon.edge(k);
    if (edge.a == edge.b || (edge.a != first && edge.b != first)) continue;
    const Point2& other = edge.a == first ? edge.b : edge.a;
    if (lowest != first && orient_2d(first, lowest, other) != Sign::negative) continue;
    lowest = other;
    forward = edge.a == first;
  }
  return forward;
}

}  // namespace sunder::planar

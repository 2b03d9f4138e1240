// Where is a point against a convex polygon on the vertical line through it? By halving the polygon's two chains.
// Also called: point location in a convex polygon, by its upper and lower hull.
#pragma once

#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/segments.h>
#include <sunder/predicate/point/orient.h>

#include <cstdint>

namespace sunder::planar {

// On the sweep line, which is vertical and tilted a little, so that points of one abscissa follow each other.
enum class Height : std::uint8_t {
  below,
  on_lower_chain,  // and not on the upper one
  inside,
  on_upper_chain,  // and not on the lower one
  on_both_chains,  // an end of the polygon, or on a segment
  above,
};

// Vertex t of the lower chain, from the leftmost vertex to the rightmost; and of the upper one.
inline std::uint32_t lower_chain_at(const ConvexPolygon& p, std::uint32_t t) {
  const std::uint32_t v = p.leftmost() + t;
  return v < p.size() ? v : v - p.size();
}
inline std::uint32_t upper_chain_at(const ConvexPolygon& p, std::uint32_t t) {
  return t <= p.leftmost() ? p.leftmost() - t : p.leftmost() + p.size() - t;
}

// How many edges the lower chain has; the upper one has the rest, or, of a segment, the same edge.
inline std::uint32_t lower_chain_length(const ConvexPolygon& p) {
  return p.rightmost() >= p.leftmost() ? p.rightmost() - p.leftmost() : p.rightmost() + p.size() - p.leftmost();
}

// Requires that p is lexicographically not before the leftmost vertex and not after the rightmost one.
// Cost: about log2 of the number of vertices, plus three, probes.
inline Height height_of(const Point2& p, const ConvexPolygon& polygon, std::uint64_t& probes) {
  if (polygon.size() == 1) return ++probes, Height::on_both_chains;
  const auto side = [&](const auto& chain_at, std::uint32_t length) {
    std::uint32_t low = 0, high = length;  // the vertex `low` is not after p, the vertex `high` not before it
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      ++probes;
      (lexicographically_less(p, polygon[chain_at(polygon, middle)]) ? high : low) = middle;
    }
    probes += 2;
    return orient_2d(polygon[chain_at(polygon, low)], polygon[chain_at(polygon, high)], p);
  };
  const std::uint32_t lower = lower_chain_length(polygon);
  const Sign from_lower = side(lower_chain_at, lower);
  if (from_lower == Sign::negative) return Height::below;
  const Sign from_upper = polygon.size() == 2 ? from_lower : side(upper_chain_at, polygon.size() - lower);
  if (from_upper == Sign::positive) return Height::above;
  if (from_upper == Sign::zero) return from_lower == Sign::zero ? Height::on_both_chains : Height::on_upper_chain;
  return from_lower == Sign::zero ? Height::on_lower_chain : Height::inside;
}

}  // namespace sunder::planar

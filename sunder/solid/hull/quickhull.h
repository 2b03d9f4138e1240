// A triangulated convex hull of points that span space. Internal to solid/hull.
// Also called: convex hull by conflict lists, outside sets.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/predicate/point/facet_plane.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

// A triangle of the boundary, and what Quickhull keeps with it: one cache line.
struct Triangle {
  static constexpr std::uint32_t none = 0xffffffff;

  std::array<std::uint32_t, 3> corner{};    // point indices, counter-clockwise from outside
  std::array<std::uint32_t, 3> adjacent{};  // the triangle beyond the edge from corner[i] to corner[i + 1]
  FacetPlane plane;                         // of the corners in this order
  std::uint32_t outside = none;             // the first point of its conflict list
  std::uint8_t lopsided = 0;                // up when an insertion left it nearly all points, down when one did not
  bool removed = false;                     // no part of the hull: every other field is meaningless

  // Which corner point v is. Requires that it is one.
  std::uint32_t place_of(std::uint32_t v) const { return (corner[1] == v ? 1u : 0u) + (corner[2] == v ? 2u : 0u); }

  // Exactly: positive when q is strictly outside the plane, negative when strictly inside.
  Sign side(std::span<const Point3> points, const Point3& q) const {
    return plane.side(points[corner[0]], points[corner[1]], points[corner[2]], q);
  }
};

constexpr std::uint32_t next(std::uint32_t place) { return place == 2 ? 0 : place + 1; }
constexpr std::uint32_t previous(std::uint32_t place) { return place == 0 ? 2 : place - 1; }

struct Triangulation {
  std::vector<Triangle> triangles;
  std::uint64_t side_tests = 0;  // how many times the side of a point to a plane was asked for
};

// Triangles none of which is degenerate, that together with their adjacency cover the boundary of the hull exactly
// once, among removed ones. Several may be coplanar, so corners may lie inside facets or edges of the hull, but every
// extreme point is a corner: of equal points the one with the lowest index.
// Requires four affinely independent points, of equal points the lowest index each.
// Cost: as convex_hull.
Triangulation quickhull(std::span<const Point3> points, std::array<std::uint32_t, 4> simplex);

}  // namespace sunder::solid

// The common part of half-planes, named by the half-planes that bound it: what questions about regions answer with.
// Also called: feasible region, feasible set; polyhedron in H-representation.
//
// A region holds numbers of half-planes only: which they belong to (Constraints, HalfPlanes, PolygonSides: `Given`
// below) has to be at hand for all that needs coordinates. Angles are those of normals, which point out.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/object/constraints.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::planar {

enum class RegionKind : std::uint8_t {
  empty,
  point,
  segment,
  ray,
  line,
  strip,       // between two parallel lines
  half_plane,  // no corner
  unbounded,   // of two dimensions, with a corner
  bounded,     // of two dimensions: a convex polygon
  plane,
};

std::string_view name_of(RegionKind);

//   R1. Given the half-planes, kind and sides are determined, except which sides contradict each other.
//   R2. Two sides that follow each other turn by less than a half turn, and their lines meet in a corner of the region;
//       so do the last and the first one of a bounded region, a segment and a point. The sides of a line or strip, and
//       the first and last of a ray, are antiparallel.
struct [[nodiscard]] Region {
  RegionKind kind = RegionKind::plane;

  // empty: two or three half-planes without a common point, counter-clockwise. Otherwise half-planes whose common part
  // is the region, by angle, counter-clockwise from the x axis on (ray, unbounded: from the gap of a half turn or more
  // on).
  //   strip, half_plane, unbounded, bounded: those with a part of the boundary in their line that is more than a point.
  //   line: two antiparallel ones. ray: one more between them, at its end. segment: two more, one at each end.
  //   point: the lowest that have it in their line, and on from each the last one that is less than a half turn
  //   further, until the first is less than a half turn further: three or four.
  // Of several that would do the lowest number.
  std::vector<std::uint32_t> sides;

  // Evidence, where asked for and not empty: for each half-plane a position p in `sides`: its normal lies between those
  // of sides p and p + 1 (or is that of side p), and it holds their corner (or is no proper part of side p).
  std::vector<std::uint32_t> cones;

  Cost cost;  // probes: signs that were asked for; exact: those that needed exact arithmetic

  bool empty() const { return kind == RegionKind::empty; }
};

// The corners, counter-clockwise, each once: a corner is the common point of the lines of two sides. Of a segment, a
// ray and a point: the ends.
std::vector<std::array<std::uint32_t, 2>> corners(const Region& region);

// A point of the region: its first corner, or where it has none, one of the line of its first side; of the plane, the
// origin. Requires a region that is not empty. exact_corner and nearest (predicate/line/constraints.h) are for the others.
template <class Given>
ExactPoint2 point_of(const Given& given, const Region& region);

// Positive numbers, one for each side of an empty region: the sum of that many times (a, b) is zero, that of c
// negative.
template <class Given>
std::vector<Dyadic> multipliers(const Given& given, const Region& region);

// Is the region what it says it is: the common part of all of the half-planes? By its evidence alone, which it must
// have; every side and every corner is checked, and nothing of a search is used. (Not checked: that of several sides
// that would do the lowest number is named, and where sides begin.)
// Cost: O(N) signs.
template <class Given>
bool check(const Given& given, const Region& region);

}  // namespace sunder::planar

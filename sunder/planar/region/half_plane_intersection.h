// What is the common part of N half-planes?
// Also called: half-plane intersection; feasible region of linear inequalities in two variables.
//
// The region is exactly right for the doubles given, whatever the position: parallel, repeated, concurrent, barely
// empty or barely not. It comes with its evidence (region.h): sides, and for each of the others the corner that it
// holds; or two or three half-planes without a common point.
//   P1. All methods give the same kind and the same sides; of an empty region, which contradict each other may differ.
//   P2. With evidence asked for, check() accepts it.
//   P3. The answer does not depend on the compiler.
// None throws, but for want of memory. `Given` is Constraints, HalfPlanes, or PolygonSides.
// Source: Shamos & Hoey 1976, section V, Theorems 9 and 11 (are N linear inequalities consistent: is it not empty?).
#pragma once

#include <sunder/planar/region/region.h>

namespace sunder::planar {

struct RegionOptions {
  bool evidence = false;  // for a region that is not empty; O(N log N) signs more, of which N are of corners
};

// The front door: the fastest method measured. A region of a small sample drops what it implies; the rest by sort. O(N)
// expected where few sides are left, O(N log N) at worst.
template <class Given>
Region half_plane_intersection(const Given& given, const RegionOptions& options = {});

// Sorts by angle; two chains, of the normals that point up and down, each by a stack; then the ends are trimmed where
// the chains meet. Cost: O(N log N) comparisons of angles, O(N) other signs.
template <class Given>
Region half_plane_intersection_by_sort(const Given& given, const RegionOptions& options = {});

// The paper's: the common parts of both halves, then the common part of these, whose sides are merged by angle.
// Cost: O(N log N) signs, O(N) where few are left of each part.
template <class Given>
Region half_plane_intersection_by_division(const Given& given, const RegionOptions& options = {});

// Each line cut by all others: the oracle. O(N^2) signs; O(N^3) where the region is empty.
template <class Given>
Region half_plane_intersection_by_scan(const Given& given, const RegionOptions& options = {});

}  // namespace sunder::planar

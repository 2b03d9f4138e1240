// From which points of a simple polygon are all of its points seen: its kernel?
// Also called: kernel of a star-shaped polygon; visibility kernel.
//
// It is the common part of the half-planes of its edges: the answer is that region over them (region.h), its sides
// numbered as the polygon's edges. Exactly right for the doubles given, with the same evidence.
//   K1. All methods give the same kind and the same sides; of an empty kernel, which contradict each other may differ.
//   K2. With evidence asked for, check() accepts it. That the polygon is simple is part of the claim, and not of the
//       evidence.
//   K3. The answer does not depend on the compiler.
// Requires a simple polygon (polygon_simple). For another one the methods give the common part of its half-planes all
// the same, which means nothing (PolygonSides). None throws, but for want of memory.
// Source: Shamos & Hoey 1976, section V, Theorem 10; by_lee_preparata: Lee & Preparata 1979.
#pragma once

#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/half_plane_intersection.h>

namespace sunder::planar {

// The front door: the fastest method measured, half_plane_intersection. Cost: O(N log N) signs at worst.
Region kernel(const PolygonSides& sides, const RegionOptions& options = {});

// The paper's: half_plane_intersection_by_sort. O(N log N) comparisons.
Region kernel_by_half_plane_intersection(const PolygonSides& sides, const RegionOptions& options = {});

// Edge after edge cuts what is left, near to where the one before did. Where that is or gets flat, and where the search
// goes around too often (on spirals), half_plane_intersection decides, and iterations in the cost is 1, else 0.
// Cost: O(N) signs; to make sure of every edge, O(N) where the sides' angles are spread evenly, O(N log N) at worst.
Region kernel_by_lee_preparata(const PolygonSides& sides, const RegionOptions& options = {});

// The oracle: half_plane_intersection_by_scan. O(N^2) signs; O(N^3) where the kernel is empty.
Region kernel_by_scan(const PolygonSides& sides, const RegionOptions& options = {});

}  // namespace sunder::planar

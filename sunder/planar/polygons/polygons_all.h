// Which pairs of N polygons with holes meet, and how? (What polygons are: polygons_any.h.)
// Also called: polygon intersection reporting; spatial join.
//
//   P1. Each pair that has a contact that counts, and whose polygons are not of one group, is given once.
//   P2. The pairs given, and whether they touch or overlap, do not depend on the method. Of a touching pair, kind is
//       the greatest there is: shared_endpoint iff all common points are vertices of both; overlap iff they have a
//       common border. Which edges show it may differ.
//   P3. The pairs are in the order of i, then of j.
// Requires of polygons, and throws for groups, as polygons_any.h.
// Source: Shamos & Hoey 1976, sections IV (Theorem 7) and VI (listing).
#pragma once

#include <sunder/planar/polygons/polygons_any.h>

namespace sunder::planar {

using PolygonsAllAnswer = AllAnswer<PolygonsContact>;

// Pairs that count.
struct PolygonsCount {
  std::uint64_t touching = 0, overlapping = 0;
  friend bool operator==(const PolygonsCount&, const PolygonsCount&) = default;
};

using PolygonsCountAnswer = CountAnswer<PolygonsCount>;

// The front doors: the fastest method measured, by boxes. Cost: as polygons_all_by_boxes. Counting keeps no
// contacts: where boxes give up, at most 32 MB, or 32 bytes for each polygon, beside what the sweep takes; where pairs
// are too many to be told apart in these, it is swept again for others.
PolygonsAllAnswer polygons_all(std::span<const Polygon> polygons, const SetOptions& options = {});
PolygonsCountAnswer polygons_count(std::span<const Polygon> polygons, const SetOptions& options = {});

// The pairs of polygons whose boxes meet; of each, the runs of edges whose boxes meet (EdgeBoxes), down to edges. Where
// that takes more than 64 looks at boxes and edges for each edge, and 16 for each pair that counts, by sweep. Memory:
// O(N) for N polygons.
PolygonsAllAnswer polygons_all_by_boxes(std::span<const Polygon> polygons, const SetOptions& options = {});

// The contacts of edges by a grid over their boxes, then the polygons around each common point, then rings inside of
// other polygons, one by one. Where the grid does not pay, or many edges crowd in a cell, by sweep. It has no bound,
// and is not the front door. O(n + k) memory for k contacts of edges.
PolygonsAllAnswer polygons_all_by_grid(std::span<const Polygon> polygons, const SetOptions& options = {});

// A line sweeps over the edges, which know the polygons that fill what is above them. O((n + k) log n) for n edges and
// k contacts: pairs that count, edges that cross, also of one group, edges that pass a vertex of another polygon. All
// edges with one end in common are one contact that does not count.
PolygonsAllAnswer polygons_all_by_sweep(std::span<const Polygon> polygons, const SetOptions& options = {});

// Every pair: the oracle.
PolygonsAllAnswer polygons_all_by_scan(std::span<const Polygon> polygons, const SetOptions& options = {});

}  // namespace sunder::planar

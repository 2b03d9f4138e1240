// Do any two of N polygons with holes meet: touch, overlap, or lie one inside the other?
// Also called: polygon intersection detection; the predicates intersects, touches, overlaps, contains.
//
// A polygon is the closed region that an odd number of its rings encloses (the even-odd rule): what is inside of the
// outer ring and not in a hole, or on an island in a hole, with its boundary. Required of each: its rings neither
// cross nor overlap, themselves or one another; they may touch in points, and vertices may be repeated: all polygons
// that are valid are such, also those with rings that touch themselves (polygon_valid.h). What does not keep to that
// is answered somehow. The answer is exactly right for the doubles given, and comes with
// evidence: two edges that meet, or a vertex of one polygon inside of the other; polygons_claims.h writes proofs.
//   P1. meet() is true iff some two polygons, not of one group, have a contact that counts.
//   P2. The contact named counts; it need not be the leftmost, nor the same for all methods.
//   P3. The answer does not depend on the compiler.
//   P4. Two polygons overlap iff their interiors have a common point; they touch iff they meet and do not overlap:
//       parcels along a common border touch, however they share its vertices.
// Throws Error bad_call where there are groups, and not one for each polygon; else none throws, but for want of memory,
// or what `progress` throws. Source: Shamos & Hoey 1976, section IV, Theorems 5 and 7.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/pair/segment_segment.h>
#include <sunder/planar/segments/contact_rule.h>

#include <cstdint>
#include <span>

namespace sunder::planar {

// How two polygons meet, and what shows it: an edge of each that meet, or a vertex of one inside of the other.
// Overlapping is shown by edges with a common point (of an overlap, its first or its last end) around which the
// interiors have common points, as the edges of both polygons there tell; or by the vertex. Edges that cross show it,
// unless both polygons have a vertex in the point: there notches of the one may hold what the other fills, and where
// the interiors are not connected, polygons may have edges that cross, and touch.
struct PolygonsContact {
  Relation contact = Relation::none;     // of a contact that was found never none
  ContactKind kind = ContactKind::none;  // of the two edges; none: it is shown by a vertex
  bool i_inside = false;                 // where kind is none: is it a vertex of i?
  std::uint32_t i = 0, j = 0;            // the polygons, i < j
  std::uint32_t of_i = 0, of_j = 0;      // edges of i and of j; or the vertex of the one that is inside
  friend bool operator==(const PolygonsContact&, const PolygonsContact&) = default;
};

// Overlapping always counts. Touching does not where `touch` is allowed, nor where `shared_endpoint` is and all common
// points are vertices of both: then kind is shared_endpoint.
inline bool counts(const PolygonsContact& c, Allowed allowed) {
  if (c.contact != Relation::touching) return c.contact == Relation::overlapping;
  return allowed == Allowed::nothing || (allowed == Allowed::shared_endpoint && c.kind != ContactKind::shared_endpoint);
}

// Probes: pairs of edges or boxes compared, and edges looked at for points inside.
using PolygonsAnswer = AnyAnswer<PolygonsContact>;

// How do two polygons meet? Of a touching pair, kind is the greatest there is. i is 0 and j is 1.
// Cost: linear, and what a grid over those edges takes that are near the other polygon; where it does not pay, many
// edges crowd in a cell, or there are many rings, as by sweep.
PolygonsAnswer polygons_contact(const Polygon& a, const Polygon& b);

// Every two edges, and all pieces into which they part each other, in exact fractions: the oracle, which requires
// nothing of the polygons. The edges that it names meet, and need not show where the polygons overlap.
// O((n + m)^3 log (n + m)) time.
PolygonsAnswer polygons_contact_by_scan(const Polygon& a, const Polygon& b);

// The front door: the fastest method measured, by boxes. Cost: as polygons_any_by_boxes. Requires fewer than 2^31 edges
// in all, as all methods.
PolygonsAnswer polygons_any(std::span<const Polygon> polygons, const SetOptions& options = {});

// A line sweeps over the edges, which know the polygons that fill what is above them, and passes contacts that do not
// count. O((n + k) log n) for n edges in all and k contacts that do not count: edges of one group that cross; edges
// that pass a vertex of another polygon. All edges with one common end are one contact. One group only: linear.
PolygonsAnswer polygons_any_by_sweep(std::span<const Polygon> polygons, const SetOptions& options = {});

// The pairs of polygons whose boxes meet; of each, the runs of edges whose boxes meet (EdgeBoxes), down to edges. Where
// that takes more than 64 looks at boxes and edges for each edge, by sweep: O(N log N) comparisons and about 64 n such
// looks for N polygons of n edges in all (the last two may need a look at all of theirs), besides what the sweep takes.
PolygonsAnswer polygons_any_by_boxes(std::span<const Polygon> polygons, const SetOptions& options = {});

// A uniform grid over the edges' boxes. Where it does not pay, or many edges crowd in cells, by sweep. Then rings whose
// boxes are in those of other polygons, one by one: it has no bound, and is not the front door.
PolygonsAnswer polygons_any_by_grid(std::span<const Polygon> polygons, const SetOptions& options = {});

// Every pair of polygons by polygons_contact_by_scan: the oracle. Names the first pair.
PolygonsAnswer polygons_any_by_scan(std::span<const Polygon> polygons, const SetOptions& options = {});

}  // namespace sunder::planar

// Do any two of N convex polygons meet? (Segments and points are polygons of two vertices and of one.)
//
// The polygons are closed: touching is meeting, and one inside another meets it. The answer is exactly right for the
// doubles given, whatever the position. It comes with its evidence: two polygons that meet in a way that counts, with
// the certificate of this pair; convex_polygons_any_claims.h writes proofs, also that there are none.
// Also called: intersection detection among convex polygons.
//   P1. meet() is true iff some two polygons, not of one group, have a contact that counts.
//   P2. The contact named counts; it need not be the leftmost, nor the same for all methods. `evidence` passes the
//       absolute check of certificate/check.h, with polygon i as body A and polygon j as body B.
//   P3. The answer does not depend on the compiler.
// Throws Error bad_call where there are groups, and not one for each polygon; else none throws, but for want of memory,
// or what `progress` throws. Source: Shamos & Hoey 1976, section IV, Theorem 6.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/segments/contact_rule.h>

#include <span>

namespace sunder::planar {

struct ConvexPolygonsContact : ContactOfTwo<Relation> {
  CommonVertices evidence;                                                                      // that they meet
  friend bool operator==(const ConvexPolygonsContact&, const ConvexPolygonsContact&) = delete;  // not of evidence
};

// Probes: vertices looked at, and pairs of boxes or polygons compared.
using ConvexPolygonsAnswer = AnyAnswer<ConvexPolygonsContact>;

// The front door: the fastest method measured, by grid. Cost: that of the sweep at most, but for a constant; with
// groups, as by grid. Requires fewer than 2^31 vertices in all, as all methods.
ConvexPolygonsAnswer convex_polygons_any(std::span<const ConvexPolygon> polygons, const SetOptions& options = {});

// Theorem 6: a line sweeps over the plane, and polygons are compared when they become neighbours on it.
// Cost: O(N log N log k) probes for polygons of at most k vertices; O(N) memory. Where there are groups, whose members
// may overlap, it does not apply: then as by grid.
ConvexPolygonsAnswer convex_polygons_any_by_sweep(std::span<const ConvexPolygon> polygons,
                                                  const SetOptions& options = {});

// The pairs whose boxes meet, by a uniform grid over the boxes. Where that does not pay, the sweep decides instead, and
// where too many crowd in a cell, the sweep decides about these; so its bound holds. Where there are groups: all pairs
// whose boxes meet; where that takes more than 64 probes a vertex, the sweep of polygons_any_by_sweep, with its bound.
// (Not where there are points or segments among the polygons.)
ConvexPolygonsAnswer convex_polygons_any_by_grid(std::span<const ConvexPolygon> polygons,
                                                 const SetOptions& options = {});

// Every pair, by its edges: the oracle. Names the first pair. O(N^2 k^2) time.
ConvexPolygonsAnswer convex_polygons_any_by_scan(std::span<const ConvexPolygon> polygons,
                                                 const SetOptions& options = {});

}  // namespace sunder::planar

// Is a polygon simple: do no two of its edges meet but where one follows the other?
// Also called: simplicity test; self-intersection test.
//
// Edges that follow each other in a ring share an end, which does not count; any other contact does: a crossing, a
// touch, an overlap (also of edges that follow each other: a spike), an end shared by edges that do not follow each
// other (a vertex that two rings, or one ring twice, pass through, and a vertex that is repeated).
//   P1. meet() is true iff some two edges have a contact that counts: then the polygon is not simple.
//   P2. The contact named counts; which one it is may differ from method to method.
// Not asked here: whether holes lie inside of the outer ring, and which way rings are turned. What files hold is mostly
// less than simple, and valid: polygon_valid.h.
// None throws, but for want of memory.
// Source: Shamos & Hoey 1976, section IV, Theorem 4.
#pragma once

#include <sunder/near/set_question.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/pair/segment_segment.h>

#include <cstdint>

namespace sunder::planar {

// The contact is one of two edges of the ring. Probes count the pairs of edges that are compared, and the pairs of
// vertices that are neighbours after sorting.
using PolygonSimpleAnswer = AnyAnswer<ContactOfTwo<ContactKind>>;

// The front door: the fastest method measured, by grid. Cost: O(N log N) comparisons at most, O(N) memory.
PolygonSimpleAnswer polygon_simple(const Polygon& polygon);

// The same where the edges, in their order, are known. Where the order of their ends is needed, that (as by
// ends_in_order) is put into `ends`.
PolygonSimpleAnswer polygon_simple(const Polygon& polygon, const Segments& edges, std::vector<std::uint32_t>& ends);

// Equal vertices by sorting, then segments_any on the edges, where shared ends are allowed: all that are left are of
// edges that follow each other. O(N log N) comparisons, O(N) memory.
PolygonSimpleAnswer polygon_simple_by_sweep(const Polygon& polygon);

// A uniform grid over the edges' boxes; where it does not pay, or many edges crowd in a cell, by sweep.
PolygonSimpleAnswer polygon_simple_by_grid(const Polygon& polygon);

// Every pair of edges: the oracle. O(N^2) time.
PolygonSimpleAnswer polygon_simple_by_scan(const Polygon& polygon);

// How two different edges meet, where it counts; else none. Requires i and j, not equal, below polygon.size().
ContactKind counted_contact(const Polygon& polygon, std::uint32_t i, std::uint32_t j);

}  // namespace sunder::planar

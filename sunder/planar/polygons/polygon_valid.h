// Is a polygon with holes, or a multipolygon, valid? What is wrong with it, and where?
// Also called: validity as of OGC; isValid, ST_IsValid.
//
// Valid as by OGC 06-103r4 (Simple Features), as isValid of JTS and GEOS, decided exactly:
//   - each ring has three different vertices at least, and its edges meet but where one follows the other nowhere;
//     a vertex may be repeated by those that follow it;
//   - two rings of a polygon, and of two parts, meet in points only, and do not cross there;
//   - each hole (ring 1 and so on) is inside of its shell (ring 0), and not inside of another hole;
//   - the interior is connected: the graph that joins each ring with the points in which it meets others has no cycle;
//   - no part of a multipolygon is inside of another one, but in its holes.
// Which way rings are turned is not asked.
//   P1. There is no defect iff the polygon is valid under the rule. So for all methods.
//   P2. What is named is so. Each crossing and each overlap of two edges is named, each ring that is too short, and
//       each point where rings cross in a vertex. What follows from where rings lie (holes, parts, the interior) is
//       looked at without those that are too short, or cross or overlap themselves, and without the later one of two
//       that cross or overlap. A hole that is outside of its shell, or inside of another hole, is named so; else it is
//       as if it were not there: no other hole is nested in it. So mending one defect may bring another one to light.
//   P3. The answer does not depend on the compiler. The order is that of the kinds, then that of the places.
// What one might assume and does not hold: that a ring with a defect is named in one of them only.
// Source: own, on Shamos & Hoey 1976, section III (the sweep). The number of parts of the interior is one more than
// that of the cycles by Euler's formula.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/object/polygon.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::planar {

// Each allows what the one before does.
enum class PolygonRule : std::uint8_t {
  simple,  // as polygon_simple: no vertex is repeated, and no two rings of a polygon have a common point
  valid,
  // A ring may touch itself in points, but not cross itself there. Cut there it is some rings that do not; those of the
  // shell may be holes that way (as ESRI has them), those of a hole may lie side by side. Of all these one must be
  // outside, and all others inside of it, side by side; then the rest is as for valid. So what an odd number of rings
  // encloses is connected, as for valid.
  self_touch,
};

enum class PolygonDefectKind : std::uint8_t {
  too_few_points,   // a ring has fewer than three vertices, not counting those repeated
  crossing,         // two edges cross, or two rings, or a ring itself, in a vertex
  overlap,          // two edges have a piece in common; also a spike
  repeated_vertex,  // only for `simple`: a vertex repeats the one before
  self_touch,       // not for `self_touch`: a ring touches itself in a point
  rings_touch,      // only for `simple`: two rings of a polygon have a point in common
  hole_outside,     // of its shell
  nested_holes,     // a hole inside of another one
  disconnected,     // the interior is not connected
  nested_parts,     // a part of a multipolygon is inside of another
};
std::string_view name_of(PolygonDefectKind);  // "hole-outside"

// A place on a ring, counted from 0: the edge from this vertex to the next. Vertices count as they were given.
struct RingPlace {
  std::uint32_t part = 0, ring = 0, edge = 0;
  friend auto operator<=>(const RingPlace&, const RingPlace&) = default;
};

// kind             a, b                                             place
// too_few_points   the ring, twice                                  its first vertex
// crossing         two edges that hold the point                    the point, to the nearest doubles
// overlap          two edges                                        the common piece
// repeated_vertex  the vertex, and that which repeats it            the vertex
// self_touch,
// rings_touch      two edges that hold the point                    the point
// hole_outside     an edge of the hole that is outside; the shell   an end of that
// nested_holes     an edge of the inner hole; the outer one         an end of that
// disconnected     two rings, or edges of one, that close a cycle   the point where they do
// nested_parts     an edge of the inner part; the outer one's       an end of that
struct PolygonDefect {
  PolygonDefectKind kind = PolygonDefectKind::crossing;
  RingPlace a, b;
  Segment place;  // a and b are equal but for an overlap
};

// Valid where there are none. Probes: comparisons of the sweep, pairs of edges, and ways around points.
using PolygonDefects = AllAnswer<PolygonDefect>;

struct ValidOptions {
  PolygonRule rule = PolygonRule::valid;
  std::size_t most = std::numeric_limits<std::size_t>::max();  // so many defects are enough; at least 1
};

// The rings of a polygon: the shell, then the holes. Whether the last vertex repeats the first, as files have it, does
// not matter.
using PolygonRings = std::vector<std::vector<Point2>>;

// The front doors: of the parts of a multipolygon, or of one polygon. Where `most` is 1 or nothing crosses or overlaps:
// O(n log n) comparisons and O(n) memory for n edges; else also the cost of segments_visit.
// Throws Error bad_value where a coordinate is not finite, bad_shape for 2^31 vertices and more.
PolygonDefects polygon_defects(std::span<const PolygonRings> parts, const ValidOptions& options = {});
PolygonDefects polygon_defects(std::span<const Polygon> parts, const ValidOptions& options = {});
PolygonDefects polygon_defects(const Polygon& polygon, const ValidOptions& options = {});

// The same defects one by one, in the same order, until the visitor returns false; `most` is not looked at. Of those
// that are two edges, no more are held than ContactsInOrder holds, 2^20 or 16 n: more are found again, block by block.
// Those at vertices are held. What is not visited is counted, too, and where it is is not computed.
using PolygonDefectVisitor = std::function<bool(const PolygonDefect&)>;
CountAnswer<> visit_polygon_defects(std::span<const PolygonRings> parts, const ValidOptions& options,
                                    const PolygonDefectVisitor& visit);

// Every two edges, every two rings, and of the interior all sides of all pieces of edges: the oracle. It shares no code
// with the others. O(n^3) time.
PolygonDefects polygon_defects_by_scan(std::span<const PolygonRings> parts, const ValidOptions& options = {});

}  // namespace sunder::planar

// Certificates of answers about a set of polygons (docs/claims.md, "polygons"): a common point, or the sweep over all
// edges.
//
// None throws, but for want of memory, or what the writer's sink or `visit` throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/sweep/sweep_events.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>

namespace sunder::planar {

// The polygons, what does not count, and whose members may meet: what an answer is about.
struct PolygonsAsked {
  std::span<const Polygon> polygons;
  Allowed allowed = Allowed::nothing;
  Groups groups{};
};

// The sweep, which proves that none meet, that these do, and how many do. nullopt where it would have more than `most`
// entries. O((n + k) log n) time for n edges, k crossings.
std::optional<SweepEvents> polygon_events(std::span<const Polygon> polygons,
                                          std::size_t most = std::numeric_limits<std::size_t>::max());

// Each writes the table and a statement. Certificates must be true: so answers are those for what was asked, not by
// scan, and polygons are as polygons_any.h requires.

// Two polygons meet; and, where touching counts, whether they touch or overlap, by a sweep of their edges. The common
// point is computed here, in time linear in the edges of both polygons, for each edge at that point.
void write_some(ClaimsWriter& file, const PolygonsAsked& asked, const PolygonsContact& found);
void write_none(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events);
// Exactly these meet, and so; and of each two where. `visit` calls for each contact that counts, by i, then j, each time
// that it is called.
using VisitContacts = std::function<void(const std::function<void(const PolygonsContact& contact)>& take)>;
void write_these(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events, const VisitContacts& visit);
void write_count(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events, std::uint64_t overlapping,
                 std::uint64_t touching);

// An entry of the table, and of that a ring.
void write_row(ClaimsWriter& file, const Polygon& polygon);
void write_row(ClaimsWriter& file, const ConvexPolygon& polygon);
void write_ring(ClaimsWriter& file, std::span<const Point2> ring);

// The whole file, of some or none.
std::string certificate_text(std::span<const Polygon> polygons, Allowed allowed, const PolygonsAnswer& answer,
                             Groups groups = {});

}  // namespace sunder::planar

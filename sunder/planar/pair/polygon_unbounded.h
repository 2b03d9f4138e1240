// What has a placed convex polygon in common with a line, a ray or a half-plane, whichever it is; do they touch, or
// overlap; and what proves it (docs/claims.md, "pair")? For one of a known kind see polygon_line.h, polygon_ray.h and
// polygon_half_plane.h, which are asked here.
// Also called: clipping of a line, ray or half-plane by a convex polygon.
//
// None throws, but for want of memory.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/planar/object/line.h>
#include <sunder/planar/pair/polygon_cut.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace sunder::planar {

// In the world.
using Unbounded = std::variant<Line, Ray, HalfPlane>;

// The two points that tell where it is.
Line line_of(const Unbounded& other);

// What the polygon has in common with it.
enum class CommonKind : std::uint8_t {
  nothing,
  point,
  along,   // a part of an edge
  across,  // a segment through the inside
  part,    // of a half-plane: what its line cuts off
  whole,   // of a half-plane: all of the polygon
};

std::string_view name_of(CommonKind);  // "across"

struct [[nodiscard]] PolygonCommon {
  CommonKind kind = CommonKind::nothing;
  PolygonCut cut;             // by the line or ray; by the half-plane's line
  std::uint32_t witness = 0;  // of a half-plane, as in polygon_half_plane.h; else meaningless

  // A vertex is its own relative interior; a segment's is without its ends, a ray's without its beginning.
  Relation contact = Relation::none;
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;

  bool meet() const { return contact != Relation::none; }
};

// Cost: that of polygon_line, polygon_ray, or of polygon_half_plane and polygon_line.
PolygonCommon polygon_unbounded(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other);

// By polygon_line_by_fibonacci. Requires a line.
PolygonCommon polygon_unbounded_by_fibonacci(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other);

// All vertices: the oracle.
PolygonCommon polygon_unbounded_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other);

// ---- Certificates: the unbounded object is one body, of a point and the ways that go on from it, so that what is said
// of it is said of the whole.

// For PairClaims::add_body.
struct UnboundedBody {
  std::array<Point3, 1> points;
  std::vector<Way3> ways;
};
UnboundedBody body_of(const Unbounded& other);

// States whether body a, the polygon, and body b, the other, meet; if tells_contact, also whether they touch, or
// overlap; the part that it has in common with a line or ray; and the vertex nearest to a line or half-plane, or
// furthest within that. Requires their answer. Cost: exact arithmetic on a few vertices, and of a ray that of
// polygon_line.
void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolygon& polygon, const Pose& pose,
                const Unbounded& other, const PolygonCommon& common, bool tells_contact);

// The image under the pose, if its coordinates are doubles. (Decided exactly.)
std::optional<Point2> exact_image(const Pose& pose, const Point2& p);

}  // namespace sunder::planar

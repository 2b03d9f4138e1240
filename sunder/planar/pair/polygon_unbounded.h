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
#include <variant>
#include <vector>

namespace sunder::planar {

// In the world.
using Unbounded = std::variant<Line, Ray, HalfPlane>;

// The two points that tell where it is.
Line line_of(const Unbounded& other);

// No vertex is in the half-plane; of two nearest to it, the one further along its direction. So below.
struct BesideHalfPlane {
  static constexpr Verdict verdict = Verdict::apart;
  static constexpr CutKind kind = CutKind::nothing;
  std::uint32_t nearest = 0;
};

// What its line cuts off: the ends are where it does, in its direction; of a polygon of two vertices one point.
struct PartWithin {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::part;
  CutEnd first, last;
  std::uint32_t furthest = 0;  // vertex, into the half-plane
};

// All of the polygon, and not all on its line.
struct WholeWithin {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::whole;
  std::uint32_t furthest = 0;
};

// What the polygon has in common with it: of a line or ray as in polygon_cut.h; of a half-plane that only its line
// touches as of that line; else one of the last three.
using PolygonCommon = Answer<
    std::variant<BesideLine, BeyondEnd, CutPoint, CutAlong, CutAcross, BesideHalfPlane, PartWithin, WholeWithin>>;

// Nothing where they are apart, and of the whole polygon.
inline std::optional<CutEnds<CutEnd>> ends_of(const PolygonCommon::Evidence& evidence) {
  return ends_in<CutEnd>(evidence);
}

// Do they touch, or overlap? Relative interiors count: that of a vertex is itself, a segment's is without its ends, a
// ray's without its beginning. Requires their answer.
Relation contact_of(const ConvexPolygon& polygon, const Unbounded& other, const PolygonCommon& common);

// Of a half-plane: the vertex nearest to it, or furthest within it, as the witness of polygon_half_plane.h. Requires
// its answer.
std::uint32_t furthest_of(const PolygonCommon& common);

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
// furthest within that. Requires their answer. Cost: exact arithmetic on a few vertices, and of a line or ray that of
// polygon_line.
void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolygon& polygon, const Pose& pose,
                const Unbounded& other, const PolygonCommon& common, bool tells_contact);

// The image under the pose, if its coordinates are doubles. (Decided exactly.)
std::optional<Point2> exact_image(const Pose& pose, const Point2& p);

}  // namespace sunder::planar

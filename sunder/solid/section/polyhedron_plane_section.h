// What a placed convex polyhedron and a plane have in common: by the names of features, and exactly. One plane, or a
// stack of parallel ones.
// Also called: cross-section; slice, slicing; plane-polyhedron intersection (IHP); contour.
//
// The body is closed, the plane is in the world. The section is nothing, a point, a segment or a convex polygon: its
// corners, and which features of the body they are, are exactly right for the numbers given.
//   S1. Each corner is a vertex of the body that is on the plane, or the crossing of the plane with an edge whose ends
//       are strictly on its two sides. No corner lies between others, and none comes twice.
//   S2. Corners of a polygon go counter-clockwise, seen from where the normal points to.
//   S3. The first corner is the least one, by `above`, then `below`; so there is one way to write a section.
// Where the plane only touches the body, or holds all of a flat one, the section is the vertex, the edge, the facet or
// the body that lies in it.
//
// Certificate: the statement `section` of docs/claims.md, which section_claims.h writes.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/plane.h>
#include <sunder/solid/object/pose.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::solid {

enum class SectionKind : std::uint8_t { nothing, point, segment, polygon };

std::string_view name_of(SectionKind);  // "polygon"

// Numbers of vertices: the ends of an edge, strictly above and strictly below the plane; or twice the one vertex on it.
struct SectionCorner {
  std::uint32_t above = 0, below = 0;
  bool is_vertex() const { return above == below; }
  friend auto operator<=>(const SectionCorner&, const SectionCorner&) = default;
};

struct [[nodiscard]] PlaneSection {
  SectionKind kind = SectionKind::nothing;
  std::vector<SectionCorner> corners;  // none, one, two, or more

  // Of nothing: positive where all of the body is above the plane, negative where it is below; else zero.
  Sign side = Sign::zero;
  std::uint32_t nearest = 0;  // then no vertex is nearer to the plane than this one; else meaningless

  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;
};

// Over the surface, from facet to facet: with a start near the plane from the search structures of extreme vertices.
// Cost: O(log n + k log m) probes for k corners, m the most vertices of a facet that the plane crosses, or neighbours
// of a vertex on it; k where these are few. The first question about a body makes its half-edges
// (represent/half_edges.h).
[[nodiscard]] PlaneSection polyhedron_plane_section(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane);

// The same by looking at every facet: the oracle. Cost: n probes.
[[nodiscard]] PlaneSection polyhedron_plane_section_by_scan(const ConvexPolyhedron& body, const Pose& pose,
                                                            const Plane& plane);

// The sections by the planes that are parallel to this one, in order: those where normal . (x - point) is the offset,
// each one; the plane's own offset does not count. `visit` gets the position of each offset, and its section, which is
// overwritten by the next one. What the planes have in common is made ready once; the corners need memory once.
// Throws Error bad_value where an offset is not finite, and what `visit` throws.
using SectionVisitor = std::function<void(std::size_t, const PlaneSection&)>;
void polyhedron_plane_sections(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                               std::span<const double> offsets, const SectionVisitor& visit);

// The corners of one body's sections by one plane, by coordinates. Keeps a reference to the body.
class SectionPoints {
 public:
  SectionPoints(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane);

  // The position of a corner in the world frame. The corner must belong to a section by this plane, or by a parallel
  // plane that was given by its offset.
  ExactPoint3 exact(const SectionCorner& corner) const;

  // The nearest doubles, ties to even; infinite beyond the range. Cost: double-double arithmetic, and exact numbers
  // where that does not tell.
  Point3 nearest(const SectionCorner& corner) const;

  void set_offset(double offset);

 private:
  const ConvexPolyhedron& body_;
  Affine3 pose_;
  bool is_at_home_;  // the pose is the identity
  Plane plane_;
  int axis_ = -1;     // that of a normal along an axis, or -1
  double level_ = 0;  // then the coordinate that all corners have, rounded
};

}  // namespace sunder::solid

// What a line, a ray or a segment has in common with a placed convex polyhedron: by the names of features, and exactly.
// Also called: clipped line; entry and exit point; chord of a convex polyhedron.
//
// The line runs from its point a through its point b; so do the ray, from a on, and the segment, from a to b.
#pragma once

#include <sunder/certificate/cut.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/line/line_in_body.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

namespace sunder::solid {

enum class CutPlace : std::uint8_t { vertex, edge, facet, inside };

std::string_view name_of(CutPlace);

// A vertex, by its number. An edge, without its ends: `feature` is the lesser of its two vertices, `other` the greater.
// A facet, without its boundary, by its number; of a flat polygon 0. The inside of a body.
struct CutFeature {
  CutPlace place = CutPlace::vertex;
  std::uint32_t feature = 0;  // zero for `inside`
  std::uint32_t other = 0;    // zero but for an edge
  friend bool operator==(const CutFeature&, const CutFeature&) = default;
};

// An end of the common part, and the feature it is in; `inside` for an own end only.
struct CutEnd {
  CutFeature at;
  OwnEnd own = OwnEnd::none;  // of a segment whose ends are one point: a
  friend bool operator==(const CutEnd&, const CutEnd&) = default;
};

// They have nothing in common: what proves it is a direction along which the body is strictly less far than the other,
// for polyhedron_line_claims.h. d is the line's direction, N a facet's normal.
struct CutParting {
  static constexpr Verdict verdict = Verdict::apart;
  static constexpr CutKind kind = CutKind::nothing;
  enum class By : std::uint8_t {
    untold,         // by the scan
    facets,         // the mix of the normals of facets i and j that is perpendicular to the line
    facet,          // N of facet i: an end of the ray or segment is beyond its plane; or the line is, parallel to it
    edge_and_line,  // (the edge i, j) x d
    edge_in_plane,  // (the edge i, j) x N of a flat body: the line is in its plane
    edge,           // perpendicular to the edge i, j, in the plane that it spans with the line: of a segment
    perpendicular,  // from vertex i to the line, perpendicular to that
    line,           // d itself, from vertex i: of a point or a segment on the line
  };
  By by = By::untold;
  std::uint32_t i = 0, j = 0;
  OwnEnd beyond = OwnEnd::a;  // the own end that is beyond; of a line any point is
};

// Of a line that meets a body with an inside: facets through whose planes it comes from outside, where it first has a
// point of the body, and goes to the outside, where it has the last. Methods may name different ones, where several
// would do.
struct LineFacets {
  std::uint32_t enters = 0, leaves = 0;
};

struct CutPoint {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::point;
  CutEnd at;
  std::optional<LineFacets> facets;  // of a body without an inside none; so below
};

// A part of an edge or of a facet, of positive length. The ends are in the direction from a to b; so below.
struct CutAlong {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::along;
  CutEnd first, last;
  CutFeature surface;  // the edge or facet that holds all but the ends
  std::optional<LineFacets> facets;
};

// A segment through the body's inside.
struct CutAcross {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr CutKind kind = CutKind::across;
  CutEnd first, last;
  LineFacets facets;
};

using PolyhedronCut = Answer<std::variant<CutParting, CutPoint, CutAlong, CutAcross>>;

// Nothing where they are apart.
inline std::optional<CutEnds<CutEnd>> ends_of(const PolyhedronCut::Evidence& evidence) {
  return ends_in<CutEnd>(evidence);
}

// Nothing where they are apart, and of a body without an inside.
std::optional<LineFacets> facets_of(const PolyhedronCut::Evidence& evidence);

// Where an end is, exactly.
struct ExactEnd {
  // The point, in the world. Its rounded coordinates are the nearest doubles; infinite beyond the range.
  ExactPoint3 point;
  Point3 rounded() const { return nearest(point); }

  // The point is a + t (b - a). Zero where a and b are one point.
  ExactFraction along_line;
};

// The exact place of an end of the common part of this body and the line, ray or segment through a and b, as one of the
// functions polyhedron_line, polyhedron_ray and polyhedron_segment gave it for them. Cost: exact arithmetic.
ExactEnd exact_end(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b, const CutEnd& end);

}  // namespace sunder::solid

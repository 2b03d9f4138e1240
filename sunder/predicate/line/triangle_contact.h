// What two triangles of one mesh have in common, besides the corners and edges that they share. Exact, for every finite
// double.
// Also called: self-intersection of a triangle mesh; improper intersection.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/predicate/point/facet_plane.h>

#include <cstdint>

namespace sunder {

//   proper      nothing: what they have in common is a corner of both, or an edge, or nothing at all
//   t_junction  a corner of one that is inside an edge of the other, or a part of an edge of each, on one line: so an edge
//               of one ends inside one of the other
//   crossing    else. Then there is a common point that is inside of one triangle, or inside of an edge of each, and the
//               edges are not on one line.
enum class TriangleContact : std::uint8_t { proper, t_junction, crossing };

// A triangle with an area, and its plane.
struct PlaneTriangle {
  Triangle3 corners;
  FacetPlane plane;

  // For points whose coordinates differ from its own by no more than `extent`, the differences as rounded.
  PlaneTriangle(const Triangle3& of, const Point3& extent) : corners(of), plane(of[0], of[1], of[2], extent) {}

  // As orient_3d says of its corners and q.
  Sign side(const Point3& q) const { return plane.side(corners[0], corners[1], corners[2], q); }
};

// Corners that are equal are shared. Requires that both have an area. Cost: one side where they share an edge, two for
// most that share a corner, three for most others.
TriangleContact triangle_contact(const PlaneTriangle& t, const PlaneTriangle& u, StageTally* tally = nullptr);

}  // namespace sunder

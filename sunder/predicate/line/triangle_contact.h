// What two triangles of one mesh have in common, besides the corners and edges that they share. Exact, for every finite
// double.
// Also called: self-intersection of a triangle mesh; improper intersection.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/predicate/point/facet_plane.h>

#include <array>
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

// Which corners of two triangles with an area are corners of both: bit k tells of corner k.
struct SharedCorners {
  unsigned of_t = 0, of_u = 0;

  // By the numbers of points, of which no two are equal, or by their coordinates.
  template <class Corner>
  SharedCorners(const std::array<Corner, 3>& t, const std::array<Corner, 3>& u) {
    for (unsigned i = 0; i < 3; ++i) {
      for (unsigned j = 0; j < 3; ++j) {
        const auto is_shared = static_cast<unsigned>(t[i] == u[j]);
        of_t |= is_shared << i;
        of_u |= is_shared << j;
      }
    }
  }
};

// Requires that both have an area. Cost: the sides of all corners, of which floating point mostly knows enough; else two
// orientations, or, where a corner is in the plane of the other triangle, some more.
TriangleContact triangle_contact(const PlaneTriangle& t, const PlaneTriangle& u, const SharedCorners& shared,
                                 StageTally* tally = nullptr);
inline TriangleContact triangle_contact(const PlaneTriangle& t, const PlaneTriangle& u, StageTally* tally = nullptr) {
  return triangle_contact(t, u, SharedCorners(t.corners, u.corners), tally);
}

// The same without a look at what floating point knows.
TriangleContact exact_triangle_contact(const PlaneTriangle& t, const PlaneTriangle& u, StageTally* tally = nullptr);

}  // namespace sunder

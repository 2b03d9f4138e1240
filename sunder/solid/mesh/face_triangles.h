// A face of a mesh as triangles, exactly.
// Also called: polygon triangulation, ear clipping, tessellation.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

// Triangles of one face, turned as it is turned, whose corners are corners of the face.
//
// The face is looked at along the axis on which its normal (Newell's) has its greatest component. There ears are cut
// off one by one: a corner is an ear if the turn at it is that of the face, and the triangle with its neighbours holds
// no other corner, and no edge from one at the place of its own. Where no corner is one, as of a face without area or
// one that crosses itself, any is cut off.
//   F1. A face of k corners gives k - 2 triangles. Each edge of the face is that of one, in its direction, and each
//       other edge is that of two, once in each direction.
//   F2. Where crosses_itself is false, no triangle turns against the face, as it is looked at. So if the face goes
//       around no point twice, its triangles do not overlap there.
// A face may touch itself, as one does that goes along a bridge to a hole and back.
struct FaceTriangles {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // Two edges cross in an inner point of both, as it is looked at, or a triangle turns against the face.
  bool crosses_itself = false;
};

// corners: numbers of points, no two that follow each other equal, three or more. Cost: k^2 signs where it is not
// convex, times those of corners that are no ears.
FaceTriangles face_triangles(std::span<const Point3> points, std::span<const std::uint32_t> corners);

}  // namespace sunder::solid

// The boundary of the convex hull of points that span R^d, as simplices: exactly, whatever the position of the points.
// Also called: beneath-beyond; placing triangulation.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point/simplex_plane.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

// Q1. The simplices are those of a triangulation of the boundary; each has d corners, and no volume of zero.
// Q2. No point is on the positive side of one (predicate/point/simplex_plane.h).
// Q3. across[i] is the other simplex at the ridge without corner i; only the two have all its corners.
// Q4. Two at a ridge may lie in one plane. So a corner may be no vertex of the hull, but between others.
struct BoundarySimplex {
  SimplexCorners corners{}, across{};
};

struct QuickhullCost {
  std::uint64_t side_tests = 0;   // how many times a point was compared with a plane
  std::uint64_t exact_tests = 0;  // of these, those that floating point left to exact numbers
  std::uint64_t zeros = 0;        // of these, points that are in the plane
  bool gives_up = false;          // asked for: end without a result where is_degenerate()

  bool is_degenerate() const { return zeros > 32 + side_tests / 32; }
};

// Of the points whose indices are given, of which `first` are d + 1 that span R^d.
// Empty where it gives up. Throws Error bad_shape where more than `most` simplices would have to be held at once.
//
// Why it is right. A point is added where it is strictly on the positive side of a simplex; the simplices of which that
// is so are taken away, and the point is joined to the ridges around them. At such a ridge is a plane that the point
// is strictly beyond, so it is not in the flat of the ridge: no new simplex is flat. If the other plane there holds the
// point, the new simplex goes on in that plane, and is the part of the larger face that was not there. A point beyond
// a simplex that is taken away is, if outside of the new hull, beyond a new one: from the inside of the old simplex to
// the point the way leaves the new hull through a face of it, at a point that is beyond the old simplex, so outside of
// the old hull; the simplices that were there before are in the old hull.
// Source: Barber, Dobkin, Huhdanpaa 1996. Departures: signs are exact, so nothing is merged, and nothing is wide.
std::vector<BoundarySimplex> quickhull(const PlanePoints& points, std::span<const std::uint32_t> indices,
                                       std::span<const std::uint32_t> first, std::uint64_t most, QuickhullCost& cost);

}  // namespace sunder::polytope

// The painter's algorithm: polygons of a picture in an order in which nearer ones come later, cut where they cross.
#pragma once

#include <sunder/number/vector.h>

#include <cstdint>
#include <vector>

namespace sunder::picture {

// A point on the picture's plane, in the world's unit: x to the right, y down, z towards the viewer.
using Seen = Vector3<double>;

// Of the plane of a convex polygon: of length one, towards the viewer where its corners run clockwise on the picture.
// Zero for a line.
Seen normal_of(const std::vector<Seen>& corners);

// A piece of a facet that is turned towards the viewer; of two corners: a line; of one: a dot.
struct Piece {
  std::uint32_t body = 0, part = 0;  // part: any number that differs between parts; they are convex
  double light = 0;                  // 0 .. 1
  std::vector<Seen> corners;         // a convex polygon
  std::vector<bool> outline;         // of the edge from each corner to the next: does the body end behind it?
  bool is_cut = false;               // by the painter
};

// The same pieces, farthest first, cut where two cross: no piece is hidden by an earlier one (but where three or more
// hide each other in a circle). Pieces of one convex part never hide each other. In floating point, with a tolerance:
// for pictures only. With very many pieces (over 20,000) the order is by the depth of their middles, and only roughly
// right. Cost: a comparison of every two.
// Source: after Newell, Newell, Sancha 1972; the order by a graph instead of by exchanges.
std::vector<Piece> in_painters_order(std::vector<Piece> pieces);

}  // namespace sunder::picture

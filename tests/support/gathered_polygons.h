// Sets of polygons where boxes tell little: around one another, about one point, in holes, many in one. From a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <vector>

namespace sunder::tests {

class GatheredPolygons {
 public:
  using Ring = std::vector<Point2>;
  using Rings = std::vector<Ring>;

  explicit GatheredPolygons(std::uint64_t seed) : random_(seed) {}

  // Of each polygon its rings, which are simple, begin anywhere and run either way. Coordinates are multiples of 1/4.

  // Frames around one another, most of which meet no other; some touch the next, overlap it, or are filled.
  std::vector<Rings> annuli();

  // Triangles about one point: in sectors of their own, or some in those of others; and what passes the point, or lies
  // around it.
  std::vector<Rings> pie();

  // A plate with holes, in each of which lies a smaller one, or not quite, with more in their holes.
  std::vector<Rings> islands();

  // Small ones within the arms of one large one, and between them; some on its border.
  std::vector<Rings> many_inside();

 private:
  double at(std::uint64_t below) { return static_cast<double>(random_.below(below)); }
  bool one_in(std::uint64_t n) { return random_.below(n) == 0; }
  Ring turned(Ring ring);

  Random random_;
};

}  // namespace sunder::tests

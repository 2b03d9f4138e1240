// Multipolygons that are nearly, or just, valid: on small grids, so that all that can touch does. From a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class NastyFamily : std::uint8_t {
  few_places,  // rings of some vertices of a tiny grid, in any order
  holes,       // a box with triangles and boxes in and around it
  lattice,     // a box with triangles of a lattice in it, which share corners
  cells,       // the outlines of sets of cells, traced as chance has it where they touch themselves
  parts,       // boxes and annuli in one another, and side by side
};
inline constexpr int nasty_family_count = 5;
std::string_view name_of(NastyFamily family);

class NastyPolygons {
 public:
  using Rings = planar::PolygonRings;

  explicit NastyPolygons(std::uint64_t seed) : random_(seed) {}

  // Coordinates are whole and at most 2^7 in size. Rings begin anywhere, and run either way; half of them are closed by
  // their first vertex; some vertices are repeated. In some a vertex has been moved, or a ring has gone elsewhere.
  std::vector<Rings> next(NastyFamily family);

  Random& random() { return random_; }

 private:
  using Ring = std::vector<Point2>;

  double at(std::uint64_t below) { return static_cast<double>(random_.below(below)); }
  bool one_in(std::uint64_t n) { return random_.below(n) == 0; }

  Ring any_ring(std::uint64_t side);
  Ring small_ring();
  std::vector<Rings> few_places();
  std::vector<Rings> box_with_holes();
  std::vector<Rings> lattice();
  std::vector<Rings> cells();
  std::vector<Rings> nested_parts();
  void change(std::vector<Rings>& parts);
  void dress(Ring& ring);

  Random random_;
};

}  // namespace sunder::tests

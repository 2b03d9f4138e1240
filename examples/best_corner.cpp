// Half-planes a x + b y <= c: what do they have in common, and where in it is x + 2 y greatest? Corners are exact
// fractions, whatever the numbers are.
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>

#include <iostream>

int main() {
  const sunder::planar::Constraints given({{-1, 0, 0}, {0, -1, 0}, {3, 1, 10}, {1, 3, 12}, {1, 1, 100}});
  const auto region = sunder::planar::half_plane_intersection(given);
  std::cout << name_of(region.kind) << ", " << region.sides.size() << " sides\n";
  for (const auto& [before, after] : corners(region)) {
    const auto at = nearest(exact_corner(given[before], given[after]));
    std::cout << "  half-planes " << before << " and " << after << " meet at about " << at.x << ", " << at.y << '\n';
  }
  const auto best = linear_program(given, {1, 2});
  std::cout << "the best corner is that of half-planes " << best.before << " and " << best.after << '\n';
  return region.sides.size() == 4 && best.feasible() ? 0 : 1;
}

// Half-planes a x + b y <= c: what do they have in common, and where in it is x + 2 y greatest? Corners are exact
// fractions, whatever the numbers are.
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>

#include <iostream>
#include <variant>

int main() {
  const sunder::planar::Constraints given({{-1, 0, 0}, {0, -1, 0}, {3, 1, 10}, {1, 3, 12}, {1, 1, 100}});
  const auto region = sunder::planar::half_plane_intersection(given);
  std::cout << name_of(region.kind) << ", " << region.sides.size() << " sides\n";
  for (const auto& [before, after] : corners(region)) {
    const auto at = nearest(exact_corner(given[before], given[after]));
    std::cout << "  half-planes " << before << " and " << after << " meet at about " << at.x << ", " << at.y << '\n';
  }
  const auto best = linear_program(given, {1, 2});
  const auto* const corner = std::get_if<sunder::planar::OneOptimum>(&best.evidence);  // null: not just one is best
  if (corner == nullptr) return 1;
  std::cout << "the best corner is that of half-planes " << corner->before << " and " << corner->after << '\n';
  return region.sides.size() == 4 ? 0 : 1;
}
